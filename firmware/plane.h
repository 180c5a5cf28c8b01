/* SPDX-License-Identifier: MIT */
/* Linear and quadratic functions over a triangle, from their values at corners and mid-edges. Inside the library only. */
#ifndef LMB_PLANE_H
#define LMB_PLANE_H

#include "lambent.h"

/* What all planes of one triangle share. With p a position relative to corner 0 in 1/16 pixel, the barycentric coordinates of
 * corners 1 and 2 are lambda1 = (step[0] px + step[2] py) / area and lambda2 = (step[1] px + step[3] py) / area. */
typedef struct lmb_lattice {
    const lmb_vertex *const *corner;
    bool ready;              /* what follows the next two is set: by the first plane, as many triangles need none */
    bool curved;             /* planes take bulges */
    bool rough;              /* large, thin or strongly bent: not all planes keep their bounds within 1/64 */
    bool exact;              /* lmb_plane_exact serves */
    bool large;              /* reaches over more than 512 pixels: the anchor may be moved */
    int32_t step[4];         /* |.| < 2^bits */
    unsigned bits;           /* 1 to 13 unless large */
    int32_t column, row;     /* the anchor: the pixel where planes are set up */
    int32_t offset[2];       /* from corner 0 to the anchor's centre, 1/16 pixel; x -7 to 8, y 0 to 15 unless large */
    uint32_t reciprocal_q16; /* 1 / area = reciprocal_q16 * 2^-(16 + shift) */
    unsigned shift;
    int16_t x[2], y[2]; /* gradients of lambda1, lambda2 as mantissas, |.| < 2^15: 2^(11 + shift - bits) is one over a pixel */
} lmb_lattice;

/* A function over the triangle in Q4.28, as a Bezier net: its values at the corners, and its bulges on edges 01, 12, 20, mid-edge
 * value minus the mean of the edge's ends. */
typedef struct lmb_net {
    int32_t value[3], bulge[3];
    bool curved; /* bulges count */
} lmb_net;

/* Bulges of planes that are not exact lie within this, Q4.28: 0.25. */
#define LMB_BULGE_MAX 0x04000000

/* Begins a lattice for three corners, clockwise on the screen with y down, which must stay in place; curved: for planes with
 * bulges too, bent: with bulges beyond LMB_BULGE_MAX. */
void lmb_lattice_begin(lmb_lattice *lattice, const lmb_vertex *const corner[3], bool curved, bool bent);

/* The plane through a net, at the lattice's anchor. Bulges count if the lattice is curved. */
void lmb_plane_begin(lmb_plane *plane, lmb_lattice *lattice, const lmb_net *net);

/* The same in wider arithmetic, for any lattice (plane_exact.c). */
void lmb_plane_exact(lmb_plane *plane, const lmb_lattice *lattice, const lmb_net *net);

/* Moves a plane some rows down, |rows| < 2^16. */
void lmb_plane_down(lmb_plane *plane, int32_t rows);

/* (high * 2^16 + low) / 2^shift, floored, modulo 2^32. */
int32_t lmb_plane_join(int32_t high, int32_t low, int32_t shift);

/* numerator times the reciprocal of the area, over 2^shift, floored, modulo 2^32. high < 2^15 * 2^16, low < 2^32 as unsigned: its
 * low 16 bits go first. */
static inline int32_t lmb_plane_over_area(int32_t numerator, uint32_t reciprocal_q16, int32_t shift)
{
    uint32_t low = lmb_mulu((uint32_t)numerator & 0xffffu, reciprocal_q16);
    int32_t high = lmb_add_wrap(lmb_mul(lmb_shr(numerator, 16), (int32_t)reciprocal_q16), (int32_t)(low >> 16));
    if (shift >= 16 && shift < 47) return lmb_shr(high, (unsigned)shift - 16);
    return lmb_plane_join(high, (int32_t)(low & 0xffffu), shift);
}

/* Bits of the largest magnitude; shifts values down so that they lie within 2^bits and returns how far. */
unsigned lmb_bits_of(const int32_t *values, unsigned count);
unsigned lmb_fit(int32_t *values, unsigned count, unsigned bits);

#endif
