/* SPDX-License-Identifier: MIT */
/* A list of frames in C for draw.c: numbers alone, so that a target draws the very frames that lmb-estimate counts.
 * usage: estimate_cases LIST MODEL_FOLDER */
#include "list.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* The mesh's name in C. */
static const char *identifier(const char *name)
{
    static char out[80];
    size_t i;
    for (i = 0; name[i] && i < sizeof out - 1; i++) out[i] = (char)(isalnum((unsigned char)name[i]) ? name[i] : '_');
    out[i] = 0;
    return out;
}

static void put_colour(lmb_rgb c) { printf("{%u, %u, %u}", c.r, c.g, c.b); }

static void put_look(const view *v)
{
    const lmb_material m = view_material(v);
    unsigned i;
    printf("    {");
    put_colour(m.ambient);
    printf(", ");
    put_colour(m.diffuse);
    printf(", ");
    put_colour(m.specular);
    printf(", %u},\n    {", m.shininess);
    for (i = 0; i < v->lights; i++) {
        const lmb_light *l = &v->light[i];
        printf("%s{{%d, %d, %d}, ", i ? ", " : "", l->direction.x, l->direction.y, l->direction.z);
        put_colour(l->colour);
        printf("}");
    }
    printf("}},\n");
}

static void put_case(const list *l, const list_case *c)
{
    const view *v = &c->view.view;
    view_lens lens;
    view_lens_of(v, &lens);
    printf("    /* %s */\n", c->text);
    printf("    {&mesh_%s, %ld, %ld, %ld, %ld, {%u, %u, %u}, %d, %d, %d,\n", identifier(l->names[c->model]), (long)lens.focal_q16,
           (long)lens.near_q16, (long)lens.far_q16, (long)lens.z_q16, lens.turn[0], lens.turn[1], lens.turn[2], v->width,
           v->height, v->strip);
    printf("    %d, %d, %d, %d, %d, %d, %d, %d, %u,\n", v->camera, v->format, v->model, v->step, v->lobe, v->order == VIEW_DEPTH,
           v->order == VIEW_PAINTER, c->view.vertices, v->lights);
    put_look(v);
}

int main(int argc, char **argv)
{
    static list l;
    unsigned i;
    if (argc != 3) {
        fprintf(stderr, "usage: estimate_cases LIST MODEL_FOLDER\n");
        return 2;
    }
    list_read(&l, argv[1], argv[2]);
    for (i = 0; i < l.models; i++) printf("extern const lmb_mesh mesh_%s;\n", identifier(l.names[i]));
    printf("static const estimate_case cases[] = {\n");
    for (i = 0; i < l.count; i++) put_case(&l, &l.cases[i]);
    printf("};\n");
    return EXIT_SUCCESS;
}
