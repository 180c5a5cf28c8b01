/* SPDX-License-Identifier: MIT */
/* What paper 000 claims of W_m = (1 - zeta (1 - cos))^m, zeta = n / m, in its order of reading.
 *
 * Its "epicentre" ends at the inflection point of cos^n, tan^2 = 1 / (n - 1), where cos^n is near e^-1/2 = 0.61. What it calls
 * bloom lies outside and has no stated end.
 */
#include "claim.h"
#include "measure.h"

#include <math.h>
#include <stdio.h>

enum { N_TEXT = 250, N_ALL = 1000, GRID = 512 };

static const double quarter = PAPER_QUARTER_TURN;
static const unsigned all_m[4] = {2, 4, 8, 16};
static const char *const all_w[4] = {"w2", "w4", "w8", "w16"};

static claim of(const char *name, const char *definition, bool literal)
{
    claim c = {"000", name, definition, literal};
    return c;
}

/* What rounding leaves of nothing differs from one libm to another, so it is not printed. */
static const char *nothing(double value, double rounding) { return fabs(value) <= rounding ? "to the last digits" : "no"; }

/* The largest relative error up to the inflection point, per cent. */
static double epicentre(const char *name, unsigned from, unsigned to)
{
    double worst = 0;
    unsigned n;
    for (n = from; n <= to; n++) worst = fmax(worst, measure_relative(paper_lobe_named(name), n, 0, paper_inflection(n)));
    return 100 * worst;
}

/* ---------------------------------------------------------------------------------------------------------- properties of W_m */

static void claims_limits(void)
{
    double centre = 0, second = 0, least = 1;
    unsigned n, i, k;
    for (n = 1; n <= N_ALL; n++) {
        for (k = 0; k < 4; k++) {
            const paper_lobe *w = paper_lobe_named(all_w[k]);
            const double x = 1e-3 / sqrt(n);
            centre = fmax(centre, fabs(w->raw(n, 0) - 1));
            second = fmax(second, fabs((1 - w->raw(n, x)) / (1 - paper_power(n, x)) - 1));
            for (i = 0; i <= GRID; i++) least = fmin(least, w->raw(n, quarter * i / GRID));
        }
    }
    claim_fact(of("one-at-centre", "all m; n = 1 to 1000", true), "W_m = 1 at the centre", centre == 0, "differs by %.1g",
               centre);
    claim_fact(of("taylor-zeta", "(1 - W_m) / (1 - cos^n) at n^1/2 x = 0.001; all m and n", true), "zeta = n/m matches x^2",
               second < 1e-6, "%s", second < 1e-6 ? "1 within 1e-6" : "no");
    claim_fact(of("not-negative", "W_m unclamped over the quarter turn", true), "W_m >= 0", least >= 0, "%s",
               least >= 0 ? "never below 0" : "below 0");
}

/* The largest W_m at its zero, cos = (n - m) / n, for n from m on. */
static double at_zero(unsigned k)
{
    double most = 0;
    unsigned n;
    for (n = all_m[k]; n <= N_ALL; n++) {
        const double x = 2 * asin(sqrt(0.5 * all_m[k] / n));
        most = fmax(most, fabs(paper_lobe_named(all_w[k])->raw(n, x)));
    }
    return most;
}

static void claims_zero(void)
{
    const double most = fmax(at_zero(1), fmax(at_zero(2), at_zero(3)));
    unsigned n, none = 0;
    for (n = 1; n <= N_ALL; n++) none += paper_lobe_named("w16")->at(n, quarter) > 1e-30;
    claim_fact(of("zero", "W_2 at cos = (n - 2) / n; n = 2 to 1000; n = 1 has it at cos = -1", true), "W = 0 at cos = (n - 2)/n",
               at_zero(0) < 1e-20, "%s", nothing(at_zero(0), 1e-20));
    claim_fact(of("reaches-zero", "W_16 within the quarter turn; n = 1 to 1000", true), "the function reaches zero", none == 0,
               "not for n below %u", none + 1);
    claim_fact(of("reaches-zero", "W_m at cos = (n - m) / n; n from m on", false), "the function reaches zero", most < 1e-20,
               "%s", nothing(most, 1e-20));
}

/* How often a lobe rises from one angle to the next, up to an angle. */
static unsigned rises(const paper_lobe *w, bool raw, double (*end)(unsigned n), unsigned from)
{
    unsigned n, i, count = 0;
    for (n = from; n <= N_ALL; n++) {
        double last = 1;
        for (i = 1; i <= GRID; i++) {
            const double x = end(n) * i / GRID, value = raw ? w->raw(n, x) : w->at(n, x);
            count += value > last;
            last = value;
        }
    }
    return count;
}

