/* SPDX-License-Identifier: MIT */
/* The specular lobe at a pixel: max(0, cos)^n from s = alpha - slope * (1 - cos) in at most four multiplications, one addition.
 *
 * Two forms, both of them paper 000's squarings with one constant in between (docs and tables/gen_lobe.c say how they are tuned):
 *
 *   plain    (s^2 + f)^(2^(m-1))                   m = 1 to 4 multiplications; W_m of paper 000 is f = 0, alpha = 1
 *   crossed  (s^2 + g) s, (s^4 + g) s^2, its square  m = 2, 3, 4; runs into zero by itself; exact for n = 3, 6, 12
 *
 * Past their zero all of them grow again, without bound: s is cut off there, and at alpha, where the lobe is one. So no s wraps.
 *
 * Formats: s is Q16.16. Every product is 16 by 16 bits in UQ0.32 and is truncated to UQ0.16; one itself, which UQ0.16 lacks,
 * is met by the comparison with alpha alone. lmb_lobe_prepare takes the largest lift with which s just below alpha stays under
 * one; that makes up for most of the truncation.
 */
#ifndef LMB_LOBE_H
#define LMB_LOBE_H

#include "lambent.h"

#define LMB_LOBE_ONE 32768

/* Bound of the magnitude of what lmb_lobe_argument returns. */
#define LMB_LOBE_ARGUMENT_MAX (1L << 27)

/* Largest difference between a lobe and its own polynomial in real arithmetic, the rounding of s to Q16.16 included. */
#define LMB_LOBE_ROUNDING (1.0 / 3000)

/* s of the lobe at v = 1 - cos.
 *   v_q30   Q2.30; any value: what is below 0 or beyond 2 by rounding gives an s beyond the ends, which the lobe meets
 *   return  Q16.16, rounded down: alpha at v = 0
 *   bounds  v * slope / 2^16 is under 2^31; then slope * v <= 500 * 2 in Q16.16 is under 2^27 */
static inline int32_t lmb_lobe_argument(const lmb_lobe *lobe, int32_t v_q30)
{
    int32_t down = lmb_mul_q16(v_q30, lobe->slope);
    return lmb_add(lmb_shr(lobe->alpha_q30, 14), lmb_shr(lmb_sub(0, down), (unsigned)(13 - lobe->slope_shift)));
}

/* The lobe between its ends, floor < s < alpha, with its form given apart: in a loop over pixels, constants for multiplications
 * and crossed leave no branch.
 *   s_q16   Q16.16; outside the ends it wraps
 *   return  UQ0.32
 *   bounds  plain: s * s and lift wrap, but their sum is in [0, 2^32) between floor and alpha
 *           crossed: (y + lift) * x grows with s and is under 2^32 at the last s below alpha (lmb_lobe_prepare)
 *   cost    multiplications, one addition, a shift for each multiplication but the last */
static inline uint32_t lmb_lobe_inside(const lmb_lobe *lobe, uint32_t s_q16, unsigned multiplications, bool crossed)
{
    uint32_t p = s_q16;
    if (crossed) {
        uint32_t x = p, y = lmb_mulu(p, p) >> 16;
        if (multiplications > 2) {
            x = y;
            y = lmb_mulu(y, y) >> 16;
        }
        p = lmb_mulu((uint32_t)lmb_add((int32_t)y, lobe->lift), x);
        if (multiplications > 3) {
            p >>= 16;
            p = lmb_mulu(p, p);
        }
        return p;
    }
    if (multiplications == 0) return p << 16;
    p = p * p + (uint32_t)lobe->lift;
    for (; multiplications > 1; multiplications--) {
        p >>= 16;
        p = lmb_mulu(p, p);
    }
    return p;
}

/* The lobe at s with its form given apart.
 *   s_q16   Q16.16, any int32: 0 where s <= floor, LMB_LOBE_ONE where s >= alpha
 *   return  UQ1.15 in [0, 32768]; never decreases with s
 *   error   lobe->error_uq16, the rounding of s included
 *   cost    multiplications, one addition, two comparisons, a shift for each multiplication */
static inline int32_t lmb_lobe_at_form(const lmb_lobe *lobe, int32_t s_q16, unsigned multiplications, bool crossed)
{
    if (s_q16 <= (int32_t)lobe->floor_q15 * 2) return 0;
    if (s_q16 >= lmb_shr(lobe->alpha_q30, 14)) return LMB_LOBE_ONE;
    return (int32_t)(lmb_lobe_inside(lobe, (uint32_t)s_q16, multiplications, crossed) >> 17);
}

/* The lobe at s: see lmb_lobe_at_form. */
static inline int32_t lmb_lobe_at(const lmb_lobe *lobe, int32_t s_q16)
{
    return lmb_lobe_at_form(lobe, s_q16, lobe->multiplications, lobe->crossed);
}

/* The lobe at v = 1 - cos, Q2.30; UQ1.15. */
static inline int32_t lmb_lobe_eval(const lmb_lobe *lobe, int32_t v_q30)
{
    return lmb_lobe_at(lobe, lmb_lobe_argument(lobe, v_q30));
}

#endif
