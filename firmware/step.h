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

/* The first pixel whose centre is not left of an edge, and the edge one row down. */
static inline int32_t lmb_stride_step(lmb_stride *stride)
{
    const int32_t x = stride->x;
    stride->x = lmb_add_wrap(x, stride->step); /* below the last row whatever it is */
    return lmb_shr(x, LMB_STRIDE_BITS);
}

/* A plane one row down. */
static inline void lmb_plane_row(lmb_plane *plane)
{
    plane->f = lmb_add_wrap(plane->f, plane->dy);
    plane->dx = lmb_add_wrap(plane->dx, plane->dxy);
    plane->dy = lmb_add_wrap(plane->dy, plane->dyy);
}

/* The term of a plane n columns right of where it stands, in two products. */
static inline lmb_term lmb_plane_term(const lmb_plane *plane, int32_t n)
{
    const int32_t bow = plane->bow, half = lmb_mul_wrap(n, bow), mean = lmb_add_wrap(plane->dx, half);
    lmb_term term;
    term.f = lmb_add_wrap(plane->f, lmb_mul_wrap(n, mean));
    term.d = lmb_add_wrap(mean, lmb_add_wrap(half, bow));
    term.c = lmb_add_wrap(bow, bow);
    return term;
}

#endif
