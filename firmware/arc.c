/* SPDX-License-Identifier: MIT */
/* Set-up of arcs: normals that turn evenly over a run of pixels (paper 001), without arccos, sine, root or division.
 *
 * With psi the angle between the end normals, m pixels, phi = psi / m, u = 1 - cos(psi), a term that is a at the start and a +
 * rise at the end is, x radians on,
 *     f(x) = a cos(x) + (rise + u a) sin(x) / sin(psi)
 * G(u) = psi / sin(psi) comes from a table of parabolas; R = G / m is phi / sin(psi), and p = R^2 u (2 - u) is phi^2. From there
 * on there are series of p and of kappa = 2 - 2 cos(phi) = 4 sin^2(h), h = phi / 2. An error of G is one of angle alone, since
 * all else is derived from it: amplitudes count n times in a highlight, angles only 0.6 sqrt(n) times. For the same reason the
 * sines over sin(psi) are refitted to kappa once that has been rounded to what the step can multiply by.
 *
 * There are three kinds of arcs:
 *     flat    two pixels and more, up to 7 degrees a pixel: two or three terms of each series do, and the first f follows from
 *             the first d, which is the better half of the work
 *     steep   more than that: whole series
 *     short   below two pixels: both f from the whole series, by way of the nearer end; no kappa
 *
 * Products are of three 16-bit ones, or of one where what is multiplied is a small correction: products of 64 bits are calls on
 * M0+ and AVR. Scaled values are times 2^guard for each factor of phi; 2^guard is m/4 to m/2, so phi scaled is psi / 4 to psi /
 * 2.
 */
#include "arc_parts.h"

#include "../tables/arc_table.h"
#include "../tables/reciprocal_table.h"
#include "../tables/series_table.h"

/* lmb_arc.direct: 0 for a flat arc; else coefficients of d are coefficients of the difference of two f, and of a single pixel
 * none. */
enum { LMB_ARC_DIRECT = 1, LMB_ARC_SINGLE = 2 };

/* ------------------------------------------------------------------------------------------------------------------ products */

/* a b, Q4.28, too small by less than 18. |a| + |b| < 7.9 and |a b| < 7.9. */
static inline int32_t product_q28(int32_t a, int32_t b)
{
    int32_t a_low = low_half(a), b_low = low_half(b), a_high = lmb_shr(a, 16), b_high = lmb_shr(b, 16);
    int32_t middle = lmb_add(lmb_mul(a_high, b_low), lmb_mul(a_low, b_high));
    return lmb_add(lmb_shl(lmb_mul(a_high, b_high), 4), lmb_shr(middle, 12));
}

/* a^2, Q4.28, too small by less than 18. |a| < 2.6. */
static inline int32_t square_q28(int32_t a)
{
    int32_t high = lmb_shr(a, 16), low = low_half(a);
    return lmb_add(lmb_shl(lmb_mul(high, high), 4), lmb_shr(lmb_mul(high, low), 11));
}

/* x (1 - part). */
static inline int32_t lessen(int32_t x_q28, int32_t part_q28) { return lmb_sub(x_q28, product_q28(x_q28, part_q28)); }

/* -------------------------------------------------------------------------------------------------------- tables and series */

/* x / (2 m) for m in [1, 2) and x in (-3, 3): r (1 + e + e^2) with r near 1/m and e = 1 - m r. |e| < 1/207, so what is left out
 * is under 2^-23 of the result. */
static inline int32_t divided(int32_t x_q28, uint32_t m_q31)
{
    int32_t r_q9 = inverse_q9(m_q31), e_q32 = residue_q32(m_q31, r_q9), e_q21 = lmb_shr(e_q32, 11);
    int32_t more_q21 = lmb_add(e_q21, lmb_shr(lmb_mul(e_q21, lmb_shr(e_q32, 17)), 15));
    x_q28 = lmb_mul_q16(x_q28, (uint32_t)r_q9 << 6);
    return lmb_add(x_q28, lmb_shr(lmb_mul(lmb_shr(x_q28, 12), more_q21), 9));
}

