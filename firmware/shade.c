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

#include "plan.h"
#include "power.h"
#include "step.h"
#include "vec.h"

#define ONE_Q28 0x10000000

/* P - 1 = 1 / sqrt(1 - u/2) - 1, Q4.28, by Taylor's series u/4 + 3/32 u^2 + 5/128 u^3 + 35/2048 u^4: two terms for u up to 1/16 (20
 * degrees), four up to 1/4 (41 degrees), short of the truth by at most 6.2e-4 and 1.3e-4 of it; above by reciprocal square root. u
 * beyond LMB_ARC_U_MAX counts as that. Without the exact planes the series serves up to 3/4, where it is
 * BULGE_MAX. */
#define BULGE_MAX (ONE_Q28 / 4)
static int32_t bulge_factor_q28(int32_t u_q28)
{
    const int32_t most = LMB_WITH_LARGE ? ONE_Q28 / 4 : ONE_Q28 / 4 * 3;
    int32_t u_q15, square_q30, factor;
    if (u_q28 > most && LMB_WITH_LARGE) {
        u_q28 = lmb_min(u_q28, LMB_ARC_U_MAX);
        return lmb_shr((int32_t)(lmb_rsqrt_q30(((uint32_t)1 << 30) - ((uint32_t)u_q28 << 1)) - ((uint32_t)1 << 30)), 2);
    }
    u_q28 = lmb_min(u_q28, most);
    u_q15 = lmb_shr(u_q28, 13);
    square_q30 = lmb_mul(u_q15, u_q15);
    factor = lmb_add(lmb_shr(u_q28, 2), lmb_shr(lmb_mul(square_q30, 3), 7));
    if (u_q28 > ONE_Q28 / 16) {
        int32_t cube_q30 = lmb_mul(lmb_shr(square_q30, 15), u_q15);
        factor = lmb_add(factor, lmb_shr(lmb_mul(lmb_shr(cube_q30, 15), lmb_add(81920, lmb_mul(u_q15, 35) >> 5)), 8));
    }
    return LMB_WITH_LARGE ? factor : lmb_min(factor, BULGE_MAX);
}

/* a Q4.28 value times another in [-1, 1] of which 15 bits matter. */
static int32_t times_q28(int32_t a, int32_t b_q28) { return lmb_mul_q15(a, lmb_min(lmb_shr(b_q28, 13), 32767)); }

/* The bulges of the edges of a triangle: factors, and the largest, or what none of a mesh exceeds until they are set. */
typedef struct bend {
    int32_t factor[3], most;
    bool set;
} bend;

/* lmb_half_distance_q28, in line. */
static LMB_OUTLINE_OR_INLINE int32_t distance_q28(const lmb_vec *a, const lmb_vec *b)
{
    const int32_t x = lmb_sub(a->x, b->x), y = lmb_sub(a->y, b->y), z = lmb_sub(a->z, b->z);
    return lmb_shr(lmb_add(lmb_add(lmb_mul(x, x), lmb_mul(y, y)), lmb_mul(z, z)), 1);
}

static int32_t bend_of(const lmb_vertex *a, const lmb_vertex *b)
{
    return bulge_factor_q28(distance_q28(&a->normal, &b->normal));
}

/* The bends of a triangle's edges: from corner i to the next. */
static LMB_APART_IF_FEW void bends_set(bend *b, const lmb_vertex *const corner[3])
{
    b->set = true;
    b->factor[0] = bend_of(corner[0], corner[1]);
    b->factor[1] = bend_of(corner[1], corner[2]);
    b->factor[2] = bend_of(corner[2], corner[0]);
    b->most = lmb_max(lmb_max(b->factor[0], b->factor[1]), b->factor[2]);
}

static inline int32_t dot_q28(const lmb_vec *a, const lmb_vec *b)
{
    return lmb_add(lmb_add(lmb_mul16(a->x, b->x), lmb_mul16(a->y, b->y)), lmb_mul16(a->z, b->z));
}

