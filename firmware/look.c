/* SPDX-License-Identifier: MIT */
/* Look: material and lights folded together, half vectors, rays in the space of the normals. */
#include "power.h"
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
    for (i = 0; i < 3; i++) out[i] = product_q15(m[i], l ? l[i] : 255);
}

static int light_prepare(struct lmb_look_light *to, const lmb_material *material, const lmb_light *light)
{
    const lmb_vec *d = &light->direction;
    if (!is_unit(d)) return LMB_ERROR_VALUE;
    lmb_vec_normalise(&to->direction, d->x, d->y, d->z);
    d = &to->direction;
    lmb_vec_normalise(&to->half, d->x, d->y, lmb_add(d->z, 16384)); /* the viewer is along +z */
    fold(to->diffuse_q15, &material->diffuse, &light->colour);
    fold(to->specular_q15, &material->specular, &light->colour);
    return LMB_OK;
}

/* The lobe of a look: without lobes its exponent alone. */
static int lobe_prepare(lmb_look *look, enum lmb_lobe_kind kind, unsigned n, uint16_t tolerance)
{
    if (LMB_WITH_LOBES) return lmb_lobe_prepare(&look->lobe, kind, n, tolerance);
    look->lobe.shininess = (uint16_t)n;
    return kind != LMB_LOBE_TUNED || n < 1 || n > LMB_SHININESS_MAX ? LMB_ERROR_VALUE : LMB_OK;
}

int lmb_look_prepare(lmb_look *look, const lmb_material *material, const lmb_light *lights, unsigned light_count,
                     enum lmb_model model, enum lmb_step_kind step)
{
    unsigned i;
    int error;
    if (light_count < 1 || light_count > LMB_LIGHTS) return LMB_ERROR_LIGHTS;
    if ((unsigned)model > LMB_MODEL_GLOSS || (unsigned)step > LMB_STEP_ARC) return LMB_ERROR_VALUE;
    if (!LMB_WITH_ARC && step == LMB_STEP_ARC) return LMB_ERROR_VALUE;
    if (!LMB_WITH_CORNERS && model < LMB_MODEL_DIFFUSE) return LMB_ERROR_VALUE;
    error = lobe_prepare(look, LMB_LOBE_TUNED, material->shininess, 0);
    look->model = (uint8_t)model;
    look->step = (uint8_t)step;
    look->lights = (uint8_t)light_count;
    fold(look->ambient_q15, &material->ambient, NULL);
    for (i = 0; i < lmb_look_lights(look) && error == LMB_OK; i++) error = light_prepare(&look->light[i], material, &lights[i]);
    if (error == LMB_OK) lmb_look_tolerance(look, LMB_TOLERANCE_RGB888);
    return error;
}

/* What a ramp holds at v = 1 - N.H, UQ1.15: the power itself, or the lobe of paper 000 where that was asked for. */
static int32_t ramp_value(const lmb_look *look, int32_t v_q30)
{
    if (LMB_WITH_LOBES && look->lobe.error_uq16 == 65535) return lmb_lobe_eval(&look->lobe, v_q30);
    return lmb_power_q15(look->lobe.shininess, v_q30);
}

/* The largest v = 1 - N.H in Q2.30 at which the highlight times strength, both UQ1.15, is above what is tolerated, or just under
 * it: bit by bit, as it never grows with v. */
static int32_t quiet_from(const lmb_look *look, int32_t strength_q15, bool ramp)
{
    const int32_t tolerated_q30 = lmb_shl(look->tolerance, 14);
    int32_t v_q30 = 0, bit;
    for (bit = (int32_t)1 << 30; bit >= 4096; bit >>= 1) {
        const int32_t v = lmb_add(v_q30, bit),
                      value = LMB_WITH_LOBES && !ramp ? lmb_lobe_eval(&look->lobe, v) : ramp_value(look, v);
        if (lmb_mul(value, strength_q15) > tolerated_q30) v_q30 = v;
    }
    return v_q30;
}

static int32_t largest(const uint16_t channel[3]) { return lmb_max(lmb_max(channel[0], channel[1]), channel[2]); }

/* The line of s, from where the highlight ends. */
static void line_of_lobe(struct lmb_look_light *light, const lmb_lobe *lobe)
{
    light->dark_q16 = lmb_lobe_argument(lobe, light->quiet_q30);
    light->line.top_q30 = lmb_sub(lobe->alpha_q30, lmb_shl(light->dark_q16, 14));
    light->line.slope = lobe->slope;
    light->line.shift = lobe->slope_shift;
}

/* The line from one at the centre to zero at quiet; one over quiet = reciprocal 2^30 / 2^(31 + shift). */
static void line_of_ramp(struct lmb_look_light *light)
{
    unsigned shift;
    uint32_t reciprocal = lmb_reciprocal((uint32_t)light->quiet_q30, &shift);
    light->line.top_q30 = 0x40000000;
    light->line.slope = (uint16_t)(reciprocal >> 15);
    light->line.shift = (int8_t)(29 - (int)shift);
}

static void lines_set(lmb_look *look, bool ramp)
{
    unsigned i, shift;
    look->specular_on = 0;
    for (i = 0; i < lmb_look_lights(look); i++) {
        struct lmb_look_light *light = &look->light[i];
        /* tolerance over the diffuse strength, up to two: the reciprocal of a number below 2^16 + 1 */
        uint32_t reciprocal = lmb_reciprocal((uint32_t)largest(light->diffuse_q15) + 1, &shift);
        light->straight_q28 = lmb_shr(lmb_mul_q16(lmb_signed(reciprocal >> 1), look->tolerance), shift < 13 ? 0 : shift - 13);
        light->quiet_q30 = quiet_from(look, largest(light->specular_q15), ramp);
        if (LMB_WITH_LOBES && !ramp) {
            line_of_lobe(light, &look->lobe);
        } else {
            line_of_ramp(light);
        }
        if (light->quiet_q30 && look->model != LMB_MODEL_DIFFUSE) look->specular_on = (uint8_t)(look->specular_on | 1u << i);
    }
}

void lmb_look_tolerance(lmb_look *look, uint16_t tolerance)
{
    look->tolerance = tolerance;
    lines_set(look, false);
}

void lmb_look_ramp(lmb_look *look) { lines_set(look, true); }

int32_t lmb_look_ramp_at(const lmb_look *look, unsigned i, uint32_t argument_q30)
{
    int32_t rest_q15 = (int32_t)(argument_q30 < 0x40000000 ? (0x40000000 - argument_q30) >> 15 : 0);
    return ramp_value(look, lmb_mul_q15(look->light[i].quiet_q30, lmb_min(rest_q15, 32767)));
}

int lmb_look_lobe(lmb_look *look, enum lmb_lobe_kind kind, uint16_t tolerance)
{
    int error = lobe_prepare(look, kind, look->lobe.shininess, tolerance);
    if (error == LMB_OK) lines_set(look, false);
    return error;
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
