/* SPDX-License-Identifier: MIT */
/* Arithmetic in double that counts its operations, so that what a method costs is counted where it runs and not by hand. */
#ifndef PAPERS_COUNT_H
#define PAPERS_COUNT_H

#include <math.h>

/* As the papers count: a subtraction is an addition, doubling is a shift. */
typedef struct paper_cost {
    double multiplications, additions, shifts, divisions, roots;
    double sines;    /* and cosines, and their inverses */
    double look_ups; /* in tables */
} paper_cost;

extern paper_cost paper_count; /* of everything below since it was last cleared */

static inline double times(double a, double b) { return paper_count.multiplications++, a * b; }
static inline double plus(double a, double b) { return paper_count.additions++, a + b; }
static inline double minus(double a, double b) { return paper_count.additions++, a - b; }
static inline double twice(double a) { return paper_count.shifts++, 2 * a; }
static inline double over(double a, double b) { return paper_count.divisions++, a / b; }
static inline double root_of(double a) { return paper_count.roots++, sqrt(a); }
static inline double sine_of(double a) { return paper_count.sines++, sin(a); }
static inline double cosine_of(double a) { return paper_count.sines++, cos(a); }
static inline double angle_of(double sine, double cosine) { return paper_count.sines++, atan2(sine, cosine); }

#endif
