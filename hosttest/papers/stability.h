/* SPDX-License-Identifier: MIT */
/* Where methods fail, by sweeps over their whole domain: each is measured on a grid of two parameters, the largest rectangle in which
 * it stays within a level of 255 is its safe region, and that is then attacked with random inputs until none gets through. */
#ifndef PAPERS_STABILITY_H
#define PAPERS_STABILITY_H

#include "../test.h"

#include <stdbool.h>

#define STABILITY_LEVEL (1.0 / 255)

#define STABILITY_COLUMNS 48
#define STABILITY_ROWS 48

/* A method under attack, by whatever sweeps it. */
typedef struct stability_subject {
    const char *method, *arithmetic;
    const void *what;
    /* The largest error of some inputs at (x, y): thorough ones for the grid, a random one else. Not a number counts as infinite. */
    double (*probe)(const struct stability_subject *s, double x, double y, bool thorough, test_random *r);
} stability_subject;

/* The axes of a sweep: values in rising order, and how a region of them reads, as in "psi <= %s deg". */
typedef struct stability_axes {
    double x[STABILITY_COLUMNS], y[STABILITY_ROWS];
    int columns, rows;
    const char *x_name, *x_unit, *y_name, *y_unit;
    bool x_whole, y_whole; /* they take whole numbers alone */
} stability_axes;

typedef struct stability_map {
    double error[STABILITY_ROWS][STABILITY_COLUMNS];
} stability_map;

/* The rectangle left..right, bottom..top of the grid, both ends in; empty if right < left. */
typedef struct stability_region {
    int left, right, bottom, top;
    double max; /* the largest error found inside */
} stability_region;

typedef struct stability_row {
    const char *kind, *method, *arithmetic; /* kind: span, lobe, turned */
    char region[96];
    double max_abs_error;
    bool safe;
} stability_row;

void stability_sweep(stability_map *map, const stability_axes *axes, const stability_subject *s);

/* Finds the region and attacks it with so many random inputs; where one gets through, its surroundings are given up. */
stability_region stability_find(stability_map *map, const stability_axes *axes, const stability_subject *s, int attacks);

/* Two rows: the safe region and the whole domain. Returns how many. */
int stability_report(stability_row out[2], const char *kind, const stability_axes *axes, const stability_subject *s, int attacks);

/* Values from low to high, even in their logarithm; whole: rounded, each once. Returns how many. */
int stability_spread(double *out, int count, double low, double high, bool whole);

/* Every method along a span (angle between its normals by length), every lobe (shininess by angle), and the turned triangle. Rows that
 * they add to out; never more than room. */
int stability_of_steps(stability_row *out, int room);
int stability_of_lobes(stability_row *out, int room);
int stability_of_rotation(stability_row *out, int room);

/* What happens to a method outside of its safe region, in a sentence. */
const char *stability_outside(const char *kind, const char *method);

/* The sweeps' axes and subjects, for charts. */
const stability_axes *stability_step_axes(void);
const stability_axes *stability_lobe_axes(void);
int stability_step_subjects(const stability_subject **out);
int stability_lobe_subjects(const stability_subject **out);

#endif