static double zero_of_w2(unsigned n) { return n < 2 ? quarter : 2 * asin(sqrt(1.0 / n)); }
static double to_horizon(unsigned n) { return n ? quarter : 0; }

static void claims_monotone(void)
{
    const paper_lobe *w2 = paper_lobe_named("w2"), *w16 = paper_lobe_named("w16");
    const unsigned to_zero = rises(w2, true, zero_of_w2, 1), printed = rises(w2, true, to_horizon, 3),
                   cut = rises(w16, false, to_horizon, 1);
    claim_fact(of("monotone", "W_2 up to its zero; n = 1 to 1000; 512 steps", true), "falls to its zero", to_zero == 0,
               "%u rises", to_zero);
    claim_fact(of("monotone", "W_2 as printed; past its zero to the horizon; n = 3 on", false), "falls to its zero", printed == 0,
               "rises again; W_16 reaches %.1g at n = 1000", w16->raw(1000, quarter));
    claim_fact(of("monotone", "W_16 with its argument clamped at 0; to the horizon", false), "falls to its zero", cut == 0,
               "%u rises", cut);
}

/* W_2' = -(n/2 (cos - 1) + 1) n sin, against differences of W_2 itself. */
static void claims_derivative(void)
{
    const paper_lobe *w2 = paper_lobe_named("w2");
    double worst = 0;
    unsigned n, i;
    for (n = 1; n <= N_ALL; n += 9) {
        for (i = 1; i < GRID; i++) {
            const double x = quarter * i / GRID, d = 1e-5, printed = -(n / 2.0 * (cos(x) - 1) + 1) * n * sin(x);
            worst = fmax(worst, fabs((w2->raw(n, x + d) - w2->raw(n, x - d)) / (2 * d) - printed) / (1.0 * n * n));
        }
    }
    claim_fact(of("derivative", "as printed; against differences over 2e-5", true), "W' = -(n/2 (cos - 1) + 1) n sin",
               worst < 1e-6, "%s", worst < 1e-6 ? "the same" : "another");
}

/* ----------------------------------------------------------------------------------------------------- Schlick, Gauss, degree */

static double schlick_end(unsigned n, double level)
{
    return acos(level * n / (1 + level * (n - 1.0))); /* c = level (n - (n - 1) c) */
}

static void claims_schlick(void)
{
    const paper_lobe *schlick = paper_lobe_named("schlick");
    const double x = paper_angle_of(100, 1.0 / 256), relative = measure_relative(schlick, 100, 0, paper_angle_of(100, 0.05));
    claim_number(of("schlick-epicentre", "relative error up to the inflection; n = 1 to 1000", true), CLAIM_AT_MOST, 10, 0, " %",
                 epicentre("schlick", 1, N_ALL));
    claim_fact(of("schlick-slow", "n = 100; where cos^n is 1/256", true), "falls to zero extremely slowly",
               schlick->at(100, x) > 0.1, "Schlick is %.3f there", schlick->at(100, x));
    claim_fact(of("schlick-slow", "n = 100; angles at which both fall under 1/256", true), "widens the range of angles",
               schlick_end(100, 1.0 / 256) > x, "%.1f degrees; cos^n %.1f", schlick_end(100, 1.0 / 256) * 90 / quarter,
               x * 90 / quarter);
    claim_fact(of("schlick-slow", "n = 100; relative error while cos^n is at least 0.05", false),
               "falls to zero extremely slowly", relative > 1, "%.0f %%", 100 * relative);
}

/* x^2 from v = 1 - cos by four terms of its series: the largest error of e^(-n x^2 / 2) that this brings, n from 16 on. */
static double series_error(void)
{
    double worst = 0;
    unsigned n, i;
    for (n = 16; n <= N_ALL; n++) {
        for (i = 0; i <= GRID; i++) {
            const double x = quarter * i / GRID, v = 1 - cos(x), g = v * (2 + v * (1.0 / 3 + v * (4.0 / 45 + v / 35)));
            worst = fmax(worst, fabs(exp(-0.5 * n * g) - exp(-0.5 * n * x * x)));
        }
    }
    return worst;
}

static double worst_absolute(const char *name, unsigned from, unsigned to)
{
    double worst = 0;
    unsigned n;
    for (n = from; n <= to; n++) worst = fmax(worst, measure_absolute(paper_lobe_named(name), n, 0, fmin(quarter, 6 / sqrt(n))));
    return worst;
}

