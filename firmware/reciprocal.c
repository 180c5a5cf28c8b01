/* SPDX-License-Identifier: MIT */
/* Reciprocal of an integer: a line and three steps of Newton's method, in 32-bit products alone. */
#include "lambent.h"

/* With m = x / 2^shift in [1, 2):
 *   line   r0 = 1.414 - 15/32 m, |1 - m r0| = |e0| < 0.066
 *   step   r1 = r0 (2 - m r0), 11 bits, and 2 in 2^10 more: without them it would be below 1/m by e0^2 and the rounding; with
 *          them |1 - m r1| = |e1| < 2^-8. At m = 2 it is exact, so that the result stays in its range. 2 in Q31 wraps to 0
 *   step   r2 = r1 (1 + e1), 17 bits: below 1/m by e1^2 and the roundings, all of which go down
 *   step   r3 = r2 (1 + e2), below 1/m by e2^2 and roundings
 * m r1 needs 42 bits and m r2 48, but their top ones are known, as both are nearly one: the low word of the product alone gives
 * e1 and e2, where a 64-bit product is a call on cores like M0+. For e2, which lies in [0, 2^-15), that holds as long as r2 never
 * exceeds 1/m: m is rounded up wherever it loses bits, everything else down (hosttest/test_vec.c, all 2^32 arguments). */
uint32_t lmb_reciprocal(uint32_t x, unsigned *shift)
{
    unsigned zeros = lmb_clz32(x > 0 ? x : 1);
    uint32_t m_q31 = (x > 0 ? x : 1) << zeros, m_q15 = m_q31 >> 16;
    uint32_t r0_q16 = 92672 - m_q15 + (m_q15 >> 4);
    uint32_t r1_q10 = (lmb_mulu(r0_q16, (0u - lmb_mulu(m_q15, r0_q16)) >> 16) >> 21) + 2;
    int32_t e1_q32 = lmb_signed(0u - ((m_q31 >> 9) + 1) * r1_q10); /* wraps */
    uint32_t r2_q17 = (r1_q10 << 7) + (uint32_t)lmb_shr(lmb_mul(lmb_shr(e1_q32, 4), (int32_t)r1_q10), 21);
    uint32_t e2_q47 = 0u - (m_q31 - (m_q31 >> 1)) * r2_q17; /* wraps */
    *shift = 31 - zeros;
    return (r2_q17 << 14) + (lmb_mulu(e2_q47 >> 17, r2_q17) >> 16);
}
