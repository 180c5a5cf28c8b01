/* SPDX-License-Identifier: MIT */
/* Chebyshev series of cos^n, and how far three terms of it serve. */
#include "chebyshev.h"

#include <math.h>

enum { GRID = 256, HALVINGS = 44 };

static const double pi = 3.14159265358979323846;

quadratic chebyshev_published(unsigned n)
{
    const double x = n;
    quadratic p = {-(0.272 * x + 0.16), 0, 1};
    if (n <= 31)
        p.b = -(0.018 * x + 0.158);
    else if (n <= 63)
        p.b = -(0.01 * x + 0.38);
    else if (n <= 255)
        p.b = -(0.005 * x + 0.7);
    else
        p.b = -(0.003 * x + 1.2);
    return p;
}

double quadratic_at(const quadratic *p, double x) { return (p->a * x + p->b) * x + p->c; }

double quadratic_zero(const quadratic *p) { return (p->b + sqrt(p->b * p->b - 4 * p->a * p->c)) / (-2 * p->a); }

/* The coefficients c_k = 2/pi times the integral of f cos(k theta) over 0 to pi, by the midpoint rule: with 64 points it is exact
 * to rounding for what is as smooth as this, with three it gives the interpolation at three nodes. With t = 2 x / end - 1 the sum
 * is c0/2 + c1 t + c2 (2 t^2 - 1). */
quadratic chebyshev_terms(enum chebyshev_kind kind, unsigned n, double end)
{
    const int nodes = kind == CHEBYSHEV_NODES ? 3 : 64;
    double c[3] = {0, 0, 0};
    quadratic p;
    int i, k;
    for (i = 0; i < nodes; i++) {
        const double theta = (i + 0.5) * pi / nodes, f = pow(cos((cos(theta) + 1) / 2 * end), n);
        for (k = 0; k < 3; k++) c[k] += f * cos(k * theta) * 2 / nodes;
    }
    p.a = 8 * c[2] / (end * end);
    p.b = (2 * c[1] - 8 * c[2]) / end;
    p.c = c[0] / 2 - c[1] + c[2];
    return p;
}

static double relative_at(const quadratic *p, unsigned n, double x) { return fabs(quadratic_at(p, x) / pow(cos(x), n) - 1); }

double chebyshev_relative(const quadratic *p, unsigned n, double end)
{
    double largest = 0;
    int i;
    for (i = 0; i <= GRID; i++) largest = fmax(largest, relative_at(p, n, end * i / GRID));
    return largest;
}

/* The error of a fit on [0, end] grows with end (test_papers_lobes holds it), so halving finds the largest. */
const chebyshev_fit *chebyshev_refit(enum chebyshev_kind kind, unsigned n)
{
    static chebyshev_fit kept[2][CHEBYSHEV_N_MAX + 1];
    chebyshev_fit *fit = &kept[kind][n];
    double low = 0, high = fmin(pi / 2 - 1e-6, 3 / sqrt(n));
    int i;
    if (fit->end > 0) return fit;
    for (i = 0; i < HALVINGS && high - low > 1e-10 * high; i++) {
        const double middle = (low + high) / 2;
        const quadratic p = chebyshev_terms(kind, n, middle);
        *(chebyshev_relative(&p, n, middle) <= CHEBYSHEV_ERROR ? &low : &high) = middle;
    }
    fit->p = chebyshev_terms(kind, n, low);
    fit->end = low;
    return fit;
}

double chebyshev_reach(const quadratic *p, unsigned n)
{
    const double step = fmin(pi / 2 - 1e-6, 4 / sqrt(n)) / (4 * GRID);
    double low = 0, high = 0;
    int i;
    for (i = 1; i <= 4 * GRID && relative_at(p, n, high) <= CHEBYSHEV_ERROR; i++) low = high, high = i * step;
    for (i = 0; i < HALVINGS; i++) {
        const double middle = (low + high) / 2;
        *(relative_at(p, n, middle) <= CHEBYSHEV_ERROR ? &low : &high) = middle;
    }
    return low;
}

/* ------------------------------------------------------------------------------------------------------------ the best of all */

