/* SPDX-License-Identifier: MIT */
/* Between the two halves of counting: frames (count.c) and calls inside the library (count_calls.c). Inside lmb-estimate only. */
#ifndef LMB_HOST_COUNT_H
#define LMB_HOST_COUNT_H

#include "costs.h"

/* Where calls are counted; NULL: nowhere. */
extern cost_counts *cost_counting;

static inline void cost_add(int class, double times)
{
    if (cost_counting) cost_counting->of[class] += times;
}

/* The spans of a triangle, uncounted. */
bool inside_lmb_triangle_next(lmb_triangle *triangle, lmb_span *span);

/* A span that is filled by itself (fill.c): counted before it is. */
void count_span(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span);

#endif
