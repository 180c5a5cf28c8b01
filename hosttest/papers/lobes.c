/* SPDX-License-Identifier: MIT */
/* The lobes in real arithmetic: each as its source has it, and its cut-offs. */
#include "lobes.h"

#include "../../firmware/lambent.h"
#include "chebyshev.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double versine(double angle)
{
    const double half = sin(angle / 2);
    return 2 * half * half;
}

/* x^m, m whole: by squarings, so that it is defined for x < 0. */
static double power_of(double x, unsigned m)
{
    double product = 1;
    for (; m; m >>= 1, x *= x) {
        if (m & 1) product *= x;
    }
    return product;
}

double paper_power(unsigned n, double angle) { return power_of(fmax(0, 1 - versine(angle)), n); }

double paper_inflection(unsigned n) { return n < 2 ? PAPER_QUARTER_TURN : atan(1 / sqrt(n - 1.0)); }

double paper_angle_of(unsigned n, double level) { return 2 * asin(sqrt(-expm1(log(level) / n) / 2)); }

/* ----------------------------------------------------------------------------------------------- Phong, Blinn, Schlick, Gauss */

static double phong(unsigned n, double angle)
{
    const double c = cos(2 * angle); /* R.V where L, V and N lie in one plane */
    return c > 0 ? pow(c, n / 4.0) : 0;
}

static double phong_raw(unsigned n, double angle) { return cos(2 * angle) < 0 ? (double)NAN : phong(n, angle); }

static double schlick(unsigned n, double angle)
{
    const double v = versine(angle), c = 1 - v;
    return c <= 0 ? 0 : c / (n * v + c);
}

static double gauss(unsigned n, double angle) { return exp(-0.5 * n * angle * angle); }

/* ------------------------------------------------------------------------------------------------------------ paper 000, Lyon */

static double w_raw(unsigned m, unsigned n, double v) { return power_of(1 - (double)n / m * v, m); }

double paper_w(unsigned m, unsigned n, double v) { return n * v >= m ? 0 : w_raw(m, n, v); }

#define W_OF(M)                                                                                                                  \
    static double w##M##_raw(unsigned n, double angle) { return w_raw(M, n, versine(angle)); }                                   \
    static double w##M(unsigned n, double angle) { return paper_w(M, n, versine(angle)); }
W_OF(2)
W_OF(4)
W_OF(8)
W_OF(16)

/* Half of D.D with N = (sin, cos) and H = (0, 1). */
static double half_difference(double angle)
{
    const double x = sin(angle), y = 1 - cos(angle);
    return (x * x + y * y) / 2;
}

static double lyon_raw(unsigned n, double angle) { return w_raw(16, n, half_difference(angle)); }
static double lyon(unsigned n, double angle) { return paper_w(16, n, half_difference(angle)); }

/* ------------------------------------------------------------------------------------------------------------------ paper 003 */

/* A parabola past its zero is below it for good. Where a fit begins above one, one is shown. */
static double cut(double value) { return fmin(1, fmax(0, value)); }

static double published_raw(unsigned n, double angle)
{
    const quadratic p = chebyshev_published(n);
    return quadratic_at(&p, angle);
}

static double refit_raw(unsigned n, double angle) { return quadratic_at(&chebyshev_refit(CHEBYSHEV_SERIES, n)->p, angle); }

/* x^2 = 2 v (1 + v/6 + 2 v^2/45 + v^3/70 + ...), from x = 2 arcsin (v/2)^1/2; the next term is 0.0051 v^4 of it. */
static double angle_squared(double v) { return v * (2 + v * (1.0 / 3 + v * (4.0 / 45 + v / 35))); }

/* The square root of x in (0, 4] as x / x^1/2, the latter as lmb_rsqrt_q30 takes it: a line and four steps of Newton's method on
 * an argument that is shifted into [1/4, 1). */
static double root_by_products(double x)
{
    int shift, i;
    double m = frexp(x, &shift), y; /* [1/2, 1) */
    if (shift & 1) m /= 2, shift++;
    y = 2 - m;
    for (i = 0; i < 4; i++) y *= (3 - m * y * y) / 2;
    return ldexp(m * y, shift / 2);
}

static double rootless_raw(unsigned n, double angle)
{
    const quadratic *p = &chebyshev_refit(CHEBYSHEV_SERIES, n)->p;
    const double g = angle_squared(versine(angle));
    return g > 0 ? p->a * g + p->c + p->b * root_by_products(g) : p->c;
}

