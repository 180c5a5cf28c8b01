/* SPDX-License-Identifier: MIT */
/* Inline steps along an arc: the recurrence of paper 001 in a form that keeps its angle in fixed point, and as published. */
#ifndef LMB_ARC_H
#define LMB_ARC_H

#include "lambent.h"

/* Both mantissas below share a 32-bit product with f: |f| <= 1.0625 in Q2.30, so |f >> 13| <= 1.0625 * 2^17. */
#define LMB_ARC_KAPPA_MAX 15420
LMB_STATIC_ASSERT((int64_t)LMB_ARC_KAPPA_MAX * 139264 <= INT32_MAX);

/* A term one pixel further along its arc: f(t+1) = 2 cos(phi) f(t) - f(t-1) (paper 001, eq. 7 and 14) in difference form
 * (Reinsch): f <- f + d, d <- d - kappa f with kappa = 4 sin^2(phi/2).
 *   Why     phi is small, and rounding 2 cos(phi) near two loses it; kappa has an exponent of its own and keeps 13.9 bits at any
 *           phi. d carries guard bits below those of f, since at m pixels it is m times smaller and is added m times.
 *   Bounds  kappa <= LMB_ARC_KAPPA_MAX and |f| <= 1.0625: the product stays inside int32_t. lmb_arc_start scales d to 1.3 at
 *           most. One pixel past the end f is still in range (see arc.c).
 *   Error   kappa's rounding is one of angle, at most 2^-15 psi. f >> 13 rounds down, which moves the centre that f swings about
 *           by 2^-18; lmb_arc_start allows for it.
 *   Cost    one multiplication (low word), three shifts, two additions */
static inline void lmb_arc_step(const lmb_arc *arc, lmb_term *term)
{
    term->f = lmb_add(term->f, lmb_shr(term->d, arc->guard));
    term->d = lmb_sub(term->d, lmb_shr(lmb_mul(arc->kappa, lmb_shr(term->f, 13)), arc->kappa_shift));
}

#endif
