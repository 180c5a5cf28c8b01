/* SPDX-License-Identifier: MIT */
/* Which way of a term is good enough, by how strongly a triangle is bent.
 *
 * A triangle's bend is p = P - 1 = 1 / cos(psi / 2) - 1, psi the largest angle between two of its normals: at least psi^2 / 8. Against
 * arcs, with amplitudes of one, for psi up to 77 degrees and n from 1 to 1000 (docs/NUMERICS.md, Plans):
 *
 *              constant             linear      quadratic
 *     N.L      range / 2 + 4/3 p    4/3 p       0.372 p^(3/2) + 0.22 p^2
 *     (N.H)^n  n times that         4/3 n p     a sqrt(n) p^(3/2) + b n p^2, a from 0.372 to 0.228, b from 0.22 to 0.595
 *
 * Twice the look's tolerance, e, is what all of it may err: half a level, as paints set it. Lights share it. With x, y and l for what
 * N.L, the highlight's way and a lobe cheaper than the best take, that is
 *
 *     x + y + l <= 2 e          where the highlight shows,
 *     x + rho y + l + e <= 2 e  where it ends: there e is left out (look.c), but highlights are less steep by rho,
 *     x + l + e <= 2 e          and where it does not show.
 *
 * With z = sqrt(p) quadratic bounds are A z^3 + B z^4, and the largest z that keeps them is found bit by bit.
 */
#include "plan.h"

#if LMB_WITH_PLANS

#define BEND_MAX_Q28 0x4700000 /* 0.277: 77 degrees */
#define NEVER INT32_MAX
#define LOBE_BEST_UQ16 69 /* what the best ones promise, over all n: just above LMB_LOBE_MAX_ERROR */

/* An error over a strength, UQ0.16, at most one. */
static uint32_t share_q16(int32_t error_q16, int32_t strength_q15)
{
    unsigned shift;
    uint32_t reciprocal; /* 2^(31 + shift) / s, s at least what makes the quotient one */
    reciprocal = lmb_reciprocal((uint32_t)lmb_max(strength_q15, lmb_add(lmb_shr(error_q16, 1), 1)), &shift);
    return (uint32_t)lmb_min((int32_t)(lmb_mulu(reciprocal >> 16, (uint32_t)error_q16) >> shift), 65535);
}

/* 0.69 share / n, which is 3/4 less what arithmetic adds: the largest p with 4/3 n p <= share. Twice that is what range + 3 p may be
 * where the term is constant. */
static int32_t straight_q28(uint32_t share, unsigned n)
{
    unsigned shift;
    const uint32_t reciprocal = lmb_reciprocal(n, &shift);
    return (int32_t)((lmb_mulu(share, 11) >> 4) * (reciprocal >> 19) >> shift);
}

static int32_t largest(const uint16_t channel[3]) { return lmb_max(lmb_max(channel[0], channel[1]), channel[2]); }

/* What a light may err, Q16: how much of the tolerance is left to N.L, the highlight's way while N.L is linear, and what rho is. */
typedef struct budget {
    int32_t left, straight, gloss;
    uint32_t rho_q16;
} budget;

/* How much less steep the highlight is where it ends, at h of its strength, than it is at most, rounded up: n c^(n-1) sqrt(1 - c^2) at
 * c^n = h over that at c^2 = 1 - 1/n. From n = 4 on below 6 h + 0.04. */
static uint32_t end_slope_q16(uint32_t h_q16, unsigned n) { return n < 4 || h_q16 > 10000 ? 65535 : 6 * h_q16 + 2621; }

static budget budget_of(const lmb_look *look, const struct lmb_look_light *light, bool ramp)
{
    const int32_t e = lmb_light_tolerance(look), strength_q15 = largest(light->specular_q15);
    const uint32_t h_q16 = share_q16(e, strength_q15);
    const bool shows = look->model == LMB_MODEL_GLOSS && h_q16 < 65535;
    const bool cheap = !ramp && !look->lobe.fixed && look->lobe.error_uq16 > LOBE_BEST_UQ16;
    budget of;
    of.rho_q16 = shows ? end_slope_q16(h_q16, look->lobe.shininess) : 0;
    of.left = cheap ? lmb_sub(e, lmb_shr(lmb_mul(look->lobe.error_uq16, strength_q15), 15)) : e;
    of.left = lmb_max(of.left, 0);
    of.gloss = lmb_sub(e, lmb_shr(lmb_mul_q16(e, of.rho_q16), 1));
    of.straight = lmb_max(lmb_sub(of.left, lmb_mul_q16(of.gloss, of.rho_q16)), 0);
    return of;
}

#if LMB_WITH_ARC

/* A bound A z^3 + B z^4, Q16. */
typedef struct bound {
    uint32_t a_q16, b_q16;
} bound;

/* Whether a bound is within e at z, below 0.53; every product is rounded up, and the sum, up to 330, has 16 bits at least. */
static bool is_within(const bound *to, uint32_t z_q16, int32_t e_q31)
{
    const int32_t square_q31 = lmb_add((int32_t)(lmb_mulu(z_q16, z_q16) >> 1), 1);
    const int32_t cube_q31 = lmb_add(lmb_mul_q16(square_q31, z_q16), 1);
    uint32_t sum = to->a_q16 + (uint32_t)lmb_mul_q16((int32_t)to->b_q16, z_q16) + 1;
    unsigned down = 0;
    for (; sum > 65534; sum >>= 1) down++;
    return lmb_mul_q16(cube_q31, sum + 1) < lmb_shr(e_q31, down);
}

