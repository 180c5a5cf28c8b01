/* SPDX-License-Identifier: MIT */
/* Papers 000 and 003 reproduced: the lobes in double against their formulas, the refits, the printed coefficients, the cases
 * where the papers' lobes fail, and the verdicts of claims.
 *
 *   test_papers_lobes [SEED]
 */
#include "papers/chebyshev.h"
#include "papers/claim.h"
#include "papers/lobes.h"
#include "papers/measure.h"
#include "papers/sphere.h"
#include "test.h"

#include <stdbool.h>
#include <string.h>

static const double quarter = PAPER_QUARTER_TURN;

/* ---------------------------------------------------------------------------------------------------------------- definitions */

/* The formulas once more, by the vectors in the plane of the angle: N on the y axis, H turned from it by the angle. */
static double definition(const char *name, double n, double x)
{
    const double c = cos(x), dd = sin(x) * sin(x) + (1 - c) * (1 - c), i = floor(255 * c + 0.5) / 255;
    const double b = n < 32 ? 0.018 * n + 0.158 : n < 64 ? 0.01 * n + 0.38 : n < 256 ? 0.005 * n + 0.7 : 0.003 * n + 1.2;
    if (!strcmp(name, "phong")) return pow(fmax(0, cos(2 * x)), n / 4);
    if (!strcmp(name, "blinn")) return pow(fmax(0, c), n);
    if (!strcmp(name, "schlick")) return c / (n - n * c + c);
    if (!strcmp(name, "gauss")) return exp(-n * x * x / 2);
    if (name[0] == 'w') {
        const double m = atof(name + 1);
        return pow(fmax(0, 1 - n / m * (1 - c)), m);
    }
    if (!strcmp(name, "lyon")) return pow(fmax(0, 1 - n / 32 * dd), 16);
    if (!strcmp(name, "table256")) return pow(i, n);
    if (!strcmp(name, "chebyshev_published")) return fmin(1, fmax(0, 1 - b * x - (0.272 * n + 0.16) * x * x));
    if (!strcmp(name, "lambent")) return pow(fmax(0, c), n); /* what it stands for */
    return fmin(1, fmax(0, quadratic_at(&chebyshev_refit(CHEBYSHEV_SERIES, (unsigned)n)->p, x)));
}

/* How far each may be from it. Without an arccos, x^2 = 2 v (1 + v/6 + ...) lacks its fifth term, 0.0102 v^5, and what follows. */
static double slack(const char *name, double n, double x)
{
    if (!strcmp(name, "lambent")) return 1.0 / 1000;
    return 1e-11 + (strcmp(name, "chebyshev_rootless") ? 0 : 1.1 * 0.0102 * n * pow(1 - cos(x), 5));
}

static void test_definitions(test_random *r)
{
    unsigned k;
    int i;
    for (k = 0; k < paper_lobe_count; k++) {
        const paper_lobe *l = &paper_lobes[k];
        const bool table = !strcmp(l->name, "table256");
        double worst = 0, at = 0, outside = 0;
        unsigned n = 1, at_n = 0;
        for (i = 0; i < 100000; i++) {
            double x = test_real(r, 0, 1), off, fraction;
            n = (unsigned)test_integer(r, 1, 1000);
            x *= i % 2 ? quarter : fmin(quarter, 3 / sqrt(n));
            fraction = 255 * cos(x) - floor(255 * cos(x));
            if (table && fabs(fraction - 0.5) < 1e-9) continue; /* a tie, which rounding decides */
            off = fabs(l->at(n, x) - definition(l->name, n, x)) / slack(l->name, n, x);
            outside = fmax(outside, fmax(-l->at(n, x), l->at(n, x) - 1));
            if (off > worst) worst = off, at = x, at_n = n;
        }
        test_verdict(worst <= 1 && outside <= 0, l->name, "off by %.3f of its bound, %.2g, at n = %u, %.4f rad; in [0, 1]", worst,
                     slack(l->name, at_n, at), at_n, at);
    }
}

