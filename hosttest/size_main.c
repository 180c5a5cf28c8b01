/* SPDX-License-Identifier: MIT */
/* What size.sh weighs and stack.sh follows: a program that draws one mesh, with and without the library. Never run.
 * SIZE_EMPTY leaves the library out, SIZE_EVERYTHING calls all that draws; otherwise SIZE_MODEL, SIZE_STEP and SIZE_FORMAT say
 * what is drawn, SIZE_PROJECT that vertices are projected once, SIZE_PERSPECTIVE and SIZE_SORT what is called as well. */
#include "../port/fill.h"

/* What compilers call for block copies; plain loops, so that they count as they would with any small libc. The empty statement
 * keeps compilers from taking the loops for what they define. */
void *memcpy(void *to, const void *from, size_t n);
void *memset(void *to, int value, size_t n);
void *memcpy(void *to, const void *from, size_t n)
{
    uint8_t *t = to;
    const uint8_t *f = from;
    for (; n > 0; n--) {
        *t++ = *f++;
        __asm__ volatile("");
    }
    return to;
}
void *memset(void *to, int value, size_t n)
{
    uint8_t *t = to;
    for (; n > 0; n--) {
        *t++ = (uint8_t)value;
        __asm__ volatile("");
    }
    return to;
}

int main(void);

/* The caller's memory for a paint: of no use but to be read off the object. */
__attribute__((section(".callers"), used)) static const uint8_t size_paint[sizeof(lmb_paint)] = {0};

/* Volatile, so that the compiler folds nothing. */
static struct {
    const lmb_mesh *mesh;
    const lmb_pose *pose;
    const lmb_light *light;
    const lmb_material *material;
    uint16_t *frame, *order;
    int16_t *keys;
    lmb_vertex *vertices;
    int choice;
} volatile in;

#if !defined(SIZE_EMPTY)
/* One strip of one mesh. */
static void draw(enum lmb_model model, enum lmb_step_kind step, enum lmb_format format, const lmb_camera *camera,
                 const lmb_vertex *vertices, const uint16_t *order)
{
    lmb_surface surface;
    lmb_look look;
    lmb_paint paint;
    const lmb_rgb black = {0, 0, 0};
    lmb_surface_strip(&surface, format, in.frame, NULL, 240, 0, 24);
    lmb_clear(&surface, black);
    lmb_look_prepare(&look, in.material, in.light, 1, model, step);
#if defined(SIZE_EVERYTHING)
    lmb_look_lobe(&look, (enum lmb_lobe_kind)step, 100);
#endif
    lmb_paint_prepare(&paint, &look, format);
    lmb_draw_mesh(&surface, in.mesh, in.pose, camera, &paint, vertices, order);
}
#endif

int main(void)
{
#if !defined(SIZE_EMPTY)
    lmb_camera camera;
    lmb_camera_orthographic(&camera, 240, 240, 110L << 16, 1L << 16, 8L << 16);
#if defined(SIZE_EVERYTHING)
    lmb_camera_perspective(&camera, 240, 240, 110L << 16, 1L << 16, 8L << 16);
    lmb_mesh_project(in.mesh, in.pose, &camera, in.vertices);
    lmb_mesh_sort(in.mesh, in.pose, in.order, in.keys);
    draw((enum lmb_model)in.choice, (enum lmb_step_kind)in.choice, (enum lmb_format)in.choice, &camera, in.vertices, in.order);
#else
#if defined(SIZE_PERSPECTIVE)
    lmb_camera_perspective(&camera, 240, 240, 110L << 16, 1L << 16, 8L << 16);
#endif
#if defined(SIZE_SORT)
    lmb_mesh_sort(in.mesh, in.pose, in.order, in.keys);
#endif
#if defined(SIZE_PROJECT)
    lmb_mesh_project(in.mesh, in.pose, &camera, in.vertices);
    draw(SIZE_MODEL, SIZE_STEP, SIZE_FORMAT, &camera, in.vertices, in.order);
#else
    draw(SIZE_MODEL, SIZE_STEP, SIZE_FORMAT, &camera, NULL, NULL);
#endif
#endif
#endif
    return in.choice;
}
