/* SPDX-License-Identifier: MIT */
/* arc.csv: the largest error of every way along a span, over angles and lengths.
 *
 * plain16, plain32 and lambent are the steps of arc.h alone: they start from the true angle and values, so that nothing but the
 * recurrence errs. All others start from rounded vectors (hosttest/compare/steps.h), and err against the normal that turns evenly
 * between the same vectors, normalised. arithmetic_error is against the same method in double: what its integers cost. */
#include "arc_reference.h"

#include "papers/steps_kernels.h"

#define PHASES 24

#define SPANS 24

enum { PLAIN16, PLAIN32, LAMBENT, STEPS };

static const char *const step_name[STEPS] = {"plain16", "plain32", "lambent"};
static const char *const kernel_name[] = {
    "flat",        "linear",         "quadratic",      "normalise_textbook", "normalise_sqrt", "normalise_multiply",
    "lyon_taylor", "forward_length", "reflection_map", "kuijk_blake",        "eq7_vector16",   "eq7_vector32",
    "block2",      "block3",         "block4",         "block4_32"};

/* Adds the errors of all forms over one arc that starts at the given phase. */
static void measure(double psi, uint32_t pixels, double amplitude, double phase, double worst[STEPS])
{
    const int32_t u = arc_u_q28(psi), a = arc_q30(amplitude * cos(phase));
    const int32_t rise = arc_q30(amplitude * (cos(phase + psi) - cos(phase)));
    lmb_plain16 plain16;
    lmb_plain32 plain32;
    lmb_arc arc;
    lmb_term term;
    uint32_t t;
    lmb_plain16_prepare(&plain16, u, pixels * LMB_ARC_PIXEL, a, rise);
    lmb_plain32_prepare(&plain32, u, pixels * LMB_ARC_PIXEL, a, rise);
    lmb_arc_prepare(&arc, u, pixels * LMB_ARC_PIXEL, 0);
    lmb_arc_start(&arc, &term, a, rise);
    for (t = 0; t <= pixels; t++) {
        const double want = amplitude * cos(phase + psi * t / pixels);
        worst[PLAIN16] = fmax(worst[PLAIN16], fabs(plain16.f / 16384.0 - want));
        worst[PLAIN32] = fmax(worst[PLAIN32], fabs(plain32.f / 1073741824.0 - want));
        worst[LAMBENT] = fmax(worst[LAMBENT], fabs(term.f / 1073741824.0 - want));
        lmb_plain16_step(&plain16);
        lmb_plain32_step(&plain32);
        lmb_arc_step(&arc, &term);
    }
}

/* The rows of one angle and length. The steps of arc.h are exact in double, so that all of their error is arithmetic. */
static void rows(test_random *r, double degrees, uint32_t pixels)
{
    const double psi = degrees * ARC_PI / 180;
    double worst[STEPS] = {0, 0, 0};
    unsigned i, k;
    for (k = 0; k < 3 * PHASES; k++) {
        double phase = 2 * ARC_PI * (k / 3 + test_real(r, 0, 1)) / PHASES;
        measure(psi, pixels, k % 3 ? test_real(r, 0.25, 1) : 1, phase, worst);
    }
    for (k = 0; k < STEPS; k++) printf("%s,%g,%u,%.3g,%.3g\n", step_name[k], degrees, (unsigned)pixels, worst[k], worst[k]);
    for (i = 0; i < sizeof kernel_name / sizeof *kernel_name; i++) {
        kernel_errors e = {0, 0};
        for (k = 0; k < SPANS; k++) {
            const kernel_span span = kernel_span_series(psi, pixels, k);
            kernel_measure(kernel_named(kernel_name[i]), &span, &e);
        }
        printf("%s,%g,%u,%.3g,%.3g\n", kernel_name[i], degrees, (unsigned)pixels, e.whole, e.arithmetic);
    }
}

int main(void)
{
    static const double psi[] = {0.01, 0.1, 0.5, 1, 2, 5, 10, 15, 30, 45, 60, 75, 90, 105, 120};
    static const uint32_t pixels[] = {1, 2, 4, 8, 16, 32, 64, 100, 128, 240, 256, 512, 800, 1024, 2048, 4096};
    test_random r = {0x9E3779B97F4A7C15u};
    unsigned i, j;
    printf("step,psi_degrees,pixels,max_abs_error,arithmetic_error\n");
    for (i = 0; i < sizeof psi / sizeof *psi; i++)
        for (j = 0; j < sizeof pixels / sizeof *pixels; j++) rows(&r, psi[i], pixels[j]);
    return 0;
}
