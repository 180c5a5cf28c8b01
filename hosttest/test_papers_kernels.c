/* SPDX-License-Identifier: MIT */
/* The kernels of lobes (hosttest/compare/) are what they are called: each against its own definition, written here anew in
 * double, so that what is measured and compared is the method and no broken copy of it.
 *
 *   test_papers_kernels [SEED]
 */
#include "compare/compare.h"
#include "papers/chebyshev.h"
#include "papers/lobes.h"
#include "test.h"

#include <string.h>

static double cut(double x) { return fmin(1, fmax(0, x)); }
static double schlick_of(double c, double n) { return c > 0 ? c / (n - n * c + c) : 0; }
static double power_of(double x, double n) { return x > 0 ? pow(x, n) : 0; }
static double squared(double x) { return x * x; }

/* The angle as these kernels take it, by four terms of x^2 = 2 sum (2v)^k / (k^2 binomial(2k, k)): at a quarter turn and beyond
 * 1.566 (test_papers_lobes holds what that is worth). */
static double angle_of(double c)
{
    static const double binomial[5] = {1, 2, 6, 20, 70};
    const double v = 1 - fmax(c, 0);
    double sum = 0;
    int k;
    for (k = 1; k <= 4; k++) sum += 2 * pow(2 * v, k) / (k * k * binomial[k]);
    return sqrt(sum);
}

/* The parabola of paper 003 with A, B, C. */
static double parabola(double x, const double k[3]) { return cut((k[0] * x + k[1]) * x + k[2]); }

static void published(double n, double k[3])
{
    k[0] = -(0.272 * n + 0.16);
    k[1] = n < 31.5 ? -(0.018 * n + 0.158) : n < 63.5 ? -(0.01 * n + 0.38) : n < 255.5 ? -(0.005 * n + 0.7) : -(0.003 * n + 1.2);
    k[2] = 1;
}

static double law(const int32_t c[4], double n) { return (c[0] + c[1] / n + c[2] / (n * n) + c[3] / (n * n * n)) * 1e-6; }

static void refitted(double n, double k[3])
{
    static const int32_t a[4] = COMPARE_LAW_A, b[4] = COMPARE_LAW_B, c[4] = COMPARE_LAW_C;
    k[0] = -law(a, n) * n;
    k[1] = -law(b, n) * sqrt(n);
    k[2] = law(c, n);
}

/* ---------------------------------------------------------------------------------------------------------------- definitions */

/* Definition of a lobe at a cosine, and the bound of its kernel's error there. */
typedef double definition(double c, double n, double *limit);

/* Floats: 24 bits of the cosine, counted n times. */
static double float_power(double c, double n, double *limit)
{
    *limit = 2e-4;
    return power_of(c, n);
}
static double float_w16(double c, double n, double *limit)
{
    *limit = 2e-4;
    return power_of(1 - n / 16 * (1 - c), 16);
}
static double float_schlick(double c, double n, double *limit)
{
    *limit = 2e-4;
    return schlick_of(c, n);
}
/* Near one a step of the cosine, 2^-24 or half of it by rounding, is 2.5e-4 of the angle, and B counts that. */
static double float_parabola(double c, double n, double *limit)
{
    double k[3];
    published(n, k);
    *limit = 2e-4 - 2.5e-4 * k[1];
    return c > 0 ? parabola(acos(c), k) : 0;
}

/* lmb_power_q15: 3e-6 beside its rounding; 1 - R.V is rounded to 2^-29, counted n / 4 times */
static double mirrored_power(double c, double n, double *limit)
{
    *limit = 2.0 / 65536;
    return c > 0 ? power_of(2 * c * c - 1, fmax(1, floor(n / 4 + 0.5))) : 0;
}
static double exact_power(double c, double n, double *limit)
{
    *limit = 2.0 / 65536;
    return power_of(c, n);
}

/* A cosine of 15 bits, and no lobe is steeper than n; then the division's own. */
static double schlick_15(double c, double n, double *limit)
{
    *limit = n / 65536 + 1.0 / 32768 + 1e-9;
    return schlick_of(c, n);
}
static double schlick_8(double c, double n, double *limit)
{
    *limit = n / 65536 + 1.0 / 512 + 1e-9;
    return schlick_of(c, n);
}

/* The cubic for 2^-f 7.5e-5; the result and its last product rounded down to 2^-15; the exponent to 2^-16. */
static double gaussian(double c, double n, double *limit)
{
    const double value = exp(-n * squared(angle_of(c)) / 2);
    *limit = 2e-4;
    return value;
}

