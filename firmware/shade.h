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

/* Tells rays that no normals of an edge are farther apart than lmb_mesh.bend says. */
void lmb_shade_bend(lmb_rays *rays, const lmb_look *look, uint16_t bend_q15);

#endif
