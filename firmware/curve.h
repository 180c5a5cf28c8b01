/* SPDX-License-Identifier: MIT */
/* Spans of arcs and of curves that stand for them. Inside the library only. */
#ifndef LMB_CURVE_H
#define LMB_CURVE_H

#include "lambent.h"

#if LMB_WITH_ARC

/* A run of pixels between two normals, length and start as lmb_arc_prepare has them. */
typedef struct lmb_run {
    lmb_ends ends;
    uint32_t length, start;
} lmb_run;

/* All terms of a run, by rough curves; false where it is too long or its normals turn too far for them. */
bool lmb_run_rough(const lmb_triangle *triangle, lmb_span *span, const lmb_run *run);

/* By curves or arcs. */
void lmb_run_exact(const lmb_triangle *triangle, lmb_span *span, lmb_run *run);

/* All terms of a run whose ends have been placed. The span becomes LMB_SPAN_PLANE where a curve is good enough. */
static inline void lmb_run_terms(const lmb_triangle *triangle, lmb_span *span, lmb_run *run)
{
    if (triangle->rays->rough && lmb_run_rough(triangle, span, run)) return;
    lmb_run_exact(triangle, span, run);
}

#endif
#endif