/* G(u) up to 2.42, for u below LMB_ARC_U_MAX. */
static inline int32_t angle_over_sine_q28(int32_t u_q28)
{
    const LMB_FLASH struct arc_piece *piece = &arc_table[u_q28 >> 24];
    uint32_t t_q16 = (uint16_t)((uint32_t)u_q28 >> 8);
    uint32_t rise_q19 = ((uint32_t)piece->slope << 1) + (lmb_mulu(piece->bend, t_q16) >> 17);
    return lmb_add(piece->value, (int32_t)(lmb_mulu(rise_q19, t_q16 >> 1) >> 6));
}

/* sin^2(psi). */
static inline int32_t sine_squared_q28(int32_t u_q28) { return lmb_sub(lmb_shl(u_q28, 1), square_q28(u_q28)); }

/* What the series lack of their first terms: sin(x) = x (1 - sine_loss), 2 - 2 cos(x) = x^2 (1 - cosine_loss), for y = x^2 up to
 * 1.12. y/6 - y^2/120 + y^3/5040 ... and y/12 - y^2/360 + y^3/20160 ..., as cubics (tables/gen_series.c), and about 2^-21 off by
 * rounding. */
static int32_t sine_loss_q28(int32_t y_q28)
{
    int32_t y_q15 = lmb_shr(y_q28, 13), h_q22 = lmb_sub(SINE_LOSS_1_Q22, lmb_shr(lmb_mul(y_q15, SINE_LOSS_2_Q28), 21));
    return product_q28(y_q28, lmb_sub(SINE_LOSS_0_Q28, lmb_shr(lmb_mul(y_q15, h_q22), 9)));
}

static int32_t cosine_loss_q28(int32_t y_q28)
{
    int32_t y_q15 = lmb_shr(y_q28, 13), h_q24 = lmb_sub(COSINE_LOSS_1_Q24, lmb_shr(lmb_mul(y_q15, COSINE_LOSS_2_Q28), 19));
    return product_q28(y_q28, lmb_sub(COSINE_LOSS_0_Q28, lmb_shr(lmb_mul(y_q15, h_q24), 11)));
}

/* sin(x) / sin(psi) and 1 - cos(x), where x = t phi, ratio = phi / sin(psi), p = phi^2. t <= 1, x^2 <= 1.12. */
struct place {
    int32_t sine_q28, fall_q28;
};

static struct place place_at(int32_t ratio_q28, int32_t p_q28, int32_t t_q28)
{
    int32_t y_q28 = product_q28(square_q28(t_q28), p_q28);
    struct place at;
    at.sine_q28 = lessen(product_q28(ratio_q28, t_q28), sine_loss_q28(y_q28));
    at.fall_q28 = lessen(lmb_shr(y_q28, 1), cosine_loss_q28(y_q28));
    return at;
}

/* --------------------------------------------------------------------------------------------------------------- short arcs */

/* The weights of a and of rise in f at t = x / psi. Past the middle from the end, where f is b cos(x) - (rise - u b) sin(x) /
 * sin(psi), b = a + rise: so x is 60 degrees at most. */
static void weigh(int32_t u_q28, int32_t t_q28, int32_t *of_a_q28, int32_t *of_rise_q28)
{
    const int32_t ratio = angle_over_sine_q28(u_q28), p = product_q28(square_q28(ratio), sine_squared_q28(u_q28));
    const bool far = t_q28 > 0x8000000;
    const struct place at = place_at(ratio, p, far ? lmb_sub(0x10000000, t_q28) : t_q28);
    *of_a_q28 = lmb_sub(product_q28(u_q28, at.sine_q28), at.fall_q28);
    *of_rise_q28 = far ? lmb_sub(lmb_add(0x10000000, *of_a_q28), at.sine_q28) : at.sine_q28;
}

