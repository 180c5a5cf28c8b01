/* SPDX-License-Identifier: MIT */
/* Look: material and lights folded together, half vectors, rays in the space of the normals. */
#include "look.h"
#include "plan.h"
#include "shade.h"
#include "vec.h"

/* The product of two UQ0.8 colours as UQ1.15: a b 32768 / 255^2, rounded to nearest. 0x81018203 is 2^47 / 255^2, rounded up;
 * its two halves keep products within 32 bits: 255^2 0x8101 < 2^31. */
static uint16_t product_q15(uint32_t a, uint32_t b)
{
    uint32_t product = lmb_mulu(a, b);
    return (uint16_t)((lmb_mulu(product, 0x8101) + (lmb_mulu(product, 0x8203) >> 16) + 0x8000u) >> 16);
}

LMB_STATIC_ASSERT(sizeof(lmb_rgb) == 3); /* so colours can be taken as three bytes */
void lmb_colour_fold(uint16_t out[3], const lmb_rgb *material, const lmb_rgb *light)
{
    const uint8_t *m = (const uint8_t *)material, *l = (const uint8_t *)light;
    unsigned i;
    for (i = 0; i < 3; i++) out[i] = product_q15(m[i], l ? l[i] : 255);
}

/* False for no unit vector. A length is the dot product with the unit vector along it, Q4.28; 0.9492 to 1.0508 are taken. */
static bool light_prepare(struct lmb_look_light *to, const lmb_material *material, const lmb_light *light)
{
    const lmb_vec *d = &light->direction, *unit = &to->direction;
    lmb_vec_normalise(&to->direction, d->x, d->y, d->z);
    if ((uint32_t)lmb_sub(lmb_shr(lmb_vec_dot_q28(d, unit), 20), 243) > 268 - 243) return false;
    lmb_vec_normalise(&to->half, unit->x, unit->y, lmb_add(unit->z, 16384)); /* the viewer is along +z */
    lmb_colour_fold(to->diffuse_q15, &material->diffuse, &light->colour);
    lmb_colour_fold(to->specular_q15, &material->specular, &light->colour);
    return true;
}

/* The lobe of a look: without lobes its exponent alone. */
static int lobe_prepare(lmb_look *look, enum lmb_lobe_kind kind, unsigned n, uint16_t tolerance)
{
    if (LMB_WITH_LOBES) return lmb_lobe_prepare(&look->lobe, kind, n, tolerance);
    look->lobe.shininess = (uint16_t)n;
    return kind != LMB_LOBE_TUNED || n - 1 >= LMB_SHININESS_MAX ? LMB_ERROR_VALUE : LMB_OK;
}

/* What is built in: first and last, and what lies between. */
#define MODEL_FIRST (LMB_WITH_CORNERS ? LMB_MODEL_FLAT : LMB_WITH_DIFFUSE ? LMB_MODEL_DIFFUSE : LMB_MODEL_GLOSS)
#define MODEL_LAST                                                                                                               \
    (LMB_WITH_GLOSS     ? LMB_MODEL_GLOSS                                                                                        \
     : LMB_WITH_DIFFUSE ? LMB_MODEL_DIFFUSE                                                                                      \
     : LMB_WITH_GOURAUD ? LMB_MODEL_GOURAUD                                                                                      \
                        : LMB_MODEL_FLAT)
#define STEP_LAST                                                                                                                \
    (LMB_WITH_PLANS ? LMB_STEP_PLANNED : LMB_WITH_ARC ? LMB_STEP_ARC : LMB_WITH_QUADRATIC ? LMB_STEP_QUADRATIC : LMB_STEP_LINEAR)

static bool is_built_in(enum lmb_model model, enum lmb_step_kind step)
{
    if ((unsigned)model - MODEL_FIRST > (unsigned)MODEL_LAST - MODEL_FIRST || (unsigned)step > STEP_LAST) return false;
    if (!LMB_WITH_GOURAUD && model == LMB_MODEL_GOURAUD) return false;
    if (!LMB_WITH_DIFFUSE && model == LMB_MODEL_DIFFUSE) return false;
    return !((!LMB_WITH_QUADRATIC && step == LMB_STEP_QUADRATIC) || (!LMB_WITH_ARC && step == LMB_STEP_ARC));
}

int lmb_look_prepare(lmb_look *look, const lmb_material *material, const lmb_light *lights, unsigned light_count,
                     enum lmb_model model, enum lmb_step_kind step)
{
    unsigned i;
    if (light_count - 1 >= LMB_LIGHTS) return LMB_ERROR_LIGHTS;
    if (!is_built_in(model, step)) return LMB_ERROR_VALUE;
    if (lobe_prepare(look, LMB_LOBE_TUNED, material->shininess, 0)) return LMB_ERROR_VALUE;
    look->model = (uint8_t)model;
    look->step = (uint8_t)step;
    look->lobe.fixed = false;
    look->lights = (uint8_t)light_count;
    lmb_colour_fold(look->ambient_q15, &material->ambient, NULL);
    for (i = 0; i < lmb_look_lights(look); i++) {
        if (!light_prepare(&look->light[i], material, &lights[i])) return LMB_ERROR_VALUE;
    }
    lmb_look_tolerance(look, LMB_TOLERANCE_RGB888);
    return LMB_OK;
}

/* The largest v = 1 - N.H in Q2.30 at which the highlight times strength, both UQ1.15, is above what is tolerated, or just under
 * it: bit by bit, as it never grows with v. */
