/* SPDX-License-Identifier: MIT */
/* From normals to terms: what light does at corners, over a triangle and along a span.
 *
 * Diffuse is f = N.L. The highlight runs on v = 1 - N.H, taken as half a squared distance: normals rounded to Q2.14 are not quite
 * unit, and in that form their length costs v a relative 2^-14 instead of an absolute one, which n would multiply. The lobe's own
 * argument s = alpha - slope v is affine in v, so the planes carry s and the pixel only squares (paper 000; paper 001, eq. 13).
 *
 * Quadratics pass through the mid-edge values of the normalised mean normal M = P (Na + Nb) / 2, P = 1 / sqrt(1 - u/2), u = 1 -
 * Na.Nb (DESIGN, after Bishop & Weimer 1986), so the bulge of f is (P - 1) (fa + fb) / 2 and that of v is (P - 1) ((va + vb) /
 * 2 - 1): no mid normal is built.
 */
#include "shade.h"

#include "step.h"
#include "vec.h"

#define ONE_Q28 0x10000000

/* P - 1 = 1 / sqrt(1 - u/2) - 1, Q4.28. For u up to 1/4 (41 degrees) u/4 (1 + 3/8 u + 5/32 u^2 + 35/512 u^3), Taylor's series,
 * short of the truth by at most 1.3e-4 of it; above by reciprocal square root. u beyond LMB_ARC_U_MAX counts as that. */
static int32_t bulge_factor_q28(int32_t u_q28)
{
    if (u_q28 <= ONE_Q28 / 4) {
        int32_t u_q16 = lmb_shr(u_q28, 12); /* at most 2^14, so products stay under 2^29 */
        int32_t h_q16 = lmb_add(10240, lmb_shr(lmb_mul(u_q16, 4480), 16));
        h_q16 = lmb_add(24576, lmb_shr(lmb_mul(u_q16, h_q16), 16));
        h_q16 = lmb_shr(lmb_mul(u_q16, h_q16), 16);
        return lmb_add(lmb_shr(u_q28, 2), lmb_mul_q16(lmb_shr(u_q28, 2), (uint32_t)h_q16));
    }
    u_q28 = lmb_min(u_q28, LMB_ARC_U_MAX);
    return lmb_shr((int32_t)(lmb_rsqrt_q30(((uint32_t)1 << 30) - ((uint32_t)u_q28 << 1)) - ((uint32_t)1 << 30)), 2);
}

/* a Q4.28 value times another in [-1, 1] of which 15 bits matter. */
static int32_t times_q28(int32_t a, int32_t b_q28) { return lmb_mul_q15(a, lmb_min(lmb_shr(b_q28, 13), 32767)); }

/* The bulges of a net from the bulge factors of its edges; mean - pull is what bulges. Edge i goes from corner i to the next. */
static void net_bulge(lmb_net *net, const int32_t factor[3], int32_t pull)
{
    unsigned i = 2, next;
    for (next = 0; next < 3; i = next++) {
        int32_t mean = lmb_shr(lmb_add(net->value[i], net->value[next]), 1);
        net->bulge[i] = times_q28(factor[i], lmb_sub(mean, pull));
    }
}

/* The greatest control value of a net: the function stays below it. */
static int32_t net_high(const lmb_net *net)
{
    int32_t high = INT32_MIN;
    unsigned i = 2, next;
    for (next = 0; next < 3; i = next++) {
        int32_t mean = lmb_shr(lmb_add(net->value[i], net->value[next]), 1);
        high = lmb_max(high, lmb_max(net->value[i], lmb_add(mean, lmb_shl(net->bulge[i], 1))));
    }
    return high;
}

/* x times slope, UQ0.16, over 2^down. */
static int32_t scaled(int32_t x, uint32_t slope_q16, int32_t down)
{
    int32_t product = lmb_mul_q16(x, slope_q16);
    return down >= 0 ? lmb_shr(product, (unsigned)down) : lmb_shl(product, (unsigned)-down);
}

/* Turns a net of v into one of s / 2^exponent, s = alpha - slope v, with the exponent that keeps it inside (-2, 2). Returns the
 * value up to which the lobe is zero. */
static int32_t net_argument(lmb_net *net, const lmb_lobe *lobe, uint8_t *exponent)
{
    /* slope v = product * 2^(slope_shift + 1) must stay under 2, 2^29 */
    int32_t up = lobe->slope_shift + 1, most = lmb_mul_q16(lmb_max(net_high(net), 0), lobe->slope), down, alpha;
    unsigned e = (unsigned)lmb_max((int32_t)(32u - lmb_clz32((uint32_t)most)) + up - 29, 0), i;
    *exponent = (uint8_t)e;
    down = (int32_t)e - up;
    alpha = lmb_shr(lobe->alpha_q30, e + 2);
    for (i = 0; i < 3; i++) {
        net->value[i] = lmb_sub(alpha, scaled(net->value[i], lobe->slope, down));
        net->bulge[i] = lmb_sub(0, scaled(net->bulge[i], lobe->slope, down));
    }
    return lmb_shr(lmb_shl(lobe->floor_q15, 13), e);
}

static void dots_q28(int32_t out[3], const lmb_vertex *const corner[3], const lmb_vec *ray)
{
    unsigned i;
    for (i = 0; i < 3; i++) out[i] = lmb_vec_dot_q28(&corner[i]->normal, ray);
}

static void distances_q28(int32_t out[3], const lmb_vertex *const corner[3], const lmb_vec *ray)
{
    unsigned i;
    for (i = 0; i < 3; i++) out[i] = lmb_vec_half_distance_q28(&corner[i]->normal, ray);
}

