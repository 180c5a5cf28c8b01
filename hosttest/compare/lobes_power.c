/* SPDX-License-Identifier: MIT */
/* Exact powers in integers, by squaring and multiplying over the bits of n: the library's own lmb_power_q15, whose products are
 * three of 16 bits each, so that n = 1000 errs no more than n = 1. Its argument is one minus the dot product.
 *
 * phong   (R.V)^k, k whole: n / 4 to nearest and at least 1. R.V is the cosine of twice the angle where L, V and N are in one plane
 * blinn   (N.H)^n
 */
#include "../../firmware/power.h"
#include "lobe_parts.h"

#define ONE_Q30 ((int32_t)1 << 30)

/* 1 - c, at most one: beyond a quarter turn the lobes are 0 as they are there. */
void compare_as_versine(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    (void)lobe;
    for (; count-- > 0; cosine_q30++) (argument++)->q = *cosine_q30 > 0 ? ONE_Q30 - *cosine_q30 : ONE_Q30;
}

/* 1 - R.V = 2 - 2 c^2, at most one. */
void compare_as_mirrored(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    (void)lobe;
    for (; count-- > 0; cosine_q30++) {
        int64_t c = *cosine_q30, v = 2 * ((int64_t)ONE_Q30 - (c * c >> 30));
        (argument++)->q = c > 0 && v < ONE_Q30 ? (int32_t)v : ONE_Q30;
    }
}

static COMPARE_INLINE uint32_t phong(const compare_lobe *lobe, compare_argument argument)
{
    return (uint32_t)lmb_power_q15((unsigned)lobe->n_mirrored, argument.q);
}

static COMPARE_INLINE uint32_t blinn(const compare_lobe *lobe, compare_argument argument)
{
    return (uint32_t)lmb_power_q15((unsigned)lobe->n, argument.q);
}

COMPARE_LOBE_SUM(compare_sum_phong, phong)
COMPARE_LOBE_SUM(compare_sum_blinn, blinn)