/* D.D = 2 (1 - c) for unit vectors, so Lyon's is W_16. Where a normal is longer or shorter by e, N.H errs by e and D.D by e^2. */
static void test_lyon(void)
{
    const double e = 1.0 / 256;
    double same = 0, dot = 0, difference = 0;
    unsigned n, i;
    for (n = 16; n <= 1000; n++) {
        for (i = 0; i <= 200; i++) {
            const double x = i * 4 / sqrt(n) / 200, length = 1 - e, c = length * cos(x);
            const double dd = length * length + 1 - 2 * length * cos(x), true_w = paper_w(16, n, 1 - cos(x));
            same = fmax(same, fabs(paper_lobe_named("lyon")->at(n, x) - paper_lobe_named("w16")->at(n, x)));
            dot = fmax(dot, fabs(paper_w(16, n, 1 - c) - true_w));
            difference = fmax(difference, fabs(paper_w(16, n, dd / 2) - true_w));
        }
    }
    test_verdict(same < 1e-11 && difference < dot / 30, "lyon is w16",
                 "unit normals: within %.1g; normals short by 1/256: the dot product errs %.3f, the difference vector %.4f", same,
                 dot, difference);
}

/* --------------------------------------------------------------------------------------------------------------------- refits */

/* Every fit meets 2 %, and no longer interval does: 1 % longer, and up to twice as long in steps of 5 %. */
static void test_refits(void)
{
    static const char *const names[2] = {"refits by integrals", "refits at three nodes"};
    int kind, i;
    for (kind = 0; kind < 2; kind++) {
        double worst = 0, least = 9;
        unsigned n, bad = 0;
        for (n = 1; n <= CHEBYSHEV_N_MAX; n += n < 40 ? 1 : 13) {
            const chebyshev_fit *fit = chebyshev_refit((enum chebyshev_kind)kind, n);
            worst = fmax(worst, chebyshev_relative(&fit->p, n, fit->end));
            for (i = -1; i <= 20; i++) {
                const double end = fit->end * (i < 0 ? 1.001 : 1 + 0.05 * i);
                const quadratic p = chebyshev_terms((enum chebyshev_kind)kind, n, end);
                if (i == 0 || end >= quarter - 1e-3) continue;
                least = fmin(least, chebyshev_relative(&p, n, end));
                bad += chebyshev_relative(&p, n, end) <= 0.02;
            }
        }
        test_verdict(bad == 0 && worst <= 0.02 && worst > 0.0199, names[kind], "at most %.6f; longer intervals err %.5f or more",
                     worst, least);
    }
}

/* The terms are those of the series: what is left of cos^n has no component of T_0, T_1, T_2; three nodes interpolate. */
static void test_terms(void)
{
    double left = 0, nodes = 0;
    unsigned n;
    int i, k;
    for (n = 1; n <= 1000; n += 37) {
        const double end = 1.1 / sqrt(n);
        const quadratic p = chebyshev_terms(CHEBYSHEV_SERIES, n, end), q = chebyshev_terms(CHEBYSHEV_NODES, n, end);
        double sum[3] = {0, 0, 0};
        for (i = 0; i < 1000; i++) {
            const double theta = (i + 0.5) * 2 * quarter / 1000, x = (1 + cos(theta)) / 2 * end;
            for (k = 0; k < 3; k++) sum[k] += (pow(cos(x), n) - quadratic_at(&p, x)) * cos(k * theta) / 1000;
        }
        for (k = 0; k < 3; k++) left = fmax(left, fabs(sum[k]));
        for (i = 1; i < 6; i += 2) {
            const double x = (1 + cos(i * quarter / 3)) / 2 * end;
            nodes = fmax(nodes, fabs(pow(cos(x), n) - quadratic_at(&q, x)));
        }
    }
    test_verdict(left < 1e-12 && nodes < 1e-12, "terms", "components left %.1g; at the nodes %.1g", left, nodes);
}

