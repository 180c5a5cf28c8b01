/* SPDX-License-Identifier: MIT */
/* Set-up of arcs: normals that turn evenly over a run of pixels (paper 001), without arccos, sine, root or division.
 *
 * With psi the angle between the end normals, m pixels, phi = psi / m, a term that is a at the start and a + rise at the end is
 *     f(t) = a cos(t phi) + (rise + u a) sin(t phi) / sin(psi),    u = 1 - cos(psi)
 * and everything that this needs is a short polynomial:
 *     sin^2(psi) = u (2 - u)
 *     theta / sin(psi) = G(u) t / m for theta = t phi, where G(u) = psi / sin(psi) comes from a table of parabolas
 *     p = theta^2 = (theta / sin(psi))^2 u (2 - u), and from p the series of 2 - 2 cos(theta) and of sin(theta) / theta
 * An error of G is one of angle alone, since all else is derived from it: amplitudes count n times in a highlight, angles only
 * 0.6 sqrt(n) times. For the same reason sin(phi) is refitted to kappa = 2 - 2 cos(phi) once that has been rounded.
 *
 * Scaled values are times 2^guard for each factor of phi, which keeps their precision on long arcs; 2^guard is m/4 to m/2.
 */
#include "flash.h"

#include "../tables/arc_table.h"

/* An angle theta: sin(theta) / sin(psi) and 2 - 2 cos(theta), both scaled. */
struct turn {
    int32_t sine_q30, kappa_q28;
};

/* What an arc's normals give: u and sin^2(psi), both Q2.30. */
struct bow {
    int32_t u_q30, sine_squared_q30;
};

/* a b / 2^30, too small by less than 3; |a b| < 2^61. Where 64-bit products are calls (M0+, AVR) three short ones take a quarter
 * of the time, and nothing here needs the last bits. */
static int32_t product_q30(int32_t a, int32_t b)
{
    int32_t a_low = a & 0x7fff, b_low = b & 0x7fff, a_high = lmb_shr(a, 15), b_high = lmb_shr(b, 15);
    int32_t middle = lmb_add(lmb_shr(lmb_mul(a_high, b_low), 15), lmb_shr(lmb_mul(a_low, b_high), 15));
    return lmb_add(lmb_mul(a_high, b_high), middle);
}

/* x (1 - part), part < 1. */
static int32_t lessen(int32_t x, int32_t part_q28) { return lmb_sub(x, product_q30(x, lmb_shl(part_q28, 2))); }

/* G(u) in Q4.28, up to 2.42, for u up to LMB_ARC_U_MAX. */
static int32_t angle_over_sine(int32_t u_q28)
{
    const LMB_FLASH struct arc_piece *piece = &arc_table[u_q28 < LMB_ARC_U_MAX ? u_q28 >> 24 : 23];
    uint32_t t_q16 = u_q28 < LMB_ARC_U_MAX ? (uint32_t)u_q28 >> 8 & 0xffff : 0xffff;
    uint32_t rise_q26 = ((uint32_t)piece->slope << 8) + (lmb_mulu(piece->bend, t_q16) >> 10);
    return lmb_add(piece->value, lmb_shl(lmb_mul_q16((int32_t)rise_q26, t_q16), 2));
}

/* With t1 = p/12, t2 = p^2/360, ... the series are
 *     2 - 2 cos(theta) = p (1 - t1 + t2 - ...)    sin(theta) = theta (1 - 2 t1 + 3 t2 - ...)
 * and t(j+1) = t(j) p / ((2j + 3)(2j + 4)). p is at most 4.39 (120 degrees), so t1 < 0.37 and t6 < 2^-22. What is left out when
 * the loop ends early is below 2^-20. */
static void series(int32_t p_q28, int32_t *cos_loss_q28, int32_t *sin_loss_q28)
{
    static const LMB_FLASH uint16_t ratio_q19[6] = {43691, 17476, 9362, 5825, 3972, 2881};
    int32_t t_q28 = lmb_shr(lmb_mul_q16(p_q28, ratio_q19[0]), 3), j;
    t_q28 = lmb_sub(t_q28, lmb_shr(t_q28, 17)); /* 43691 is 2^19/12 and a 2^17th part too much */
    *cos_loss_q28 = t_q28;
    *sin_loss_q28 = lmb_shl(t_q28, 1);
    if (p_q28 < 0x240000) return;
    for (j = 1; j < 6 && (t_q28 >= 0x4000 || t_q28 <= -0x4000); j++) {
        t_q28 = lmb_sub(0, product_q30(lmb_shl(t_q28, 2), lmb_shr(lmb_mul_q16(p_q28, ratio_q19[j]), 3)));
        *cos_loss_q28 = lmb_add(*cos_loss_q28, t_q28);
        *sin_loss_q28 = lmb_add(*sin_loss_q28, lmb_mul(t_q28, j + 2));
    }
}

