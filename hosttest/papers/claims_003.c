/* SPDX-License-Identifier: MIT */
/* What paper 003 claims of the parabola A x^2 + B x + C that stands for cos^n x, in its order of reading.
 *
 * "Refit": three terms of a Chebyshev series of cos^n on [0 b], b the largest with 2 % of relative error, found by ourselves for
 * each n; by integrals (the series) or from three nodes (interpolation), as the paper does not say which. y = n^1/2 x makes all n
 * alike.
 */
#include "chebyshev.h"
#include "claim.h"
#include "measure.h"
#include "sphere.h"

#include <math.h>

enum { N_ALL = CHEBYSHEV_N_MAX, N_SMALL = 8, GRID = 512 };

static claim of(const char *name, const char *definition, bool literal)
{
    claim c = {"003", name, definition, literal};
    return c;
}

/* A largest figure, and the n where it is. */
typedef struct most {
    double value;
    unsigned n;
} most;

static void take(most *m, double value, unsigned n)
{
    if (value > m->value) m->value = value, m->n = n;
}

/* --------------------------------------------------------------------------------------------------------------------- wishes */

static void claims_wishes(const char *report)
{
    const paper_lobe *published = paper_lobe_named("chebyshev_published");
    const lobe_cost cost = paper_lobe_cost(published, 100, LOBE_WHOLE);
    const lobe_cost rootless = paper_lobe_cost(paper_lobe_named("chebyshev_rootless"), 100, LOBE_WHOLE);
    most least = {0, 0};
    double end_low = 9, end_high = 0;
    unsigned n;
    for (n = N_SMALL; n <= N_ALL; n++) {
        const quadratic p = chebyshev_published(n);
        const double end = quadratic_zero(&p);
        take(&least, -quadratic_at(&p, PAPER_QUARTER_TURN), n);
        end_low = fmin(end_low, paper_power(n, end));
        end_high = fmax(end_high, paper_power(n, end));
    }
    claim_fact(of("by-the-cosine", "its parabola takes the angle", true), "a BRDF must be reckoned by the cosine",
               cost.calls == 0, "%d arccos an evaluation", cost.calls);
    claim_fact(of("by-the-cosine", "angle by series and root; instructions on Cortex-M0+; with acosf", false),
               "a BRDF must be reckoned by the cosine", rootless.calls == 0, "%.0f; %.0f",
               claim_instructions(report, "m0plus", "lobe-chebyshev_published"),
               claim_instructions(report, "m0plus", "lobe-acosf"));
    claim_fact(of("not-negative", "least value over the quarter turn; n = 8 to 1000", true),
               "preferably positive: no extra cut-off", least.value <= 0, "-%.0f at n = %u", least.value, least.n);
    claim_fact(of("not-negative", "what cos^n still is where the parabola ends; n = 8 to 1000", false),
               "preferably positive: no extra cut-off", end_high < 0.01, "%.3f to %.3f", end_low, end_high);
}

static void claims_monotone(void)
{
    unsigned n, i, rises = 0;
    double most_slope = 0;
    for (n = 1; n <= N_ALL; n++) {
        const quadratic p = chebyshev_published(n);
        double last = 1;
        for (i = 1; i <= GRID; i++) {
            const double value = quadratic_at(&p, PAPER_QUARTER_TURN * i / GRID);
            rises += value > last;
            last = value;
        }
        most_slope = fmax(most_slope, -(2 * p.a * quadratic_zero(&p) + p.b) / sqrt(n));
    }
    claim_fact(of("monotone", "over the quarter turn; n = 1 to 1000; 512 steps", true), "intensity changes monotonically",
               rises == 0, "%u rises", rises);
    claim_fact(of("no-artefacts", "slope in y where the parabola is cut off at zero; cos^n falls at most at 0.61", false),
               "no artefacts at the rim", most_slope <= 0.61, "%.2f", most_slope);
}

/* --------------------------------------------------------------------------------------------------------------- coefficients */

enum coefficient { OF_A, OF_B };

static double coefficient_of(const quadratic *p, enum coefficient k) { return k == OF_A ? p->a : p->b; }

/* The worst relative deviation of the printed law from refits. */
static most deviation(enum chebyshev_kind kind, enum coefficient k, unsigned from)
{
    most worst = {0, 0};
    unsigned n;
    for (n = from; n <= N_ALL; n++) {
        const quadratic p = chebyshev_published(n), *fit = &chebyshev_refit(kind, n)->p;
        take(&worst, fabs(coefficient_of(&p, k) / coefficient_of(fit, k) - 1), n);
    }
    return worst;
}

