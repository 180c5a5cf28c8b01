/* SPDX-License-Identifier: MIT */
/* The lobes side by side: source, formula, operations, errors and instructions, as a table in Markdown. */
#include "claim.h"
#include "measure.h"

#include <math.h>
#include <stdio.h>

/* The largest absolute error over a range of n: a grid over the visible part, and its neighbourhood once more where tables step. */
static double worst(const paper_lobe *lobe, unsigned from, unsigned to)
{
    double most = 0;
    unsigned n, i;
    for (n = from; n <= to; n++) {
        const double end = fmin(PAPER_QUARTER_TURN, 6 / sqrt(n));
        for (i = 0; i < 8; i++) most = fmax(most, measure_absolute(lobe, n, end * i / 8, end * (i + 1) / 8));
    }
    return most;
}

static void print_operations(lobe_cost c)
{
    static const char *const one[6] = {"product", "addition", "division", "root", "read", "call"};
    const int count[6] = {c.multiplications, c.additions, c.divisions, c.roots, c.reads, c.calls};
    int k, any = 0;
    for (k = 0; k < 6; k++) {
        if (!count[k]) continue;
        printf("%s%d %s%s", any ? ", " : "", count[k], one[k], count[k] > 1 ? "s" : "");
        any = 1;
    }
}

/* Lambent's kernel is called lobe. */
static void print_instructions(const char *report, const char *core, const char *name)
{
    char kernel[64];
    double count;
    snprintf(kernel, sizeof kernel, "lobe-%s", name);
    count = claim_instructions(report, core, kernel);
    if (isnan(count) && name[0] == 'l') count = claim_instructions(report, core, "lobe");
    if (isnan(count))
        printf(" – |");
    else
        printf(" %.0f |", count);
}

void claim_print_lobes(const char *report)
{
    unsigned k;
    printf("| lobe | source | value | runs along a row | operations, n = 100 | error, n = 16 to 1000 | n = 1 to 15 | M0+ | M4 | "
           "RV32IMC "
           "|\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (k = 0; k < paper_lobe_count; k++) {
        const paper_lobe *l = &paper_lobes[k];
        printf("| `%s` | %s | %s | %s | ", l->name, l->source, l->formula, l->argument);
        print_operations(paper_lobe_cost(l, 100, LOBE_CARRIED));
        printf(" | %.2g | %.2g |", worst(l, 16, 1000), worst(l, 1, 15));
        print_instructions(report, "m0plus", l->name);
        print_instructions(report, "m4", l->name);
        print_instructions(report, "rv32imc", l->name);
        printf("\n");
    }
}
