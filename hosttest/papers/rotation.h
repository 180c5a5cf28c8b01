/* SPDX-License-Identifier: MIT */
/* Whether a triangle keeps its shading when it is turned on the screen, light and normals with it: what interpolates over the
 * triangle does, what interpolates along rows does not (paper 001 does not mention it). */
#ifndef PAPERS_ROTATION_H
#define PAPERS_ROTATION_H

#include "../arc_reference.h"

enum rotation_way {
    ROTATION_LINEAR,     /* intensities, linear over the triangle: Gouraud */
    ROTATION_NORMALISE,  /* normals, linear over the triangle, normalised: Phong */
    ROTATION_ROWS,       /* normals, linear along edges and rows, normalised at the ends of rows and at pixels */
    ROTATION_SLERP,      /* normals that turn evenly along edges and rows: paper 001, eq. 2 */
    ROTATION_QUADRATIC,  /* quadratic over the triangle, through normalised mid-edge normals */
    ROTATION_OWN_LINEAR, /* the library's: LMB_STEP_LINEAR */
    ROTATION_OWN_QUADRATIC /* LMB_STEP_QUADRATIC */,
    ROTATION_OWN_ARC, /* LMB_STEP_ARC */
    ROTATION_WAYS
};
extern const char *const rotation_name[ROTATION_WAYS];
static inline bool rotation_is_integer(enum rotation_way way) { return way >= ROTATION_OWN_LINEAR; }

/* Corners in pixels about the triangle's middle, counter-clockwise with y up; unit normals. */
typedef struct rotation_case {
    double x[3], y[3];
    arc_vector normal[3], ray;
} rotation_case;

/* A triangle of some 60 pixels a side whose corners' normals lie degrees apart, a ray that lights it where power shows most; shape 0
 * is equilateral, 1 oblique and 2 thin. */
rotation_case rotation_make(double degrees, unsigned shape);

/* The largest difference over a full turn, by steps of whole degrees, of (N.R)^power at one and the same point of the triangle. */
double rotation_spread(const rotation_case *c, enum rotation_way way, unsigned power);

#endif