/* Arcs that hold one pixel keep d = 0 and kappa = 0. Those that hold two need no kappa to reach the second; their true one can be
 * 3 and is too large for the step: with 1 in its place the third, which nobody sees, is f(1) - f(0) and in range. */
static void prepare_short(lmb_arc *arc, int32_t u_q28, uint32_t length, uint32_t start)
{
    uint32_t m_q31 = length;
    const unsigned shift = 31 - raise(&m_q31);
    const int32_t inverse_q28 = divided(0x20000000, m_q31);
    arc->direct = LMB_ARC_SINGLE;
    arc->kappa = arc->kappa_shift = arc->guard = 0;
    /* on arcs under a pixel start, which is not longer, is first raised to where it still fits 16 bits */
    weigh(u_q28, shift < 16 ? lmb_shl(lmb_mul_q16(inverse_q28, start << (15 - shift)), 1) : lmb_mul_q16(inverse_q28, start),
          &arc->f_from_a, &arc->f_from_rise);
    if (start + LMB_ARC_PIXEL > length) return;
    arc->direct = LMB_ARC_DIRECT;
    arc->kappa = 8192;
    weigh(u_q28, lmb_add(inverse_q28, lmb_mul_q16(inverse_q28, start)), &arc->d_from_a_q28, &arc->d_from_rise_q28);
    arc->d_from_a_q28 = lmb_sub(arc->d_from_a_q28, arc->f_from_a);
    arc->d_from_rise_q28 = lmb_sub(arc->d_from_rise_q28, arc->f_from_rise);
    if (u_q28 == 0) arc->d_from_rise_q28 = lmb_min(arc->d_from_rise_q28, 0x0ffff800); /* see prepare_straight */
}

/* ------------------------------------------------------------------------------------------------ arcs of two pixels and more */

/* 2^-6: 7.17 degrees a pixel. */
#define STEEP_Q28 0x400000

/* W changed by the fraction e: |e| < 2^-10. */
static inline int32_t refit(int32_t w_q28, int32_t e_q29)
{
    return lmb_add(w_q28, lmb_shr(lmb_mul(lmb_shr(w_q28, 16), e_q29), 13));
}

/* The coefficients from the rounded kappa and half the fraction that it was changed by, e. With P, W = sin(theta), sin(phi) over
 * sin(psi), theta = start phi:
 *     (sin(theta + phi) - sin(theta)) / sin(psi) = W cos(theta) - P kappa/2
 *     cos(theta) - cos(theta + phi)              = cos(theta) kappa/2 + P W sin^2(psi)
 * sin^2(phi) = kappa - kappa^2/4 changes by e (2 - 2 y/(1-y)), y = kappa/4; y/(1-y) is y + 4/3 y^2 for y <= 1/4 (from two pixels
 * on, phi <= 60 degrees), exact at its end. */
static void set_steep(lmb_arc *arc, int32_t u_q28, int32_t ratio_q28, int32_t p_q28, int32_t kappa_q28, int32_t e_q29,
                      uint32_t start)
{
    const unsigned guard = arc->guard;
    const int32_t real_q28 = lmb_shr(p_q28, 2 * guard), half_q28 = lmb_shr(kappa_q28, guard + 1);
    const struct place at = place_at(lmb_shr(ratio_q28, guard), real_q28, (int32_t)(start << 12));
    int32_t quarter_q12 = lmb_shr(half_q28, guard + 17), w, across;
    quarter_q12 = lmb_add(quarter_q12, lmb_shr(lmb_mul(lmb_mul(quarter_q12, quarter_q12), 341), 20)); /* 341/256 = 4/3 */
    w = refit(lessen(ratio_q28, sine_loss_q28(real_q28)), lmb_sub(e_q29, lmb_shr(lmb_mul(e_q29, quarter_q12), 12)));
    across = product_q28(product_q28(at.sine_q28, sine_squared_q28(u_q28)), w);
    arc->direct = LMB_ARC_DIRECT;
    arc->f_from_rise = at.sine_q28;
    arc->f_from_a = lmb_sub(product_q28(u_q28, at.sine_q28), at.fall_q28);
    w = lmb_sub(lessen(w, at.fall_q28), product_q28(at.sine_q28, half_q28));
    arc->d_from_rise_q28 = w;
    arc->d_from_a_q28 = lmb_sub(product_q28(u_q28, w), lmb_add(lessen(half_q28, at.fall_q28), across));
}

