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
 * Values with a lower case scaled are times 2^guard for each factor of phi, so that they keep their precision on long arcs;
 * 2^guard is m/2 to m/4.
 */
#include "lambent.h"

#include "../tables/arc_table.h"

/* An angle theta: sin(theta) / sin(psi) and 2 - 2 cos(theta), both scaled. */
struct turn {
    uint32_t sine_q30, kappa_q28;
};

/* x (1 - part), part < 1; x < 2^31 unless part >= 2^-8. Most parts on arcs of 16 pixels and more are small, and then need no
 * 64-bit product: 16 bits of x meet 16 bits of part, which loses 2^-23 x at most. */
static uint32_t lessen(uint32_t x, uint32_t part_q28)
{
    if (part_q28 < 0x100000u) return x - (lmb_mulu(x >> 15, part_q28 >> 4) >> 9);
    return x - lmb_mulu_hi(x, part_q28 << 4);
}

/* G(u) in Q4.28, for u up to LMB_ARC_U_MAX. Values up to 2.42. */
static uint32_t angle_over_sine(int32_t u_q28)
{
    const struct arc_piece *piece = &arc_table[lmb_min(lmb_shr(u_q28, 24), 23)];
    uint32_t t_q16 = lmb_min(u_q28 - (int32_t)(piece - arc_table) * 0x1000000, 0xffffff) >> 8;
    uint32_t rise_q26 = ((uint32_t)piece->slope << 8) + (lmb_mulu(piece->bend, t_q16) >> 10);
    return (uint32_t)piece->value + ((uint32_t)lmb_mul_q16((int32_t)rise_q26, t_q16) << 2);
}

/* With t1 = p/12, t2 = p^2/360, ... the series are
 *     2 - 2 cos(theta) = p (1 - t1 + t2 - ...)    sin(theta) = theta (1 - 2 t1 + 3 t2 - ...)
 * and t(j+1) = t(j) p / ((2j + 3)(2j + 4)). p is at most 4.39 (120 degrees), so t1 < 0.37 and t6 < 2^-22. */
static void series(uint32_t p_q28, uint32_t *cos_loss_q28, uint32_t *sin_loss_q28)
{
    static const uint16_t ratio_q19[6] = {43691, 17476, 9362, 5825, 3972, 2881};
    uint32_t t_q28 = (uint32_t)lmb_mul_q16((int32_t)p_q28, ratio_q19[0]) >> 3, j = 1;
    *cos_loss_q28 = *sin_loss_q28 = 0;
    for (;;) {
        uint32_t weighted = lmb_mulu(t_q28, j + 1);
        *cos_loss_q28 += j & 1 ? t_q28 : 0u - t_q28;
        *sin_loss_q28 += j & 1 ? weighted : 0u - weighted;
        if (j == 6 || t_q28 < 0x4000 || p_q28 < 0x240000) return; /* what follows is below 2^-21 */
        t_q28 = lmb_mulu_hi(t_q28 << 4, (uint32_t)lmb_mul_q16((int32_t)p_q28, ratio_q19[j]) >> 3);
        j++;
    }
}

/* The angle theta whose ratio to sin(psi) is given, scaled: at most 2.42 in Q28, and p unscaled at most 4.39. */
static struct turn turn_by(uint32_t ratio_q28, uint32_t sine_squared_q30, unsigned guard)
{
    uint32_t square_q28 = lmb_mulu_hi(ratio_q28 << 2, ratio_q28 << 2), cos_loss, sin_loss;
    uint32_t p_q28 = lmb_mulu_hi(square_q28 << 1, sine_squared_q30 << 1);
    struct turn turn;
    series(p_q28 >> 2 * guard, &cos_loss, &sin_loss);
    turn.sine_q30 = lessen(ratio_q28 << 2, sin_loss);
    turn.kappa_q28 = lessen(p_q28, cos_loss);
    return turn;
}

/* Rounds kappa to a mantissa of 14 bits and refits sin(phi): when kappa changes by the fraction e, sin^2 = kappa - kappa^2/4
 * changes by e (1 - kappa / (4 - kappa)), and sin by half of that. Two steps of kappa apart at most: |e| < 2^-13.9.
 *   scale    kappa 2^(2 guard) = k 2^(drop - zeros) in Q4.28, so that d, in Q2.30 times 2^guard, falls by k f 2^(drop - zeros - 28 -
 *            guard), which is (k (f >> 13)) >> (zeros + guard + 15 - drop)
 *   1/x      1 + T3 / 99 over x, a parabola about 1.5 and within 1/99: e needs no more
 *   y/(1-y)  y + 4/3 y^2 with y = kappa/4 <= 1/4 (from two pixels on, phi <= 60 degrees), exact at its end */
