/* SPDX-License-Identifier: MIT */
/* The rows of pareto.csv, and the figures that they take from other reports. */
#ifndef PARETO_TABLE_H
#define PARETO_TABLE_H

#include "errors.h"

#define PARETO_WORD 40

typedef struct pareto_row {
    char core[PARETO_WORD], scope[PARETO_WORD], scene[PARETO_WORD], method[PARETO_WORD], unit[PARETO_WORD];
    double cost, most, rms, bytes;
    bool on_front; /* no other of its core, scope and scene is as cheap and as accurate, and cheaper or more accurate */
} pareto_row;

typedef struct pareto_table {
    pareto_row *row;
    unsigned rows, room;
} pareto_table;

/* Adds a row: all but on_front. */
void pareto_table_add(pareto_table *table, const pareto_row *row);

/* Sets on_front of all rows. */
void pareto_table_fronts(pareto_table *table);

void pareto_table_print(const pareto_table *table);

/* What was measured: kernel_cycles.csv, frames of all cores and bytes of kernels, told apart by their numbers of columns. The
 * program ends if a file cannot be read. */
void pareto_costs_read(const char *path);

/* The cores that bytes were read of, in the order of the files; NULL behind the last. */
const char *pareto_core(unsigned i);

/* Cycles, or instructions where no cycles are known, of one unit of a kernel; NaN where the core does not have it. unit, which
 * may be NULL, takes what they are. */
double pareto_kernel_cost(const char *core, const char *kernel, const char **unit);
double pareto_kernel_bytes(const char *core, const char *kernel);

/* A measured frame by its number: core, scene, format and method; false behind the last. Cost and bytes come with it. */
typedef struct pareto_frame {
    char core[PARETO_WORD], scene[PARETO_WORD], method[PARETO_WORD], format[PARETO_WORD], unit[PARETO_WORD];
    double cost, bytes;
} pareto_frame;
const pareto_frame *pareto_frame_at(unsigned i);

/* Rows of the three scopes. */
void pareto_lobes(pareto_table *table);
void pareto_spans(pareto_table *table);
void pareto_frames(pareto_table *table);

#endif
