/* SPDX-License-Identifier: MIT */
/* Data of paper 001's charts: errors of the ways along a span over angle and length, and one span as it is shaded. */
#include "charts.h"

#include "steps_kernels.h"

#define SPANS 24
#define DEGREE (3.14159265358979323846 / 180)

static void head(FILE *file, const char *x, const char *const *name, unsigned names)
{
    unsigned i;
    fprintf(file, "%s", x);
    for (i = 0; i < names; i++) fprintf(file, " %s", name[i]);
    fprintf(file, "\n");
}

/* The worst error of each kernel, as x and a row of figures. Nothing is drawn below 1e-7. */
static void row(FILE *file, double x, const char *const *name, unsigned names, double degrees, unsigned pixels)
{
    unsigned i, k;
    fprintf(file, "%.5g", x);
    for (i = 0; i < names; i++) {
        kernel_errors e = {1e-7, 0};
        for (k = 0; k < SPANS; k++) {
            const kernel_span span = kernel_span_series(degrees * DEGREE, pixels, k);
            kernel_measure(kernel_named(name[i]), &span, &e);
        }
        fprintf(file, " %.4g", e.whole);
    }
    fprintf(file, "\n");
}

static void over_angle(const char *folder)
{
    static const char *const name[] = {"flat",        "linear",  "quadratic", "normalise_sqrt", "lyon_taylor", "reflection_map",
                                       "kuijk_blake", "plain16", "block4",    "eq7_vector16",   "plain32",     "lambent"};
    FILE *file = chart_open(folder, "paper-001-error-psi");
    unsigned i;
    head(file, "psi", name, sizeof name / sizeof *name);
    for (i = 0; i <= 120; i++) {
        const double degrees = 0.1 * pow(1199, i / 120.0); /* to 119.9, short of where the library's arc runs straight */
        row(file, degrees, name, sizeof name / sizeof *name, degrees, 240);
    }
    chart_close(file);
}

static void over_length(const char *folder, const char *chart, double degrees)
{
    static const char *const name[] = {"linear",  "quadratic", "normalise_sqrt", "kuijk_blake",
                                       "plain16", "block4",    "plain32",        "lambent"};
    FILE *file = chart_open(folder, chart);
    unsigned i, last = 0;
    head(file, "pixels", name, sizeof name / sizeof *name);
    for (i = 0; i <= 120; i++) {
        const unsigned pixels = (unsigned)(pow(4096, i / 120.0) + 0.5);
        if (pixels == last) continue;
        row(file, pixels, name, sizeof name / sizeof *name, degrees, pixels);
        last = pixels;
    }
    chart_close(file);
}

/* One row a kernel: errors at 15 and at 90 degrees over 240 pixels; what it costs the chart takes from the report. */
static void by_kernel(const char *folder)
{
    FILE *file = chart_open(folder, "paper-001-cost");
    unsigned i, k, part;
    fprintf(file, "step error15 error90\n");
    for (i = 0; i < compare_step_count; i++) {
        fprintf(file, "%s", compare_steps[i].name);
        for (part = 0; part < 2; part++) {
            kernel_errors e = {0, 0};
            for (k = 0; k < SPANS; k++) {
                const kernel_span span = kernel_span_series((part ? 90 : 15) * DEGREE, 240, k);
                kernel_measure(&compare_steps[i], &span, &e);
            }
            fprintf(file, " %.4g", e.whole);
        }
        fprintf(file, "\n");
    }
    chart_close(file);
}

/* One span of 240 pixels that turns by 90 degrees, the ray in its plane, a third of the way along. */
static void along(const char *folder)
{
    static const char *const name[] = {"linear", "quadratic", "normalise_sqrt", "plain16", "block4", "lambent"};
    enum { NAMES = sizeof name / sizeof *name, PIXELS = 240 };
    static double f[NAMES][PAPER_PIXELS_MAX + 4];
    const paper_span wanted = paper_span_flat(90 * DEGREE, PIXELS, 30 * DEGREE, 0);
    const kernel_span span = kernel_span_of(&wanted);
    const paper_span exact = kernel_span_exact(&span);
    FILE *file = chart_open(folder, "paper-001-span");
    unsigned i, t;
    head(file, "pixel exact", name, NAMES);
    for (i = 0; i < NAMES; i++) kernel_run(kernel_named(name[i]), &span, f[i]);
    for (t = 0; t <= PIXELS; t++) {
        fprintf(file, "%u %.6f", t, paper_exact(&exact, t));
        for (i = 0; i < NAMES; i++) fprintf(file, " %.6f", f[i][t]);
        fprintf(file, "\n");
    }
    chart_close(file);
}

void charts_steps(const char *folder)
{
    over_angle(folder);
    over_length(folder, "paper-001-error-length-15", 15);
    over_length(folder, "paper-001-error-length-90", 90);
    along(folder);
    by_kernel(folder);
}
