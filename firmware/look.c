/* SPDX-License-Identifier: MIT */
/* Look: material and lights folded together, half vectors, rays in the space of the normals. */
#include "vec.h"

/* Directions within 5 % of unit length: 0.95^2 and 1.05^2 in Q4.28. */
#define LENGTH2_MIN 242262999u
#define LENGTH2_MAX 295950609u
LMB_STATIC_ASSERT(LENGTH2_MIN<0x10000000 && LENGTH2_MAX> 0x10000000);

static uint32_t square(int32_t x) { return (uint32_t)lmb_mul16(x, x); }

/* Any vector: three squares of 2^30 fit 32 bits. */
static bool is_unit(const lmb_vec *d)
{
    uint32_t length2 = square(d->x) + square(d->y) + square(d->z);
    return length2 >= LENGTH2_MIN && length2 <= LENGTH2_MAX;
}

/* The product of two UQ0.8 colours as UQ1.15: a b 32768 / 255^2, rounded to nearest. 0x81018203 is 2^47 / 255^2, rounded up;
 * its two halves keep products within 32 bits: 255^2 0x8101 < 2^31. */
static uint16_t product_q15(uint32_t a, uint32_t b)
{
    uint32_t product = lmb_mulu(a, b);
    return (uint16_t)((lmb_mulu(product, 0x8101) + (lmb_mulu(product, 0x8203) >> 16) + 0x8000u) >> 16);
}

LMB_STATIC_ASSERT(sizeof(lmb_rgb) == 3); /* so colours can be taken as three bytes */
static void fold(uint16_t out[3], const lmb_rgb *material, const lmb_rgb *light)
{
    const uint8_t *m = (const uint8_t *)material, *l = (const uint8_t *)light;
    unsigned i;
    for (i = 0; i < 3; i++) out[i] = product_q15(m[i], l[i]);
}

static int light_prepare(lmb_look *look, unsigned i, const lmb_material *material, const lmb_light *light)
{
    const lmb_vec *d = &light->direction;
    struct lmb_look_light *to = &look->light[i];
    if (!is_unit(d)) return LMB_ERROR_VALUE;
    lmb_vec_normalise(&to->direction, d->x, d->y, d->z);
    d = &to->direction;
    lmb_vec_normalise(&to->half, d->x, d->y, lmb_add(d->z, 16384)); /* the viewer is along +z */
    fold(to->diffuse_q15, &material->diffuse, &light->colour);
    fold(to->specular_q15, &material->specular, &light->colour);
    if (to->specular_q15[0] | to->specular_q15[1] | to->specular_q15[2]) look->specular_on |= (uint8_t)(1u << i);
    return LMB_OK;
}

int lmb_look_prepare(lmb_look *look, const lmb_material *material, const lmb_light *lights, unsigned light_count,
                     enum lmb_model model, enum lmb_step_kind step)
{
    static const lmb_rgb white = {255, 255, 255};
    unsigned i;
    int error;
    if (light_count < 1 || light_count > LMB_LIGHTS) return LMB_ERROR_LIGHTS;
    if ((unsigned)model > LMB_MODEL_GLOSS || (unsigned)step > LMB_STEP_ARC) return LMB_ERROR_VALUE;
    if (!LMB_WITH_ARC && step == LMB_STEP_ARC) return LMB_ERROR_VALUE;
    if (!LMB_WITH_CORNERS && model < LMB_MODEL_DIFFUSE) return LMB_ERROR_VALUE;
    error = lmb_lobe_prepare(&look->lobe, LMB_LOBE_TUNED, material->shininess, 0);
    look->model = (uint8_t)model;
    look->step = (uint8_t)step;
    look->lights = (uint8_t)light_count;
    look->specular_on = 0;
    fold(look->ambient_q15, &material->ambient, &white);
    for (i = 0; i < lmb_look_lights(look) && error == LMB_OK; i++) error = light_prepare(look, i, material, &lights[i]);
    if (model == LMB_MODEL_DIFFUSE) look->specular_on = 0;
    return error;
}

int lmb_look_lobe(lmb_look *look, enum lmb_lobe_kind kind, uint16_t tolerance)
{
    return lmb_lobe_prepare(&look->lobe, kind, look->lobe.shininess, tolerance);
}

void lmb_rays_prepare(lmb_rays *rays, const lmb_look *look, const lmb_matrix *rotation)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(look); i++) {
        struct lmb_ray *ray = &rays->light[i];
        lmb_vec_copy(&ray->direction, &look->light[i].direction);
        lmb_vec_copy(&ray->half, &look->light[i].half);
        if (!rotation) continue;
        lmb_vec_rotate_back(rotation, &ray->direction);
        lmb_vec_rotate_back(rotation, &ray->half);
    }
}
