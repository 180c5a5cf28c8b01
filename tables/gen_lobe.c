/* SPDX-License-Identifier: MIT */
/* Writes tables/lobe_table.h: the constants of the tuned lobes, as cubics in 2^m / n.
 *
 * A lobe of m multiplications stands for (1 - v)^n, v = 1 - cos, by one of two forms in s = a - b * (n / 2^m) * v:
 *   plain    (s^2 + f)^(2^(m-1))        f = 1 - a^2, so that the centre is 1
 *   crossed  ((s^4 + g) s^2)^(2^(m-3))  g = 1 / a^2 - a^4, likewise; for m = 3 and 4. It runs into zero by itself
 * Both are cut off at s <= 0, or where s^2 + f is zero. That leaves a and b; for a node n the largest error over the quarter turn
 * is minimised by two golden sections, one inside the other. Then a(y) and b(y), y = 2^m / n, are fitted through the nodes by
 * least squares and rounded to Q2.14.
 *
 * Only +, -, *, / and sqrt of doubles are used, which IEEE 754 rounds alike everywhere; the searches end far below the rounding.
 * Takes about a second. Usage: gen_lobe [file]
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

/* POINTS of the search, CHECK of the error promised; MARGIN is what integer arithmetic adds at most, in 2^-16
 * (hosttest/test_lobe.c); from n = CROSS on the crossed form of four multiplications is better than the plain one. */
enum { POINTS = 400, CHECK = 2000, MARGIN = 16, CROSS = 90 };

typedef struct form {
    int multiplications, crossed;
} form;

static double power(double x, unsigned n)
{
    double r = 1;
    for (; n; n >>= 1, x *= x) {
        if (n & 1) r *= x;
    }
    return r;
}

/* The value of a form in real arithmetic. floor is where a plain form with f < 0 reaches zero. */
static double form_at(form w, double a, double floor, double s)
{
    double y;
    if (s <= floor) return 0;
    y = w.crossed ? (s * s * s * s + (1 / (a * a) - a * a * a * a)) * s * s : s * s + (1 - a * a);
    return power(y, 1u << (w.multiplications - (w.crossed ? 3 : 1)));
}

/* Largest error over points v = (end) r^2: evenly spaced in angle, nearly, and never past what cos^n still shows. */
static double form_error(form w, unsigned n, double a, double b, int points)
{
    double end = n > 14 ? 14.0 / n : 1.0, slope = b * n / (1 << w.multiplications), worst = 0;
    double floor = !w.crossed && a > 1 ? sqrt(a * a - 1) : 0;
    double cut = (a - floor) / slope, before, after;
    for (int i = 0; i <= points; i++) {
        double r = (double)i / points, v = end * r * r;
        double e = fabs(form_at(w, a, floor, a - slope * v) - power(1 - v, n));
        if (e > worst) worst = e;
    }
    /* Both sides of the cut, which the points may miss. */
    after = cut < 1 ? power(1 - cut, n) : 0;
    before = cut < 1 ? fabs(form_at(w, a, floor, floor + 1e-9) - after) : 0;
    if (after > worst) worst = after;
    return before > worst ? before : worst;
}

static double best_b(form w, unsigned n, double a, double *b)
{
    const double ratio = 0.6180339887498949;
    double low = 0.6, high = 2.0, x1 = high - ratio * (high - low), x2 = low + ratio * (high - low);
    double e1 = form_error(w, n, a, x1, POINTS), e2 = form_error(w, n, a, x2, POINTS);
    for (int i = 0; i < 34; i++) {
        if (e1 < e2) {
            high = x2, x2 = x1, e2 = e1, x1 = high - ratio * (high - low), e1 = form_error(w, n, a, x1, POINTS);
        } else {
            low = x1, x1 = x2, e1 = e2, x2 = low + ratio * (high - low), e2 = form_error(w, n, a, x2, POINTS);
        }
    }
    *b = (low + high) / 2;
    return form_error(w, n, a, *b, POINTS);
}