/* The same where kappa < 2^-6, from W = 2 sin(h) / sin(psi), the rise of sin(x) / sin(psi) from -h to h: refitting it takes e
 * alone. With s = start, v = s (s + 1), theta' = theta + h = (2s + 1) h, from the middle of a pixel to that of the next:
 *     d = (rise + u a) W cos(theta') - a 2 sin(h) sin(theta')
 *     2 sin(h) sin(theta')  = kappa (s + 1/2) (1 - v kappa/6 ...)
 *     f = a cos(h) / cos(theta') + d sin(theta) / (2 sin(h) cos(theta'))
 *     sin(theta) / (2 sin(h) cos(theta')) = s (1 + z + z^2 ...), z = kappa (1 + s + 2v) / 6
 *     cos(h) / cos(theta')  = 1 + g, g = v kappa/2 (1 + y + y^2 ...), y = z + kappa (v - 2s) / 12
 *     cos(theta')           = 1 - x + x g - x g^2 ..., x = g + 1 - cos(h) = g + kappa/8 + kappa^2/128 ...
 * What is left out is under 2^-20 of a and of (rise + u a) / sin(psi). */
static void set_flat(lmb_arc *arc, int32_t u_q28, int32_t w_q28, int32_t kappa_q28, uint32_t start)
{
    const int32_t scaled_q28 = lmb_shr(kappa_q28, arc->guard); /* once */
    const uint32_t kappa_q22 = (uint32_t)lmb_shr(scaled_q28, arc->guard) >> 6, sixth_q22 = lmb_mulu(kappa_q22, 10923) >> 16;
    const uint32_t v_q16 = (lmb_mulu(start, start) >> 16) + start, pull_q22 = lmb_mulu(v_q16, sixth_q22) >> 16;
    uint32_t z_q22 = lmb_mulu(2 * v_q16 + start + 65536, sixth_q22) >> 16, g_q22 = 3 * pull_q22, y_q22;
    int32_t fall_q28 = lmb_add(lmb_mul_q16(scaled_q28, start), lmb_shr(scaled_q28, 1));
    fall_q28 = lmb_sub(fall_q28, lmb_shr(lmb_mul(lmb_shr(fall_q28, 13), (int32_t)pull_q22), 9));
    z_q22 += lmb_mulu(z_q22 >> 1, z_q22) >> 21;
    arc->f_from_rise = (int32_t)(start + (lmb_mulu(z_q22 >> 1, start) >> 21)); /* times d, UQ1.16 */
    y_q22 = z_q22 - (lmb_mulu(2 * start - v_q16, sixth_q22) >> 17);
    g_q22 += lmb_mulu(g_q22 >> 1, y_q22) >> 21;
    arc->f_from_a = (int32_t)(g_q22 >> 1); /* UQ0.21 */
    z_q22 = g_q22 + (kappa_q22 >> 3) + (lmb_mulu(kappa_q22 >> 2, kappa_q22) >> 27);
    z_q22 -= lmb_mulu(z_q22 >> 1, g_q22 - (lmb_mulu(g_q22 >> 1, g_q22) >> 21)) >> 21;
    w_q28 = lmb_sub(w_q28, lmb_shr(lmb_mul(lmb_shr(w_q28, 14), (int32_t)z_q22), 8));
    arc->direct = 0;
    arc->d_from_rise_q28 = w_q28;
    arc->d_from_a_q28 = lmb_sub(product_q28(u_q28, w_q28), fall_q28);
}