/* The best parabola has the error that it is said to have; no other has less, here those near the series; the series has more. */
static void test_least(test_random *r)
{
    double gain = 0, off = 0;
    unsigned n, better = 0;
    int i;
    for (n = 1; n <= 1000; n += 111) {
        const chebyshev_fit *fit = chebyshev_refit(CHEBYSHEV_SERIES, n);
        quadratic best;
        const double least = chebyshev_least(n, fit->end, &best);
        gain = fmax(gain, least / 0.02);
        off = fmax(off, fabs(chebyshev_relative(&best, n, fit->end) / least - 1));
        for (i = 0; i < 2000; i++) {
            quadratic p = best;
            p.a *= 1 + test_real(r, -0.02, 0.02);
            p.b *= 1 + test_real(r, -0.05, 0.05);
            p.c += test_real(r, -0.002, 0.002);
            better += chebyshev_relative(&p, n, fit->end) < least * (1 - 1e-4);
        }
    }
    test_verdict(better == 0 && off < 1e-3 && gain < 0.8, "least",
                 "at most %.2f of the series' error, which its parabola has within %.1g of it; %u of 20000 others are better",
                 gain, off, better);
}

static void test_law(void)
{
    const chebyshev_law *law_of = chebyshev_law_of_refits();
    double worst = 0, relative = 0;
    unsigned n, at = 0;
    int i;
    for (n = 1; n <= CHEBYSHEV_N_MAX; n++) {
        const chebyshev_fit *fit = chebyshev_refit(CHEBYSHEV_SERIES, n);
        const quadratic law = chebyshev_by_law(n);
        relative = fmax(relative, chebyshev_relative(&law, n, fit->end));
        for (i = 0; i <= 100; i++) {
            const double x = quadratic_zero(&fit->p) * i / 100, off = fabs(quadratic_at(&law, x) - quadratic_at(&fit->p, x));
            if (off > worst) worst = off, at = n;
        }
    }
    test_verdict(worst < 2e-4 && relative < 0.0201, "law",
                 "within %.6f of the refits, worst at n = %u; relative error up to b %.5f; A = -%.4f n, B = -%.4f n^1/2, C = "
                 "%.4f for large n",
                 worst, at, relative, law_of->a[0], law_of->b[0], law_of->c[0]);
}

/* As printed; and with either sign turned the error passes 2 % before y = 0.3. */
static void test_published(void)
{
    static const struct {
        unsigned n;
        double a, b;
    } printed[] = {{1, -0.432, -0.176},  {31, -8.592, -0.716},  {32, -8.864, -0.7},     {63, -17.296, -1.01},
                   {64, -17.568, -1.02}, {255, -69.52, -1.975}, {256, -69.792, -1.968}, {1000, -272.16, -4.2}};
    double worst = 0, turned = 0;
    unsigned i, n;
    for (i = 0; i < sizeof printed / sizeof printed[0]; i++) {
        const quadratic p = chebyshev_published(printed[i].n);
        worst = fmax(worst, fmax(fabs(p.a - printed[i].a), fmax(fabs(p.b - printed[i].b), fabs(p.c - 1))));
    }
    for (n = 8; n <= 1000; n++) {
        quadratic p = chebyshev_published(n), q = p;
        p.b = -p.b;
        q.a = -q.a;
        turned = fmax(turned, sqrt(n) * fmax(chebyshev_reach(&p, n), chebyshev_reach(&q, n)));
    }
    test_verdict(worst < 1e-12 && turned < 0.3, "published",
                 "A and B as printed within %.1g; signs turned, 2 %% ends at y = %.2f or before", worst, turned);
}

/* --------------------------------------------------------------------------------------------------- where papers' lobes fail */