/* The angle theta whose ratio to sin(psi) is given, scaled: at most 2.42. p is at most 4.39 before scaling, 1.1 after. */
static struct turn turn_by(const struct bow *bow, int32_t ratio_q29, unsigned guard)
{
    int32_t p_q28 = product_q30(product_q30(ratio_q29, ratio_q29), bow->sine_squared_q30), cos_loss, sin_loss;
    struct turn turn;
    series(lmb_shr(p_q28, 2 * guard), &cos_loss, &sin_loss);
    turn.sine_q30 = lmb_shl(lessen(ratio_q29, sin_loss), 1);
    turn.kappa_q28 = lessen(p_q28, cos_loss);
    return turn;
}

/* Rounds kappa to a mantissa of 14 bits and refits sin(phi): when kappa changes by the fraction e, sin^2 = kappa - kappa^2/4
 * changes by e (1 - kappa / (4 - kappa)), and sin by half of that. Two steps of kappa apart at most: |e| < 2^-13.9.
 *   scale    kappa 2^(2 guard) = k 2^(drop - zeros) in Q4.28, so that d, in Q2.30 times 2^guard, falls by
 *            k f 2^(drop - zeros - 28 - guard), which is (k (f >> 13)) >> (zeros + guard + 15 - drop)
 *   1/x      1 + T3 / 99 over x, a parabola about 1.5 and within 1/99: e needs no more
 *   y/(1-y)  y + 4/3 y^2 with y = kappa/4 <= 1/4 (from two pixels on, phi <= 60 degrees), exact at its end */
static void round_kappa(lmb_arc *arc, struct turn *phi)
{
    unsigned zeros = lmb_clz32((uint32_t)phi->kappa_q28 | 1), drop = 18;
    uint32_t x_q31 = (uint32_t)phi->kappa_q28 << zeros, k = (x_q31 >> 18) + (x_q31 >> 17 & 1);
    int32_t y_q12, inverse_q12, half_e_q32, quarter_q12;
    if (k > LMB_ARC_KAPPA_MAX) {
        drop = 19;
        k = (x_q31 >> 19) + (x_q31 >> 18 & 1);
    }
    y_q12 = lmb_sub((int32_t)(x_q31 >> 19), 6144);
    inverse_q12 = lmb_sub(2731, lmb_shr(lmb_mul16(y_q12, lmb_sub(1986, lmb_shr(lmb_mul16(y_q12, 1324), 12))), 12));
    half_e_q32 = lmb_shr(lmb_mul(lmb_signed((k << drop) - x_q31), inverse_q12), 12); /* k << drop wraps when it is 2^32 */
    quarter_q12 = lmb_shr(lmb_shr(phi->kappa_q28, 2u * arc->guard), 18);
    quarter_q12 = lmb_add(quarter_q12, lmb_shr(lmb_mul(lmb_mul(quarter_q12, quarter_q12), 341), 20)); /* 341/256 = 4/3 */
    half_e_q32 = lmb_sub(half_e_q32, lmb_shr(lmb_mul(half_e_q32, quarter_q12), 12));
    phi->sine_q30 = lmb_add(phi->sine_q30, lmb_shr(lmb_mul(lmb_shr(phi->sine_q30, 15), lmb_shr(half_e_q32, 3)), 14));
    zeros += arc->guard + 15u - drop;
    if (zeros > 31) { /* hardly a turn at all: at most 2^-22 of f in 65536 pixels */
        k = zeros > 45 ? 0 : k >> (zeros - 31);
        zeros = 31;
    }
    arc->kappa = (uint16_t)k;
    arc->kappa_shift = (uint8_t)zeros;
}

/* The coefficients of the first f: the pixel centre lies theta after the start of the arc. */
static void place_first(lmb_arc *arc, const struct bow *bow, const struct turn *theta)
{
    arc->f_from_rise_q30 = theta->sine_q30;
    arc->f_from_a_q30 = lmb_sub(product_q30(bow->u_q30, theta->sine_q30), lmb_shl(theta->kappa_q28, 1));
}

/* The coefficients of the first d, f one pixel on less f. With P, W = sin(theta), sin(phi) over sin(psi):
 *     (sin(theta + phi) - sin(theta)) / sin(psi) = W cos(theta) - P kappa/2
 *     cos(theta) - cos(theta + phi)              = cos(theta) kappa/2 + P W sin^2(psi)
 * kappa/2 is at most 1.5, and 1 - cos(theta) 1/2: theta and phi together are at most 120 degrees, theta not the larger. */
