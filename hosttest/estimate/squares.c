/* SPDX-License-Identifier: MIT */
/* Least squares with no negative unknown, by active sets (Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23), on
 * normal equations of columns scaled to length one. A ten thousand millionth on the diagonal decides where columns are the same. */
#include "squares.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RIDGE 1e-10
#define GRADIENT_LEAST 1e-10

static void *room(size_t n, size_t size)
{
    void *p = calloc(n, size);
    if (!p) {
        fprintf(stderr, "squares: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return p;
}

typedef struct problem {
    size_t n;
    double *product, *right; /* a' a and a' b */
    bool *free;              /* unknowns that may be above zero */
    size_t *index;           /* those */
    double *factor, *trial;
} problem;

/* The least sum over the free unknowns, whatever their signs; others 0. By Cholesky's factor. */
static void solve_free(const problem *p, double *x)
{
    size_t m = 0, i, j, k;
    memset(x, 0, p->n * sizeof *x);
    for (i = 0; i < p->n; i++)
        if (p->free[i]) p->index[m++] = i;
    for (i = 0; i < m; i++) {
        for (j = 0; j <= i; j++) {
            double sum = p->product[p->index[i] * p->n + p->index[j]] + (i == j ? RIDGE : 0);
            for (k = 0; k < j; k++) sum -= p->factor[i * p->n + k] * p->factor[j * p->n + k];
            p->factor[i * p->n + j] = i == j ? sqrt(fmax(sum, RIDGE)) : sum / p->factor[j * p->n + j];
        }
    }
    for (i = 0; i < m; i++) {
        double sum = p->right[p->index[i]];
        for (k = 0; k < i; k++) sum -= p->factor[i * p->n + k] * p->trial[k];
        p->trial[i] = sum / p->factor[i * p->n + i];
    }
    for (i = m; i-- > 0;) {
        double sum = p->trial[i];
        for (k = i + 1; k < m; k++) sum -= p->factor[k * p->n + i] * x[p->index[k]];
        x[p->index[i]] = sum / p->factor[i * p->n + i];
    }
}

/* The unknown at zero whose growth lowers the sum fastest; n for none. */
static size_t steepest(const problem *p, const double *x)
{
    size_t best = p->n, i, k;
    double most = GRADIENT_LEAST;
    for (i = 0; i < p->n; i++) {
        double gradient = p->right[i];
        if (p->free[i] || p->product[i * p->n + i] <= 0) continue;
        for (k = 0; k < p->n; k++) gradient -= p->product[i * p->n + k] * x[k];
        if (gradient > most) most = gradient, best = i;
    }
    return best;
}

/* Goes from x towards better as far as nothing turns negative; what comes to zero is free no more. True if it got there. */
static bool go(problem *p, double *x, const double *better)
{
    double part = 1;
    size_t i;
    for (i = 0; i < p->n; i++)
        if (p->free[i] && better[i] <= 0) part = fmin(part, x[i] / (x[i] - better[i]));
    for (i = 0; i < p->n; i++) {
        x[i] += part * (better[i] - x[i]);
        if (p->free[i] && better[i] <= 0 && x[i] <= 1e-15) {
            x[i] = 0;
            p->free[i] = false;
        }
    }
    return part >= 1;
}

static void minimise(problem *p, double *x)
{
    double *better = room(p->n, sizeof *better);
    size_t rounds, i;
    for (rounds = 0; rounds < 30 * p->n; rounds++) {
        i = steepest(p, x);
        if (i == p->n) break;
        p->free[i] = true;
        do solve_free(p, better);
        while (!go(p, x, better));
        if (!p->free[i]) break; /* it came back at once: rounding is all that is left */
    }
    free(better);
}

void squares_solve(double *x, const double *a, const double *b, size_t rows, size_t columns)
{
    double *length = room(columns, sizeof *length);
    problem p = {columns,
                 room(columns * columns, sizeof(double)),
                 room(columns, sizeof(double)),
                 room(columns, sizeof(bool)),
                 room(columns, sizeof(size_t)),
                 room(columns * columns, sizeof(double)),
                 room(columns, sizeof(double))};
    size_t i, j, k;
    for (k = 0; k < rows; k++)
        for (i = 0; i < columns; i++) length[i] += a[k * columns + i] * a[k * columns + i];
    for (i = 0; i < columns; i++) length[i] = length[i] > 0 ? sqrt(length[i]) : 1;
    for (k = 0; k < rows; k++) {
        const double *row = a + k * columns;
        for (i = 0; i < columns; i++) {
            p.right[i] += row[i] / length[i] * b[k];
            for (j = 0; j < columns; j++) p.product[i * columns + j] += row[i] / length[i] * row[j] / length[j];
        }
    }
    memset(x, 0, columns * sizeof *x);
    minimise(&p, x);
    for (i = 0; i < columns; i++) x[i] /= length[i];
    free(length);
    free(p.product);
    free(p.right);
    free(p.free);
    free(p.index);
    free(p.factor);
    free(p.trial);
}