static int32_t quiet_from(const lmb_look *look, int32_t strength_q15, bool ramp)
{
    int32_t v = 0;
    unsigned bit;
    for (bit = 30; bit >= 12; bit--) {
        int32_t value;
        v = lmb_add(v, (int32_t)1 << bit);
        value = LMB_WITH_LOBES && !ramp ? lmb_lobe_eval(&look->lobe, v) : lmb_highlight_q15(look, v);
        if (lmb_mul(value, strength_q15) <= lmb_shl(lmb_light_tolerance(look), 14)) v = lmb_sub(v, (int32_t)1 << bit);
    }
    return v;
}

static LMB_OUTLINE int32_t largest(const uint16_t channel[3]) { return lmb_max(lmb_max(channel[0], channel[1]), channel[2]); }

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

/* The bend up to which linear N.L is good enough, Q28: tolerance over the diffuse strength. Strengths below a quarter are
 * doubled until they are not: four times the tolerance is enough. */
static int32_t straight_up_to(uint16_t tolerance, int32_t strength_q15)
{
    unsigned shift;
    const uint32_t reciprocal = lmb_reciprocal((uint32_t)strength_q15 + 1, &shift);
    return (int32_t)(lmb_mulu(reciprocal >> 17, tolerance) >> (shift < 13 ? 0 : shift - 13));
}

/* What the tolerance makes of a light; true if it leaves a highlight. */
static bool light_set(const lmb_look *look, struct lmb_look_light *light, bool ramp)
{
    light->straight_q28 = straight_up_to(look->tolerance, largest(light->diffuse_q15));
    lmb_plan_light(look, light, ramp || !LMB_WITH_LOBES);
    if (!LMB_WITH_GLOSS && !LMB_WITH_CORNERS) return false;
    light->quiet_q30 = quiet_from(look, largest(light->specular_q15), ramp);
    if (LMB_WITH_LOBES && !ramp) {
        line_of_lobe(light, &look->lobe);
    } else {
        line_of_ramp(light);
    }
    return look->model != LMB_MODEL_DIFFUSE && light->quiet_q30;
}

static void lights_set(lmb_look *look, bool ramp)
{
    unsigned i, on = 0;
    for (i = 0; i < lmb_look_lights(look); i++) on |= (unsigned)light_set(look, &look->light[i], ramp) << i;
    look->specular_on = (uint8_t)on;
}

void lmb_look_tolerance(lmb_look *look, uint16_t tolerance)
{
    look->tolerance = tolerance;
    if (LMB_WITH_LOBES && lmb_is_planned(look) && !look->lobe.fixed)
        (void)lmb_lobe_prepare(&look->lobe, LMB_LOBE_TUNED, look->lobe.shininess, lmb_plan_lobe(look));
    lights_set(look, false);
}

void lmb_look_ramp(lmb_look *look)
{
    if (LMB_WITH_LOBES) lights_set(look, true); /* without lobes lines are those of ramps anyway */
}

int32_t lmb_look_ramp_at(const lmb_look *look, unsigned i, uint32_t argument_q30)
{
    int32_t rest_q15 = (int32_t)(argument_q30 < 0x40000000 ? (0x40000000 - argument_q30) >> 15 : 0);
    return lmb_highlight_q15(look, lmb_mul_q15(look->light[i].quiet_q30, lmb_min(rest_q15, 32767)));
}

int lmb_look_lobe(lmb_look *look, enum lmb_lobe_kind kind, uint16_t tolerance)
{
    int error = lobe_prepare(look, kind, look->lobe.shininess, tolerance);
    if (error) return error;
    look->lobe.fixed = true;
    lmb_look_tolerance(look, look->tolerance);
    return LMB_OK;
}

#if LMB_WITH_ARC
/* The highlight's beam is slope (N.H), over 2^exponent; slope < 2^(shift + 1), so that the argument is in (-2, 2) then. */
static void beams_prepare(struct lmb_ray *ray, const lmb_line *line)
{
    const int32_t above = line->shift + 1, exponent = lmb_max(above, 0);
    lmb_beam_prepare(&ray->diffuse, ray->direction, 65536);
    lmb_beam_prepare(&ray->specular, ray->half, (uint32_t)line->slope >> (exponent - above));
    ray->offset_q30 = lmb_sub(lmb_shr(line->top_q30, (unsigned)exponent), ray->specular.peak_q30);
    ray->exponent = (uint8_t)exponent;
}
#endif

void lmb_rays_prepare(lmb_rays *rays, const lmb_look *look, const lmb_matrix *rotation)
{
    unsigned i;
    rays->bend_q28 = LMB_BEND_UNKNOWN;
    rays->far_q28 = INT32_MAX;
    for (i = 0; i < lmb_look_lights(look); i++) {
        struct lmb_ray *ray = &rays->light[i];
        lmb_vec_copy(&ray->direction, &look->light[i].direction);
        lmb_vec_copy(&ray->half, &look->light[i].half);
        if (rotation) {
            lmb_vec_rotate_back(rotation, &ray->direction);
            lmb_vec_rotate_back(rotation, &ray->half);
        }
#if LMB_WITH_ARC
        if (look->step >= LMB_STEP_ARC) beams_prepare(ray, &look->light[i].line);
        ray->shines = lmb_bit(look->specular_on, i);
#endif
    }
#if LMB_WITH_ARC
    rays->arcs = lmb_is_planned(look);
    rays->curve_q28 = lmb_curve_limit_q28(look->lobe.shininess);
    rays->rough = look->tolerance >= LMB_TOLERANCE_RGB565 && look->lobe.shininess <= LMB_CURVE_ROUGH_SHININESS;
#endif
}
