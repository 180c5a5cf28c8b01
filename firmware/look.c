/* SPDX-License-Identifier: MIT */
/* Look: material and lights folded together, half vectors, rays in the space of the normals. */
#include "lambent.h"

/* Directions within 5 % of unit length: 0.95^2 and 1.05^2 in Q4.28; no component can be longer. */
#define LENGTH2_MIN 242262999
#define LENGTH2_MAX 295950609
#define COMPONENT_MAX 17203
LMB_STATIC_ASSERT((int32_t)COMPONENT_MAX * COMPONENT_MAX >= LENGTH2_MAX - 2L * COMPONENT_MAX && LENGTH2_MIN < 0x10000000);

static bool is_unit(lmb_vec d)
{
    int32_t length2;
    if (lmb_max(lmb_max(d.x, d.y), d.z) > COMPONENT_MAX || lmb_min(lmb_min(d.x, d.y), d.z) < -COMPONENT_MAX) return false;
    length2 = lmb_dot_q28(d, d);
    return length2 >= LENGTH2_MIN && length2 <= LENGTH2_MAX;
}

/* The product of two UQ0.8 colours as UQ1.15: a b 32768 / 255^2, rounded to nearest. 0x81020409 is 2^47 / 255^2, rounded up. */
static uint16_t product_q15(uint32_t a, uint32_t b)
{
    return (uint16_t)((lmb_mulu_hi(lmb_mulu(a, b) << 1, 0x81020409u) + 1u) >> 1);
}

static void fold(uint16_t out[3], lmb_rgb material, lmb_rgb light)
{
    out[0] = product_q15(material.r, light.r);
    out[1] = product_q15(material.g, light.g);
    out[2] = product_q15(material.b, light.b);
}

static int light_prepare(lmb_look *look, unsigned i, const lmb_material *material, const lmb_light *light)
{
    lmb_vec d = light->direction;
    struct lmb_look_light *to = &look->light[i];
    if (!is_unit(d)) return LMB_ERROR_VALUE;
    d = lmb_normalise(d.x, d.y, d.z);
    to->direction = d;
    to->half = lmb_normalise(d.x, d.y, lmb_add(d.z, 16384)); /* the viewer is along +z */
    fold(to->diffuse_q15, material->diffuse, light->colour);
    fold(to->specular_q15, material->specular, light->colour);
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
    fold(look->ambient_q15, material->ambient, white);
    for (i = 0; i < light_count && error == LMB_OK; i++) error = light_prepare(look, i, material, &lights[i]);
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
    for (i = 0; i < look->lights; i++) {
        rays->light[i].direction = look->light[i].direction;
        rays->light[i].half = look->light[i].half;
        if (!rotation) continue;
        rays->light[i].direction = lmb_rotate_back(rotation, look->light[i].direction);
        rays->light[i].half = lmb_rotate_back(rotation, look->light[i].half);
    }
}
