/* SPDX-License-Identifier: MIT */
/* Writes plan.csv to stdout: what the planner chooses for the terms of each demo scene's triangles, one per light and triangle. */
#include "../port/demo/scenes.h"

#include <stdio.h>
#include <stdlib.h>

static void print_term(const char *scene_name, const char *format, const char *term, const lmb_statistics *all,
                       const uint32_t ways[LMB_WAYS])
{
    printf("%s,%s,%s,%lu,%lu,%lu,%lu,%lu,%lu\n", scene_name, format, term, (unsigned long)all->triangles,
           (unsigned long)ways[LMB_WAY_NONE], (unsigned long)ways[LMB_WAY_CONSTANT], (unsigned long)ways[LMB_WAY_LINEAR],
           (unsigned long)ways[LMB_WAY_QUADRATIC], (unsigned long)ways[LMB_WAY_ARC]);
}

/* Of a whole frame; a paint has its format's tolerance. */
static int report(const scene *s, enum lmb_format format, const char *format_name)
{
    static const lmb_statistics nothing;
    lmb_statistics all = nothing;
    lmb_window window = {0, 0, 0, 0, false};
    unsigned i;
    window.right = (int16_t)s->width;
    window.bottom = (int16_t)s->height;
    for (i = 0; i < s->objects; i++) {
        const scene_object *o = &s->object[i];
        lmb_look look;
        lmb_paint paint;
        lmb_walk walk;
        if (lmb_look_prepare(&look, &o->material, s->light, s->lights, LMB_MODEL_GLOSS, LMB_STEP_PLANNED)) return -1;
        lmb_paint_prepare(&paint, &look, format);
        lmb_mesh_begin(&walk, o->mesh, &o->pose, &s->camera, &paint.look, &window, NULL, NULL);
        lmb_mesh_statistics(&walk, &all);
    }
    print_term(s->name, format_name, "diffuse", &all, all.diffuse);
    print_term(s->name, format_name, "specular", &all, all.specular);
    return 0;
}

int main(void)
{
    unsigned i;
    printf("scene,format,term,triangles,none,constant,linear,quadratic,arc\n");
    for (i = 0; i < scene_count(); i++) {
        scene s;
        scene_make(&s, i);
        if (report(&s, LMB_RGB565, "rgb565") || report(&s, LMB_RGB888, "rgb888")) {
            fprintf(stderr, "report_plan: the library refuses the look of %s\n", s.name);
            return EXIT_FAILURE;
        }
    }
    return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
