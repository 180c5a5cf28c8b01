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

/* One row down along an edge. */
static inline void lmb_edge_step(lmb_edge *edge)
{
    int32_t gap = lmb_sub(edge->gap, edge->part), x = lmb_add(edge->x, edge->step);
    if (gap < 0) {
        gap = lmb_add(gap, edge->modulus);
        x = lmb_add(x, 1);
    }
    edge->gap = gap;
    edge->x = x;
}

/* A plane one row down. */
static inline void lmb_plane_row(lmb_plane *plane)
{
    plane->f = lmb_add_wrap(plane->f, plane->dy);
    plane->dx = lmb_add_wrap(plane->dx, plane->dxy);
    plane->dy = lmb_add_wrap(plane->dy, plane->dyy);
}

/* n (n - 1) / 2: even before it is halved, and below 2^32. |n| < 2^16. */
static inline int32_t lmb_pairs(int32_t n) { return lmb_signed(((uint32_t)n * ((uint32_t)n - 1u)) >> 1); }

/* The term of a plane some columns right of where it stands. */
static inline lmb_term lmb_plane_term(const lmb_plane *plane, int32_t columns)
{
    lmb_term term = {plane->f, plane->dx, plane->dxx};
    term.f = lmb_add_wrap(term.f, lmb_mul_wrap(columns, term.d));
    term.f = lmb_add_wrap(term.f, lmb_mul_wrap(lmb_pairs(columns), term.c));
    term.d = lmb_add_wrap(term.d, lmb_mul_wrap(columns, term.c));
    return term;
}

#endif
