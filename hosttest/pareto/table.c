/* SPDX-License-Identifier: MIT */
/* Rows and fronts. */
#include "table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void pareto_table_add(pareto_table *t, const pareto_row *row)
{
    if (t->rows == t->room) {
        t->room = t->room * 2 + 1024;
        t->row = realloc(t->row, t->room * sizeof *t->row);
        if (!t->row) {
            fprintf(stderr, "pareto: out of memory\n");
            exit(EXIT_FAILURE);
        }
    }
    t->row[t->rows++] = *row;
}

static bool same_panel(const pareto_row *a, const pareto_row *b)
{
    return !strcmp(a->core, b->core) && !strcmp(a->scope, b->scope) && !strcmp(a->scene, b->scene);
}

/* Figures count as they are printed, so that whoever reads the file finds the same fronts. */
static double printed(const char *format, double x)
{
    char text[32];
    snprintf(text, sizeof text, format, x);
    return strtod(text, NULL);
}

static bool beats(const pareto_row *a, const pareto_row *b)
{
    return a->cost <= b->cost && a->most <= b->most && (a->cost < b->cost || a->most < b->most);
}

void pareto_table_fronts(pareto_table *t)
{
    unsigned i, k;
    for (i = 0; i < t->rows; i++) {
        t->row[i].cost = printed("%.3f", t->row[i].cost);
        t->row[i].most = printed("%.7f", t->row[i].most);
    }
    for (i = 0; i < t->rows; i++) {
        t->row[i].on_front = true;
        for (k = 0; k < t->rows && t->row[i].on_front; k++)
            if (same_panel(&t->row[i], &t->row[k]) && beats(&t->row[k], &t->row[i])) t->row[i].on_front = false;
    }
}

void pareto_table_print(const pareto_table *t)
{
    unsigned i;
    printf("core,scope,scene,method,cycles,unit,max_abs_error,rms_error,psnr_db,bytes,on_front\n");
    for (i = 0; i < t->rows; i++) {
        const pareto_row *r = &t->row[i];
        printf("%s,%s,%s,%s,%.3f,%s,%.7f,%.7f,%.2f,%.0f,%d\n", r->core, r->scope, r->scene, r->method, r->cost, r->unit, r->most,
               r->rms, pareto_psnr_db(r->rms), r->bytes, r->on_front);
    }
}
