/* SPDX-License-Identifier: MIT */
/* What each core takes for each class of work. */
#include "costs.h"

#include "costs_table.h"

double cost_each(const cost_core *core, int class) { return (double)costs[class][core->column]; }

double cost_sum(const cost_core *core, const cost_counts *counts, double parts[COST_PARTS])
{
    double all = 0;
    int i;
    for (i = 0; i < COST_PARTS; i++) parts[i] = 0;
    for (i = 0; i < COST_CLASSES; i++) {
        const double cost = counts->of[i] * cost_each(core, i);
        parts[cost_kind_of(i).part] += cost;
        all += cost;
    }
    return all;
}
