/* SPDX-License-Identifier: MIT */
/* Ways along a span, defined in double: paper 001's own, those that it compares itself with, and those that came after it.
 *
 * A span has m steps between the unit normals at its ends, psi apart. Wanted is f(t) = N(t).L at t = 0 ... m, where the normal
 * turns evenly (paper 001, eq. 2). One name each, used by programs, CSV and charts alike. */
#ifndef PAPERS_STEPS_H
#define PAPERS_STEPS_H

#include "count.h"

#define PAPER_PIXELS_MAX 4096

typedef struct paper_vector {
    double x, y, z;
} paper_vector;

typedef struct paper_span {
    paper_vector from, to; /* normals, unit unless a test wants them otherwise */
    paper_vector ray;      /* L or H, unit */
    unsigned pixels;       /* m */
} paper_span;

typedef struct paper_step {
    const char *name, *source, *formula;
    void (*run)(const paper_span *span, double *f); /* writes f[0] ... f[pixels] */
} paper_step;

extern const paper_step paper_steps[];
extern const unsigned paper_step_count;

/* The step of a name; the program ends if there is none. */
const paper_step *paper_step_named(const char *name);

/* What a step costs a pixel more and a span, by counting spans of 24 and of 48 pixels. A span's part includes f[0]. */
void paper_step_cost(const paper_step *step, paper_cost *pixel, paper_cost *span);

/* N(t) by the equation of that number, 2 to 6; of equation 6 t is whole pixels, as of all. */
paper_vector paper_normal(int equation, const paper_span *span, double t);

/* f(t) by the definition, with none of the code above: the angle from half angles, exact where sines and cosines cancel. */
double paper_exact(const paper_span *span, double t);

/* The span whose normals are psi apart, and whose ray lies phase past the first in their plane and lift above it. */
paper_span paper_span_flat(double psi, unsigned pixels, double phase, double lift);

/* The largest |f - paper_exact| along a span; the step's values alone. */
double paper_step_error(const paper_step *step, const paper_span *span);

/* The same, the worst over rays all round the plane of the normals, within it and lifted out of it. */
double paper_step_worst(const paper_step *step, double psi, unsigned pixels);

/* Reflection map of so many cells a side, one map for normals towards the viewer and one for those away. */
void paper_reflection_map(const paper_span *span, double *f, unsigned cells);

static inline double paper_dot(paper_vector a, paper_vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

#endif