/* Takes the mantissa of 14 bits that the step multiplies by, and its shift; from kappa, scaled twice, up to 1.1. Returns half the
 * fraction by which that changes kappa: the mantissa is 7710 to 15420, so that is below 2^-14.9.
 *   scale   kappa 2^(2 guard) = k 2^(18 - zeros) in Q4.28, so that d, in Q2.30 times 2^guard, falls by
 *           k f 2^(18 - zeros - 28 - guard), which is (k (f >> 13)) >> (zeros + guard - 3) */
static int32_t round_kappa(lmb_arc *arc, int32_t *kappa_q28, unsigned guard)
{
    uint32_t x_q31 = (uint32_t)*kappa_q28, k;
    unsigned shift = raise(&x_q31);
    int32_t inverse = inverse_q9(x_q31), e_q29;
    if (x_q31 >= ((LMB_ARC_KAPPA_MAX * 2ul + 1) << 17)) {
        x_q31 >>= 1;
        shift--;
        inverse <<= 1;
    }
    k = ((x_q31 >> 17) + 1) >> 1;
    e_q29 = lmb_shr(lmb_mul(lmb_signed((k << 18) - x_q31), inverse), 12);
    *kappa_q28 = (int32_t)(k << 18 >> shift);
    shift += guard - 3u;
    if (shift > 31) { /* hardly a turn at all: at most 2^-22 of f in 65536 pixels */
        k = shift > 45 ? 0 : k >> (shift - 31);
        shift = 31;
    }
    arc->kappa = (uint16_t)k;
    arc->kappa_shift = (uint8_t)shift;
    return e_q29;
}

static void prepare_long(lmb_arc *arc, int32_t u_q28, uint32_t length, uint32_t start)
{
    uint32_t m_q31 = length;
    const unsigned guard = 14 - raise(&m_q31);
    const int32_t ratio_q28 = divided(angle_over_sine_q28(u_q28), m_q31); /* scaled: m 2^-guard is 2 to 4 */
    const int32_t p_q28 = product_q28(square_q28(ratio_q28), sine_squared_q28(u_q28)), real_q28 = lmb_shr(p_q28, 2 * guard);
    int32_t kappa_q28, twelfth_q22 = 0, e_q29;
    if (real_q28 >= STEEP_Q28) {
        kappa_q28 = lessen(p_q28, cosine_loss_q28(real_q28));
    } else { /* kappa = p (1 - p/12 ...), W = R (1 - p/24 ...) */
        twelfth_q22 = (int32_t)(lmb_mulu((uint32_t)lmb_shr(real_q28, 6), 43691) >> 19);
        kappa_q28 = lmb_sub(p_q28, lmb_shr(lmb_mul(lmb_shr(p_q28, 13), twelfth_q22), 9));
    }
    arc->guard = (uint8_t)guard;
    e_q29 = round_kappa(arc, &kappa_q28, guard);
    if (real_q28 >= STEEP_Q28) {
        set_steep(arc, u_q28, ratio_q28, p_q28, kappa_q28, e_q29, start);
    } else {
        set_flat(arc, u_q28, refit(ratio_q28, lmb_sub(e_q29, lmb_shl(twelfth_q22, 6))), kappa_q28, start);
    }
}

/* Beyond LMB_ARC_U_MAX there is no turn, and terms run linearly. One whose ends are opposite rises by two: in one pixel, or until
 * one pixel after the end of two pixels, that would be just out of range. Below two pixels the slope is held a 2^17th part below
 * that; for two pixels it is 2^-21 short, as divided leaves it. */
static void prepare_straight(lmb_arc *arc, uint32_t length, uint32_t start)
{
    uint32_t m_q31 = length;
    arc->guard = (uint8_t)(14 - raise(&m_q31));
    arc->direct = LMB_ARC_DIRECT;
    arc->kappa = arc->kappa_shift = 0;
    arc->d_from_a_q28 = arc->f_from_a = 0;
    arc->d_from_rise_q28 = divided(0x10000000, m_q31);
    arc->f_from_rise = lmb_shr(lmb_mul_q16(arc->d_from_rise_q28, start), arc->guard);
}

