/* SPDX-License-Identifier: MIT */
/* Vectors whose operations are counted, and the steps that turn; between steps.c and steps_turn.c. */
#ifndef PAPERS_STEPS_PARTS_H
#define PAPERS_STEPS_PARTS_H

#include "steps.h"

#include <stdbool.h>

static inline double dot(paper_vector a, paper_vector b) { return plus(plus(times(a.x, b.x), times(a.y, b.y)), times(a.z, b.z)); }
static inline paper_vector sum(paper_vector a, paper_vector b)
{
    paper_vector v = {plus(a.x, b.x), plus(a.y, b.y), plus(a.z, b.z)};
    return v;
}
static inline paper_vector difference(paper_vector a, paper_vector b)
{
    paper_vector v = {minus(a.x, b.x), minus(a.y, b.y), minus(a.z, b.z)};
    return v;
}
static inline paper_vector scaled(paper_vector a, double s)
{
    paper_vector v = {times(a.x, s), times(a.y, s), times(a.z, s)};
    return v;
}
static inline paper_vector divided(paper_vector a, double d)
{
    paper_vector v = {over(a.x, d), over(a.y, d), over(a.z, d)};
    return v;
}
/* The zero vector stays what it is. */
static inline paper_vector unit(paper_vector a)
{
    const double length = root_of(dot(a, a));
    return length > 0 ? divided(a, length) : a;
}

typedef void paper_run(const paper_span *span, double *f);
paper_run paper_slerp, paper_kuijk_blake, paper_eq7_vector, paper_block2, paper_block3, paper_block4, paper_block3_printed;
paper_run paper_block4_printed, paper_eq14, paper_lambent;

#endif
