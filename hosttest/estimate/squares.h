/* SPDX-License-Identifier: MIT */
/* Least squares with no negative unknown. */
#ifndef ESTIMATE_SQUARES_H
#define ESTIMATE_SQUARES_H

#include <stddef.h>

/* Minimises the sum over rows of (a x - b)^2 with x >= 0. a: rows x columns, row after row. A column of nothing gets 0. */
void squares_solve(double *x, const double *a, const double *b, size_t rows, size_t columns);

#endif