LMB_STATIC_ASSERT(LMB_ARC_PIXEL == 1UL << 16);
void lmb_arc_prepare(lmb_arc *arc, int32_t u_q28, uint32_t length, uint32_t start)
{
    const bool straight = u_q28 > LMB_ARC_U_MAX;
    if (u_q28 >= LMB_ARC_U_MAX) u_q28 = straight ? 0 : LMB_ARC_U_MAX - 1; /* where the table ends */
    if (length < 2 * LMB_ARC_PIXEL) {
        prepare_short(arc, u_q28, length, start < length ? start : length);
    } else if (straight) {
        prepare_straight(arc, length, start);
    } else {
        prepare_long(arc, u_q28, length, start);
    }
}

/* ------------------------------------------------------------------------------------------------------------ terms on arcs */

/* The step's f >> 13 rounds down and so swings f about 2^-18, not about zero. With that taken from a where d is concerned, the
 * arc still ends where it should, and errs by at most 2^-18 (1 / cos(psi/2) - 1) between. */
#define SWING 18

static void start_direct(const lmb_arc *arc, lmb_term *term, int32_t a_q28, int32_t rise_q28)
{
    int32_t x = lmb_add(a_q28, product_q28(a_q28, arc->f_from_a));
    term->f = lmb_shl(lmb_add(x, product_q28(rise_q28, arc->f_from_rise)), 2);
    term->d = 0;
    if (arc->direct == LMB_ARC_SINGLE) return;
    x = lmb_sub(product_q28(a_q28, arc->d_from_a_q28), lmb_shr(arc->d_from_a_q28, SWING));
    term->d = lmb_shl(lmb_add(x, product_q28(rise_q28, arc->d_from_rise_q28)), 2);
}

static inline void start_exact(const lmb_arc *arc, lmb_term *term, int32_t a_q28, int32_t rise_q28)
{
    int32_t d, f;
    uint32_t along_q16;
    if (arc->direct) {
        start_direct(arc, term, a_q28, rise_q28);
        return;
    }
    d = lmb_sub(product_q28(a_q28, arc->d_from_a_q28), lmb_shr(arc->d_from_a_q28, SWING));
    d = lmb_add(d, product_q28(rise_q28, arc->d_from_rise_q28));
    term->d = lmb_shl(d, 2);
    d = lmb_shr(d, arc->guard);
    along_q16 = (uint32_t)arc->f_from_rise; /* 17 bits, |d| < 0.1 */
    f = lmb_add(a_q28, lmb_shr(lmb_mul(lmb_shr(a_q28, 13), arc->f_from_a), 8));
    f = lmb_add(f, lmb_mul(lmb_shr(d, 16), (int32_t)along_q16));
    term->f = lmb_shl(lmb_add(f, (int32_t)(lmb_mulu((uint32_t)low_half(d) >> 1, along_q16) >> 15)), 2);
}

void lmb_arc_start(const lmb_arc *arc, lmb_term *term, int32_t a_q30, int32_t rise_q30)
{
    start_exact(arc, term, lmb_shr(a_q30, 2), lmb_shr(rise_q30, 2));
    term->c = 0;
}

/* One product of 16 bits for three; on flat arcs. The products can pass two where the normals are 120 degrees apart, d does
 * not. */
static inline void start_rough(const lmb_arc *arc, lmb_term *term, int32_t a_q30, int32_t rise_q30)
{
    int32_t a_q15 = lmb_shr(a_q30, 15), d = lmb_mul_wrap(a_q15, lmb_shr(arc->d_from_a_q28, 13));
    d = lmb_add_wrap(d, lmb_mul_wrap(lmb_shr(rise_q30, 15), lmb_shr(arc->d_from_rise_q28, 13)));
    term->d = d;
    a_q30 = lmb_add(a_q30, lmb_shr(lmb_mul(a_q15, arc->f_from_a), 6));
    term->f = lmb_add(a_q30, lmb_shr(lmb_mul(lmb_shr(lmb_shr(d, arc->guard), 14), arc->f_from_rise), 2));
}

