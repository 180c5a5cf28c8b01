/* SPDX-License-Identifier: MIT */
/* Rows of lobes: for each exponent that is charted, and for all from 1 to 1000 together, of which cycles are the mean of those
 * exponents. */
#include "../papers/lobe_errors.h"
#include "exponents.h"
#include "table.h"

#include <stdio.h>
#include <string.h>

enum { METHODS_MAX = 40, SUMMARY = PARETO_EXPONENTS, SETS };

/* A kernel, and for the library's own the most multiplications that it may take; 0: as many as it likes. */
typedef struct method {
    const compare_lobe_kernel *kernel;
    unsigned multiplications;
    char name[PARETO_WORD];                  /* of the row; with lobe- and the exponent that of the profile */
    const char *evaluated[PARETO_EXPONENTS]; /* the kernel for each exponent */
    lobe_errors errors[SETS];
} method;

static method methods[METHODS_MAX];
static unsigned count;

static void methods_add(const compare_lobe_kernel *kernel, unsigned multiplications)
{
    method *m = &methods[count++];
    m->kernel = kernel;
    m->multiplications = multiplications;
    if (multiplications) {
        snprintf(m->name, sizeof m->name, "tuned-%u", multiplications);
    } else {
        snprintf(m->name, sizeof m->name, "%s", kernel->name + strlen("lobe-"));
    }
}

static void methods_set(void)
{
    unsigned i, k;
    for (i = 0; i < compare_lobe_count; i++) {
        const compare_lobe_kernel *kernel = &compare_lobes[i];
        if (!strcmp(kernel->name, "lobe-none")) continue;
        methods_add(kernel, 0);
        for (k = 1; k <= PARETO_MULTIPLICATIONS && !strcmp(kernel->name, "lobe-lambent"); k++) methods_add(kernel, k);
    }
}

static void measure(unsigned n, const double *truth, compare_lobe *prepared)
{
    static compare_lobe other;
    unsigned i, k;
    for (i = 0; i < count; i++) {
        method *m = &methods[i];
        lobe_subject s = {NULL, m->kernel, prepared, n};
        lobe_errors e, *all = &m->errors[SUMMARY];
        if (m->multiplications) {
            other = *prepared;
            s.kernel = pareto_tuned_kernel(&other, n, m->multiplications);
            s.prepared = &other;
        }
        e = lobe_measure(&s, truth);
        for (k = 0; k < PARETO_EXPONENTS; k++) {
            if (pareto_exponents[k] != n) continue;
            m->errors[k] = e;
            m->evaluated[k] = s.kernel->name;
        }
        all->most = fmax(all->most, e.most);
        all->rms += e.rms * e.rms / LMB_SHININESS_MAX; /* the root at the end */
    }
}

/* The library's own is called lobe by the profiler. */
static double cost_of(const char *core, const method *m, unsigned n, const char **unit)
{
    const bool plain = !m->multiplications && !strcmp(m->name, "lambent");
    char name[PARETO_WORD + 16];
    snprintf(name, sizeof name, plain ? "lobe%.0s/%u" : "lobe-%s/%u", m->name, n);
    return pareto_kernel_cost(core, name, unit);
}

/* Code and constants, and the table that is made for an exponent; of all exponents together the most. */
static double bytes_of(const char *core, const method *m, unsigned set)
{
    const bool has_table = !strcmp(m->kernel->name, "lobe-table256");
    double most = 0;
    unsigned k;
    for (k = 0; k < PARETO_EXPONENTS; k++)
        if (set == k || set == SUMMARY) most = fmax(most, pareto_kernel_bytes(core, m->evaluated[k]));
    return most + (has_table ? sizeof(uint16_t) * COMPARE_POWERS : 0);
}

static void rows_of(pareto_table *table, const char *core, unsigned set)
{
    unsigned i, k;
    for (i = 0; i < count; i++) {
        const method *m = &methods[i];
        const char *unit = "";
        pareto_row r;
        memset(&r, 0, sizeof r);
        for (k = 0; k < PARETO_EXPONENTS; k++) {
            const double cost = cost_of(core, m, pareto_exponents[k], &unit);
            if (set == SUMMARY) r.cost += cost / PARETO_EXPONENTS;
            if (set == k) r.cost = cost;
        }
        if (isnan(r.cost)) continue; /* the core does not have it */
        snprintf(r.core, sizeof r.core, "%s", core);
        snprintf(r.scope, sizeof r.scope, "lobe");
        if (set == SUMMARY) snprintf(r.scene, sizeof r.scene, "n-1-1000");
        if (set != SUMMARY) snprintf(r.scene, sizeof r.scene, "n-%u", pareto_exponents[set]);
        memcpy(r.method, m->name, sizeof r.method);
        snprintf(r.unit, sizeof r.unit, "%.39s", unit);
        r.most = m->errors[set].most;
        r.rms = set == SUMMARY ? sqrt(m->errors[set].rms) : m->errors[set].rms;
        r.bytes = bytes_of(core, m, set);
        pareto_table_add(table, &r);
    }
}

void pareto_lobes(pareto_table *table)
{
    static double truth[LOBE_GRID + 1];
    static compare_lobe prepared;
    unsigned n, i, set;
    methods_set();
    for (n = 1; n <= LMB_SHININESS_MAX; n++) {
        if (n % 100 == 1) fprintf(stderr, "pareto: lobes, n = %u ...\n", n);
        if (compare_lobe_prepare(&prepared, n) != LMB_OK) continue;
        lobe_truth(truth, n);
        measure(n, truth, &prepared);
    }
    for (i = 0; pareto_core(i); i++)
        for (set = 0; set < SETS; set++) rows_of(table, pareto_core(i), set);
}
