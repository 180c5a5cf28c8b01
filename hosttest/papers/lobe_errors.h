/* SPDX-License-Identifier: MIT */
/* What a lobe errs by over the quarter turn, in double or as its kernel reckons it. */
#ifndef PAPERS_LOBE_ERRORS_H
#define PAPERS_LOBE_ERRORS_H

#include "../compare/compare.h"
#include "lobes.h"

#define LOBE_GRID 4096

/* What is measured. */
typedef struct lobe_subject {
    const paper_lobe *lobe;            /* in double, if there is no kernel */
    const compare_lobe_kernel *kernel; /* of integers or floats, or NULL */
    const compare_lobe *prepared;      /* for the kernel and n */
    unsigned n;
} lobe_subject;

/* max_abs and where it is; the mean square is taken evenly over the angle; monotone: never rises with the angle on the grid. */
typedef struct lobe_errors {
    double most, angle, rms;
    int monotone;
} lobe_errors;

/* cos^n on the grid, for all lobes of one n. */
void lobe_truth(double truth[LOBE_GRID + 1], unsigned n);

lobe_errors lobe_measure(const lobe_subject *subject, const double truth[LOBE_GRID + 1]);

#endif