static double published(unsigned n, double angle) { return cut(published_raw(n, angle)); }
static double refit(unsigned n, double angle) { return cut(refit_raw(n, angle)); }
static double rootless(unsigned n, double angle) { return cut(rootless_raw(n, angle)); }

/* ------------------------------------------------------------------------------------------------------- the library, a table */

static const lmb_lobe *tuned(unsigned n)
{
    static lmb_lobe kept[LMB_SHININESS_MAX + 1];
    if (!kept[n].shininess && lmb_lobe_prepare(&kept[n], LMB_LOBE_TUNED, n, 0) != LMB_OK) {
        fprintf(stderr, "lobes: no lobe for n = %u\n", n);
        exit(EXIT_FAILURE);
    }
    return &kept[n];
}

/* The struct's constants; the one between the squarings makes the centre one. */
static double tuned_polynomial(const lmb_lobe *lobe, double a, double s)
{
    const double a2 = a * a;
    if (lobe->multiplications == 0) return s;
    if (!lobe->crossed) return power_of(s * s + 1 - a2, 1u << (lobe->multiplications - 1));
    if (lobe->multiplications == 2) return (s * s + 1 / a - a2) * s;
    return power_of((s * s * s * s + 1 / a2 - a2 * a2) * s * s, lobe->multiplications - 2u);
}

static double tuned_argument(const lmb_lobe *lobe, double *a, double angle)
{
    *a = lobe->alpha_q30 / 1073741824.0;
    return *a - ldexp(lobe->slope, lobe->slope_shift - 15) * versine(angle);
}

static double lambent_raw(unsigned n, double angle)
{
    const lmb_lobe *lobe = tuned(n);
    double a, s = tuned_argument(lobe, &a, angle);
    return tuned_polynomial(lobe, a, s);
}

static double lambent(unsigned n, double angle)
{
    const lmb_lobe *lobe = tuned(n);
    double a, s = tuned_argument(lobe, &a, angle);
    if (s <= (a > 1 ? sqrt(a * a - 1) : 0)) return 0;
    return s >= a ? 1 : tuned_polynomial(lobe, a, s);
}

static double table256(unsigned n, double angle) { return power_of(floor(255 * (1 - versine(angle)) + 0.5) / 255, n); }

/* ------------------------------------------------------------------------------------------------------------------ the table */

/* Costs: multiplications, additions, divisions, roots, reads, calls; carried, whole, integer. The root by products: a line and
 * four steps of three products; in integers 13, seven additions. x^2 from v: four. Powers and the library's squarings are added
 * by paper_lobe_cost. */
