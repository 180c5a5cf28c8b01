/* SPDX-License-Identifier: MIT */
/* The integer kernels of hosttest/compare/steps.h beside their definitions in double: one span, one error. */
#ifndef PAPERS_STEPS_KERNELS_H
#define PAPERS_STEPS_KERNELS_H

#include "../compare/steps.h"
#include "steps.h"

/* A span as kernels take it. */
typedef struct kernel_span {
    lmb_vec from, to, ray;
    unsigned pixels;
} kernel_span;

typedef struct kernel_errors {
    double whole;      /* against the evenly turning normal (eq. 2) of the same vectors, normalised */
    double arithmetic; /* against the same method in double, of the same vectors, normalised */
} kernel_errors;

/* The kernel of a name; the program ends if there is none. */
const compare_step_kernel *kernel_named(const char *name);

/* Runs a kernel: f(0) ... f(pixels). */
void kernel_run(const compare_step_kernel *kernel, const kernel_span *span, double *f);

/* Raises worst to the errors of a kernel along a span. */
void kernel_measure(const compare_step_kernel *kernel, const kernel_span *span, kernel_errors *worst);

/* Quantises a span; and what references take of it, the same vectors normalised. */
kernel_span kernel_span_of(const paper_span *span);
paper_span kernel_span_exact(const kernel_span *span);

/* Span i of a fixed series: the ends psi apart, in a plane that turns about; rays all round them, a third of them in their plane. */
kernel_span kernel_span_series(double psi, unsigned pixels, unsigned i);

#endif
