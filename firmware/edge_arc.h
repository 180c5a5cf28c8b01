/* SPDX-License-Identifier: MIT */
/* Normals along the edges of a triangle of LMB_SPAN_ARC. Inside the library only. */
#ifndef LMB_EDGE_ARC_H
#define LMB_EDGE_ARC_H

#include "lambent.h"

#if LMB_WITH_ARC

/* Walks the normal of a side, 0 the left one and 1 the right, whose edge has just been placed on row t->y. */
void lmb_edge_arc_begin(lmb_triangle *triangle, unsigned side, const lmb_vertex *top, const lmb_vertex *bottom);

/* One row down, on both sides. */
void lmb_edge_arc_step(lmb_triangle *triangle);

/* The terms of a span, whose first pixel is hidden columns right of the left edge. */
void lmb_edge_arc_span(const lmb_triangle *triangle, lmb_span *span, int32_t hidden);

#else

static inline void lmb_edge_arc_begin(lmb_triangle *triangle, unsigned side, const lmb_vertex *top, const lmb_vertex *bottom)
{
    (void)triangle, (void)side, (void)top, (void)bottom;
}
static inline void lmb_edge_arc_step(lmb_triangle *triangle) { (void)triangle; }
static inline void lmb_edge_arc_span(const lmb_triangle *triangle, lmb_span *span, int32_t hidden)
{
    (void)triangle, (void)span, (void)hidden;
}

#endif
#endif