void lmb_arc_start_rough(const lmb_arc *arc, lmb_term *term, int32_t a_q30, int32_t rise_q30)
{
    if (arc->direct) {
        start_direct(arc, term, lmb_shr(a_q30, 2), lmb_shr(rise_q30, 2));
    } else {
        start_rough(arc, term, a_q30, rise_q30);
    }
}

/* ------------------------------------------------------------------------------------------------------------ ends and beams */

int32_t lmb_excess_q28(lmb_vec v) { return lmb_sub(lmb_dot_q28(v, v), 0x10000000); }

/* 2^-11: what normalising and turning by a rotation leave is a fourth of it. */
#define EXCESS_MAX 0x20000

static LMB_OUTLINE void end_set(lmb_end *end, lmb_vec v) { lmb_end_set(end, v.x, v.y, v.z); }

void lmb_end_prepare(lmb_end *end, lmb_vec normal)
{
    end_set(end, normal);
    if (end->excess_q28 > EXCESS_MAX || end->excess_q28 < -EXCESS_MAX) end_set(end, lmb_normalise(normal.x, normal.y, normal.z));
}

static inline int32_t cosine_q28(const lmb_end *a, const lmb_end *b)
{
    int32_t dot = lmb_add(lmb_add(lmb_narrow_(a->x, b->x), lmb_narrow_(a->y, b->y)), lmb_narrow_(a->z, b->z));
    return corrected_q28(dot, lmb_add(a->excess_q28, b->excess_q28));
}

int32_t lmb_ends_measure(lmb_ends *ends)
{
    const int32_t ax = ends->from.x, ay = ends->from.y, az = ends->from.z, bx = ends->to.x, by = ends->to.y, bz = ends->to.z;
    const int32_t dot = lmb_add(lmb_add(lmb_narrow_(ax, bx), lmb_narrow_(ay, by)), lmb_narrow_(az, bz));
    const int32_t a = lmb_sub(lmb_add(lmb_add(lmb_narrow_(ax, ax), lmb_narrow_(ay, ay)), lmb_narrow_(az, az)), 0x10000000);
    const int32_t b = lmb_sub(lmb_add(lmb_add(lmb_narrow_(bx, bx), lmb_narrow_(by, by)), lmb_narrow_(bz, bz)), 0x10000000);
    ends->from.excess_q28 = a;
    ends->to.excess_q28 = b;
    return lmb_max(lmb_sub(0x10000000, corrected_q28(dot, lmb_add(a, b))), 0);
}

int32_t lmb_ends_u_q28(const lmb_ends *ends) { return lmb_max(lmb_sub(0x10000000, cosine_q28(&ends->from, &ends->to)), 0); }

/* A component times scale: 15 bits by 17. */
static int32_t beam_component(int32_t x_q14, int32_t scale_q16) { return lmb_shr_round(lmb_mul(x_q14, scale_q16), 14); }

/* scale less half the excess of it, and less a unit, so that rounding makes no term larger than scale. */
void lmb_beam_prepare(lmb_beam *beam, lmb_vec ray, uint32_t scale)
{
    lmb_end end;
    int32_t scale_q16 = (int32_t)scale, peak;
    lmb_end_prepare(&end, ray);
    scale_q16 = lmb_sub(scale_q16, lmb_shr(lmb_mul(lmb_shr(scale_q16, 3), lmb_shr(end.excess_q28, 4)), 22));
    scale_q16 = lmb_max(lmb_sub(scale_q16, 1), 0);
    beam->x_q16 = beam_component(end.x, scale_q16);
    beam->y_q16 = beam_component(end.y, scale_q16);
    beam->z_q16 = beam_component(end.z, scale_q16);
    peak = lmb_add(lmb_add(lmb_mul(beam->x_q16, end.x), lmb_mul(beam->y_q16, end.y)), lmb_mul(beam->z_q16, end.z));
    beam->peak_q30 = lmb_shl(corrected_q28(lmb_shr(peak, 2), end.excess_q28), 2);
}