/* Least squares of -A or -B over n = 1 to 1000: slope and intercept, and the worst deviation from that line. */
static double line_of(enum chebyshev_kind kind, enum coefficient k, double *intercept, double *deviates)
{
    double sn = 0, sa = 0, snn = 0, sna = 0, slope;
    unsigned n;
    for (n = 1; n <= N_ALL; n++) {
        const double a = -coefficient_of(&chebyshev_refit(kind, n)->p, k);
        sn += n;
        sa += a;
        snn += (double)n * n;
        sna += n * a;
    }
    slope = (N_ALL * sna - sn * sa) / (N_ALL * snn - sn * sn);
    *intercept = (sa - slope * sn) / N_ALL;
    for (n = 1, *deviates = 0; n <= N_ALL; n++)
        *deviates = fmax(*deviates, fabs(-coefficient_of(&chebyshev_refit(kind, n)->p, k) - slope * n - *intercept));
    return slope;
}

static const char *const by[2] = {"refits by integrals; n = 1 to 1000", "refits at three nodes; n = 1 to 1000"};

static void claims_a(void)
{
    double slope[2], intercept[2], deviates[2];
    int k;
    for (k = 0; k < 2; k++) slope[k] = line_of((enum chebyshev_kind)k, OF_A, &intercept[k], &deviates[k]);
    for (k = 0; k < 2; k++)
        claim_fact(of("a-linear", by[k], true), "A is linear in n", deviates[k] < 0.05, "within %.3f of a line", deviates[k]);
    for (k = 0; k < 2; k++) claim_fact(of("a-slope", by[k], true), "0.272", fabs(slope[k] - 0.272) <= 0.0005, "%.4f", slope[k]);
    for (k = 0; k < 2; k++)
        claim_fact(of("a-intercept", by[k], true), "0.16", fabs(intercept[k] - 0.16) <= 0.005, "%.3f", intercept[k]);
    for (k = 0; k < 2; k++) {
        const most small = deviation((enum chebyshev_kind)k, OF_A, 1), large = deviation((enum chebyshev_kind)k, OF_A, N_SMALL);
        claim_fact(of("a-law", by[k], true), "A = -(0.272 n + 0.16)", small.value <= 0.02,
                   "off by %.1f %% at n = %u; from n = 8 %.1f %%", 100 * small.value, small.n, 100 * large.value);
    }
}

/* The largest change of the printed lobe from n to n + 1 beyond that of the refitted one, up to its zero. */
static double lobe_jump(unsigned n)
{
    const paper_lobe *printed = paper_lobe_named("chebyshev_published"), *refit = paper_lobe_named("chebyshev_refit");
    const quadratic p = chebyshev_published(n), q = chebyshev_published(n + 1);
    const double end = fmin(quadratic_zero(&p), quadratic_zero(&q));
    double largest = 0;
    int i;
    for (i = 0; i <= GRID; i++) {
        const double x = end * i / GRID;
        largest = fmax(largest, fabs(printed->at(n + 1, x) - printed->at(n, x) - refit->at(n + 1, x) + refit->at(n, x)));
    }
    return largest;
}

static void claims_b(void)
{
    static const unsigned bound[3] = {31, 63, 255};
    static const char *const at[3] = {"n = 31 to 32", "n = 63 to 64", "n = 255 to 256"};
    most law = {0, 0};
    double intercept, deviates;
    unsigned n;
    int i;
    line_of(CHEBYSHEV_NODES, OF_B, &intercept, &deviates);
    claim_fact(of("b-not-linear", by[CHEBYSHEV_NODES], true), "B is not linear in n", deviates > 0.05,
               "up to %.2f off the best line", deviates);
    for (i = 0; i < 2; i++) {
        const most small = deviation((enum chebyshev_kind)i, OF_B, 1), large = deviation((enum chebyshev_kind)i, OF_B, N_SMALL);
        claim_fact(of("b-law", by[i], true), "B by four pieces", small.value <= 0.02,
                   "off by %.0f %% at n = %u; from n = 8 %.1f %% at %u", 100 * small.value, small.n, 100 * large.value, large.n);
    }
    for (n = 1; n <= N_ALL; n++) {
        const quadratic p = chebyshev_by_law(n);
        take(&law, fabs(p.b / chebyshev_refit(CHEBYSHEV_SERIES, n)->p.b - 1), n);
    }
    claim_fact(of("b-law", "in their place -n^1/2 times a cubic in 1 / n; against refits by integrals", false),
               "B by four pieces", law.value <= 0.02, "off by %.2f %% at n = %u", 100 * law.value, law.n);
    for (i = 0; i < 3; i++) {
        const quadratic p = chebyshev_published(bound[i]), q = chebyshev_published(bound[i] + 1);
        const double own =
            chebyshev_refit(CHEBYSHEV_SERIES, bound[i] + 1)->p.b - chebyshev_refit(CHEBYSHEV_SERIES, bound[i])->p.b;
        claim_fact(of("b-continuous", at[i], false), "pieces join", fabs(q.b - p.b - own) < 0.002,
                   "B %+.3f where refits %+.3f; lobe %.4f", q.b - p.b, own, lobe_jump(bound[i]));
    }
}