/* Solves four equations of four unknowns, kept with their right sides; pivots are the largest of their column. */
static void solve(double m[4][5])
{
    int i, k, j;
    for (k = 0; k < 4; k++) {
        for (i = k + 1; i < 4; i++) {
            if (fabs(m[i][k]) <= fabs(m[k][k])) continue;
            for (j = 0; j < 5; j++) {
                const double kept = m[k][j];
                m[k][j] = m[i][j];
                m[i][j] = kept;
            }
        }
        for (i = 0; i < 4; i++) {
            const double by = m[i][k] / m[k][k];
            for (j = k; j < 5 && i != k; j++) m[i][j] -= by * m[k][j];
        }
    }
}

/* The parabola with p = f (1 -+ e) in turns at four points; e. In t = x / end, which keeps the equations even. */
static double level(quadratic *p, unsigned n, double end, const double t[4])
{
    double m[4][5];
    int i;
    for (i = 0; i < 4; i++) {
        const double f = pow(cos(t[i] * end), n), row[5] = {t[i] * t[i], t[i], 1, i % 2 ? -f : f, f};
        for (int j = 0; j < 5; j++) m[i][j] = row[j];
    }
    solve(m);
    p->a = m[0][4] / m[0][0] / (end * end);
    p->b = m[1][4] / m[1][1] / end;
    p->c = m[2][4] / m[2][2];
    return fabs(m[3][4] / m[3][3]);
}

/* The error is largest at both ends and at one inner point of either sign: these move to where it is largest for now. */
double chebyshev_least(unsigned n, double end, quadratic *p)
{
    double t[4] = {0, 0.25, 0.75, 1}, error = 0;
    int round, i, k;
    for (round = 0; round < 12; round++) {
        error = level(p, n, end, t);
        for (k = 1; k < 3; k++) {
            const double sign = quadratic_at(p, t[k] * end) > pow(cos(t[k] * end), n) ? 1 : -1;
            double best = 0;
            for (i = 1; i < 4 * GRID; i++) {
                const double x = (double)i / (4 * GRID), e = sign * (quadratic_at(p, x * end) / pow(cos(x * end), n) - 1);
                if (e > best) best = e, t[k] = x;
            }
        }
    }
    return error;
}

/* ------------------------------------------------------------------------------------------------------------ laws of our own */

static double cubic(const double c[4], double t) { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; }

/* Newton's divided differences, multiplied out. */
static void through(double c[4], const double t[4], const double value[4])
{
    double d[4];
    int i, k;
    for (i = 0; i < 4; i++) d[i] = value[i];
    for (k = 1; k < 4; k++) {
        for (i = 3; i >= k; i--) d[i] = (d[i] - d[i - 1]) / (t[i] - t[i - k]);
    }
    for (i = 0; i < 4; i++) c[i] = 0;
    for (k = 3; k >= 0; k--) { /* c = c * (t - t[k]) + d[k] */
        for (i = 3; i > 0; i--) c[i] = c[i - 1] - c[i] * t[k];
        c[0] = d[k] - c[0] * t[k];
    }
}

const chebyshev_law *chebyshev_law_of_refits(void)
{
    static const unsigned n[4] = CHEBYSHEV_LAW_N;
    static chebyshev_law law;
    double t[4], a[4], b[4], c[4];
    int i;
    if (law.c[0] > 0) return &law;
    for (i = 0; i < 4; i++) {
        const quadratic p = chebyshev_refit(CHEBYSHEV_SERIES, n[i])->p;
        t[i] = 1.0 / n[i];
        a[i] = -p.a / n[i];
        b[i] = -p.b / sqrt(n[i]);
        c[i] = p.c;
    }
    through(law.a, t, a);
    through(law.b, t, b);
    through(law.c, t, c);
    return &law;
}

quadratic chebyshev_by_law(unsigned n)
{
    const chebyshev_law *law = chebyshev_law_of_refits();
    const double t = 1.0 / n;
    quadratic p = {-cubic(law->a, t) * n, -cubic(law->b, t) * sqrt(n), cubic(law->c, t)};
    return p;
}
