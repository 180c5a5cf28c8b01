/* SPDX-License-Identifier: MIT */
/* Data of the maps of errors and of drift: hosttest/charts/stability-*.gp. A map is a matrix, rows from the bottom; maps of one chart
 * follow one another with two empty lines between. */
#include "charts.h"

#include "../arc_reference.h"
#include "../compare/steps.h"
#include "lobes.h"
#include "rotation.h"
#include "stability.h"
#include "steps.h"

#include <string.h>

#define FLOOR 1e-6 /* what is less is drawn as that */
#define LOBE_COLUMNS 60
#define LOBE_ROWS 90

static void fail(const char *what)
{
    fprintf(stderr, "chart_data: no method %s\n", what);
    exit(EXIT_FAILURE);
}

/* ------------------------------------------------------------------------------------------------------------- along a span */

static const stability_subject *subject_of(const char *method, bool kernel)
{
    const stability_subject *s;
    int i, n = stability_step_subjects(&s);
    for (i = 0; i < n; i++)
        if (!strcmp(s[i].method, method) && kernel == (strcmp(s[i].arithmetic, "double") != 0)) return &s[i];
    fail(method);
    return NULL;
}

static void write_steps(const char *folder, const char *name, const char *const *method, int count)
{
    static stability_map map;
    const stability_axes *axes = stability_step_axes();
    FILE *file = chart_open(folder, name);
    int i, j, k;
    fprintf(file, "# log10 of the largest error; columns: psi, rows: pixels\n");
    for (k = 0; k < count; k++) {
        stability_sweep(&map, axes, subject_of(method[k], true));
        for (j = 0; j < axes->rows; j++)
            for (i = 0; i < axes->columns; i++)
                fprintf(file, "%.2f%c", log10(fmax(map.error[j][i], FLOOR)), i + 1 < axes->columns ? ' ' : '\n');
        if (k + 1 < count) fprintf(file, "\n\n");
    }
    chart_close(file);
}

/* ------------------------------------------------------------------------------------------------------------------- lobes */

enum measure { ABSOLUTE, RELATIVE, UNCLAMPED };

/* Relative errors are of interest where there is something to be seen: from a tenth of a level of 255 on. */
static double lobe_error(const paper_lobe *lobe, unsigned n, double angle, enum measure measure)
{
    const double want = paper_power(n, angle), got = measure == UNCLAMPED ? lobe->raw(n, angle) : lobe->at(n, angle);
    const double error = fabs(got - want);
    if (measure == RELATIVE) return want < STABILITY_LEVEL / 10 ? FLOOR : error / want;
    return error <= 1e30 ? error : 1e30; /* not a number as well */
}

static void write_lobes(const char *folder, const char *name, const char *const *method, int count, enum measure measure)
{
    double shininess[LOBE_COLUMNS];
    FILE *file = chart_open(folder, name);
    int i, j, k;
    stability_spread(shininess, LOBE_COLUMNS, 1, 1000, false);
    fprintf(file, "# log10 of the error; columns: n, rows: angle\n");
    for (k = 0; k < count; k++) {
        const paper_lobe *lobe = paper_lobe_named(method[k]);
        for (j = 0; j < LOBE_ROWS; j++) {
            for (i = 0; i < LOBE_COLUMNS; i++) {
                const double angle = (j + 0.5) / LOBE_ROWS * PAPER_QUARTER_TURN;
                const double error = lobe_error(lobe, (unsigned)lround(shininess[i]), angle, measure);
                fprintf(file, "%.2f%c", log10(fmax(error, FLOOR)), i + 1 < LOBE_COLUMNS ? ' ' : '\n');
            }
        }
        if (k + 1 < count) fprintf(file, "\n\n");
    }
    chart_close(file);
}

/* ------------------------------------------------------------------------------------------------------------------- drift */

#define DRIFTERS 5
static const char *const drifter[DRIFTERS] = {"lambent", "plain16", "plain32", "block4_32", "eq7_vector32"};

static const compare_step_kernel *kernel_of(const char *name)
{
    unsigned i;
    for (i = 0; i < compare_step_count; i++)
        if (!strcmp(compare_steps[i].name, name)) return &compare_steps[i];
    fail(name);
    return NULL;
}

