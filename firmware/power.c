/* SPDX-License-Identifier: MIT */
/* cos^n without a lobe's error, for ramps: what is looked up for each pixel may take its time to be set up. */
#include "power.h"

/* a b / 2^30, too small by less than 3; a, b <= 2^30. */
static uint32_t product_q30(uint32_t a, uint32_t b)
{
    uint32_t a_low = a & 0x7fff, b_low = b & 0x7fff, a_high = a >> 15, b_high = b >> 15;
    return lmb_mulu(a_high, b_high) + (lmb_mulu(a_high, b_low) >> 15) + (lmb_mulu(a_low, b_high) >> 15);
}

/* Squarings over the bits of n. The error of each product, 3 in 2^30, counts as often as there is exponent left, so the result is
 * short by less than 3 (n + 10) / 2^30 of one. */
int32_t lmb_power_q15(unsigned n, int32_t v_q30)
{
    uint32_t power = 0x40000000, base = power - (uint32_t)v_q30;
    if (v_q30 >= 0x40000000) return 0;
    for (; n > 0; n >>= 1) {
        if (n & 1u) power = product_q30(power, base);
        base = product_q30(base, base);
    }
    return (int32_t)((power + 0x4000u) >> 15);
}
