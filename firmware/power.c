/* SPDX-License-Identifier: MIT */
/* Powers: cos^n, the reciprocal square root, and vectors scaled to unit length by it, in 32-bit products alone. */
#include "power.h"
#include "vec.h"

/* a b / 2^30, too small by less than 3; |a|, |b| <= 2^30. The product of the low halves is left out. */
static LMB_OUTLINE int32_t product_q30(int32_t a, int32_t b)
{
    int32_t a_low = a & 0x7fff, b_low = b & 0x7fff, a_high = lmb_shr(a, 15), b_high = lmb_shr(b, 15);
    return lmb_add(lmb_add(lmb_mul(a_high, b_high), lmb_shr(lmb_mul(a_high, b_low), 15)), lmb_shr(lmb_mul(a_low, b_high), 15));
}

/* Squarings over the bits of n, without a lobe's error: what is looked up for each pixel may take its time to be set up. The
 * error of each product, 3 in 2^30, counts as often as there is exponent left, so the result is short by less than
 * 3 (n + 10) / 2^30 of one. */
int32_t lmb_power_q15(unsigned n, int32_t v_q30)
{
    int32_t power = 0x40000000, base = lmb_max(0, lmb_sub(power, v_q30));
    do {
        if (n & 1u) power = product_q30(power, base);
        base = product_q30(base, base);
    } while ((n >>= 1) > 0);
    return lmb_shr_round(power, 15);
}

/* A line and four steps of Newton's method, y <- y (3 - x y^2) / 2. A product that is known to be nearly one needs its low word
 * alone to give h = 1 - x y^2, where a 64-bit product is a call on cores like M0+.
 *   line   2 - x, |h| < 0.24
 *   three  steps of 16 bits; each leaves 3/4 h^2 of h, and what counts at last is the rounding, always down: |h| < 2^-13
 *   t      x y, Q29
 *   h      1 - t y, Q44; from bit 16 on times y: below 2^15 * 2^16
 * Outside the domain products wrap. What remains is 3/8 h^2 and the roundings of t and h. */
uint32_t lmb_rsqrt_q30(uint32_t x)
{
    uint32_t x_q16 = x >> 14, y_q15 = 65536 - (x >> 15), t_q29;
    int32_t h_q44;
    unsigned i;
    LMB_UNROLL
    for (i = 0; i < 3; i++) y_q15 = (y_q15 * ((0xc0000000u - (y_q15 * y_q15 >> 16) * x_q16) >> 16)) >> 15;
    t_q29 = (x >> 16) * y_q15 + ((x & 0xffff) * y_q15 >> 16);
    h_q44 = lmb_signed(0u - t_q29 * y_q15); /* wraps: 2^44, one, is 0 in the low word */
    return (y_q15 << 15) + (uint32_t)lmb_shr(lmb_mul_wrap(lmb_shr(h_q44, 16), lmb_signed(y_q15)), 14);
}

/* All components are shifted up by one distance, so that the largest lies in [2^29, 2^30] and nothing is lost; the one's
 * complement stands for the magnitude of a negative one, which lets -2^30 through as well.
 *   s   |a|^2 / 2^32 + 4 - less than 4.5, so never under 2^26; at most 3 * 2^28 + 4
 *   r   from s or 4 s, whichever lies in [2^28, 2^30)
 * s is off by at most 4 in 2^26, which moves r by 2^-25, and r by LMB_RSQRT_MAX_ERROR: together under 2^-24.4, or 2^-10.4
 * units of the result beyond its rounding; a product adds less than 2^-13. Before its rounding it is at most 2^29 (1 + 2^-24),
 * since it is a component over the length. */
void lmb_vec_normalise(lmb_vec *unit, int32_t x, int32_t y, int32_t z)
{
    int16_t *to = (int16_t *)unit;
    int32_t v[3], s_q28 = 4, r_q29;
    uint32_t magnitudes = 0;
    unsigned up, i, down = 2;
    v[0] = x;
    v[1] = y;
    v[2] = (x | y | z) == 0 ? 1 : z;
    LMB_UNROLL
    for (i = 0; i < 3; i++) magnitudes |= (uint32_t)(v[i] ^ lmb_shr(v[i], 31));
    up = lmb_clz32(magnitudes) - 2;
    LMB_UNROLL
    for (i = 0; i < 3; i++) {
        v[i] = lmb_shl(v[i], up);
        s_q28 = lmb_add(s_q28, lmb_shr(product_q30(v[i], v[i]), 2));
    }
    if (s_q28 < 0x10000000) {
        s_q28 = lmb_shl(s_q28, 2);
        down = 1;
    }
    r_q29 = (int32_t)(lmb_rsqrt_q30((uint32_t)s_q28) >> down);
    LMB_UNROLL
    for (i = 0; i < 3; i++) to[i] = (int16_t)lmb_shr_round(product_q30(v[i], r_q29), 15);
}

lmb_vec lmb_normalise(int32_t x, int32_t y, int32_t z)
{
    lmb_vec unit;
    lmb_vec_normalise(&unit, x, y, z);
    return unit;
}