/* N.R at the corners. */
static void dots_set(lmb_net *net, const lmb_vertex *const corner[3], const lmb_vec *ray)
{
    unsigned i;
    LMB_UNROLL
    for (i = 0; i < 3; i++) net->value[i] = dot_q28(&corner[i]->normal, ray);
}

/* 1 - N.R at the corners. */
static void distances_set(lmb_net *net, const lmb_vertex *const corner[3], const lmb_vec *ray)
{
    unsigned i;
    for (i = 0; i < 3; i++) net->value[i] = distance_q28(&corner[i]->normal, ray);
}

static void net_range(lmb_net *net)
{
    const int32_t *v = net->value;
    net->low = lmb_min(lmb_min(v[0], v[1]), v[2]);
    net->high = lmb_max(lmb_max(v[0], v[1]), v[2]);
}

/* Adds bulges, unless the triangle's own bends are within straight: what bulges on an edge is its mean less pull. Edge i goes from
 * corner i to the next. */
static LMB_APART void net_bend(lmb_net *net, const lmb_vertex *const corner[3], bend *b, int32_t straight_q28, int32_t pull)
{
    unsigned i, next = 1;
    if (!b->set) bends_set(b, corner);
    net->curved = b->most > straight_q28;
    if (!net->curved) return;
    LMB_UNROLL
    for (i = 0; i < 3; i++) {
        const int32_t mean = lmb_shr(lmb_add(net->value[i], net->value[next]), 1);
        const int32_t bulge = times_q28(b->factor[i], lmb_sub(mean, pull)), control = lmb_add(mean, lmb_shl(bulge, 1));
        net->bulge[i] = bulge;
        net->low = lmb_min(net->low, control);
        net->high = lmb_max(net->high, control);
        next = next == 2 ? 0 : next + 1;
    }
}

/* Makes a term constant that ranges, and bulges, by no more than level allows: the middle of its range. The triangle's own bends tell,
 * whatever is known of its mesh. */
static inline void net_level(lmb_net *net, const lmb_vertex *const corner[3], bend *b, int32_t level_q28)
{
    const int32_t range = lmb_sub(net->high, net->low);
    if (!LMB_WITH_PLANS || range > level_q28) return;
    if (!b->set) bends_set(b, corner);
    if (lmb_add(range, lmb_mul(b->most, 3)) > level_q28) return;
    net->high = net->low = lmb_shr(lmb_add(net->low, net->high), 1);
    net->value[0] = net->value[1] = net->value[2] = net->low;
}

/* x times slope, UQ0.16, over 2^down. */
static int32_t scaled(int32_t x, uint32_t slope_q16, int32_t down)
{
    int32_t product = lmb_mul_q16(x, slope_q16);
    return down >= 0 ? lmb_shr(product, (unsigned)down) : lmb_shl(product, (unsigned)-down);
}

/* Turns a net of v, none of it above high, into one of the argument / 2^exponent, top - slope v, with the exponent that keeps it
 * inside (-2, 2). Returns the exponent; net->low becomes what the argument does not pass. */
static LMB_APART unsigned net_argument(lmb_net *net, const lmb_line *line, int32_t high)
{
    /* slope v = product * 2^(shift + 1) must stay under 2, 2^29 */
    int32_t up = line->shift + 1, most = lmb_mul_q16(lmb_max(high, 0), line->slope), down, top;
    unsigned e = 0, i;
    if (up > 29 || most >> (29 - lmb_max(up, 0))) e = (unsigned)lmb_max((int32_t)(32u - lmb_clz32((uint32_t)most)) + up - 29, 0);
    down = (int32_t)e - up;
    top = lmb_shr(line->top_q30, e + 2);
    for (i = 0; i < 3; i++) {
        net->value[i] = lmb_sub(top, scaled(net->value[i], line->slope, down));
        if (net->curved) net->bulge[i] = lmb_sub(0, scaled(net->bulge[i], line->slope, down));
    }
    net->low = lmb_sub(top, scaled(net->low, line->slope, down));
    return e;
}

