/* SPDX-License-Identifier: MIT */
/* Linear and quadratic functions over a triangle, from their values at corners and mid-edges. Inside the library only. */
#ifndef LMB_PLANE_H
#define LMB_PLANE_H

#include "lambent.h"

/* What all planes of one triangle share. With p a position relative to corner 0 in 1/16 pixel, the barycentric coordinates of
 * corners 1 and 2 are lambda1 = (step[0] px + step[2] py) / area and lambda2 = (step[1] px + step[3] py) / area. */
typedef struct lmb_lattice {
    const lmb_vertex *const *corner;
    bool ready;  /* what follows is set: by the first plane, as many triangles need none */
    bool graded; /* gradients are set: by the first curve */
    bool rough;  /* large, or some curve too strong for a triangle so thin: planes may leave their bounds by 1/64 */
    bool flat;   /* so thin that no plane takes bulges */
    bool large;  /* reaches over more than 512 pixels: the anchor may be moved */
    bool exact;  /* large, or very thin: lmb_plane_exact serves linear planes, too */
    uint16_t tolerance;
    int32_t step[4];         /* |.| < 2^bits */
    unsigned bits;           /* 1 to 13 unless large */
    int32_t column, row;     /* the anchor: the pixel where planes are set up */
    int32_t offset[2];       /* from corner 0 to the anchor's centre, 1/16 pixel; x -7 to 8, y 0 to 15 unless large */
    uint32_t reciprocal_q16; /* 1 / area = reciprocal_q16 * 2^-(16 + shift) */
    unsigned shift;
    int32_t
        gradient[4]; /* of lambda1, lambda2 in x and in y, as mantissas, |.| < 2^15: 2^(11 + shift - bits) is one over a pixel */
} lmb_lattice;

/* A function over the triangle in Q4.28, as a Bezier net: its values at the corners, and its bulges on edges 01, 12, 20, mid-edge
 * value minus the mean of the edge's ends. */
typedef struct lmb_net {
    int32_t value[3], bulge[3];
    int32_t low, high; /* between which its control values lie: corners, and mid-edges plus twice the bulge */
    bool curved;       /* bulges count */
} lmb_net;

/* Begins a lattice for three corners, clockwise on the screen with y down, which must stay in place, and a look's tolerance. */
static inline void lmb_lattice_begin(lmb_lattice *lattice, const lmb_vertex *const corner[3], uint16_t tolerance)
{
    lattice->corner = corner;
    lattice->tolerance = tolerance;
    lattice->ready = lattice->graded = lattice->rough = false;
}

/* The plane through a net, at the lattice's anchor. Bulges count unless the lattice is flat. */
void lmb_plane_begin(lmb_plane *plane, lmb_lattice *lattice, const lmb_net *net);

/* The same in wider arithmetic, for any lattice (plane_exact.c). */
void lmb_plane_exact(lmb_plane *plane, const lmb_lattice *lattice, const lmb_net *net);

/* Moves a plane some rows down, |rows| < 2^16. */
void lmb_plane_down(lmb_plane *plane, int32_t rows);

/* Half of what was floored, odd numbers up: no farther from the truth. */
static inline int32_t lmb_half(int32_t x) { return lmb_add(lmb_shr(x, 1), x & 1); }

/* Bits of the largest magnitude; shifts values down so that they lie within 2^bits and returns how far. */
unsigned lmb_bits_of(const int32_t *values, unsigned count);
unsigned lmb_fit(int32_t *values, unsigned count, unsigned bits);

#endif