/* Best a and b for one n; a between low and high. One multiplication: a stays 1, the gain is not worth a jump at the end. */
static double best_form(form w, unsigned n, double low, double high, double *a, double *b)
{
    const double ratio = 0.6180339887498949;
    double x1 = high - ratio * (high - low), x2 = low + ratio * (high - low), e1, e2;
    if (w.multiplications == 1) return *a = 1, best_b(w, n, *a, b);
    e1 = best_b(w, n, x1, b), e2 = best_b(w, n, x2, b);
    for (int i = 0; i < 30; i++) {
        if (e1 < e2) {
            high = x2, x2 = x1, e2 = e1, x1 = high - ratio * (high - low), e1 = best_b(w, n, x1, b);
        } else {
            low = x1, x1 = x2, e1 = e2, x2 = low + ratio * (high - low), e2 = best_b(w, n, x2, b);
        }
    }
    *a = (low + high) / 2;
    return best_b(w, n, *a, b);
}

typedef struct row {
    form w;
    unsigned first, last; /* shininess that the row serves */
    double low, high;     /* search a here; EXACT: no search, s is the cosine itself */
    int terms;            /* of the curves */
} row;

#define EXACT 1, 1, 0

/* The most accurate of at most four multiplications, in order of n; each serves up to where the next begins. first == last:
 * constants, no curves. n = 5, 7, 13, 14, 15 have f < 0: s is cut off at its root. */
static const row rows[] = {
    {{0, 0}, 1, 1, EXACT},
    {{1, 0}, 2, 2, EXACT},
    {{2, 1}, 3, 3, EXACT},
    {{2, 0}, 4, 4, EXACT},
    {{3, 0}, 5, 5, 1.2, 1.8, 0},
    {{3, 1}, 6, 6, EXACT},
    {{3, 0}, 7, 7, 1.01, 1.3, 0},
    {{3, 0}, 8, 8, EXACT},
    {{3, 0}, 9, 27, 0.8, 1, 4},
    {{4, 1}, 12, 12, EXACT},
    {{4, 0}, 13, 13, 1.01, 1.3, 0},
    {{4, 0}, 14, 14, 1.01, 1.3, 0},
    {{4, 0}, 15, 15, 1.005, 1.3, 0},
    {{4, 0}, 16, 16, EXACT},
    {{4, 0}, 17, CROSS - 1, 0.7, 1, 4},
    {{4, 1}, CROSS, 1000, 0.9, 1, 3},
};

/* Those of fewer multiplications, in order of their cost: the order in which lmb_lobe_prepare tries them. */
static const row cheap_rows[] = {
    {{1, 0}, 3, 1000, 1, 1, 4},
    {{2, 0}, 5, 1000, 0.9, 1, 4},
    {{3, 0}, 9, 27, 0.8, 1, 4},
    {{3, 1}, 28, 1000, 0.9, 1, 4},
};

static int is_exact(const row *r) { return r->terms == 0 && r->high <= 1; }

/* Least squares: the polynomial c of so many terms through count points. */
static void fit(const double *y, const double *value, int count, int terms, double *c)
{
    double m[4][5] = {{0}};
    for (int p = 0; p < count; p++) {
        double basis[4] = {1, y[p], y[p] * y[p], y[p] * y[p] * y[p]};
        for (int i = 0; i < terms; i++) {
            for (int j = 0; j < terms; j++) m[i][j] += basis[i] * basis[j];
            m[i][4] += basis[i] * value[p];
        }
    }
    for (int i = 0; i < terms; i++) { /* Gauss and Jordan; the matrix is positive definite, so no pivoting */
        for (int k = 0; k < terms; k++) {
            double ratio = m[k][i] / m[i][i];
            if (k == i) continue;
            for (int j = 0; j < 5; j++) m[k][j] -= ratio * m[i][j];
        }
    }
    for (int i = 0; i < 4; i++) c[i] = i < terms ? m[i][4] / m[i][i] : 0;
}

