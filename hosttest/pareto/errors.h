/* SPDX-License-Identifier: MIT */
/* Errors of what pareto.csv compares, each against its definition in double. */
#ifndef PARETO_ERRORS_H
#define PARETO_ERRORS_H

#include "../compare/compare.h"
#include "../compare/steps.h"
#include "../reference.h"
#include "methods.h"

#include <math.h>

typedef struct pareto_errors {
    double most, squares;
    double count;
} pareto_errors;

static inline void pareto_add(pareto_errors *e, double error)
{
    e->most = fmax(e->most, fabs(error));
    e->squares += error * error;
    e->count++;
}

static inline double pareto_rms(const pareto_errors *e) { return e->count > 0 ? sqrt(e->squares / e->count) : 0; }

/* Full scale over the root of the mean square; 99 at most. */
static inline double pareto_psnr_db(double rms) { return rms > 1.2e-5 ? -20 * log10(rms) : 99; }

/* The exact frame of a scene: normals turn evenly along edges and rows, exact powers (reference.h, same_model along arcs). */
typedef struct pareto_truth {
    const scene *s;
    ref_frame frame;
} pareto_truth;

void pareto_truth_begin(pareto_truth *truth, const scene *s);
void pareto_truth_end(pareto_truth *truth);

/* The intensities that a method paints, where it paints, row by row. The program ends if there is no such paint. */
void pareto_frame_intensities(double (*rgb)[3], bool *painted, const scene *s, enum lmb_format format,
                              const pareto_method *method);

/* Errors of the intensities that a method paints, before they are rounded to levels, over all pixels and channels. */
void pareto_frame_errors(pareto_errors *e, const pareto_truth *truth, enum lmb_format format, const pareto_method *method);

/* The same of a method of comparison: from its own sums, before they are packed. False if it does not draw the scene. */
bool pareto_rival_errors(pareto_errors *e, const pareto_truth *truth, const compare_frame *rival);

#endif