static void claims_gauss(void)
{
    claim_fact(of("gauss-accurate", "largest absolute error; n = 16 to 1000; W_16 beside it", false), "accurate enough",
               worst_absolute("gauss", 16, N_ALL) < 0.02, "%.4f; W_16 %.4f", worst_absolute("gauss", 16, N_ALL),
               worst_absolute("w16", 16, N_ALL));
    claim_fact(of("gauss-accurate", "the same for n = 1 to 15", false), "accurate enough", worst_absolute("gauss", 1, 15) < 0.02,
               "%.3f", worst_absolute("gauss", 1, 15));
    claim_fact(of("gauss-arccos", "its argument is x^2; a series in 1 - cos of four products gives it; n from 16 on", true),
               "needs an inverse function", series_error() > 0.001, "the series errs by %.1g", series_error());
}

static void claims_degree(void)
{
    int least = 99, most = 0;
    unsigned n;
    for (n = 17; n <= N_ALL; n++) {
        const int p = paper_power_products(n);
        least = p < least ? p : least;
        most = p > most ? p : most;
    }
    claim_fact(of("lower-degree", "n over m = 16 at n = 100; at n = 250; at n = 1000", true),
               "much lower degree than Phong and Blinn", 100 / 16.0 > 2, "%.1f; %.1f; %.1f times", 100 / 16.0, 250 / 16.0,
               1000 / 16.0);
    claim_fact(of("lower-degree", "products: W_16 from N.H; cos^n by squaring and multiplying; n = 17 to 1000", false),
               "much lower degree than Phong and Blinn",
               paper_lobe_cost(paper_lobe_named("w16"), 100, LOBE_WHOLE).multiplications < least, "5; cos^n %d to %d", least,
               most);
}

/* ------------------------------------------------------------------------------------------------------------------- accuracy */

/* The first n from which on the lobe is nearer to cos^n than Schlick's up to the inflection (or everywhere) for every n to 1000. */
static unsigned better_from(const char *name, bool everywhere)
{
    const paper_lobe *w = paper_lobe_named(name), *schlick = paper_lobe_named("schlick");
    unsigned n;
    for (n = N_ALL; n > 0; n--) {
        const double end = fmin(quarter, 6 / sqrt(n)), edge = paper_inflection(n);
        if (everywhere ? measure_absolute(w, n, 0, end) >= measure_absolute(schlick, n, 0, end)
                       : measure_relative(w, n, 0, edge) >= measure_relative(schlick, n, 0, edge))
            break;
    }
    return n + 1;
}

static void claims_order(void)
{
    const unsigned w2 = better_from("w2", false);
    unsigned k, first = 1, worse = 0, last = 0, n;
    claim_fact(of("figure3-epicentre", "n = 100; relative error up to the inflection; Schlick's beside it", false),
               "W_2 is accurate in the epicentre", epicentre("w2", 100, 100) < epicentre("schlick", 100, 100), "%.1f %%; %.1f %%",
               epicentre("w2", 100, 100), epicentre("schlick", 100, 100));
    claim_fact(of("figure4-w2-schlick", "relative error up to the inflection; n = 1 to 1000", true), "W_2 is nearer than Schlick",
               w2 == 1, "from n = %u on", w2);
    for (k = 1; k < 4; k++) first = better_from(all_w[k], true) > first ? better_from(all_w[k], true) : first;
    claim_fact(of("all-better-than-schlick", "largest absolute error of W_4 and W_8 and W_16; n = 1 to 1000", true),
               "all three are better than Schlick", first == 1, "from n = %u on", first);
    for (n = 1; n <= N_ALL; n++) {
        const double w4 = worst_absolute("w4", n, n), w8 = worst_absolute("w8", n, n), w16 = worst_absolute("w16", n, n);
        if (w8 >= w4 || w16 >= w8) worse++, last = n;
    }
    claim_fact(of("better-with-m", "largest absolute error of W_4 then W_8 then W_16; n = 1 to 1000", true),
               "the error falls as m grows", worse == 0, "not for %u n; the last is %u", worse, last);
}

static void claims_inflection(void)
{
    static const double stated[3] = {8, 3.8, 1};
    static const char *const name[3] = {"inflection-w4", "inflection-w8", "inflection-w16"};
    int k;
    for (k = 0; k < 3; k++) {
        claim_number(of(name[k], "relative error up to the inflection of cos^n; n = 1 to 250", true), CLAIM_AT_MOST, stated[k],
                     k != 0, " %", epicentre(all_w[k + 1], 1, N_TEXT));
        claim_number(of(name[k], "the same; n = 2 to 250: at n = 1 it is where cos is 0", false), CLAIM_AT_MOST, stated[k],
                     k != 0, " %", epicentre(all_w[k + 1], 2, N_TEXT));
        claim_number(of(name[k], "the same; n = 16 to 250", false), CLAIM_AT_MOST, stated[k], k != 0, " %",
                     epicentre(all_w[k + 1], 16, N_TEXT));
    }
    claim_number(of("inflection-schlick", "relative error up to the inflection of cos^n; n = 2 to 250", true), CLAIM_AT_LEAST, 22,
                 0, " %", epicentre("schlick", 2, N_TEXT));
}