/* The largest p up to BEND_MAX that is within e. */
static int32_t curved_q28(const bound *to, int32_t e_q16)
{
    uint32_t z_q16 = 0, bit;
    for (bit = 0x8000; bit > 0; bit >>= 1) {
        if (z_q16 + bit < 34600 && is_within(to, z_q16 + bit, lmb_shl(lmb_min(e_q16, 65535), 15))) z_q16 += bit;
    }
    return lmb_min((int32_t)(lmb_mulu(z_q16, z_q16) >> 4), BEND_MAX_Q28);
}

/* sqrt(n), Q11, rounded up. */
static uint32_t root_q11(unsigned n)
{
    uint32_t root = 0, bit;
    for (bit = 0x8000; bit > 0; bit >>= 1) {
        if (lmb_mulu(root + bit, root + bit) <= (uint32_t)n << 22) root += bit;
    }
    return root + 1;
}

/* The bounds above times a strength. */
static bound diffuse_bound(int32_t strength_q15)
{
    bound to;
    to.a_q16 = lmb_mulu((uint32_t)strength_q15, 381) >> 9; /* 0.372 */
    to.b_q16 = lmb_mulu((uint32_t)strength_q15, 113) >> 8; /* 0.22 */
    return to;
}

static bound gloss_bound(int32_t strength_q15, unsigned n)
{
    const uint32_t strength = (uint32_t)strength_q15;
    const uint32_t a_q10 = n == 1 ? 381 : n < 4 ? 271 : n < 16 ? 248 : 234; /* 0.372, 0.264, 0.242, 0.228 */
    const uint32_t b_q10 = n == 1 ? 226 : n <= 16 ? 522 : 610;              /* 0.22, 0.51, 0.595 */
    bound to;
    to.a_q16 = lmb_mulu(lmb_mulu(strength, a_q10) >> 10, root_q11(n)) >> 10;
    to.b_q16 = lmb_mulu(lmb_mulu(strength, b_q10) >> 9, n);
    return to;
}

/* A bound and part of another. */
static bound sum_of(const bound *a, const bound *b, uint32_t part_q16)
{
    bound to;
    to.a_q16 = a->a_q16 + (uint32_t)lmb_mul_q16((int32_t)b->a_q16, part_q16) + 1;
    to.b_q16 = a->b_q16 + (uint32_t)lmb_mul_q16((int32_t)b->b_q16, part_q16) + 1;
    return to;
}

/* Bends beyond which arcs are wanted. What is linear takes its budget whole, so that it may be that only as far as a quadratic keeps to the
 * other's. */
static void plan_arcs(struct lmb_look_light *light, const lmb_look *look, const budget *of)
{
    struct lmb_plan *plan = &light->plan;
    const bound diffuse = diffuse_bound(largest(light->diffuse_q15));
    const bound gloss = gloss_bound(largest(light->specular_q15), look->lobe.shininess);
    const bound both = sum_of(&diffuse, &gloss, 65535), end = sum_of(&diffuse, &gloss, of->rho_q16);
    int32_t alone, together;
    plan->curved_q28 = LMB_WITH_QUADRATIC ? curved_q28(&diffuse, of->left) : light->straight_q28;
    plan->gloss_curved_q28 = plan->gloss_straight_q28;
    if (!LMB_WITH_QUADRATIC) return;
    plan->gloss_straight_q28 = lmb_min(plan->gloss_straight_q28, curved_q28(&diffuse, of->straight));
    alone = curved_q28(&gloss, of->gloss);
    together = lmb_min(curved_q28(&both, lmb_add(of->left, lmb_light_tolerance(look))), curved_q28(&end, of->left));
    plan->gloss_curved_q28 = together > light->straight_q28 ? together : lmb_min(together, alone);
    if (together > light->straight_q28) light->straight_q28 = lmb_min(light->straight_q28, alone);
}
#endif

void lmb_plan_light(const lmb_look *look, struct lmb_look_light *light, bool ramp)
{
    struct lmb_plan *plan = &light->plan;
    budget of;
    plan->level_q28 = plan->gloss_level_q28 = -1;
    plan->gloss_straight_q28 = 0;
    plan->curved_q28 = plan->gloss_curved_q28 = NEVER;
    if (!lmb_is_planned(look)) return;
    of = budget_of(look, light, ramp);
    light->straight_q28 = straight_q28(share_q16(of.straight, largest(light->diffuse_q15)), 1);
    plan->level_q28 = lmb_shl(light->straight_q28, 1);
    plan->gloss_straight_q28 = straight_q28(share_q16(of.gloss, largest(light->specular_q15)), look->lobe.shininess);
    plan->gloss_level_q28 = lmb_shl(plan->gloss_straight_q28, 1);
#if LMB_WITH_ARC
    plan_arcs(light, look, &of);
#endif
}

/* A quarter of what a light may err: a lobe that takes more is not worth it. */
uint16_t lmb_plan_lobe(const lmb_look *look)
{
    int32_t strongest = 0;
    unsigned i;
    for (i = 0; i < lmb_look_lights(look); i++) strongest = lmb_max(strongest, largest(look->light[i].specular_q15));
    return (uint16_t)share_q16(lmb_light_tolerance(look) >> 1, strongest);
}

#else
typedef int lmb_no_plan; /* a translation unit needs a declaration */
#endif