static void test_clamps(void)
{
    const double far = paper_lobe_named("w16")->raw(1000, quarter);
    unsigned n, k, rises = 0, i;
    test_verdict(far > 3.5e28 && far < 4.5e28 && paper_lobe_named("w16")->at(1000, quarter) == 0, "past the zero",
                 "W_16 at the horizon for n = 1000: %.2g as printed, 0 cut off", far);
    test_verdict(fabs(measure_absolute(paper_lobe_named("w16"), 2, 0, quarter) - 0.145) < 0.001 &&
                     measure_absolute(paper_lobe_named("w2"), 2, 0, quarter) < 1e-12,
                 "n below m", "n = 2: W_16 errs %.3f, W_2 %.1g", measure_absolute(paper_lobe_named("w16"), 2, 0, quarter),
                 measure_absolute(paper_lobe_named("w2"), 2, 0, quarter));
    for (k = 0; k < paper_lobe_count; k++) {
        for (n = 1; n <= 1000; n += 9) {
            double last = 2;
            for (i = 0; i <= 2000; i++) {
                const double value = paper_lobes[k].at(n, quarter * i / 2000);
                rises += value > last;
                last = value;
            }
        }
    }
    test_verdict(rises == 0, "monotone", "14 lobes cut off: %u rises over the quarter turn", rises);
}

static void test_schlick(void)
{
    const double x = paper_angle_of(100, 0.05), relative = paper_lobe_named("schlick")->at(100, x) / 0.05 - 1;
    test_verdict(fabs(paper_power(100, x) - 0.05) < 1e-9 && relative > 3.9 && relative < 4.1, "schlick",
                 "where cos^100 is 0.05 it errs by %.0f %%", 100 * relative);
}

static double published_error(unsigned n)
{
    const quadratic p = chebyshev_published(n);
    return chebyshev_relative(&p, n, paper_inflection(n));
}

static void test_small_n(void)
{
    const quadratic p = chebyshev_published(100);
    const double end = 10 * quadratic_zero(&p), left = paper_power(100, quadratic_zero(&p));
    test_verdict(published_error(8) < 0.025 && published_error(4) > 0.04 && published_error(4) < 0.05 &&
                     published_error(2) > 0.16 && published_error(2) < 0.18,
                 "published, small n", "relative error up to the inflection: n = 8 %.3f, n = 4 %.3f, n = 2 %.3f",
                 published_error(8), published_error(4), published_error(2));
    test_verdict(end > 1.65 && end < 1.75 && left > 0.22 && left < 0.25, "published, its end", "y = %.3f, where cos^n is %.3f",
                 end, left);
}

/* ------------------------------------------------------------------------------------------------------------------- verdicts */

static bool is(enum claim_verdict verdict, const char *measured)
{
    const claim_record *r = claim_latest();
    return r && r->verdict == verdict && !strcmp(r->measured, measured);
}

static void test_claims(void)
{
    const claim said = {"000", "test", "in its words", true}, ours = {"000", "test", "in ours", false};
    unsigned right = 0;
    claim_number(said, CLAIM_AT_MOST, 10, 0, " %", 10.4);
    right += is(CLAIM_HOLDS, "10.4 %");
    claim_number(said, CLAIM_AT_MOST, 10, 0, " %", 10.6);
    right += is(CLAIM_DOES_NOT_HOLD, "10.6 %");
    claim_number(ours, CLAIM_AT_MOST, 1, 1, "", 1.04);
    right += is(CLAIM_HOLDS_WHERE_DEFINED, "1.04");
    claim_number(ours, CLAIM_AT_MOST, 1, 1, "", 1.06);
    right += is(CLAIM_DOES_NOT_HOLD, "1.06");
    claim_number(said, CLAIM_AT_LEAST, 2.3, 1, " times", 2.26);
    right += is(CLAIM_HOLDS, "2.26 times");
    claim_number(said, CLAIM_AT_LEAST, 2.3, 1, " times", 2.2);
    right += is(CLAIM_DOES_NOT_HOLD, "2.2 times");
    claim_number(ours, CLAIM_ABOUT, 8, 1, " %", 8.39);
    right += is(CLAIM_HOLDS_WHERE_DEFINED, "8.39 %");
    claim_number(said, CLAIM_ABOUT, 8, 1, " %", 7.5);
    right += is(CLAIM_DOES_NOT_HOLD, "7.5 %");
    claim_number(said, CLAIM_ABOUT, 0.3, 1, "", 0.34);
    right += is(CLAIM_HOLDS, "0.34");
    claim_number(said, CLAIM_AT_MOST, 8, 0, " %", INFINITY);
    right += is(CLAIM_DOES_NOT_HOLD, "inf %");
    claim_fact(said, "so", true, "%d", 3);
    right += is(CLAIM_HOLDS, "3");
    claim_fact(ours, "so", true, "%d", 4);
    right += is(CLAIM_HOLDS_WHERE_DEFINED, "4");
    claim_fact(said, "so", false, "%d", 5);
    right += is(CLAIM_DOES_NOT_HOLD, "5");
    test_verdict(right == 13, "verdicts", "%u of 13 judged right", right);
}