/* The largest error up to each pixel of a long span. */
static void drift_of(const compare_step_kernel *kernel, double psi, double *worst)
{
    static int32_t f[COMPARE_STEP_PIXELS_MAX + 1 + COMPARE_STEP_SPARE];
    const arc_vector a = {0.2, 0.3, 0.93}, side = {0.9, -0.1, 0.1};
    const arc_vector from = arc_unit(a), across = arc_unit(arc_blend(side, 1, from, -arc_inner(side, from)));
    const lmb_vec first = arc_round(from, 16384), last = arc_round(arc_blend(from, cos(psi), across, sin(psi)), 16384);
    const lmb_vec ray = arc_round(arc_blend(from, cos(psi / 3), across, sin(psi / 3)), 16384);
    const arc_vector n0 = arc_from(first), n1 = arc_from(last), l = arc_from(ray);
    const double turn = arc_angle(n0, n1);
    compare_step_state state;
    unsigned t;
    memset(&state, 0, sizeof state);
    kernel->begin(&state, first, last, ray, COMPARE_STEP_PIXELS_MAX);
    kernel->run(&state, f, COMPARE_STEP_PIXELS_MAX + 1);
    for (t = 0; t <= COMPARE_STEP_PIXELS_MAX; t++) {
        const double x = turn * t / COMPARE_STEP_PIXELS_MAX;
        const double want = (sin(turn - x) * arc_inner(n0, l) + sin(x) * arc_inner(n1, l)) / sin(turn);
        const double error = fabs(ldexp(f[t], -(int)kernel->fraction_bits) - want);
        worst[t] = t ? fmax(worst[t - 1], error) : error;
    }
}

static void write_drift(const char *folder, const char *name, double degrees)
{
    static double worst[DRIFTERS][COMPARE_STEP_PIXELS_MAX + 1];
    FILE *file = chart_open(folder, name);
    double x;
    int k;
    unsigned t, last = 0;
    fprintf(file, "pixel");
    for (k = 0; k < DRIFTERS; k++) {
        fprintf(file, " %s", drifter[k]);
        drift_of(kernel_of(drifter[k]), degrees * ARC_PI / 180, worst[k]);
    }
    fprintf(file, "\n");
    for (x = 1; x <= COMPARE_STEP_PIXELS_MAX; x *= 1.07) {
        t = (unsigned)x;
        if (t == last) continue;
        last = t;
        fprintf(file, "%u", t);
        for (k = 0; k < DRIFTERS; k++) fprintf(file, " %.3g", fmax(worst[k][t], FLOOR / 100));
        fprintf(file, "\n");
    }
    chart_close(file);
}

/* ---------------------------------------------------------------------------------------------------------------- rotation */

static void write_rotation(const char *folder)
{
    static const enum rotation_way ways[] = {ROTATION_SLERP, ROTATION_ROWS, ROTATION_OWN_ARC, ROTATION_OWN_QUADRATIC};
    FILE *file = chart_open(folder, "stability-rotation");
    double degrees;
    int i;
    fprintf(file, "degrees");
    for (i = 0; i < 4; i++) fprintf(file, " %s", rotation_name[ways[i]]);
    fprintf(file, "\n");
    for (degrees = 2; degrees < 91; degrees += degrees < 10 ? 1 : 4) {
        fprintf(file, "%g", degrees);
        for (i = 0; i < 4; i++) {
            double worst = FLOOR;
            unsigned shape;
            for (shape = 0; shape < 3; shape++) {
                const rotation_case c = rotation_make(degrees, shape);
                worst = fmax(worst, rotation_spread(&c, ways[i], 1));
            }
            fprintf(file, " %.3g", worst);
        }
        fprintf(file, "\n");
    }
    chart_close(file);
}

void charts_stability(const char *folder)
{
    static const char *const narrow[] = {"plain16",        "eq7_vector16",   "block4",
                                         "normalise_sqrt", "forward_length", "reflection_map"};
    static const char *const wide[] = {"linear",    "quadratic",    "lyon_taylor",        "kuijk_blake", "plain32",
                                       "block4_32", "eq7_vector32", "normalise_textbook", "lambent"};
    static const char *const lobes[] = {"schlick", "gauss",    "chebyshev_published", "w4",     "w8",
                                        "w16",     "table256", "chebyshev_refit",     "lambent"};
    static const char *const raw[] = {"w2", "w4", "w8", "w16", "chebyshev_published", "lambent"};
    write_steps(folder, "stability-spans-16", narrow, 6);
    write_steps(folder, "stability-spans-32", wide, 9);
    write_lobes(folder, "stability-lobes-absolute", lobes, 9, ABSOLUTE);
    write_lobes(folder, "stability-lobes-relative", lobes, 9, RELATIVE);
    write_lobes(folder, "stability-lobes-unclamped", raw, 6, UNCLAMPED);
    write_drift(folder, "stability-drift-5", 5);
    write_drift(folder, "stability-drift-90", 90);
    write_rotation(folder);
}