static void place_second(lmb_arc *arc, const struct bow *bow, const struct turn *theta, const struct turn *phi,
                         int32_t half_kappa_q30)
{
    int32_t loss_q28 = lmb_shr(theta->kappa_q28, 1);
    int32_t across_q30 = product_q30(product_q30(theta->sine_q30, bow->sine_squared_q30), phi->sine_q30);
    int32_t fall_q30 = lmb_add(lessen(half_kappa_q30, loss_q28), across_q30);
    arc->d_from_rise_q30 = lmb_sub(lessen(phi->sine_q30, loss_q28), product_q30(theta->sine_q30, half_kappa_q30));
    arc->d_from_a_q30 = lmb_sub(product_q30(bow->u_q30, arc->d_from_rise_q30), fall_q30);
}

/* phi for arcs of two pixels and more; sets kappa and guard. Returns kappa / 2 in Q2.30, scaled once. */
static int32_t prepare_turn(lmb_arc *arc, const struct bow *bow, struct turn *phi, int32_t ratio_q29, unsigned guard)
{
    arc->guard = (uint8_t)guard;
    *phi = turn_by(bow, ratio_q29, guard);
    round_kappa(arc, phi);
    return lmb_shr(lmb_shl(arc->kappa, 16), arc->kappa_shift);
}

/* u and sin^2(psi) = u (2 - u); returns G times 2^(shift - 1) / length, where shift is that of the reciprocal. Beyond
 * LMB_ARC_U_MAX there is no turn, and G is one. */
static int32_t measure(struct bow *bow, int32_t u_q28, uint32_t length, unsigned *shift)
{
    const int32_t turn_q28 = u_q28 <= LMB_ARC_U_MAX ? u_q28 : 0;
    uint32_t inverse = lmb_reciprocal(length, shift); /* 2^(31 + shift) / length, up to 2^31 */
    bow->u_q30 = lmb_shl(turn_q28, 2);
    bow->sine_squared_q30 = lmb_shl(product_q30(bow->u_q30, lmb_sub(0x40000000, lmb_shl(turn_q28, 1))), 1);
    return product_q30(angle_over_sine(turn_q28), (int32_t)(inverse >> 1));
}

/* start G / length from G / length * 2^(shift - 1). On arcs under a pixel start, which is not longer, is first raised to where it
 * still fits 16 bits. */
static int32_t first_ratio(int32_t ratio_q29, unsigned shift, uint32_t start)
{
    if (shift < 16) return lmb_shl(lmb_mul_q16(ratio_q29, start << (15 - shift)), 2);
    ratio_q29 = lmb_mul_q16(ratio_q29, start);
    return shift == 16 ? lmb_shl(ratio_q29, 1) : lmb_shr(ratio_q29, shift - 17);
}

/* One reciprocal serves both angles: ratio = G / length * 2^(shift - 1) is that of phi scaled, 2^16 G / length * 2^guard, from
 * two pixels on, where guard = shift - 17; theta has start in the place of 2^16, which is LMB_ARC_PIXEL.
 * Arcs that hold one pixel keep d = 0 and kappa = 0. Those under two pixels that hold two need no kappa to reach the second;
 * their true one can be 3 and is too large for the step: with 1 in its place the third, which nobody sees, is f(1) - f(0) and in
 * range. Without a turn (u = 0) terms run linearly. A term whose ends are opposite rises by two: in one pixel, or until one pixel
 * after the end of two pixels, that would be just out of range. So slopes stay a 2^17th part below the whole rise, which leaves
 * room for the rounding of f >> 13, and from two pixels on below half of it; the later ones are far from the limit. */
LMB_STATIC_ASSERT(LMB_ARC_PIXEL == 1UL << 16);
void lmb_arc_prepare(lmb_arc *arc, int32_t u_q28, uint32_t length, uint32_t start)
{
    unsigned shift;
    struct bow bow;
    struct turn theta = {0, 0}, phi;
    int32_t ratio_q29 = measure(&bow, u_q28, length, &shift), half_kappa_q30;
    start = start < length ? start : length;
    if (start) theta = turn_by(&bow, first_ratio(ratio_q29, shift, start), 0);
    arc->kappa = arc->kappa_shift = arc->guard = 0;
    arc->d_from_a_q30 = arc->d_from_rise_q30 = 0;
    place_first(arc, &bow, &theta);
    if (start + LMB_ARC_PIXEL > length) return;
    if (shift >= 17) {
        half_kappa_q30 = prepare_turn(arc, &bow, &phi, ratio_q29, shift - 17);
    } else {
        phi = turn_by(&bow, lmb_shl(ratio_q29, 1), 0);
        half_kappa_q30 = lmb_shl(phi.kappa_q28, 1);
        arc->kappa = 8192;
    }
    place_second(arc, &bow, &theta, &phi, half_kappa_q30);
    if (bow.u_q30 == 0 && shift <= 17) {
        arc->d_from_rise_q30 = lmb_min(arc->d_from_rise_q30, shift < 17 ? 0x3fffe000 : 0x1ffff000);
    }
}