/* N.L of light i. Where all corners are unlit the triangle is: bulges have the sign of what bulges. */
static LMB_IN_LINE void shade_diffuse(lmb_triangle *t, lmb_lattice *lattice, unsigned i, bend *b)
{
    const struct lmb_look_light *light = &t->look->light[i];
    lmb_net net;
    dots_set(&net, lattice->corner, &t->rays->light[i].direction);
    net_range(&net);
    if (net.high <= 0) return;
    net.curved = false;
    if (LMB_WITH_QUADRATIC && b->most > light->straight_q28) net_bend(&net, lattice->corner, b, light->straight_q28, 0);
    if (!net.curved) net_level(&net, lattice->corner, b, lmb_plan_of(light)->level_q28);
    t->diffuse_on = (uint8_t)(t->diffuse_on | 1u << i);
    if (i == 0) {
        t->low = net.low;
        t->high = net.high;
    }
    lmb_plane_begin(&t->u.light[i].diffuse, lattice, &net);
}

/* The highlight's argument of light i. A triangle is dark if no control value reaches where the highlight begins to be seen; a
 * bulge is no deeper than its factor. */
static LMB_IN_LINE void shade_specular(lmb_triangle *t, lmb_lattice *lattice, unsigned i, bend *b)
{
    const struct lmb_look_light *light = &t->look->light[i];
    const int32_t quiet_q28 = lmb_shr(light->quiet_q30, 2), straight_q28 = lmb_plan_of(light)->gloss_straight_q28;
    lmb_net net;
    distances_set(&net, lattice->corner, &t->rays->light[i].half);
    net_range(&net);
    if (lmb_sub(net.low, lmb_shl(b->most, 1)) > quiet_q28) return;
    net.curved = false;
    if (LMB_WITH_QUADRATIC && b->most > straight_q28) net_bend(&net, lattice->corner, b, straight_q28, ONE_Q28);
    if (!net.curved) net_level(&net, lattice->corner, b, lmb_plan_of(light)->gloss_level_q28);
    if (net.low > quiet_q28) return;
    t->specular_on = (uint8_t)(t->specular_on | 1u << i);
    t->exponent[i] = (uint8_t)net_argument(&net, &light->line, lmb_max(net.high, lmb_shl(b->most, 3)));
    if (i == 0) t->gleam = net.low;
    lmb_plane_begin(&t->u.light[i].specular, lattice, &net);
}

/* Both terms of light i. */
static LMB_IN_LINE void shade_light(lmb_triangle *t, lmb_lattice *lattice, unsigned i, bend *b)
{
    shade_diffuse(t, lattice, i, b);
    if (!LMB_WITH_GLOSS || !lmb_bit(t->look->specular_on, i)) return;
    if (LMB_SHORT_CUTS && i == 0 && distance_q28(&lattice->corner[0]->normal, &t->rays->light[i].half) > t->rays->far_q28) return;
    shade_specular(t, lattice, i, b);
}

#if LMB_WITH_ARC
static void shade_arcs(lmb_triangle *t)
{
    t->kind = LMB_SPAN_ARC;
    t->diffuse_on = (uint8_t)((1u << t->look->lights) - 1u);
    t->specular_on = t->look->specular_on;
}
#else
#define shade_arcs(t) ((void)0)
#endif

/* ---------------------------------------------------------------------------------------------------------- what a plan chooses */

#if LMB_WITH_ARC && LMB_WITH_PLANS

/* Whether N.L of light i shows and is bent more than quadratics serve. */
static bool diffuse_wants_arcs(const lmb_triangle *t, const lmb_vertex *const corner[3], unsigned i, const bend *b)
{
    lmb_net net;
    if (b->most <= lmb_plan_of(&t->look->light[i])->curved_q28) return false;
    dots_set(&net, corner, &t->rays->light[i].direction);
    net_range(&net);
    return net.high > 0;
}

static bool specular_wants_arcs(const lmb_triangle *t, const lmb_vertex *const corner[3], unsigned i, const bend *b)
{
    const struct lmb_look_light *light = &t->look->light[i];
    lmb_net net;
    if (b->most <= lmb_plan_of(light)->gloss_curved_q28 || !lmb_bit(t->look->specular_on, i)) return false;
    distances_set(&net, corner, &t->rays->light[i].half);
    net_range(&net);
    return lmb_sub(net.low, lmb_shl(b->most, 1)) <= lmb_shr(light->quiet_q30, 2);
}