/* Begins a plane unless it stays at or below zero; returns bit i if it does not. */
static uint8_t plane_begin(lmb_plane plane[], unsigned i, const lmb_lattice *lattice, const lmb_net *net, int32_t zero)
{
    if (net_high(net) <= zero) return 0;
    lmb_plane_begin(&plane[i], lattice, net);
    return (uint8_t)(1u << i);
}

/* Diffuse and gloss by linear or quadratic planes. */
static void shade_planes(lmb_triangle *t, const lmb_lattice *lattice, const lmb_vertex *const corner[3])
{
    int32_t factor[3] = {0, 0, 0};
    lmb_net net;
    unsigned i = 2, next;
    for (next = 0; next < 3 && lattice->curved; i = next++) {
        factor[i] = bulge_factor_q28(lmb_vec_half_distance_q28(&corner[i]->normal, &corner[next]->normal));
    }
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        dots_q28(net.value, corner, &t->rays->light[i].direction);
        net_bulge(&net, factor, 0);
        t->diffuse_on |= plane_begin(t->u.plane.diffuse, i, lattice, &net, 0);
        if (!lmb_bit(t->look->specular_on, i)) continue;
        distances_q28(net.value, corner, &t->rays->light[i].half);
        net_bulge(&net, factor, ONE_Q28);
        t->specular_on |= plane_begin(t->u.plane.specular, i, lattice, &net, net_argument(&net, &t->look->lobe, &t->exponent[i]));
    }
}

/* What the lobe returns at v, Q4.28. */
static int32_t lobe_q28(const lmb_lobe *lobe, int32_t v_q28)
{
    return lmb_shl(lmb_lobe_eval(lobe, lmb_shl(lmb_min(v_q28, 2 * ONE_Q28 - 1), 2)), 13);
}

/* Gouraud: both terms lit at the corners, linear between. */
static void shade_corners(lmb_triangle *t, const lmb_lattice *lattice, const lmb_vertex *const corner[3])
{
    lmb_net net = {{0, 0, 0}, {0, 0, 0}};
    unsigned i, k;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        dots_q28(net.value, corner, &t->rays->light[i].direction);
        for (k = 0; k < 3; k++) net.value[k] = lmb_max(net.value[k], 0);
        t->diffuse_on |= plane_begin(t->u.plane.diffuse, i, lattice, &net, 0);
        if (!lmb_bit(t->look->specular_on, i)) continue;
        distances_q28(net.value, corner, &t->rays->light[i].half);
        for (k = 0; k < 3; k++) net.value[k] = lobe_q28(&t->look->lobe, net.value[k]);
        t->specular_on |= plane_begin(t->u.plane.specular, i, lattice, &net, 0);
    }
}

/* Flat: one normal for the triangle, the normalised sum of its three. */
static void shade_face(lmb_triangle *t, const lmb_vertex *const corner[3])
{
    const lmb_vec a = corner[0]->normal, b = corner[1]->normal, c = corner[2]->normal;
    lmb_vec n = lmb_normalise(lmb_add(lmb_add(a.x, b.x), c.x), lmb_add(lmb_add(a.y, b.y), c.y), lmb_add(lmb_add(a.z, b.z), c.z));
    unsigned i;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        int32_t value = lmb_dot_q28(n, t->rays->light[i].direction);
        if (value > 0) {
            t->diffuse_on |= (uint8_t)(1u << i);
            t->u.plane.diffuse[i].f = lmb_shl(value, 2);
        }
        if (!lmb_bit(t->look->specular_on, i)) continue;
        value = lobe_q28(&t->look->lobe, lmb_half_distance_q28(n, t->rays->light[i].half));
        if (value > 0) {
            t->specular_on |= (uint8_t)(1u << i);
            t->u.plane.specular[i].f = lmb_shl(value, 2);
        }
    }
}

void lmb_shade_begin(lmb_triangle *t, const lmb_lattice *lattice, const lmb_vertex *const corner[3])
{
    t->diffuse_on = t->specular_on = 0;
    t->kind = LMB_SPAN_PLANE;
    if (LMB_WITH_CORNERS && t->look->model == LMB_MODEL_FLAT) {
        t->kind = LMB_SPAN_FLAT;
        shade_face(t, corner);
    } else if (LMB_WITH_CORNERS && t->look->model == LMB_MODEL_GOURAUD) {
        shade_corners(t, lattice, corner);
    } else if (LMB_WITH_ARC && t->look->step == LMB_STEP_ARC) {
        t->kind = LMB_SPAN_ARC;
        t->diffuse_on = (uint8_t)((1u << t->look->lights) - 1u);
        t->specular_on = t->look->specular_on;
    } else {
        shade_planes(t, lattice, corner);
    }
}

void lmb_shade_arc(const lmb_triangle *t, lmb_span *span, lmb_vec from, lmb_vec to, uint32_t length, uint32_t start)
{
    /* s = slope f + (alpha - slope), both parts over 2^exponent; slope < 2^(slope_shift + 1), so s is in (-2, 2) then */
    const lmb_lobe *lobe = &t->look->lobe;
    int32_t above = lobe->slope_shift + 1, exponent = lmb_max(above, 0);
    uint32_t scale_q16 = (uint32_t)lobe->slope >> (exponent - above);
    unsigned i;
    lmb_arc_between(&span->arc, from, to, length, start);
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        lmb_arc_dot(&span->arc, &span->diffuse[i], from, to, t->rays->light[i].direction, 65536);
        if (!lmb_bit(t->specular_on, i)) continue;
        lmb_arc_dot(&span->arc, &span->specular[i], from, to, t->rays->light[i].half, scale_q16);
        span->specular[i].c = lmb_sub(lmb_shr(lobe->alpha_q30, (unsigned)exponent), (int32_t)(scale_q16 << 14));
        span->exponent[i] = (uint8_t)exponent;
    }
}
