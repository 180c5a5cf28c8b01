/* SPDX-License-Identifier: MIT */
/* What size.sh links: a program that draws one mesh, with and without the library. Never run. */
#include "../port/fill.h"

#include <stddef.h>

/* What compilers call for block copies; plain loops, so that they count as they would with any small libc. */
void *memcpy(void *to, const void *from, size_t n);
void *memset(void *to, int value, size_t n);
void *memcpy(void *to, const void *from, size_t n)
{
    uint8_t *t = to;
    const uint8_t *f = from;
    while (n-- > 0) *t++ = *f++;
    return to;
}
void *memset(void *to, int value, size_t n)
{
    uint8_t *t = to;
    while (n-- > 0) *t++ = (uint8_t)value;
    return to;
}

int main(void);
extern const lmb_mesh size_mesh; /* volatile input keeps the compiler from folding anything */
static uint16_t *volatile frame = (uint16_t *)0x20000100;
static const lmb_mesh *volatile mesh_in = (const lmb_mesh *)0x1000;
static const lmb_light *volatile light_in = (const lmb_light *)0x1100;
static const lmb_material *volatile material_in = (const lmb_material *)0x1200;
static const lmb_pose *volatile pose_in = (const lmb_pose *)0x1300;

#if defined(SIZE_GLOSS) || defined(SIZE_EVERYTHING)
static void draw(enum lmb_model model, enum lmb_step_kind step, enum lmb_format format)
{
    lmb_surface surface;
    lmb_camera camera;
    lmb_look look;
    const lmb_rgb black = {0, 0, 0};
    lmb_surface_strip(&surface, format, frame, NULL, 240, 0, 24);
    lmb_clear(&surface, black);
    lmb_camera_orthographic(&camera, 240, 240, 110L << 16, 1L << 16, 8L << 16);
    lmb_look_prepare(&look, material_in, light_in, 1, model, step);
    lmb_draw_mesh(&surface, mesh_in, pose_in, &camera, &look, NULL, NULL);
}
#endif

int main(void)
{
#if defined(SIZE_GLOSS)
    draw(LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, LMB_RGB565);
#elif defined(SIZE_EVERYTHING)
    static volatile int choice;
    draw((enum lmb_model)choice, (enum lmb_step_kind)choice, (enum lmb_format)choice);
#endif
    return (int)(intptr_t)frame + (int)(intptr_t)mesh_in + (int)(intptr_t)light_in + (int)(intptr_t)material_in +
           (int)(intptr_t)pose_in;
}
