/* SPDX-License-Identifier: MIT */
/* Judges estimates by measured frames.
 * usage: estimate_judge csv|verdicts LIST MODEL_FOLDER MEASURED.csv...
 *        estimate_judge costs|loops          the costs that are used, as tables for docs/GROWTH.md
 *   csv       core,scene,model,measured_cycles,estimated_cycles,error a frame; instructions where no manual gives cycles
 *   verdicts  a line for each frame: pass or FAIL, at most 10 % off */
#include "measured.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WORST 0.10

static const cost_core *core_of(const char *name)
{
    unsigned i;
    for (i = 0; i < cost_core_count; i++)
        if (!strcmp(cost_cores[i].name, name)) return &cost_cores[i];
    fprintf(stderr, "estimate: no costs of %s are in port/host/costs_table.h; run make costs\n", name);
    exit(EXIT_FAILURE);
}

/* The estimate of a frame with each stage beside what was measured, for those who look for a class that is missing. */
static void show_stages(const cost_core *core, const cost_counts *counts, const measured *f)
{
    int s, c;
    printf("   ");
    for (s = 0; s < COST_STAGES; s++) {
        double sum = 0;
        for (c = 0; c < COST_CLASSES; c++)
            if ((int)cost_kind_of(c).stage == s) sum += counts->of[c] * cost_each(core, c);
        printf(" %s %.0f for %.0f", cost_stage_names[s], sum, f->stages[s]);
    }
    printf("\n");
}

/* Cores of the tables. */
static const char *const shown[] = {"m0plus", "m4", "rv32imc"};
#define SHOWN 3

static void print_costs(void)
{
    int c, i;
    printf("| stage | class | a cost is of | share | Cortex-M0+ | Cortex-M4 | RV32IMC |\n|---|---|---|---|---|---|---|\n");
    for (c = 0; c < COST_OTHERS; c++) {
        const cost_kind kind = cost_kind_of(c);
        printf("| %s | %s | %s | %s |", cost_stage_names[kind.stage], kind.name, kind.text, cost_part_names[kind.part]);
        for (i = 0; i < SHOWN; i++) printf(" %.1f |", cost_each(core_of(shown[i]), c));
        printf("\n");
    }
}

static void print_loops(void)
{
    const cost_core *core = core_of(shown[0]);
    int loop, what;
    printf("| loop | what it draws | triangle | row | run | pixel | gleam | more | hidden "
           "|\n|---|---|---|---|---|---|---|---|---|\n");
    for (loop = 0; loop < COST_LOOPS; loop++) {
        const cost_kind kind = cost_kind_of(cost_of((enum cost_loop)loop, LOOP_triangle));
        printf("| %.*s | %s |", (int)strcspn(kind.name, "."), kind.name, kind.text);
        for (what = 0; what < COST_OF_LOOP; what++) {
            const double each = cost_each(core, cost_of((enum cost_loop)loop, (enum cost_of_loop)what));
            if (each >= 0.05)
                printf(" %.1f |", each);
            else
                printf(" |");
        }
        printf("\n");
    }
}

int main(int argc, char **argv)
{
    static list l;
    const bool csv = argc > 1 && !strcmp(argv[1], "csv");
    cost_counts *counts;
    int i, failed = 0;
    unsigned k;
    if (argc == 2 && !strcmp(argv[1], "costs")) return print_costs(), EXIT_SUCCESS;
    if (argc == 2 && !strcmp(argv[1], "loops")) return print_loops(), EXIT_SUCCESS;
    if (argc < 5 || (!csv && strcmp(argv[1], "verdicts"))) {
        fprintf(stderr, "usage: estimate_judge csv|verdicts LIST MODEL_FOLDER MEASURED.csv..., or costs, or loops\n");
        return 2;
    }
    list_read(&l, argv[2], argv[3]);
    counts = list_count(&l);
    if (csv) printf("core,scene,model,measured_cycles,estimated_cycles,error\n");
    for (i = 4; i < argc; i++) {
        measurements m;
        const cost_core *core;
        measured_read(&m, argv[i], l.count);
        measured_check(&m, &l, counts);
        core = core_of(m.core);
        for (k = 0; k < l.count; k++) {
            const view *v = &l.cases[k].view.view;
            double parts[COST_PARTS];
            const double sum = cost_sum(core, &counts[k], parts), error = sum / m.frames[k].all - 1;
            if (csv) {
                printf("%s,\"%s\",%s,%.0f,%.0f,%.4f\n", m.core, l.cases[k].text, view_models[v->model], m.frames[k].all, sum,
                       error);
                continue;
            }
            printf("%s estimate %s, %s: %.0f %s, measured %.0f, %+.1f %%\n", fabs(error) <= WORST ? "pass" : "FAIL", m.core,
                   l.cases[k].text, sum, core->unit, m.frames[k].all, 100 * error);
            if (fabs(error) > WORST) {
                failed = 1;
                show_stages(core, &counts[k], &m.frames[k]);
            }
        }
    }
    return failed;
}