/* Whether some term does. What is known of the mesh may tell that none does. */
static bool wants_arcs(const lmb_triangle *t, const lmb_vertex *const corner[3], bend *b)
{
    unsigned i;
    if (!t->rays->arcs) return false;
    if (!b->set) bends_set(b, corner);
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        if (diffuse_wants_arcs(t, corner, i, b) || specular_wants_arcs(t, corner, i, b)) return true;
    }
    return false;
}

/* Whether a bend is more than quadratics serve for some term of a look. */
static bool may_want_arcs(const lmb_look *look, int32_t most_q28)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(look); i++) {
        const struct lmb_plan *plan = lmb_plan_of(&look->light[i]);
        if (most_q28 > plan->curved_q28 || (most_q28 > plan->gloss_curved_q28 && lmb_bit(look->specular_on, i))) return true;
    }
    return false;
}

/* Whether some term that is on would be quadratic. */
static bool wants_curves(const lmb_triangle *t, int32_t most_q28)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        const struct lmb_look_light *light = &t->look->light[i];
        if (lmb_bit(t->diffuse_on, i) && most_q28 > light->straight_q28) return true;
        if (lmb_bit(t->specular_on, i) && most_q28 > lmb_plan_of(light)->gloss_straight_q28) return true;
    }
    return false;
}

#else
#define wants_arcs(t, corner, b) false
#define wants_curves(t, most_q28) ((void)(most_q28), false)
#endif

#if LMB_WITH_PLANS

/* Whether all terms are constant. */
static bool is_level(const lmb_triangle *t)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        const lmb_plane *d = &t->u.light[i].diffuse, *s = &t->u.light[i].specular;
        if (lmb_bit(t->diffuse_on, i) && (d->dx | d->dy | d->bow | d->dxy | d->dyy)) return false;
        if (lmb_bit(t->specular_on, i) && (s->dx | s->dy | s->bow | s->dxy | s->dyy)) return false;
    }
    return true;
}

/* What terms that have been begun tell: one colour for all of the triangle, or that it is too thin for its planes to take curves. */
static void plan_end(lmb_triangle *t, const lmb_lattice *lattice, int32_t most_q28)
{
    if (is_level(t)) {
        t->kind = LMB_SPAN_FLAT;
    } else if (LMB_WITH_ARC && lattice->ready && lattice->flat && wants_curves(t, most_q28)) {
        shade_arcs(t);
    }
}

#else
#define plan_end(t, lattice, most_q28) ((void)0)
#endif

/* ------------------------------------------------------------------------------------------------------------------- triangles */

/* Diffuse and gloss by linear or quadratic planes. One light has code of its own. */
static void shade_planes(lmb_triangle *t, lmb_lattice *lattice, const lmb_vertex *const corner[3])
{
    const unsigned lights = lmb_look_lights(t->look);
    bend b;
    unsigned i;
    b.set = false;
    b.most = t->look->step == LMB_STEP_LINEAR || !(LMB_WITH_QUADRATIC || LMB_WITH_PLANS) ? 0 : t->rays->bend_q28;
    if (b.most == LMB_BEND_UNKNOWN) bends_set(&b, corner);
    if (wants_arcs(t, corner, &b)) {
        shade_arcs(t);
        return;
    }
    if (LMB_SHORT_CUTS && lights == 1) {
        shade_light(t, lattice, 0, &b);
    } else {
        for (i = 0; i < lights; i++) shade_light(t, lattice, i, &b);
    }
    if (lmb_is_planned(t->look)) plan_end(t, lattice, b.most);
}

/* With normals no farther apart than u, and a the v that a highlight must not come down to, v > a all over where that of a corner
 * exceeds (sqrt a + sqrt u)^2 <= 5/4 a + 5 u. u <= 4 (P - 1) and a = quiet + 2 (P - 1) (shade_specular): so 5/4 quiet + 22 1/2 (P - 1).
 * Normals that run linearly do not bulge, but turn as far. */