/* clang-format off */
const paper_lobe paper_lobes[] = {
    {"phong", "Phong 1975; papers 000 and 003", "[R.V]^(n/4)", "R.V",
     phong_raw, phong, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 0, 0}},
    {"blinn", "Blinn 1977; papers 000 and 003", "[N.H]^n", "N.H",
     paper_power, paper_power, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}},
    {"schlick", "Schlick 1994; paper 000", "c / (n - n c + c)", "c",
     schlick, schlick, {1, 1, 1, 0, 0, 0}, {1, 1, 1, 0, 0, 0}, {1, 2, 1, 0, 0, 0}},
    {"gauss", "paper 000", "e^(-n x^2 / 2)", "x",
     gauss, gauss, {2, 0, 0, 0, 0, 1}, {2, 0, 0, 0, 0, 2}, {9, 7, 0, 0, 0, 0}},
    {"w2", "paper 000; m = 2", "[1 - n/2 (1 - c)]^2", "s",
     w2_raw, w2, {1, 0, 0, 0, 0, 0}, {2, 2, 0, 0, 0, 0}, {1, 1, 0, 0, 0, 0}},
    {"w4", "paper 000; its W_1", "[1 - n/4 (1 - c)]^4", "s",
     w4_raw, w4, {2, 0, 0, 0, 0, 0}, {3, 2, 0, 0, 0, 0}, {2, 1, 0, 0, 0, 0}},
    {"w8", "paper 000; its W_2", "[1 - n/8 (1 - c)]^8", "s",
     w8_raw, w8, {3, 0, 0, 0, 0, 0}, {4, 2, 0, 0, 0, 0}, {3, 1, 0, 0, 0, 0}},
    {"w16", "paper 000; its W_3", "[1 - n/16 (1 - c)]^16", "s",
     w16_raw, w16, {4, 0, 0, 0, 0, 0}, {5, 2, 0, 0, 0, 0}, {4, 1, 0, 0, 0, 0}},
    {"chebyshev_published", "paper 003; A and B and C as printed", "A x^2 + B x + 1", "x",
     published_raw, published, {2, 2, 0, 0, 0, 0}, {2, 2, 0, 0, 0, 1}, {21, 12, 0, 0, 0, 0}},
    {"chebyshev_refit", "paper 003; A and B and C fitted anew", "A x^2 + B x + C", "x",
     refit_raw, refit, {2, 2, 0, 0, 0, 0}, {2, 2, 0, 0, 0, 1}, {0, 0, 0, 0, 0, 0}},
    {"chebyshev_rootless", "paper 003 without arccos", "A g + B g^(1/2) + C; g = x^2 by its series in v", "v",
     rootless_raw, rootless, {19, 10, 0, 0, 0, 0}, {19, 11, 0, 0, 0, 0}, {21, 12, 0, 0, 0, 0}},
    {"lambent", "Lambent; firmware/lobe.h", "squarings of s = alpha - slope v; one constant between them", "s",
     lambent_raw, lambent, {0, 0, 0, 0, 0, 0}, {1, 2, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}},
    {"table256", "256 powers", "(round(255 c) / 255)^n", "c",
     table256, table256, {0, 0, 0, 0, 1, 0}, {1, 1, 0, 0, 1, 0}, {0, 0, 0, 0, 1, 0}},
    {"lyon", "Lyon 1993", "[1 - n/32 D.D]^16; D = N - H", "D.D",
     lyon_raw, lyon, {5, 1, 0, 0, 0, 0}, {5, 1, 0, 0, 0, 0}, {6, 3, 0, 0, 0, 0}},
};
/* clang-format on */
const unsigned paper_lobe_count = sizeof paper_lobes / sizeof paper_lobes[0];

const paper_lobe *paper_lobe_named(const char *name)
{
    unsigned i;
    for (i = 0; i < paper_lobe_count; i++) {
        if (!strcmp(paper_lobes[i].name, name)) return &paper_lobes[i];
    }
    fprintf(stderr, "lobes: there is no lobe %s\n", name);
    exit(EXIT_FAILURE);
}

int paper_power_products(unsigned n)
{
    int products = -1;
    for (; n; n >>= 1) products += (n & 1 ? 1 : 0) + (n > 1);
    return products;
}

unsigned paper_phong_exponent(unsigned n) { return n < 6 ? 1 : (n + 2) / 4; }

/* The loop of the integer power multiplies for each set bit and squares for each bit of n. */
static int loop_products(unsigned n)
{
    int products = 0;
    for (; n; n >>= 1) products += n & 1 ? 2 : 1;
    return products;
}

/* The constant between the squarings makes the centre one; real arithmetic does without where alpha is one. */
static void add_tuned(lobe_cost *cost, unsigned n, enum lobe_form form)
{
    const lmb_lobe *lobe = tuned(n);
    cost->multiplications += lobe->multiplications;
    cost->additions += lobe->multiplications > 0 && (form == LOBE_INTEGER || lobe->alpha_q30 != 1 << 30);
}

static void add_power(lobe_cost *cost, unsigned n, enum lobe_form form)
{
    if (form == LOBE_INTEGER) { /* three products of halves for one, and their sum */
        cost->multiplications += 3 * loop_products(n);
        cost->additions += 1 + 2 * loop_products(n);
    } else if (!cost->calls) {
        cost->multiplications += paper_power_products(n);
    }
}

lobe_cost paper_lobe_cost(const paper_lobe *lobe, unsigned n, enum lobe_form form)
{
    lobe_cost cost = form == LOBE_CARRIED ? lobe->carried : form == LOBE_WHOLE ? lobe->whole : lobe->integer;
    if (lobe->at == lambent) add_tuned(&cost, n, form);
    if (lobe->at == paper_power) add_power(&cost, n, form);
    if (lobe->at == phong) add_power(&cost, form == LOBE_INTEGER ? paper_phong_exponent(n) : n, form);
    return cost;
}