static int rounded(double x) { return (int)(x < 0 ? x - 0.5 : x + 0.5); }

/* Horner in integers, as in lmb_lobe_prepare; c highest power first, y Q2.14. */
static int32_t curve_at(const int *c, int32_t y)
{
    int32_t r = c[0];
    for (int i = 1; i < 4; i++) r = ((r * y) >> 14) + c[i];
    return r;
}

/* 2^m / n in Q2.14, to nearest. */
static int32_t argument_of(form w, unsigned n) { return (int32_t)(((32768ul << w.multiplications) / n + 1) / 2); }

/* Rounds a cubic to integers of the given scale, highest power first. */
static void round_curve(const double *c, double scale, int *out)
{
    for (int i = 0; i < 4; i++) {
        out[i] = rounded(c[3 - i] * scale);
        if (out[i] < INT16_MIN || out[i] > INT16_MAX) fprintf(stderr, "gen_lobe: a coefficient does not fit int16_t\n"), exit(1);
    }
}

/* The largest error of a row's lobe for n with its rounded constants, real arithmetic. */
static double rounded_error(const row *r, unsigned n, int a, int b)
{
    return form_error(r->w, n, a / 16384.0, b / 16384.0, CHECK);
}

/* The error curve promised: fitted, then raised to lie above the real error of every n by MARGIN. */
static void promise(const row *r, int c[3][4], const double *y, const double *error, int count)
{
    double e[4], short_by = 0;
    fit(y, error, count, r->terms, e);
    round_curve(e, 65536, c[2]);
    for (unsigned n = r->first; n <= r->last; n++) {
        int32_t at = argument_of(r->w, n);
        double gap;
        gap = 65536 * rounded_error(r, n, curve_at(c[0], at), curve_at(c[1], at)) - curve_at(c[2], at);
        if (gap > short_by) short_by = gap;
    }
    c[2][3] += (int)short_by + 1 + MARGIN;
}

/* Finds, fits and prints the curves of one row: a, b and the error. Returns how many numbers. */
static int print_curves(FILE *out, const row *r)
{
    double y[64], a[64], b[64], error[64], ca[4], cb[4], worst = 0;
    int c[3][4], count = 0;
    for (unsigned n = r->first; n <= r->last; n = n < 16 ? n + 1 : n + n / 5) {
        error[count] = best_form(r->w, n, r->low, r->high, &a[count], &b[count]);
        y[count++] = (double)(1 << r->w.multiplications) / n;
    }
    fit(y, a, count, r->terms, ca);
    fit(y, b, count, r->terms, cb);
    round_curve(ca, 16384, c[0]);
    round_curve(cb, 16384, c[1]);
    promise(r, c, y, error, count);
    for (unsigned n = r->first; n <= r->last; n++) {
        int32_t at = argument_of(r->w, n);
        double e = rounded_error(r, n, curve_at(c[0], at), curve_at(c[1], at));
        if (e > worst) worst = e;
    }
    fprintf(out, "    /* %s, m = %d, n = %u to %u: max error %.6f */\n", r->w.crossed ? "crossed" : "plain", r->w.multiplications,
            r->first, r->last, worst);
    for (int i = 0; i < 3; i++) fprintf(out, "    %d, %d, %d, %d,\n", c[i][0], c[i][1], c[i][2], c[i][3]);
    return 12;
}