/* Half of x a + y b in Q2.30: products can pass two where f and d do not. */
static int32_t half_of(int32_t x_q30, int32_t a_q30, int32_t y_q30, int32_t b_q30)
{
    return lmb_add(product_q30(lmb_shr(x_q30, 1), a_q30), product_q30(lmb_shr(y_q30, 1), b_q30));
}

/* a - 2^12 where the recurrence sees a: the step's f >> 13 rounds down and so swings f about 2^-18, not about zero. With the
 * difference taken from there the arc still ends where it should, and errs by at most 2^-18 (1 / cos(psi/2) - 1) between. */
void lmb_arc_start(const lmb_arc *arc, lmb_term *term, int32_t a_q30, int32_t rise_q30)
{
    int32_t half = half_of(a_q30, arc->f_from_a_q30, rise_q30, arc->f_from_rise_q30);
    term->f = lmb_add(lmb_add(a_q30, half), half);
    term->d = lmb_shl(half_of(lmb_sub(a_q30, 0x1000), arc->d_from_a_q30, rise_q30, arc->d_from_rise_q30), 1);
    term->c = 0;
}

lmb_turn lmb_arc_turn(int32_t u_q28, uint32_t length)
{
    unsigned shift, guard;
    struct bow bow;
    int32_t ratio_q29 = measure(&bow, u_q28, length > LMB_ARC_PIXEL ? length : LMB_ARC_PIXEL, &shift);
    struct turn phi;
    lmb_turn turn;
    guard = shift > 17 ? shift - 17 : 0;
    phi = turn_by(&bow, shift < 17 ? lmb_shl(ratio_q29, 1) : ratio_q29, guard);
    turn.kappa_q30 = guard ? (uint32_t)phi.kappa_q28 >> (2 * guard - 2) : (uint32_t)phi.kappa_q28 << 2;
    turn.sine_q30 = (uint32_t)phi.sine_q30 >> guard;
    return turn;
}

int32_t lmb_excess_q28(lmb_vec v) { return lmb_sub(lmb_dot_q28(v, v), 0x10000000); }

/* With |a| = 1 + x and |b| = 1 + y the cosine is a.b (1 - x)(1 - y) but for squares of x and y, and x is half the excess of a.
 * a.b (1 - excess/2) is never above one: |a| |b| (2 - (|a|^2 + |b|^2)/2) <= |a| |b| (2 - |a| |b|) <= 1. Held inside one all the
 * same, for vectors that are far off; -1 is left out so that a rise of two fits Q2.30. */
static int32_t cosine_of(const lmb_vec *a, const lmb_vec *b, int32_t excess_q28)
{
    int32_t dot_q28 = lmb_add(lmb_add(lmb_mul16(a->x, b->x), lmb_mul16(a->y, b->y)), lmb_mul16(a->z, b->z));
    int32_t size_q15 = lmb_min(lmb_shr(dot_q28 < 0 ? lmb_sub(0, dot_q28) : dot_q28, 13), 0xffff);
    int32_t half_q28 = lmb_mul_q16(excess_q28, (uint32_t)size_q15); /* |a.b| excess/2 */
    dot_q28 = dot_q28 < 0 ? lmb_add(dot_q28, half_q28) : lmb_sub(dot_q28, half_q28);
    return lmb_shl(lmb_max(lmb_min(dot_q28, 0x10000000), 1 - 0x10000000), 2);
}

int32_t lmb_cosine_q30(lmb_vec a, lmb_vec b, int32_t excess_q28) { return cosine_of(&a, &b, excess_q28); }

void lmb_arc_between(lmb_arc *arc, lmb_vec from, lmb_vec to, uint32_t length, uint32_t start)
{
    int32_t cosine_q30;
    arc->excess_from_q28 = lmb_excess_q28(from);
    arc->excess_to_q28 = lmb_excess_q28(to);
    cosine_q30 = cosine_of(&from, &to, lmb_add(arc->excess_from_q28, arc->excess_to_q28));
    lmb_arc_prepare(arc, lmb_sub(0x10000000, lmb_shr(cosine_q30, 2)), length, start);
}

void lmb_arc_dot(const lmb_arc *arc, lmb_term *term, lmb_vec from, lmb_vec to, lmb_vec ray, uint32_t scale)
{
    int32_t excess_q28 = lmb_excess_q28(ray);
    int32_t a_q30 = cosine_of(&from, &ray, lmb_add(excess_q28, arc->excess_from_q28));
    int32_t rise_q30 = lmb_sub(cosine_of(&to, &ray, lmb_add(excess_q28, arc->excess_to_q28)), a_q30);
    if (scale < 65536) {
        a_q30 = lmb_mul_q16(a_q30, scale);
        rise_q30 = lmb_mul_q16(rise_q30, scale);
    }
    lmb_arc_start(arc, term, a_q30, rise_q30);
}
