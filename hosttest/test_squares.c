/* SPDX-License-Identifier: MIT */
/* Least squares without negative unknowns, by what tells the least apart from all else: where an unknown is above zero the sum does not
 * change with it, where it is zero the sum does not fall (Karush, Kuhn and Tucker). */
#include "estimate/squares.h"
#include "test.h"

#define ROWS 60
#define COLUMNS 24

/* The worst breach of these conditions, of columns of length one, and how many unknowns are zero. */
static double breach(const double *x, const double *a, const double *b, int *zeros)
{
    double worst = 0;
    int i, k, j;
    *zeros = 0;
    for (i = 0; i < COLUMNS; i++) {
        double gradient = 0, length = 0;
        for (k = 0; k < ROWS; k++) {
            double left = -b[k];
            for (j = 0; j < COLUMNS; j++) left += a[k * COLUMNS + j] * x[j];
            gradient += a[k * COLUMNS + i] * left;
            length += a[k * COLUMNS + i] * a[k * COLUMNS + i];
        }
        gradient = length > 0 ? gradient / sqrt(length) : 0;
        *zeros += x[i] == 0;
        worst = fmax(worst, x[i] < 0 ? 1e9 : x[i] > 0 ? fabs(gradient) : -gradient);
    }
    return worst;
}

static void test_least(test_random *random)
{
    double a[ROWS * COLUMNS], b[ROWS], x[COLUMNS], worst = 0;
    int round, i, k, zeros, all = 0;
    for (round = 0; round < 500; round++) {
        for (k = 0; k < ROWS; k++) {
            b[k] = test_real(random, -1, 3);
            for (i = 0; i < COLUMNS; i++) a[k * COLUMNS + i] = test_real(random, -1, 1) * pow(10, i % 5 - 2);
        }
        squares_solve(x, a, b, ROWS, COLUMNS);
        worst = fmax(worst, breach(x, a, b, &zeros));
        all += zeros;
    }
    test_verdict(worst < 1e-6 && all > 1000 && all < 500 * COLUMNS - 1000, "squares: nothing lowers the sum",
                 "500 problems of %d unknowns, %d of them zero, worst breach %.1e", COLUMNS, all, worst);
}

static void test_exact(test_random *random)
{
    double a[ROWS * COLUMNS], b[ROWS], x[COLUMNS], true_x[COLUMNS], worst = 0;
    int i, k;
    for (i = 0; i < COLUMNS; i++) true_x[i] = i % 3 ? test_real(random, 0.1, 900) : 0;
    for (k = 0; k < ROWS; k++) {
        b[k] = 0;
        for (i = 0; i < COLUMNS; i++) b[k] += (a[k * COLUMNS + i] = (double)test_integer(random, 0, 50)) * true_x[i];
    }
    squares_solve(x, a, b, ROWS, COLUMNS);
    for (i = 0; i < COLUMNS; i++) worst = fmax(worst, fabs(x[i] - true_x[i]));
    test_verdict(worst < 1e-2, "squares: finds what there was", "costs up to 900, worst %.1e off", worst);
}

static void test_twins(test_random *random)
{
    double a[ROWS * COLUMNS], b[ROWS], x[COLUMNS];
    int i, k;
    for (k = 0; k < ROWS; k++) {
        b[k] = 0;
        for (i = 0; i < COLUMNS; i++) {
            a[k * COLUMNS + i] = i == 1 ? a[k * COLUMNS] : i == 2 ? 0 : (double)test_integer(random, 0, 50);
            b[k] += a[k * COLUMNS + i] * 7;
        }
    }
    squares_solve(x, a, b, ROWS, COLUMNS);
    test_verdict(fabs(x[0] + x[1] - 14) < 1e-3 && x[2] == 0 && fabs(x[3] - 7) < 1e-3,
                 "squares: columns that are the same, and none", "%g and %g for 14, %g for nothing", x[0], x[1], x[2]);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_least(&random);
    test_exact(&random);
    test_twins(&random);
    return test_end();
}
