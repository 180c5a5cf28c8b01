/* SPDX-License-Identifier: MIT */
/* Linear and quadratic functions over a triangle, from their values at corners and mid-edges. Inside the library only. */
#ifndef LMB_PLANE_H
#define LMB_PLANE_H

#include "lambent.h"

/* What all planes of one triangle share. With p a position relative to corner 0 in 1/16 pixel, the barycentric coordinates of
 * corners 1 and 2 are lambda1 = (step[0] px + step[2] py) / area and lambda2 = (step[1] px + step[3] py) / area. */
typedef struct lmb_lattice {
    bool large;      /* reaches over more than 512 pixels: products are formed in 64 bits, and the anchor may be moved */
    bool curved;     /* square_q16 and what follows are valid */
    int32_t step[4]; /* |.| < 2^bits */
    unsigned bits;
    int32_t column, row;     /* the anchor: the pixel where planes are set up */
    int32_t offset[2];       /* from corner 0 to the anchor's centre, 1/16 pixel; -7 to 8 unless large */
    uint32_t reciprocal_q16; /* 1 / area = reciprocal_q16 * 2^-(16 + shift) */
    unsigned shift;
    uint32_t square_q16; /* 1 / area^2 = square_q16 * 2^-(16 + 2 shift) */
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

/* Sets a lattice up for three corners, clockwise on the screen with y down; curved: for planes with bulges too. */
void lmb_lattice_begin(lmb_lattice *lattice, const lmb_vertex *const corner[3], bool curved);

/* The plane through a net, at the lattice's anchor. Bulges count if the lattice is curved. */
void lmb_plane_begin(lmb_plane *plane, const lmb_lattice *lattice, const lmb_net *net);

/* The term some columns and rows on from the anchor, |columns|, |rows| < 2^16. */
void lmb_plane_term(lmb_term *term, const lmb_plane *plane, int32_t columns, int32_t rows);

#endif
