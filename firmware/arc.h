/* SPDX-License-Identifier: MIT */
/* Inline steps along an arc: the recurrence of paper 001 in a form that keeps its angle in fixed point, and as published. */
#ifndef LMB_ARC_H
#define LMB_ARC_H

#include "lambent.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Its product with f >> 13 fits 32 bits as long as |f| <= 1.0625 in Q2.30. */
#define LMB_ARC_KAPPA_MAX 15420
LMB_STATIC_ASSERT(LMB_ARC_KAPPA_MAX <= INT32_MAX / 139264); /* 1.0625 * 2^17 */

/* A term one pixel further along its arc: f(t+1) = 2 cos(phi) f(t) - f(t-1) (paper 001, eq. 7 and 14) in difference form
 * (Reinsch): f <- f + d, d <- d - kappa f with kappa = 2 - 2 cos(phi).
 *   Why     phi is small, and rounding 2 cos(phi) near two loses it; kappa has an exponent of its own and 14 bits of mantissa at
 *           any phi. d carries guard bits below those of f, since over m pixels it is m times smaller and is added m times.
 *   Bounds  |f| <= 1.0625 wherever a pixel is seen and one pixel after; |d|, scaled by 2^guard, < 2
 *   Error   rounding kappa turns the angle by at most 2^-14.9 psi. f >> 13 rounds down, so that f swings about 2^-18 instead of
 *           zero; lmb_arc_start allows for that.
 *   Cost    one multiplication (low word), three shifts, two additions */
static inline void lmb_arc_step(const lmb_arc *arc, lmb_term *term)
{
    term->f = lmb_add(term->f, lmb_shr(term->d, arc->guard));
    term->d = lmb_sub(term->d, lmb_shr(lmb_mul(arc->kappa, lmb_shr(term->f, 13)), arc->kappa_shift));
}

/* A product of components: where int has 16 bits the narrow product is the cheap one; elsewhere loads of int16_t cost more. */
static inline int32_t lmb_narrow_(int32_t a, int32_t b) { return sizeof(int) == 2 ? lmb_mul16(a, b) : lmb_mul(a, b); }

/* The components of an end alone, which are enough for rough curves; and what of it the others want. */
static inline void lmb_end_place(lmb_end *end, int32_t x, int32_t y, int32_t z)
{
    end->x = x;
    end->y = y;
    end->z = z;
}
static inline void lmb_end_measure(lmb_end *end)
{
    const int32_t x = end->x, y = end->y, z = end->z;
    end->excess_q28 = lmb_sub(lmb_add(lmb_add(lmb_narrow_(x, x), lmb_narrow_(y, y)), lmb_narrow_(z, z)), 0x10000000);
}

/* lmb_end_prepare for a normal, Q2.14, that is known to be unit within 2^-11 of its squared length. */
static inline void lmb_end_set(lmb_end *end, int32_t x, int32_t y, int32_t z)
{
    lmb_end_place(end, x, y, z);
    lmb_end_measure(end);
}

/* ----------------------------------------------------------------------------------------------- the forms of paper 001 itself
 * For comparison; their set-ups are in arc_papers.c and are linked only where they are called. All start at the start of the
 * arc. Lengths under a pixel count as one pixel; the other arguments are as for lmb_arc_prepare and lmb_arc_start. */

/* kappa = 2 - 2 cos(phi) and sin(phi) / sin(psi) of an arc before any of the rounding that lmb_arc_prepare does, UQ2.30. */
typedef struct lmb_turn {
    uint32_t kappa_q30, sine_q30;
} lmb_turn;
lmb_turn lmb_arc_turn(int32_t u_q28, uint32_t length);

/* The low 16 bits of x as a signed number: what a register of 16 bits would hold. */
static inline int32_t lmb_wrap16(int32_t x) { return lmb_shr(lmb_shl_wrap(x, 16), 16); }

/* Eq. 14 in 16 bits. f and the value before it in Q2.14, 2 cos(phi) in UQ2.14. Useful on short spans alone: the angle is lost
 * below 0.6 degrees a pixel, and rounding grows with the square of the length until the state wraps (hosttest/report_arc.c). */
typedef struct lmb_plain16 {
    int32_t f, before, twice_cos;
} lmb_plain16;
void lmb_plain16_prepare(lmb_plain16 *term, int32_t u_q28, uint32_t length, int32_t a_q30, int32_t rise_q30);
static inline void lmb_plain16_step(lmb_plain16 *term)
{
    int32_t next = lmb_sub(lmb_shr_round(lmb_mul(term->twice_cos, term->f), 14), term->before);
    term->before = term->f;
    term->f = lmb_wrap16(next);
}

/* Eq. 14 in 32 bits with a 64-bit product, f and cos(phi) in Q2.30. The product rounds down and counts twice, hence the one. The
 * sums wrap on purpose: 2 cos(phi) f can pass two by a hair, its difference from the value before is in range again. */
typedef struct lmb_plain32 {
    int32_t f, before, cosine;
} lmb_plain32;
void lmb_plain32_prepare(lmb_plain32 *term, int32_t u_q28, uint32_t length, int32_t a_q30, int32_t rise_q30);
static inline void lmb_plain32_step(lmb_plain32 *term)
{
    int32_t half = lmb_mul_shr(term->cosine, term->f, 30);
    int32_t next = lmb_add_wrap(lmb_sub_wrap(half, term->before), lmb_add_wrap(half, 1));
    term->before = term->f;
    term->f = next;
}

/* A block of four pixels from the two before it in 16 bits, formats as for lmb_plain16. Eq. 7 and 9 give the first two; (10)
 * and (11) as printed do not hold, not even at phi = 0. Derived again, in the paper's own operands:
 *     f(t+3) = cos(2 phi) (4 cos(phi) f(t) - 2 f(t-1)) - f(t-1)
 *            = 2 cos(2 phi) f(t+1) - f(t-1)
 *     f(t+4) = (4 cos^2(2 phi) + 2 cos(2 phi) - 1) f(t) - 4 cos(phi) cos(2 phi) f(t-1)
 *            = 2 cos(2 phi) f(t+2) - f(t)
 * The second forms are what is computed: five multiplications for four pixels, each product at most 2^30. */
typedef struct lmb_block4 {
    int32_t f, before, twice_cos, twice_cos2;
} lmb_block4;
void lmb_block4_prepare(lmb_block4 *term, int32_t u_q28, uint32_t length, int32_t a_q30, int32_t rise_q30);
static inline void lmb_block4_step(lmb_block4 *term, int32_t next_q14[4])
{
    const int32_t f = term->f, before = term->before;
    int32_t second =
        lmb_sub(lmb_shr_round(lmb_mul(term->twice_cos2, f), 14), lmb_shr_round(lmb_mul(term->twice_cos, before), 14));
    next_q14[0] = lmb_wrap16(lmb_sub(lmb_shr_round(lmb_mul(term->twice_cos, f), 14), before));
    next_q14[1] = lmb_wrap16(lmb_add(second, f));
    next_q14[2] = lmb_wrap16(lmb_sub(lmb_shr_round(lmb_mul(term->twice_cos2, next_q14[0]), 14), before));
    next_q14[3] = lmb_wrap16(lmb_sub(lmb_shr_round(lmb_mul(term->twice_cos2, next_q14[1]), 14), f));
    term->before = next_q14[2];
    term->f = next_q14[3];
}

#ifdef __cplusplus
}
#endif
#endif