static void claims_c(void)
{
    int k;
    for (k = 0; k < 2; k++) {
        double low = 9, high = 0;
        unsigned n;
        for (n = 1; n <= N_ALL; n++) {
            const double c = chebyshev_refit((enum chebyshev_kind)k, n)->p.c;
            low = fmin(low, c);
            high = fmax(high, c);
        }
        claim_fact(of("c-one", by[k], true), "C = 1 for all n", low > 0.995 && high < 1.005, "%.4f to %.4f", low, high);
    }
}

/* ------------------------------------------------------------------------------------------------------------------- accuracy */

/* What three terms of a series give away: the best parabola's error on the same interval, and how far it keeps 2 %. */
static void claims_least(void)
{
    const chebyshev_fit *fit = chebyshev_refit(CHEBYSHEV_SERIES, 100);
    quadratic best;
    const double error = chebyshev_least(100, fit->end, &best);
    double end = fit->end;
    while (chebyshev_least(100, end, &best) <= CHEBYSHEV_ERROR) end += 0.001 * fit->end;
    claim_fact(of("least-deviation", "best parabola of all in relative error; n = 100; same interval", true),
               "Chebyshev polynomials deviate least", error > 0.95 * CHEBYSHEV_ERROR, "%.2f %% in place of 2", 100 * error);
    claim_fact(of("least-deviation", "how far that one keeps 2 %; n = 100; y of both", false),
               "Chebyshev polynomials deviate least", end < 1.05 * fit->end, "%.2f in place of %.2f", 10 * end, 10 * fit->end);
}

static most error_to(unsigned from, enum chebyshev_kind kind)
{
    most worst = {0, 0};
    unsigned n;
    for (n = from; n <= N_ALL; n++) {
        const quadratic p = chebyshev_published(n);
        take(&worst, chebyshev_relative(&p, n, chebyshev_refit(kind, n)->end), n);
    }
    return worst;
}

static most error_to_y(unsigned from, double y)
{
    most worst = {0, 0};
    unsigned n;
    for (n = from; n <= N_ALL; n++) {
        const quadratic p = chebyshev_published(n);
        take(&worst, chebyshev_relative(&p, n, y / sqrt(n)), n);
    }
    return worst;
}

static void percent(const char *name, const char *definition, bool literal, const char *stated, most worst)
{
    claim_fact(of(name, definition, literal), stated, worst.value <= 0.025, "%.1f %% at n = %u", 100 * worst.value, worst.n);
}

static void claims_error(void)
{
    double ends[2] = {9, 0}, level = 9;
    most refit = {0, 0};
    unsigned n, reached = 0;
    percent("error-2-percent", "printed coefficients on [0 b]; b of refits by integrals; n = 1 to 1000", true, "<= 2 %",
            error_to(1, CHEBYSHEV_SERIES));
    percent("error-2-percent", "the same; b of refits at three nodes", true, "<= 2 %", error_to(1, CHEBYSHEV_NODES));
    percent("error-2-percent", "the same; n = 8 to 1000", false, "<= 2 %", error_to(N_SMALL, CHEBYSHEV_NODES));
    percent("error-2-percent", "printed coefficients up to y = 1; n = 8 to 1000", false, "<= 2 %", error_to_y(N_SMALL, 1));
    for (n = 1; n <= N_ALL; n++) {
        const chebyshev_fit *fit = chebyshev_refit(CHEBYSHEV_SERIES, n);
        const quadratic p = chebyshev_published(n);
        take(&refit, chebyshev_relative(&fit->p, n, fit->end), n);
        reached += chebyshev_reach(&p, n) >= 0.95 * fit->end;
        if (n < 2) continue;
        ends[0] = fmin(ends[0], fit->end * sqrt(n));
        ends[1] = fmax(ends[1], fit->end * sqrt(n));
        level = fmin(level, paper_power(n, fit->end));
    }
    percent("error-2-percent", "our refits on their [0 b]; n = 1 to 1000", false, "<= 2 %", refit);
    claim_fact(of("interval-end", "how many of 1000 n keep 2 % up to 95 % of the refit's b", true), "2 % up to b",
               reached == N_ALL, "%u", reached);
    claim_fact(of("upper-part-parabola", "refits; n = 2 to 1000; y and cos^n at b", false), "the upper part is like a parabola",
               level > 0.45, "y = %.3f to %.3f; cos^n from %.2f up", ends[0], ends[1], level);
}