static double w_m(double c, double n, double m, double *limit)
{
    *limit = LMB_LOBE_ROUNDING;
    return power_of(1 - n / m * (1 - c), m);
}
static double w_2(double c, double n, double *limit) { return w_m(c, n, 2, limit); }
static double w_4(double c, double n, double *limit) { return w_m(c, n, 4, limit); }
static double w_8(double c, double n, double *limit) { return w_m(c, n, 8, limit); }
static double w_16(double c, double n, double *limit) { return w_m(c, n, 16, limit); }
static double lyon(double c, double n, double *limit)
{
    const double dd = 2 - 2 * c; /* of unit vectors */
    *limit = LMB_LOBE_ROUNDING;
    return power_of(1 - n / 32 * dd, 16);
}

/* a and b rounded down to 2^-15, W up to 3 and W^1/2 up to 1.73: 1.4e-4; the result to 2^-15; the root to 2^-14, times 0.18 at
 * most. */
static double parabola_published(double c, double n, double *limit)
{
    double k[3];
    published(n, k);
    *limit = 2e-4;
    return parabola(angle_of(c), k);
}
static double parabola_refitted(double c, double n, double *limit)
{
    double k[3];
    refitted(n, k);
    *limit = 2e-4;
    return parabola(angle_of(c), k);
}

/* Half an entry. */
static double table(double c, double n, double *limit)
{
    *limit = n * 0.5 / 255 + 1.0 / 32768;
    return power_of(c, n);
}

static const struct {
    const char *name;
    definition *at;
} definitions[] = {
    {"lobe-powf", float_power},
    {"lobe-float-squarings", float_w16},
    {"lobe-float-schlick", float_schlick},
    {"lobe-acosf", float_parabola},
    {"lobe-phong", mirrored_power},
    {"lobe-blinn", exact_power},
    {"lobe-schlick", schlick_15},
    {"lobe-schlick-8", schlick_8},
    {"lobe-gauss", gaussian},
    {"lobe-w2", w_2},
    {"lobe-w4", w_4},
    {"lobe-w8", w_8},
    {"lobe-w16", w_16},
    {"lobe-chebyshev_published", parabola_published},
    {"lobe-chebyshev_rootless", parabola_refitted},
    {"lobe-lambent", exact_power}, /* its bound comes with it */
    {"lobe-table256", table},
    {"lobe-lyon", lyon},
};

static definition *definition_of(const char *name)
{
    unsigned i;
    for (i = 0; i < sizeof definitions / sizeof definitions[0]; i++) {
        if (!strcmp(definitions[i].name, name)) return definitions[i].at;
    }
    return NULL;
}

/* -------------------------------------------------------------------------------------------------------------------- kernels */

static double lobe_value(const compare_lobe_kernel *kernel, uint32_t word)
{
    float f;
    memcpy(&f, &word, sizeof f);
    return kernel->is_float ? (double)f : word / 32768.0;
}

typedef struct found {
    double over, error, c; /* error over its bound, the error itself, and where */
    unsigned n;
    double from_power, over_wrong; /* for n = 16, from cos^16; over the bounds if n were one more */
    bool sums;
} found;

/* Of 4096 cosines over the whole half turn, of those that are measured, and of random ones near the centre. */
enum { EVEN = 4096, NEAR = 512, ALL = COMPARE_ARGUMENTS + EVEN + NEAR };

static void cosines(int32_t cosine[ALL], unsigned n, test_random *r)
{
    int i;
    compare_lobe_cosines(cosine, n);
    for (i = 1; i <= EVEN; i++) cosine[COMPARE_ARGUMENTS + i - 1] = (i - EVEN / 2) * (1 << 19);
    for (i = 0; i < NEAR; i++) cosine[COMPARE_ARGUMENTS + EVEN + i] = (1 << 30) - (int32_t)test_integer(r, 0, (1 << 30) / n);
}

