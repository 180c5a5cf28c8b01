/* SPDX-License-Identifier: MIT */
/* Errors of lobes over regions of the angle, and the search for the regions under which paper 000's table 1 can be read. */
#ifndef PAPERS_MEASURE_H
#define PAPERS_MEASURE_H

#include "lobes.h"

/* The largest |lobe / cos^n - 1|, and |lobe - cos^n|, over [from, to]. */
double measure_relative(const paper_lobe *lobe, unsigned n, double from, double to);
double measure_absolute(const paper_lobe *lobe, unsigned n, double from, double to);

/* Where the lobe itself turns from bending down to bending up. */
double measure_own_inflection(const paper_lobe *lobe, unsigned n);

/* Columns of table 1: what it states for W_4, W_8, W_16 and Schlick, per cent. */
enum { TABLE1_ROWS = 4, TABLE1_INFLECTION = 0, TABLE1_BLOOM = 1 };
extern const char *const table1_rows[TABLE1_ROWS];
extern const double table1_stated[2][TABLE1_ROWS];

/* A region from the centre outwards, a measure and a range of n. */
typedef struct table1_reading {
    const char *text; /* as a definition */
    double percent[TABLE1_ROWS];
    int met;    /* rows that come within a twentieth of what is stated */
    double off; /* how far they are apart, summed */
} table1_reading;

/* The reading under which most rows of a column are met, and these best, of: relative error, the same over the lobe, absolute
 * error; up to where cos^n or the lobe itself is level, every two-hundredth of one; n from 1, from 16, and n = 250 alone. */
const table1_reading *table1_best(int column);

#endif