/* The largest relative error of a row of table 1 up to its own inflection, or in the bloom, per cent; n from 16 to 250. */
static double row_error(int column, int row)
{
    const paper_lobe *lobe = paper_lobe_named(table1_rows[row]);
    double worst = 0;
    unsigned n;
    for (n = 16; n <= N_TEXT; n++) {
        const double edge = paper_inflection(n), own = measure_own_inflection(lobe, n);
        worst = fmax(worst, column == TABLE1_BLOOM ? measure_relative(lobe, n, edge, paper_angle_of(n, 1.0 / 256))
                                                   : measure_relative(lobe, n, 0, own));
    }
    return 100 * worst;
}

static void claims_table1(int column)
{
    static const char *const zone[2] = {"inflection", "bloom"};
    const table1_reading *best = table1_best(column);
    static char name[2][TABLE1_ROWS][32];
    int row;
    for (row = 0; row < TABLE1_ROWS; row++) {
        const double stated = table1_stated[column][row];
        char *id = name[column][row];
        snprintf(id, sizeof name[column][row], "table1-%s-%s", zone[column], table1_rows[row]);
        if (column == TABLE1_INFLECTION)
            claim_number(of(id, "up to the inflection of cos^n; n = 16 to 250", true), CLAIM_ABOUT, stated, 1, " %",
                         epicentre(table1_rows[row], 16, N_TEXT));
        claim_number(of(id,
                        column == TABLE1_BLOOM ? "from the inflection to where cos^n is 1/256; n = 16 to 250"
                                               : "up to the lobe's own inflection; n = 16 to 250",
                        false),
                     CLAIM_ABOUT, stated, 1, " %", row_error(column, row));
        claim_number(of(id, best->text, false), CLAIM_ABOUT, stated, 1, " %", best->percent[row]);
    }
}

static void claims_gain(void)
{
    const table1_reading *inflection = table1_best(TABLE1_INFLECTION), *bloom = table1_best(TABLE1_BLOOM);
    claim_number(of("gain-inflection", "table 1's own figures; 22.4 / 1.0", true), CLAIM_AT_LEAST, 22, 0, "",
                 table1_stated[TABLE1_INFLECTION][3] / table1_stated[TABLE1_INFLECTION][2]);
    claim_number(of("gain-inflection", "Schlick over W_16 up to the inflection; n = 16 to 250", true), CLAIM_AT_LEAST, 22, 0, "",
                 epicentre("schlick", 16, N_TEXT) / epicentre("w16", 16, N_TEXT));
    claim_number(of("gain-inflection", inflection->text, false), CLAIM_AT_LEAST, 22, 0, "",
                 inflection->percent[3] / inflection->percent[2]);
    claim_number(of("gain-bloom", "table 1's own figures; 98.2 / 7.6", true), CLAIM_AT_LEAST, 14, 0, "",
                 table1_stated[TABLE1_BLOOM][3] / table1_stated[TABLE1_BLOOM][2]);
    claim_number(of("gain-bloom", bloom->text, false), CLAIM_AT_LEAST, 14, 0, "", bloom->percent[3] / bloom->percent[2]);
    claim_number(of("gain-bloom", "largest absolute error; n = 16 to 1000", false), CLAIM_AT_LEAST, 14, 0, "",
                 worst_absolute("schlick", 16, N_ALL) / worst_absolute("w16", 16, N_ALL));
}

/* ----------------------------------------------------------------------------------------------------------------------- cost */

/* The largest error of W_16 from n = 16 on if wires that shift n drop what falls off its end. */
static double dropped(void)
{
    double worst = 0;
    unsigned n, i;
    for (n = 16; n <= N_ALL; n++) {
        for (i = 0; i <= GRID; i++) {
            const double x = fmin(quarter, 6 / sqrt(n)) * i / GRID;
            worst = fmax(worst, fabs(paper_w(16, n / 16 * 16, 1 - cos(x)) - paper_power(n, x)));
        }
    }
    return worst;
}

