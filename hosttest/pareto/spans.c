/* SPDX-License-Identifier: MIT */
/* Rows of ways along a span: what a pixel costs with its share of the set-up, and N.L's error along 24 spans of each kind. */
#include "../papers/steps_kernels.h"
#include "table.h"

#include <stdio.h>
#include <string.h>

enum { SPANS = 24 };

static const double degree = 3.14159265358979323846 / 180;

/* How far normals turn along how many pixels: a triangle of a fine mesh, of a coarse one, and two of very few. */
static const struct {
    unsigned degrees, pixels;
} kinds[] = {{5, 8}, {10, 16}, {30, 64}, {90, 240}};

static void measure(pareto_errors *e, const compare_step_kernel *kernel, double psi, unsigned pixels)
{
    static double got[PAPER_PIXELS_MAX + 1];
    unsigned i, t;
    for (i = 0; i < SPANS; i++) {
        const kernel_span span = kernel_span_series(psi, pixels, i);
        const paper_span exact = kernel_span_exact(&span);
        kernel_run(kernel, &span, got);
        for (t = 0; t <= pixels; t++) pareto_add(e, got[t] - paper_exact(&exact, t));
    }
}

/* Code and constants, and the map that is made for a light. */
static double bytes_of(const char *core, const compare_step_kernel *kernel, const char *name)
{
    const bool has_map = !strcmp(kernel->form, "reflection_map");
    return pareto_kernel_bytes(core, name) + (has_map ? sizeof(compare_step_map) : 0);
}

static void rows_of(pareto_table *table, const compare_step_kernel *kernel, unsigned kind, const pareto_errors *e)
{
    char name[PARETO_WORD], setup[PARETO_WORD + 8];
    const char *core;
    unsigned i;
    snprintf(name, sizeof name, "step-%.30s", kernel->name);
    snprintf(setup, sizeof setup, "%s-setup", name);
    for (i = 0; (core = pareto_core(i)); i++) {
        const char *unit = "";
        pareto_row r;
        memset(&r, 0, sizeof r);
        r.cost = pareto_kernel_cost(core, name, &unit) + pareto_kernel_cost(core, setup, NULL) / kinds[kind].pixels;
        if (isnan(r.cost)) continue; /* the core does not have it */
        snprintf(r.core, sizeof r.core, "%s", core);
        snprintf(r.scope, sizeof r.scope, "span");
        snprintf(r.scene, sizeof r.scene, "psi-%u-m-%u", kinds[kind].degrees, kinds[kind].pixels);
        snprintf(r.method, sizeof r.method, "%.39s", kernel->name);
        snprintf(r.unit, sizeof r.unit, "%.39s", unit);
        r.most = e->most;
        r.rms = pareto_rms(e);
        r.bytes = bytes_of(core, kernel, name);
        pareto_table_add(table, &r);
    }
}

void pareto_spans(pareto_table *table)
{
    unsigned i, kind;
    fprintf(stderr, "pareto: ways along a span ...\n");
    for (kind = 0; kind < sizeof kinds / sizeof *kinds; kind++) {
        for (i = 0; i < compare_step_count; i++) {
            pareto_errors e = {0, 0, 0};
            measure(&e, &compare_steps[i], kinds[kind].degrees * degree, kinds[kind].pixels);
            rows_of(table, &compare_steps[i], kind, &e);
        }
    }
}
