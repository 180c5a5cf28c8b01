/* SPDX-License-Identifier: MIT */
/* Paper 003: cos^n x replaced by a parabola A x^2 + B x + C in the angle, three terms of a Chebyshev series on [0, b].
 *
 * The print gives A and B as laws in n whose signs its text layer lost. Both are negative: with either sign turned the relative
 * error passes the paper's 2 % before n^1/2 x = 0.3 for every n from 8 on, and every fit of our own has both below zero.
 *
 * The paper does not say how it takes the coefficients. Two ways are usual: integrals, which are the series' own terms, and sums
 * over three Chebyshev nodes, which interpolate there. The second reproduces the printed law of A (claims_003.c).
 */
#ifndef PAPERS_CHEBYSHEV_H
#define PAPERS_CHEBYSHEV_H

#define CHEBYSHEV_ERROR 0.02 /* relative; the paper's choice */
#define CHEBYSHEV_N_MAX 1000

typedef struct quadratic {
    double a, b, c; /* a x^2 + b x + c */
} quadratic;

enum chebyshev_kind { CHEBYSHEV_SERIES, CHEBYSHEV_NODES };

typedef struct chebyshev_fit {
    quadratic p;
    double end; /* the paper's b: x up to which p serves */
} chebyshev_fit;

/* A(n), B(n), C as printed, signs mended. n: 1 to 1000 */
quadratic chebyshev_published(unsigned n);

/* Three terms of cos^n on [0, end]. */
quadratic chebyshev_terms(enum chebyshev_kind kind, unsigned n, double end);

/* The largest relative error of p against cos^n on [0, end], end < pi / 2. */
double chebyshev_relative(const quadratic *p, unsigned n, double end);

/* The fit whose end is the largest with an error of at most CHEBYSHEV_ERROR. n: 1 to 1000; kept once it has been found. */
const chebyshev_fit *chebyshev_refit(enum chebyshev_kind kind, unsigned n);

/* The largest x up to which the error of p is at most CHEBYSHEV_ERROR all along. */
double chebyshev_reach(const quadratic *p, unsigned n);

/* The least relative error that any parabola has on [0, end], by exchange (Remez), and that parabola. */
double chebyshev_least(unsigned n, double end, quadratic *p);

double quadratic_at(const quadratic *p, double x);
double quadratic_zero(const quadratic *p); /* the x > 0 where p, which falls, becomes zero */

/* A, B and C of the refitted series as laws, in place of a search: with t = 1 / n, A = -n a(t), B = -n^1/2 b(t) and C = c(t) are
 * cubics in t, which pass through the refits of these n. */
#define CHEBYSHEV_LAW_N                                                                                                          \
    {                                                                                                                            \
        1, 2, 5, 1000                                                                                                            \
    }
typedef struct chebyshev_law {
    double a[4], b[4], c[4]; /* coefficients of t^0 to t^3 */
} chebyshev_law;
const chebyshev_law *chebyshev_law_of_refits(void);
quadratic chebyshev_by_law(unsigned n);

#endif