static void claims_cost(void)
{
    const lobe_cost schlick = paper_lobe_cost(paper_lobe_named("schlick"), 100, LOBE_WHOLE);
    const lobe_cost whole = paper_lobe_cost(paper_lobe_named("w16"), 100, LOBE_WHOLE);
    const lobe_cost carried = paper_lobe_cost(paper_lobe_named("w16"), 100, LOBE_CARRIED);
    claim_fact(of("cost-schlick", "c / (n - (n - 1) c); n - 1 once a material", true),
               "a product; a division; a subtraction; n - 1",
               schlick.multiplications == 1 && schlick.divisions == 1 && schlick.additions == 1,
               "%d product; %d division; %d subtraction", schlick.multiplications, schlick.divisions, schlick.additions);
    claim_fact(of("cost-w16", "from N.H; n (1 - c) is a product too", true), "four products; shift; two counts",
               whole.multiplications == 4, "%d products; %d additions", whole.multiplications, whole.additions);
    claim_fact(of("cost-w16", "from s = 1 - zeta (1 - c) carried along the row", false), "four products; shift; two counts",
               carried.multiplications == 4, "%d products; %d additions", carried.multiplications, carried.additions);
    claim_fact(of("zeta-by-wires", "n / 16 with its four fraction bits kept; largest error for n = 16 to 1000", true),
               "a shift gives zeta", worst_absolute("w16", 16, N_ALL) < 0.02, "%.3f", worst_absolute("w16", 16, N_ALL));
    claim_fact(of("zeta-by-wires", "the same with them dropped", false), "a shift gives zeta", dropped() < 0.02, "%.3f",
               dropped());
    claim_fact(of("no-division", "W_m", true), "no division", whole.divisions == 0, "%d divisions", whole.divisions);
}

static void speed(const char *report, const char *core, const char *over, const char *under, const char *definition, bool literal)
{
    claim_number(of("faster-than-schlick", definition, literal), CLAIM_AT_LEAST, 2.3, 1, " times",
                 claim_instructions(report, core, over) / claim_instructions(report, core, under));
}

static void claims_speed(const char *report)
{
    const double blinn = claim_instructions(report, "m0plus", "lobe-blinn"),
                 powf_ = claim_instructions(report, "m0plus", "lobe-powf");
    const double schlick = claim_instructions(report, "m0plus", "lobe-schlick"),
                 in_float = claim_instructions(report, "m0plus", "lobe-float-schlick");
    speed(report, "host", "lobe-float-schlick", "lobe-float-squarings", "instructions; x86-64; floats; n = 16; from N.H", true);
    speed(report, "host", "lobe-schlick", "lobe-w16", "instructions; x86-64; integers; W_16 from s", false);
    speed(report, "m0plus", "lobe-float-schlick", "lobe-float-squarings", "instructions; Cortex-M0+; floats; from N.H", true);
    speed(report, "m0plus", "lobe-schlick", "lobe-w16", "instructions; Cortex-M0+; integers; W_16 from s", false);
    speed(report, "m0plus", "lobe-schlick", "lobe-lyon", "instructions; Cortex-M0+; integers; W_16 from 1 - c", false);
    speed(report, "m4", "lobe-schlick", "lobe-w16", "instructions; Cortex-M4 with its divider; integers; W_16 from s", false);
    speed(report, "m55", "lobe-float-schlick", "lobe-float-squarings", "instructions; Cortex-M55 with its FPU; floats; from N.H",
          true);
    speed(report, "rv32ec", "lobe-schlick", "lobe-w16", "instructions; RV32EC: neither divider nor multiplier; W_16 from s",
          false);
    speed(report, "atmega1284p", "lobe-schlick", "lobe-w16", "instructions; ATmega1284P; integers; W_16 from s", false);
    claim_fact(of("schlick-cheaper", "instructions; Cortex-M0+; integers; cos^16 by squarings", false),
               "far cheaper than Phong and Blinn", schlick < blinn / 2, "%.0f; cos^16 %.0f", schlick, blinn);
    claim_fact(of("schlick-cheaper", "instructions; Cortex-M0+; floats; cos^n by powf", false),
               "far cheaper than Phong and Blinn", in_float < powf_ / 2, "%.0f; powf %.0f", in_float, powf_);
}

void claims_000(const char *report)
{
    claims_limits();
    claims_zero();
    claims_monotone();
    claims_derivative();
    claims_schlick();
    claims_gauss();
    claims_degree();
    claims_order();
    claims_inflection();
    claims_table1(TABLE1_INFLECTION);
    claims_table1(TABLE1_BLOOM);
    claims_gain();
    claims_cost();
    claims_speed(report);
}
