/* SPDX-License-Identifier: MIT */
/* From normals to terms: what light does at corners, over a triangle and along a span. Inside the library only. */
#ifndef LMB_SHADE_H
#define LMB_SHADE_H

#include "plane.h"

/* Sets the terms of a triangle up for look->model and look->step: planes, which stand at the lattice's anchor, or the choice of
 * arcs. Begins the lattice for the corners, clockwise on the screen with y down. */
void lmb_shade_begin(lmb_triangle *triangle, lmb_lattice *lattice, const lmb_vertex *const corner[3]);

/* Of rays that know of no mesh. */
#define LMB_BEND_UNKNOWN INT32_MAX

/* How far an edge can bulge, Q4.28, whose normals are no farther apart than lmb_mesh.bend says. */
int32_t lmb_shade_bend(uint16_t bend_q15);

#endif
