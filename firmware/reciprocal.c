/* SPDX-License-Identifier: MIT */
/* Reciprocal of an integer: a table and two steps of Newton's method, in 32-bit products alone. */
#include "flash.h"

#include "../tables/reciprocal_table.h"

LMB_STATIC_ASSERT(sizeof reciprocal_table == 128);

/* With m = x / 2^shift in [1, 2):
 *   guess  r0, 9 bits, |1 - m r0| = |e0| < 2^-7.7 (tables/gen_reciprocal.c)
 *   step   r1 = r0 (1 + e0), 17 bits: below 1/m by e0^2 and the roundings, all of which go down
 *   step   r2 = r1 (1 + e1), below 1/m by e1^2 and roundings
 * m r1 needs 48 bits, but its top ones are known: it lies in (1 - 2^-15, 1], and so the low word of the product alone
 * gives e1, where a 64-bit product is a call on cores like M0+. That holds as long as r1 never exceeds 1/m: m is
 * rounded up wherever it loses bits, everything else down (hosttest/test_vec.c, all 2^32 arguments). */
uint32_t lmb_reciprocal(uint32_t x, unsigned *shift)
{
    unsigned zeros = lmb_clz32(x | (x == 0));
    uint32_t m_q31 = (x | (x == 0)) << zeros;
    uint32_t r0_q9 = 256u + reciprocal_table[(m_q31 >> 24) & 127];
    int32_t e0_q31 = lmb_signed(0x80000000u - lmb_mulu((m_q31 >> 9) + 1, r0_q9)); /* |e0| < 2^24 */
    uint32_t r1_q17 = (r0_q9 << 8) + (uint32_t)lmb_shr(lmb_mul(lmb_shr(e0_q31, 4), (int32_t)r0_q9), 19);
    uint32_t e1_q47 = 0u - (m_q31 - (m_q31 >> 1)) * r1_q17; /* wraps: 2^47 (1 - m r1), in [0, 2^32) */
    *shift = 31 - zeros;
    return (r1_q17 << 14) + (lmb_mulu(e1_q47 >> 17, r1_q17) >> 16);
}