/* Counts out of a table of kernels, and none where there is none. */
static void test_instructions(void)
{
    const char *folder = ".";
    FILE *file = fopen("./kernel_cycles.csv", "r");
    if (file) fclose(file);
    test_verdict(isnan(claim_instructions("/nowhere", "m0plus", "lobe-w16")) &&
                     (file || isnan(claim_instructions(folder, "m0plus", "lobe"))),
                 "instructions", "no table, no figure");
}

/* CIE L* of a grey level of sRGB, with the constants as the standards round them. */
static double lightness(double grey)
{
    const double v = grey / 255, y = v > 0.04045 ? pow((v + 0.055) / 1.055, 2.4) : v / 12.92;
    return y > 0.008856 ? 116 * pow(y, 1.0 / 3) - 16 : 903.3 * y;
}

/* A column of table 1: the reading that the search finds is no worse than any it was told of, and a sphere knows itself. */
static void test_measures(void)
{
    const table1_reading *a = table1_best(TABLE1_INFLECTION), *b = table1_best(TABLE1_BLOOM);
    const sphere_difference same = sphere_compare(paper_lobe_named("blinn"), 32), w2 = sphere_compare(paper_lobe_named("w2"), 32);
    test_verdict(a->met >= 3 && b->met >= 3, "table 1", "%s: %d of 4; %s: %d of 4", a->text, a->met, b->text, b->met);
    unsigned all = 0, over = 0, seen = 0;
    int x, y;
    for (y = 0; y < SPHERE_SIZE; y++) {
        for (x = 0; x < SPHERE_SIZE; x++) {
            const double a_level = floor(0.5 + 255 * sphere_light(paper_lobe_named("blinn"), 32, x, y));
            const double b_level = floor(0.5 + 255 * sphere_light(paper_lobe_named("w2"), 32, x, y));
            all += a_level >= 0;
            over += a_level >= 0 && fabs(a_level - b_level) > 1.5;
            seen += a_level >= 0 && fabs(lightness(a_level) - lightness(b_level)) > 1;
        }
    }
    test_verdict(same.levels == 0 && fabs(w2.over_1 * all - over) < 0.5 && fabs(w2.seen * all - seen) < 0.5 && same.seen <= 0 &&
                     w2.levels > 10 && w2.over_1 > w2.seen && w2.seen > 0,
                 "sphere", "itself %d levels; W_2 for n = 32 %d levels, %.1f dB, %.3f over one level, %.3f seen", same.levels,
                 w2.levels, w2.psnr_db, w2.over_1, w2.seen);
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    test_definitions(&r);
    test_lyon();
    test_refits();
    test_terms();
    test_least(&r);
    test_law();
    test_published();
    test_clamps();
    test_schlick();
    test_small_n();
    test_claims();
    test_instructions();
    test_measures();
    return test_end();
}