void lmb_arc_beam(const lmb_arc *arc, lmb_term *term, const lmb_ends *ends, const lmb_beam *beam)
{
    int32_t a = corrected_q28(lmb_shr(lit_q30(&ends->from, beam), 2), ends->from.excess_q28);
    int32_t b = corrected_q28(lmb_shr(lit_q30(&ends->to, beam), 2), ends->to.excess_q28);
    start_exact(arc, term, a, lmb_sub(b, a));
}

void lmb_arc_beam_rough(const lmb_arc *arc, lmb_term *term, const lmb_ends *ends, const lmb_beam *beam)
{
    int32_t a_q30;
    if (arc->direct) {
        lmb_arc_beam(arc, term, ends, beam);
        return;
    }
    a_q30 = lit_q30(&ends->from, beam);
    start_rough(arc, term, a_q30, lmb_sub(lit_q30(&ends->to, beam), a_q30));
}

/* ------------------------------------------------------------------------------------------------- from normals, on their own */

void lmb_arc_between(lmb_arc *arc, lmb_vec from, lmb_vec to, uint32_t length, uint32_t start)
{
    lmb_ends ends;
    lmb_end_prepare(&ends.from, from);
    lmb_end_prepare(&ends.to, to);
    lmb_arc_prepare(arc, lmb_ends_u_q28(&ends), length, start);
}

void lmb_arc_dot(const lmb_arc *arc, lmb_term *term, lmb_vec from, lmb_vec to, lmb_vec ray, uint32_t scale)
{
    lmb_end end, light;
    int32_t a, b;
    lmb_end_prepare(&light, ray);
    lmb_end_prepare(&end, from);
    a = cosine_q28(&end, &light);
    lmb_end_prepare(&end, to);
    b = cosine_q28(&end, &light);
    if (scale < 65536) {
        a = lmb_mul_q16(a, scale);
        b = lmb_mul_q16(b, scale);
    }
    start_exact(arc, term, a, lmb_sub(b, a));
    term->c = 0;
}

/* From half the angle, which is 60 degrees at most: sin(phi) = 2 sin(h) cos(h), kappa = 4 sin^2(h). */
lmb_turn lmb_arc_turn(int32_t u_q28, uint32_t length)
{
    const int32_t turn_q28 = u_q28 < LMB_ARC_U_MAX ? u_q28 : u_q28 > LMB_ARC_U_MAX ? 0 : LMB_ARC_U_MAX - 1;
    uint32_t m_q31 = length > LMB_ARC_PIXEL ? length : LMB_ARC_PIXEL;
    const unsigned shift = 31 - raise(&m_q31), guard = shift > 16 ? shift - 16 : 0; /* m 2^-guard is 1 to 2 */
    const int32_t ratio_q28 = lmb_shl(divided(angle_over_sine_q28(turn_q28), m_q31), 1);
    const int32_t quarter_q28 =
        lmb_shr(product_q28(square_q28(ratio_q28), sine_squared_q28(turn_q28)), 2); /* h^2, scaled twice */
    const int32_t real_q28 = lmb_shr(quarter_q28, 2 * guard), loss_q28 = sine_loss_q28(real_q28);
    const int32_t fall_q28 = lessen(lmb_shr(real_q28, 1), cosine_loss_q28(real_q28));
    const int32_t square = lessen(lessen(quarter_q28, loss_q28), loss_q28); /* sin^2(h), scaled twice: at most 1.1 */
    lmb_turn turn;
    turn.kappa_q30 = guard > 1 ? (uint32_t)square >> (2 * guard - 4) : (uint32_t)square << (4 - 2 * guard);
    turn.sine_q30 = ((uint32_t)lessen(lessen(ratio_q28, loss_q28), fall_q28) << 2) >> guard;
    return turn;
}
