/* SPDX-License-Identifier: MIT */
/* Linear and quadratic functions over a triangle, from their values at corners and mid-edges. Inside the library only. */
#ifndef LMB_PLANE_H
#define LMB_PLANE_H

#include "lambent.h"

/* What all planes of one triangle share. With p a position relative to corner 0 in 1/16 pixel, the barycentric coordinates of corners
 * 1 and 2 are lambda1 = (x[0] px + y[0] py) / area and lambda2 = (x[1] px + y[1] py) / area. */
typedef struct lmb_lattice {
    int32_t x[2], y[2];         /* |.| < 2^bits */
    unsigned bits;
    bool large;                 /* reaches over more than 512 pixels: products are formed in 64 bits, and the anchor may be moved */
    bool curved;                /* square_q16 and what follows are valid */
    int32_t column;             /* the anchor: the pixel where planes are set up */
    int32_t rows;               /* from there to the row where they begin */
    int32_t offset_x, offset_y; /* from corner 0 to the anchor's centre, 1/16 pixel; -7 to 8 unless large */
    uint32_t reciprocal_q16;    /* 1 / area = reciprocal_q16 * 2^-(16 + shift) */
    unsigned shift;
    uint32_t square_q16;        /* 1 / area^2 = square_q16 * 2^-(16 + 2 shift) */
    /* Products of numerators, from which each quadratic takes its six numbers: value, dx, dy, dxx/2, dyy/2, dxy/2, each as
     * (lambda1 lambda1, lambda2 lambda2, lambda1 lambda2 twice), and what they have been shifted down by. */
    int32_t form[6][3];
    unsigned form_shift[6];
} lmb_lattice;

/* A function over the triangle in Q4.28, as a Bezier net: its values at the corners, and its bulges on edges 01, 12, 20, mid-edge
 * value minus the mean of the edge's ends. */
typedef struct lmb_net {
    int32_t value[3], bulge[3];
} lmb_net;

/* Sets a lattice up for three corners, clockwise on the screen with y down, and planes that begin on a row; curved: for planes with
 * bulges too. */
void lmb_lattice_begin(lmb_lattice *lattice, const lmb_vertex *const corner[3], int32_t row, bool curved);

/* The plane through a net, on the lattice's row and column. Bulges count if the lattice is curved. */
void lmb_plane_begin(lmb_plane *plane, const lmb_lattice *lattice, const lmb_net *net);

/* One row down. */
static inline void lmb_plane_down(lmb_plane *plane)
{
    plane->f = lmb_add_wrap(plane->f, plane->dy);
    plane->dy = lmb_add_wrap(plane->dy, plane->dyy);
    plane->dx = lmb_add_wrap(plane->dx, plane->dxy);
}

/* f + n d + n (n - 1) / 2 c and d + n c: a term n steps on, |n| < 2^16. n (n - 1) is even and below 2^32, so its half is exact. */
static inline lmb_term lmb_term_move(int32_t f, int32_t d, int32_t c, int32_t n)
{
    lmb_term term;
    term.f = lmb_add_wrap(f, lmb_mul_wrap(n, d));
    term.d = d;
    term.c = c;
    if (c != 0) {
        uint32_t pairs = ((uint32_t)n * ((uint32_t)n - 1u)) >> 1;
        term.f = lmb_add_wrap(term.f, lmb_mul_wrap(lmb_signed(pairs), c));
        term.d = lmb_add_wrap(d, lmb_mul_wrap(n, c));
    }
    return term;
}

/* The term of the plane's row, some columns on. */
static inline lmb_term lmb_plane_term(const lmb_plane *plane, int32_t columns)
{
    return lmb_term_move(plane->f, plane->dx, plane->dxx, columns);
}

#endif