static void round_kappa(lmb_arc *arc, struct turn *phi)
{
    unsigned zeros = lmb_clz32(phi->kappa_q28), drop = 18;
    uint32_t x_q31 = phi->kappa_q28 << zeros, k = (x_q31 >> 18) + (x_q31 >> 17 & 1);
    int32_t y_q12, inverse_q12, half_e_q32, quarter_q12;
    if (k > LMB_ARC_KAPPA_MAX) {
        drop = 19;
        k = (x_q31 >> 19) + (x_q31 >> 18 & 1);
    }
    y_q12 = lmb_sub((int32_t)(x_q31 >> 19), 6144);
    inverse_q12 = lmb_sub(2731, lmb_shr(lmb_mul16(y_q12, lmb_sub(1986, lmb_shr(lmb_mul16(y_q12, 1324), 12))), 12));
    half_e_q32 = lmb_shr(lmb_mul(lmb_signed((k << drop) - x_q31), inverse_q12), 12); /* k << drop wraps when it is 2^32 */
    quarter_q12 = (int32_t)(phi->kappa_q28 >> 2 * arc->guard >> 18);
    quarter_q12 = lmb_add(quarter_q12, lmb_shr(lmb_mul(lmb_mul(quarter_q12, quarter_q12), 341), 20)); /* 341/256 = 4/3 */
    half_e_q32 = lmb_sub(half_e_q32, lmb_shr(lmb_mul(half_e_q32, quarter_q12), 12));
    phi->sine_q30 += (uint32_t)lmb_shr(lmb_mul((int32_t)(phi->sine_q30 >> 15), lmb_shr(half_e_q32, 3)), 14);
    arc->kappa = (uint16_t)k;
    arc->kappa_shift = (uint8_t)(zeros + arc->guard + 15 - drop);
}

/* kappa / 2 in Q2.30, scaled once: k 2^(16 - kappa_shift). */
static uint32_t half_kappa_q30(const lmb_arc *arc)
{
    return (uint32_t)arc->kappa << 16 >> arc->kappa_shift;
}

/* The coefficients of the first f, from the angle theta between the start of the arc and the first pixel centre. */
static void place_first(lmb_arc *arc, const struct turn *theta, int32_t u_q28)
{
    arc->f_from_rise_q30 = (int32_t)theta->sine_q30;
    arc->f_from_a_q30 = lmb_sub(lmb_mul_shr(u_q28, (int32_t)theta->sine_q30, 28), (int32_t)(theta->kappa_q28 << 1));
}

/* The coefficients of the first d, f one pixel on less f:
 *     (sin(theta + phi) - sin(theta)) / sin(psi) = W cos(theta) - P kappa/2                 W, P: sines over sin(psi)
 *     cos(theta) - cos(theta + phi)              = kappa/2 cos(theta) + sin^2(psi) W P */
static void place_second(lmb_arc *arc, const struct turn *theta, const struct turn *phi, uint32_t half_kappa, int32_t u_q28,
                         uint32_t sine_squared_q30)
{
    int32_t p_q30 = (int32_t)theta->sine_q30, w_q30 = (int32_t)phi->sine_q30;
    int32_t across = lmb_mul_shr(lmb_mul_shr((int32_t)sine_squared_q30, p_q30, 30), w_q30, 30);
    int32_t fall = lmb_add((int32_t)lessen(half_kappa, theta->kappa_q28 >> 1), across);
    arc->d_from_rise_q30 = lmb_sub((int32_t)lessen((uint32_t)w_q30, theta->kappa_q28 >> 1),
                                   lmb_mul_shr(p_q30, (int32_t)half_kappa, 30));
    arc->d_from_a_q30 = lmb_sub(lmb_mul_shr(u_q28, arc->d_from_rise_q30, 28), fall);
}

/* Beyond LMB_ARC_U_MAX: straight from end to end. On arcs that short the slope is held under a half, so that a term of
 * opposite ends, which rises by two, is still in range one pixel after its end. */
static void prepare_line(lmb_arc *arc, uint32_t inverse_q28, uint32_t start)
{
    arc->f_from_rise_q30 = (int32_t)(lmb_mulu(inverse_q28 >> 4, start) << 2 >> arc->guard);
    arc->d_from_rise_q30 = lmb_min((int32_t)(inverse_q28 << 2), 0x1fe00000);
}

/* The angle theta of the first pixel centre is start/16 of the angle phi of a pixel; neither is more than psi. When no second
 * pixel fits, d stays zero. */
void lmb_arc_prepare(lmb_arc *arc, int32_t u_q28, uint32_t length, uint32_t start)
{
    unsigned shift;
    uint32_t inverse = lmb_reciprocal(length, &shift); /* 2^(31 + shift) / length */
    bool turns = u_q28 <= LMB_ARC_U_MAX;
    uint32_t ratio_q28 = turns ? lmb_mulu_hi(angle_over_sine(u_q28), inverse) : inverse >> 4;
    uint32_t sine_squared_q30 = turns ? (uint32_t)lmb_mul_shr(u_q28, 0x20000000 - u_q28, 26) : 0;
    struct turn phi, theta;
}
