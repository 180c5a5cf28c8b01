/* SPDX-License-Identifier: MIT */
/* The measured program: draws each case of a list, as lmb-estimate understands it, between marks. Not counted: preparing a paint,
 * clearing; and clearing alone, a case of its own at the end for each format, without and with depth. */
#include "../profile/mark.h"
#include "case.h"

#include ESTIMATE_CASES

#define VERTICES_MAX 10400
#define BYTES_MAX (480ul * 480ul * 3ul)
#define CLEAR_SIDE 100

static lmb_vertex vertices[VERTICES_MAX];
static uint16_t order[21000], depth[480 * 480];
static int16_t keys[21000];
static union {
    uint16_t aligned;
    uint8_t bytes[BYTES_MAX];
} pixels;
static lmb_paint paint;

static void say_case(const char *name, unsigned i, const estimate_case *c)
{
    profile_say("scene ");
    profile_say(name);
    profile_say("-");
    profile_say_number(i);
    profile_say(" frame ");
    profile_say(c->format == LMB_RGB565 ? "rgb565 " : "rgb888 ");
    profile_say_number(c->mesh->triangles);
    profile_say(" size ");
    profile_say_number((uint32_t)c->width);
    profile_say(" rows ");
    profile_say_number((uint32_t)c->rows);
    profile_say_end();
}

static void say_drawn(uint32_t drawn)
{
    profile_say("drawn ");
    profile_say_number(drawn);
    profile_say_end();
}

static int strip(lmb_surface *surface, const estimate_case *c, int top)
{
    const int bottom = top + c->rows < c->height ? top + c->rows : c->height;
    lmb_surface_strip(surface, (enum lmb_format)c->format, pixels.bytes, c->depth ? depth : NULL, c->width, top, bottom);
    return bottom;
}

static bool prepare(const estimate_case *c, lmb_camera *camera, lmb_pose *pose)
{
    lmb_look look;
    if (lmb_look_prepare(&look, &c->material, c->light, c->lights, (enum lmb_model)c->model, (enum lmb_step_kind)c->step))
        return false;
    if (c->lobe != LMB_LOBE_TUNED && lmb_look_lobe(&look, (enum lmb_lobe_kind)c->lobe, 0)) return false;
    lmb_paint_prepare(&paint, &look, (enum lmb_format)c->format);
    pose->rotation = lmb_rotation(c->turn[0], c->turn[1], c->turn[2]);
    pose->x = pose->y = 0;
    pose->z = c->z_q16;
    if (c->perspective) return !lmb_camera_perspective(camera, c->width, c->height, c->focal_q16, c->near_q16, c->far_q16);
    return !lmb_camera_orthographic(camera, c->width, c->height, c->focal_q16, c->near_q16, c->far_q16);
}

/* A strip's worth of memory is shared, so depth is cleared before each strip: uncounted, in a region of its own that adds up. */
static void draw(unsigned i, const estimate_case *c)
{
    static const lmb_rgb black = {0, 0, 0};
    lmb_surface surface;
    lmb_camera camera;
    lmb_pose pose;
    uint32_t drawn = 0;
    int top, bottom;
    if (c->mesh->vertices > VERTICES_MAX || (uint32_t)c->width * (uint32_t)c->rows * 3 > BYTES_MAX ||
        !prepare(c, &camera, &pose)) {
        profile_say("error: a case that has no room here, or is refused: ");
        profile_say_number(i);
        profile_say_end();
        return;
    }
    say_case("case", i, c);
    for (top = 0; top < c->height; top = bottom) {
        bottom = strip(&surface, c, top);
        lmb_clear(&surface, black);
        profile_begin();
        if (top == 0 && !c->anew) lmb_mesh_project(c->mesh, &pose, &camera, vertices);
        if (top == 0 && c->painter) (void)lmb_mesh_sort(c->mesh, &pose, order, keys);
        bottom = strip(&surface, c, top);
        drawn += lmb_draw_mesh(&surface, c->mesh, &pose, &camera, &paint, c->anew ? NULL : vertices, c->painter ? order : NULL);
        profile_end();
    }
    say_drawn(drawn);
}

static void clear(unsigned i)
{
    static const lmb_rgb colour = {1, 2, 3};
    estimate_case c = cases[0];
    lmb_surface surface;
    c.format = i & 1 ? LMB_RGB888 : LMB_RGB565;
    c.depth = i > 1;
    c.width = c.height = c.rows = CLEAR_SIDE;
    say_case("clear", i, &c);
    strip(&surface, &c, 0);
    profile_begin();
    lmb_clear(&surface, colour);
    profile_end();
    say_drawn(CLEAR_SIDE * CLEAR_SIDE);
}

int main(void)
{
    unsigned i;
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++) draw(i, &cases[i]);
    for (i = 0; i < 4; i++) clear(i);
    return 0;
}
