/* SPDX-License-Identifier: MIT */
/* From normals to terms: what light does at corners, over a triangle and along a span. Inside the library only. */
#ifndef LMB_SHADE_H
#define LMB_SHADE_H

#include "plane.h"

/* Sets the terms of a triangle up for look->model and look->step: planes, which stand at the lattice's anchor, or the choice of
 * arcs. Begins the lattice for the corners, clockwise on the screen with y down. */
void lmb_shade_begin(lmb_triangle *triangle, lmb_lattice *lattice, const lmb_vertex *const corner[3]);

/* Starts all terms of an arc span between two normals, length and start as lmb_arc_prepare has them. */
void lmb_shade_arc(const lmb_triangle *triangle, lmb_span *span, lmb_vec from, lmb_vec to, uint32_t length, uint32_t start);

#endif