void lmb_shade_bend(lmb_rays *rays, const lmb_look *look, uint16_t bend_q15)
{
    const int32_t most = bulge_factor_q28(lmb_shl(bend_q15, 13)), quiet = lmb_shr(look->light[0].quiet_q30, 2);
    rays->bend_q28 = most;
#if LMB_WITH_ARC && LMB_WITH_PLANS
    rays->arcs = may_want_arcs(look, most);
#endif
    if (LMB_SHORT_CUTS && most < ONE_Q28 / 32) rays->far_q28 = lmb_add(lmb_add(quiet, lmb_shr(quiet, 2)), lmb_mul(most, 23));
}

/* What the lobe returns at v, Q4.28. */
static int32_t lobe_q28(const lmb_lobe *lobe, int32_t v_q28)
{
    const int32_t v_q30 = lmb_shl(lmb_min(v_q28, 2 * ONE_Q28 - 1), 2);
    return lmb_shl(LMB_WITH_LOBES ? lmb_lobe_eval(lobe, v_q30) : lmb_power_q15(lobe->shininess, v_q30), 13);
}

/* Begins a linear plane unless it is zero; returns bit i if it is not. */
static uint8_t corners_begin(lmb_plane *plane, unsigned i, lmb_lattice *lattice, const lmb_net *net)
{
    if (!(net->value[0] | net->value[1] | net->value[2])) return 0;
    lmb_plane_begin(plane, lattice, net);
    return (uint8_t)(1u << i);
}

/* Gouraud: both terms lit at the corners, linear between. */
static void shade_corners(lmb_triangle *t, lmb_lattice *lattice, const lmb_vertex *const corner[3])
{
    lmb_net net;
    unsigned i, k;
    net.curved = false;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        dots_set(&net, corner, &t->rays->light[i].direction);
        for (k = 0; k < 3; k++) net.value[k] = lmb_max(net.value[k], 0);
        t->diffuse_on = (uint8_t)(t->diffuse_on | corners_begin(&t->u.light[i].diffuse, i, lattice, &net));
        if (!lmb_bit(t->look->specular_on, i)) continue;
        distances_set(&net, corner, &t->rays->light[i].half);
        for (k = 0; k < 3; k++) net.value[k] = lobe_q28(&t->look->lobe, net.value[k]);
        t->specular_on = (uint8_t)(t->specular_on | corners_begin(&t->u.light[i].specular, i, lattice, &net));
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
            t->diffuse_on = (uint8_t)(t->diffuse_on | 1u << i);
            t->u.light[i].diffuse.f = lmb_shl(value, 2);
        }
        t->exponent[i] = 0;
        if (!lmb_bit(t->look->specular_on, i)) continue;
        value = lobe_q28(&t->look->lobe, lmb_half_distance_q28(n, t->rays->light[i].half));
        if (value > 0) {
            t->specular_on = (uint8_t)(t->specular_on | 1u << i);
            t->u.light[i].specular.f = lmb_shl(value, 2);
        }
    }
}

void lmb_shade_begin(lmb_triangle *t, lmb_lattice *lattice, const lmb_vertex *const corner[3])
{
    t->diffuse_on = t->specular_on = 0;
    t->kind = LMB_SPAN_PLANE;
    t->low = t->high = 0;
    lmb_lattice_begin(lattice, corner, t->look->tolerance);
    if (LMB_WITH_CORNERS && t->look->model == LMB_MODEL_FLAT) {
        t->kind = LMB_SPAN_FLAT;
        shade_face(t, corner);
    } else if (LMB_WITH_GOURAUD && t->look->model == LMB_MODEL_GOURAUD) {
        shade_corners(t, lattice, corner);
    } else if (LMB_WITH_ARC && t->look->step == LMB_STEP_ARC) {
        shade_arcs(t);
    } else if (LMB_WITH_PIXELS) {
        shade_planes(t, lattice, corner);
    }
}
