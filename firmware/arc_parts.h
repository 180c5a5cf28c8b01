/* SPDX-License-Identifier: MIT */
/* What the set-ups of arcs and curves have in common. Inside the library only. */
#ifndef LMB_ARC_PARTS_H
#define LMB_ARC_PARTS_H

#include "arc.h"
#include "flash.h"

static inline int32_t low_half(int32_t a) { return (uint16_t)a; }

/* Whether zeros are counted and shifted out in the same steps. */
#if defined(__OPTIMIZE_SIZE__) || (defined(__GNUC__) && (!defined(__arm__) || defined(__ARM_FEATURE_CLZ)) &&                     \
                                   !defined(__riscv) && !defined(__AVR__) && !defined(__XTENSA__))
#define LMB_CLZ_BY_STEPS 0
#else
#define LMB_CLZ_BY_STEPS 1
#endif

/* x up to where bit 31 is set; by how much, 31 for 0. Where this is no instruction, both at once are as cheap as one. */
static inline unsigned raise(uint32_t *x)
{
#if !LMB_CLZ_BY_STEPS
    unsigned n = lmb_clz32(*x | 1);
    *x <<= n;
    return n;
#else
    uint32_t y = *x;
    unsigned n = 0;
    if (y >> 16 == 0) y <<= 16, n = 16;
    if (y >> 24 == 0) y <<= 8, n += 8;
    if (y >> 28 == 0) y <<= 4, n += 4;
    if (y >> 30 == 0) y <<= 2, n += 2;
    if (y >> 31 == 0) y <<= 1, n += 1;
    *x = y;
    return n;
#endif
}

extern const LMB_FLASH uint8_t lmb_reciprocal_table[128]; /* tables/reciprocal_table.h */

/* 1/x for x in [1, 2), within 1/207. */
static inline int32_t inverse_q9(uint32_t x_q31) { return 256 + lmb_reciprocal_table[x_q31 << 1 >> 25]; }

/* 1 - m r, of which the low word of m r is enough since it is small: r near 1/m, Q0.9. */
static inline int32_t residue_q32(uint32_t m_q31, int32_t r_q9) { return lmb_signed(0u - (m_q31 >> 8) * (uint32_t)r_q9); }

/* With |a| = 1 + x and |b| = 1 + y the cosine is a.b (1 - x)(1 - y) but for squares of x and y, and x is half the excess of a: a
 * dot product less half the sum of the excesses of it. */
static inline int32_t corrected_q28(int32_t dot_q28, int32_t excess_q28)
{
    return lmb_sub(dot_q28, lmb_shr(lmb_mul(lmb_shr(dot_q28, 16), excess_q28), 13));
}

/* The dot product of an end and a beam. */
static inline int32_t lit_q30(const lmb_end *end, const lmb_beam *beam)
{
    return lmb_add(lmb_add(lmb_mul(end->x, beam->x_q16), lmb_mul(end->y, beam->y_q16)), lmb_mul(end->z, beam->z_q16));
}

/* Measures both ends, then lmb_ends_u_q28. */
int32_t lmb_ends_measure(lmb_ends *ends);

#endif
