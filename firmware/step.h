/* SPDX-License-Identifier: MIT */
/* Inline steps from pixel to pixel: what a fused inner loop is made of. */
#ifndef LMB_STEP_H
#define LMB_STEP_H

#include "lambent.h"

#include "arc.h"
#include "lobe.h"

/* A term over a triangle, one pixel to the right. The state wraps on purpose: f is a polynomial in integers, exact modulo 2^32
 * wherever it is evaluated, and inside the triangle its true value lies in (-2, 2). */
static inline void lmb_plane_step(lmb_term *term)
{
    term->f = lmb_add_wrap(term->f, term->d);
    term->d = lmb_add_wrap(term->d, term->c);
}

#endif