static void epicentre(const char *name, const char *definition, unsigned from)
{
    most worst = {0, 0};
    unsigned n;
    for (n = from; n <= N_ALL; n++) take(&worst, measure_relative(paper_lobe_named(name), n, 0, paper_inflection(n)), n);
    percent("epicentre", definition, false, "high accuracy; 2 % say", worst);
}

static void claims_epicentre(void)
{
    epicentre("chebyshev_published", "printed; relative error up to the inflection of cos^n; n = 2 to 1000", 2);
    epicentre("chebyshev_published", "the same; n = 8 to 1000", N_SMALL);
    epicentre("chebyshev_refit", "refit; the same; n = 8 to 1000", N_SMALL);
    epicentre("w16", "W_16 of paper 000; the same; n = 16 to 1000", 16);
    epicentre("lambent", "Lambent's; the same; n = 8 to 1000", N_SMALL);
}

/* ------------------------------------------------------------------------------------------------------------- cost and looks */

static void claims_cost(void)
{
    const lobe_cost published = paper_lobe_cost(paper_lobe_named("chebyshev_published"), 1000, LOBE_CARRIED);
    const lobe_cost whole = paper_lobe_cost(paper_lobe_named("chebyshev_published"), 1000, LOBE_WHOLE);
    const lobe_cost once = paper_lobe_cost(paper_lobe_named("chebyshev_published"), 1, LOBE_CARRIED);
    const lobe_cost rootless = paper_lobe_cost(paper_lobe_named("chebyshev_rootless"), 1000, LOBE_WHOLE);
    claim_fact(of("second-degree", "A x^2 + B x + C; all n", true), "second degree for all n", published.multiplications == 2,
               "%d products; %d additions once x is there", published.multiplications, published.additions);
    claim_fact(of("cost-independent-of-n", "products for n = 1; for n = 1000; x given", true), "cost does not depend on n",
               once.multiplications == published.multiplications, "%d; %d", once.multiplications, published.multiplications);
    claim_fact(of("simple-hardware", "from N.H", true), "no complex functions nor long operations", whole.calls == 0,
               "%d products; %d additions; %d arccos", whole.multiplications, whole.additions, whole.calls);
    claim_fact(of("simple-hardware", "from N.H by series and root", false), "no complex functions nor long operations",
               rootless.multiplications <= 5, "%d products; %d additions", rootless.multiplications, rootless.additions);
}

static void looks(const char *lobe, unsigned n, const char *definition, bool literal)
{
    const sphere_difference d = sphere_compare(paper_lobe_named(lobe), n);
    claim_fact(of("no-visible-difference", definition, literal), "no visible difference", d.seen == 0,
               "%d levels; %.1f dB; %.1f %% over 1 level; %.1f %% dL* > 1", d.levels, d.psnr_db, 100 * d.over_1, 100 * d.seen);
}

static void claims_looks(void)
{
    looks("chebyshev_published", 8, "lit sphere; printed; n = 8", true);
    looks("chebyshev_published", 32, "lit sphere; printed; n = 32", true);
    looks("chebyshev_published", 100, "lit sphere; printed; n = 100", true);
    looks("chebyshev_published", 500, "lit sphere; printed; n = 500", true);
    looks("chebyshev_refit", 32, "lit sphere; refit; n = 32", false);
    looks("w16", 32, "lit sphere; W_16 of paper 000; n = 32", false);
    looks("lambent", 32, "lit sphere; Lambent's; n = 32", false);
    looks("lambent", 500, "lit sphere; Lambent's; n = 500", false);
}

void claims_003(const char *report)
{
    claims_wishes(report);
    claims_monotone();
    claims_a();
    claims_b();
    claims_c();
    claims_error();
    claims_least();
    claims_epicentre();
    claims_cost();
    claims_looks();
}