/* Prints the constants of a row for one n: a, b, the error, the floor. */
static int print_constants(FILE *out, const row *r)
{
    double a, b, error, floor;
    unsigned n = r->first;
    if (is_exact(r)) { /* s is the cosine: slope 1 */
        a = 1, b = (double)(1 << r->w.multiplications) / n, error = 0, floor = 0;
    } else {
        best_form(r->w, n, r->low, r->high, &a, &b);
        a = rounded(a * 16384) / 16384.0;
        error = best_b(r->w, n, a, &b);
        floor = sqrt(a * a - 1);
    }
    fprintf(out, "    /* %s, m = %d, n = %u%s: max error %.6f */\n", r->w.crossed ? "crossed" : "plain", r->w.multiplications, n,
            is_exact(r) ? " and all others that are exact" : "", error);
    /* The floor is rounded up, to where s^2 + f cannot be negative. */
    fprintf(out, "    %d, %d, %d, %d,\n", rounded(a * 16384), rounded(b * 16384), (int)(error * 65536) + 1 + MARGIN,
            (int)(floor * 16384) + (floor > 0));
    return 4;
}

/* Prints the curves of some rows and says where each starts. */
static void print_numbers(FILE *out, const char *name, const row *table, unsigned count, unsigned start[])
{
    unsigned next = 0, exact[2] = {~0u, ~0u};
    fprintf(out, "static const LMB_FLASH int16_t %s[] = {\n", name);
    for (unsigned i = 0; i < count; i++) {
        const row *r = &table[i];
        unsigned *shared = is_exact(r) ? &exact[r->w.crossed] : NULL; /* all exact lobes of a form have the same constants */
        start[i] = shared && *shared != ~0u ? *shared : next;
        if (shared && *shared != ~0u) continue;
        if (shared) *shared = next;
        next += (unsigned)(r->first == r->last ? print_constants(out, r) : print_curves(out, r));
    }
    fprintf(out, "};\n\n");
}

static void print_row(FILE *out, const row *r, unsigned last, unsigned start)
{
    fprintf(out, "{%u, %s%s%d, %u}", last, r->first != r->last ? "CUBIC | " : "", r->w.crossed ? "CROSSED | " : "",
            r->w.multiplications, start);
}

int main(int argc, char **argv)
{
    enum { ROWS = sizeof rows / sizeof *rows, CHEAP_ROWS = sizeof cheap_rows / sizeof *cheap_rows };
    unsigned start[ROWS], cheap_start[CHEAP_ROWS];
    FILE *out = argc > 1 ? fopen(argv[1], "w") : stdout;
    if (!out) return perror(argv[1]), EXIT_FAILURE;
    fprintf(out,
            "/* Generated by tables/gen_lobe.c; do not edit. Cubics in y = 2^multiplications / n, Q2.14, highest\n"
            " * power first: a Q2.14, b Q2.14, error UQ0.16; or constants: a Q2.14, b Q2.14, error UQ0.16, floor Q2.14.\n"
            " * These errors are upper bounds that allow for integer arithmetic; the comments give real arithmetic's. */\n\n");
    print_numbers(out, "lobe_numbers", rows, ROWS, start);
    fprintf(out, "/* The most accurate: last n, form, where its numbers start. */\n"
                 "static const LMB_FLASH lobe_row lobe_rows[] = {\n");
    for (unsigned i = 0; i < ROWS; i++) {
        fprintf(out, "    ");
        print_row(out, &rows[i], i + 1 < ROWS ? rows[i + 1].first - 1 : rows[i].last, start[i]);
        fprintf(out, ",\n");
    }
    fprintf(out, "};\n\n/* Fewer multiplications. */\n");
    print_numbers(out, "cheap_numbers", cheap_rows, CHEAP_ROWS, cheap_start);
    fprintf(out, "/* First n, and as above. */\nstatic const LMB_FLASH cheap_row cheap_rows[] = {\n");
    for (unsigned i = 0; i < CHEAP_ROWS; i++) {
        fprintf(out, "    {%u, ", cheap_rows[i].first);
        print_row(out, &cheap_rows[i], cheap_rows[i].last, cheap_start[i]);
        fprintf(out, "},\n");
    }
    fprintf(out, "};\n");
    return fclose(out) ? EXIT_FAILURE : EXIT_SUCCESS;
}