static void lobe_errors(const compare_lobe_kernel *kernel, unsigned n, test_random *r, found *f)
{
    static int32_t cosine[ALL];
    static compare_argument argument[ALL];
    static compare_lobe lobe;
    definition *at = definition_of(kernel->name);
    uint32_t sum = 0;
    unsigned i;
    if (compare_lobe_prepare(&lobe, n) != LMB_OK || !at) {
        f->over = INFINITY;
        return;
    }
    cosines(cosine, n, r);
    kernel->arguments(&lobe, argument, cosine, ALL);
    for (i = 0; i < ALL; i++) {
        double limit, c = cosine[i] / 1073741824.0, want = at(c, n, &limit), wrong, other;
        uint32_t word = kernel->sum(&lobe, &argument[i], 1);
        double value = lobe_value(kernel, word), error = fabs(value - want);
        if (!strcmp(kernel->name, "lobe-lambent")) limit = lobe.tuned.error_uq16 / 65536.0;
        wrong = fabs(value - at(c, n + fmax(4, n / 8), &other)) / limit;
        sum += word;
        if (error / limit > f->over) f->over = error / limit, f->error = error, f->c = c, f->n = n;
        f->over_wrong = fmax(f->over_wrong, wrong);
        if (n == 16) f->from_power = fmax(f->from_power, fabs(value - power_of(c, n)));
    }
    f->sums = f->sums && sum == kernel->sum(&lobe, argument, ALL);
}

static void test_kernels(test_random *r)
{
    static const unsigned exponents[] = {1,  2,  3,  4,  5,  6,   7,   8,   10,  12,  16,  17,  20,
                                         31, 32, 50, 63, 64, 100, 128, 200, 255, 256, 300, 500, 1000};
    unsigned k, i;
    for (k = 1; k < compare_lobe_count; k++) {
        found f = {0, 0, 0, 0, 0, 0, true};
        for (i = 0; i < sizeof exponents / sizeof exponents[0]; i++) lobe_errors(&compare_lobes[k], exponents[i], r, &f);
        test_verdict(f.over <= 1 && f.over > 0 && f.over_wrong > 1 && f.sums, compare_lobes[k].name,
                     "%.3f of its bound: %.6f at n = %u, cos %.6f; another n misses it %.0f times; sums %s; from cos^16 %.5f",
                     f.over, f.error, f.n, f.c, f.over_wrong, f.sums ? "are those of single values" : "DIFFER from single values",
                     f.from_power);
    }
}

/* Every lobe of the papers has a kernel of its name, but those that are only another's coefficients. */
static void test_names(void)
{
    unsigned i, k, missing = 0, kernels = 0;
    for (i = 0; i < paper_lobe_count; i++) {
        bool is_there = false;
        for (k = 0; k < compare_lobe_count; k++) is_there |= !strcmp(compare_lobes[k].name + 5, paper_lobes[i].name);
        kernels += is_there;
        missing += !is_there && strcmp(paper_lobes[i].name, "chebyshev_refit");
    }
    test_verdict(missing == 0 && kernels == paper_lobe_count - 1, "names",
                 "%u of %u lobes have a kernel; chebyshev_refit's is rootless", kernels, paper_lobe_count);
}

/* The laws that kernels take for refitted coefficients are those of the refits, rounded to millionths. */
static void test_laws(void)
{
    static const int32_t kept[3][4] = {COMPARE_LAW_A, COMPARE_LAW_B, COMPARE_LAW_C};
    const chebyshev_law *l = chebyshev_law_of_refits();
    const double *found_law[3];
    double worst = 0;
    int i, k;
    found_law[0] = l->a;
    found_law[1] = l->b;
    found_law[2] = l->c;
    for (k = 0; k < 3; k++) {
        for (i = 0; i < 4; i++) worst = fmax(worst, fabs(kept[k][i] * 1e-6 - found_law[k][i]));
    }
    test_verdict(worst <= 1.5e-6, "laws", "COMPARE_LAW_A, _B, _C are those of the refits within %.2g, at most 1.5e-6", worst);
}

/* The cosines that are measured begin at one, fall, and end where the lobe does. */
static void test_arguments(void)
{
    static const unsigned exponents[] = {1, 3, 16, 100, 1000};
    unsigned i, k, bad = 0;
    double end = 0;
    for (i = 0; i < 5; i++) {
        int32_t cosine[COMPARE_ARGUMENTS];
        compare_lobe_cosines(cosine, exponents[i]);
        bad += cosine[0] != 1 << 30;
        for (k = 1; k < COMPARE_ARGUMENTS; k++) bad += cosine[k] >= cosine[k - 1] || cosine[k] < 0;
        end = fmax(end, pow(cosine[COMPARE_ARGUMENTS - 1] / 1073741824.0, exponents[i]));
    }
    test_verdict(bad == 0 && end < 1 / 200.0, "arguments",
                 "cosines fall from 1 to where the lobe is %.4f or less; %u out of order", end, bad);
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    test_names();
    test_kernels(&r);
    test_laws();
    test_arguments();
    return test_end();
}
