/* SPDX-License-Identifier: MIT */
/* The sweeps of stability: that they find regions whose ends are known, that attacks find what a grid misses, that each method has its
 * verdict, and that the library's own methods are safe where they are used. */
#include "papers/stability.h"

#include <string.h>

/* --------------------------------------------------------------------------------------- subjects whose regions are known */

#define TRAP_X 3.3
#define TRAP_Y 5.5

/* Safe up to x = 10. */
static double probe_edge(const stability_subject *s, double x, double y, bool thorough, test_random *r)
{
    (void)s, (void)y, (void)thorough, (void)r;
    return x <= 10 ? STABILITY_LEVEL / 2 : 1;
}

/* The same, but for a spot that no grid point meets. */
static double probe_trap(const stability_subject *s, double x, double y, bool thorough, test_random *r)
{
    if (fabs(log(x / TRAP_X)) < 0.03 && fabs(log(y / TRAP_Y)) < 0.1) return 1;
    return probe_edge(s, x, y, thorough, r);
}

static double probe_never(const stability_subject *s, double x, double y, bool thorough, test_random *r)
{
    (void)s, (void)x, (void)y, (void)thorough, (void)r;
    return NAN;
}

static stability_axes known_axes(void)
{
    stability_axes axes = {.x_name = "x", .x_unit = "", .y_name = "y", .y_unit = ""};
    axes.columns = stability_spread(axes.x, 31, 1, 1000, false);
    axes.rows = stability_spread(axes.y, 21, 1, 100, false);
    return axes;
}

static void test_regions(void)
{
    const stability_axes axes = known_axes();
    const stability_subject edge = {"edge", "", NULL, probe_edge}, trap = {"trap", "", NULL, probe_trap};
    const stability_subject never = {"never", "", NULL, probe_never};
    stability_map map;
    stability_region at;
    stability_row row[2];
    int ok;
    stability_sweep(&map, &axes, &edge);
    at = stability_find(&map, &axes, &edge, 1000);
    ok = at.left == 0 && fabs(axes.x[at.right] - 10) < 1e-6 && at.bottom == 0 && at.top == axes.rows - 1;
    test_verdict(ok && at.max == STABILITY_LEVEL / 2, "stability_region", "an edge at x = 10 is found at %.4g, any y: %d..%d",
                 axes.x[at.right], at.bottom, at.top);
    stability_sweep(&map, &axes, &trap);
    at = stability_find(&map, &axes, &trap, 20000);
    ok = axes.x[at.left] > TRAP_X || axes.x[at.right] < TRAP_X || axes.y[at.bottom] > TRAP_Y || axes.y[at.top] < TRAP_Y;
    test_verdict(ok && at.right >= at.left, "stability_attack",
                 "a spot between grid points drives the region to x %.3g..%.3g, y %.3g..%.3g", axes.x[at.left], axes.x[at.right],
                 axes.y[at.bottom], axes.y[at.top]);
    stability_report(row, "span", &axes, &never, 10);
    test_verdict(!row[0].safe && !row[1].safe && !strcmp(row[0].region, "none"), "stability_never",
                 "what is no number is safe nowhere: %s, %.3g", row[0].region, row[1].max_abs_error);
}

/* -------------------------------------------------------------------------------------------------------- the real sweeps */

static void report_of(const stability_subject *subject, int count, const char *kind, const stability_axes *axes,
                      const char *method, const char *arithmetic, stability_row row[2])
{
    int i;
    row[0].safe = row[1].safe = false;
    for (i = 0; i < count; i++)
        if (!strcmp(subject[i].method, method) && !strcmp(subject[i].arithmetic, arithmetic))
            stability_report(row, kind, axes, &subject[i], 400);
}

static void test_library(void)
{
    const stability_subject *subject;
    stability_row row[2];
    double psi = 0;
    int count = stability_step_subjects(&subject);
    report_of(subject, count, "span", stability_step_axes(), "lambent", "32-bit", row);
    sscanf(row[0].region, "psi <= %lf", &psi); /* the last column of the grid below LMB_ARC_U_MAX */
    test_verdict(row[0].safe && strstr(row[0].region, "any pixels") && psi > 110 && psi < 120 &&
                     row[0].max_abs_error <= 1.0 / 8192,
                 "stability_arc", "%s: %.3g", row[0].region, row[0].max_abs_error);
    report_of(subject, count, "span", stability_step_axes(), "plain16", "16-bit", row);
    test_verdict(row[0].safe && !row[1].safe && row[1].max_abs_error > 0.5, "stability_plain16", "%s: %.3g; everywhere %.3g",
                 row[0].region, row[0].max_abs_error, row[1].max_abs_error);
    count = stability_lobe_subjects(&subject);
    report_of(subject, count, "lobe", stability_lobe_axes(), "lambent", "integer", row);
    test_verdict(row[1].safe && row[1].max_abs_error <= 1.0 / 1000, "stability_lobe", "%s: %.3g", row[0].region,
                 row[1].max_abs_error);
    report_of(subject, count, "lobe", stability_lobe_axes(), "w16", "double before its clamp", row);
    test_verdict(row[1].max_abs_error > 4e28 && row[1].max_abs_error < 5e28, "stability_w16_unclamped",
                 "grows to %.3g at the horizon", row[1].max_abs_error);
}

/* A row without its sentence would be a chart without a verdict. */
static void test_words(void)
{
    const stability_subject *subject;
    const char *missing = NULL;
    int i, count = stability_step_subjects(&subject), all = count;
    for (i = 0; i < count; i++)
        if (!stability_outside("span", subject[i].method)) missing = subject[i].method;
    count = stability_lobe_subjects(&subject);
    for (i = 0; i < count; i++)
        if (!stability_outside("lobe", subject[i].method)) missing = subject[i].method;
    test_verdict(!missing && all > 30 && count > 20, "stability_words", "%d methods; without a sentence: %s", all + count,
                 missing ? missing : "none");
    test_verdict(!stability_outside("span", "nothing"), "stability_words_unknown", "a method that is not there has none");
}

int main(void)
{
    test_regions();
    test_library();
    test_words();
    return test_end();
}
