/* SPDX-License-Identifier: MIT */
/* What paper 001 says of its equations, and of the operations that they take. Operations are counted by running (count.h). */
#include "claims_001.h"

#include "steps_kernels.h"
#include "steps_parts.h"

/* ---------------------------------------------------------------------------------------------------- equations 2 to 6: N(t) */

/* The largest of something over angles of 1 to 175 degrees and all along 24 pixels. */
static double worst_over(double (*of)(const paper_span *span, double t))
{
    double worst = 0, t;
    int degrees;
    for (degrees = 1; degrees <= 175; degrees++) {
        const paper_span span = paper_span_flat(degrees * CLAIM_DEGREE, 24, 0.3 * degrees, 0.4);
        for (t = 0; t <= 24; t++) worst = fmax(worst, of(&span, t));
    }
    return worst;
}

static double apart(const paper_span *span, double t)
{
    double worst = 0;
    int e;
    for (e = 2; e <= 6; e++) worst = fmax(worst, fabs(paper_dot(paper_normal(e, span, t), span->ray) - paper_exact(span, t)));
    return worst;
}

static double off_unit(const paper_span *span, double t)
{
    const paper_vector n = paper_normal(6, span, t);
    return fabs(sqrt(paper_dot(n, n)) - 1);
}

/* (5) at a right angle, t = 0 and psi w = 90 degrees apart, is Na and Nk: unit and at right angles. */
static double across(const paper_span *span, double t)
{
    const double psi = acos(paper_dot(span->from, span->to));
    const paper_vector k = paper_normal(5, span, 24 * 90 * CLAIM_DEGREE / psi);
    (void)t;
    return fmax(fabs(paper_dot(k, span->from)), fabs(sqrt(paper_dot(k, k)) - 1));
}

static double off_ends(const paper_span *span, double t)
{
    const paper_vector n = paper_normal(2, span, t > 12 ? 24 : 0), end = t > 12 ? span->to : span->from;
    return fmax(fabs(n.x - end.x), fmax(fabs(n.y - end.y), fabs(n.z - end.z)));
}

#define ROUNDING 1e-11 /* less than that is rounding in double, which differs from one libm to another */

/* An identity in double: what is left is rounding, and what is little more is told by its power of ten. */
static void exact(const char *name, bool literal, const char *definition, double error)
{
    const claim c = claim_001(name, literal, definition);
    if (error < ROUNDING)
        claim_fact(c, "exact", true, "to the last digits");
    else if (error < 1e-6)
        claim_fact(c, "exact", false, "off by some 1e%.0f", log10(error));
    else
        claim_fact(c, "exact", false, "off by %.2g", error);
}

static void turning(void)
{
    exact("equations-2-to-6-agree", true, "1 to 175 degrees", worst_over(apart));
    exact("normal-is-unit", true, "length of N by (6); 1 to 175 degrees", worst_over(off_unit));
    exact("nk-is-unit-and-orthogonal", true, "of (5); 1 to 175 degrees", worst_over(across));
    exact("interpolates-the-ends", true, "(2) at t = 0 and m", worst_over(off_ends));
}

/* ------------------------------------------------------------------------------------------------------- (7) to (11) and (14) */

/* The worst of one block, over phi up to 45 degrees and rays all round. */
static double once(const char *name, unsigned pixels, double from_degrees, double to_degrees)
{
    double worst = 0, phi;
    for (phi = from_degrees; phi <= to_degrees; phi += 0.25)
        worst = fmax(worst, paper_step_worst(paper_step_named(name), phi * pixels * CLAIM_DEGREE, pixels));
    return worst;
}

/* (10) with the numbers of the print, wherever its brackets may end: C = cos(2 phi), c = cos(phi). The least of the worst. */
static double printed_third(int reading, double c, double c2, double f, double before)
{
    switch (reading) {
    case 0:
        return c2 * (4 * f * c - before) - 3 * before;
    case 1:
        return c2 * 4 * (f * c - before) - 3 * before;
    case 2:
        return c2 * (4 * f * c - before - 3 * before);
    case 3:
        return c2 * 4 * f * c - before - 3 * before;
    default:
        return c2 * (4 * f * c - 3 * before) - before; /* the two factors exchanged */
    }
}

static double any_reading(double phi)
{
    double least = 1e9;
    int reading, k;
    for (reading = 0; reading < 5; reading++) {
        double worst = 0;
        for (k = 0; k < 36; k++) {
            const double x = 10 * k * CLAIM_DEGREE, got = printed_third(reading, cos(phi), cos(2 * phi), cos(x), cos(x - phi));
            worst = fmax(worst, fabs(got - cos(x + 3 * phi)));
        }
        least = fmin(least, worst);
    }
    return least;
}

/* (11) with the numbers of the print and each choice of its three signs: a scan may lose a minus. The least of the worst. */
static double any_signs(double phi)
{
    const double c = cos(phi), c2 = cos(2 * phi);
    double least = 1e9;
    int signs, k;
    for (signs = 0; signs < 8; signs++) {
        const double three = signs & 1 ? -3 : 3, four = signs & 2 ? -4 : 4, one = signs & 4 ? -1 : 1;
        double worst = 0;
        for (k = 0; k < 36; k++) {
            const double x = 10 * k * CLAIM_DEGREE, f = cos(x), before = cos(x - phi);
            const double got = 2 * f * c2 * (2 * c2 + three) - 2 * before * c * (c2 + four) + one * f;
            worst = fmax(worst, fabs(got - cos(x + 4 * phi)));
        }
        least = fmin(least, worst);
    }
    return least;
}

/* (13): a light's colour may be multiplied into the ray once, since (14) is linear. */
static double scaled_ray(void)
{
    static double f[PAPER_PIXELS_MAX + 4], g[PAPER_PIXELS_MAX + 4];
    paper_span span = paper_span_flat(60 * CLAIM_DEGREE, 100, 0.5, 0.3);
    double worst = 0;
    unsigned t;
    paper_step_named("eq14")->run(&span, f);
    span.ray = scaled(span.ray, 0.7);
    paper_step_named("eq14")->run(&span, g);
    for (t = 0; t <= span.pixels; t++) worst = fmax(worst, fabs(g[t] - 0.7 * f[t]));
    return worst;
}

/* In fixed point the recurrence of vectors fails, though it is exact. */
static double vectors_of_16_bits(void)
{
    kernel_errors e = {0, 0};
    unsigned i;
    for (i = 0; i < 24; i++) {
        const kernel_span span = kernel_span_series(90 * CLAIM_DEGREE, 240, i);
        kernel_measure(kernel_named("eq7_vector16"), &span, &e);
    }
    return e.whole;
}

static void recurrences(void)
{
    exact("eq7", true, "one step; phi to 45 degrees", once("eq7_vector", 2, 0.25, 45));
    exact("eq7", false, "4096 steps in double; 90 degrees",
          paper_step_worst(paper_step_named("eq7_vector"), 90 * CLAIM_DEGREE, 4096));
    exact("eq7", false, "240 steps in 16 bits; 90 degrees", vectors_of_16_bits());
    exact("eq8-eq9", true, "phi to 43 degrees", once("block2", 2, 0.25, 43));
    exact("eq10", true, "as printed; phi = 0", once("block3_printed", 3, 0, 0));
    exact("eq10", true, "as printed; phi to 45 degrees", once("block3_printed", 3, 0, 45));
    exact("eq10", false, "the best of five readings of the print; phi = 0", any_reading(0));
    exact("eq10", false, "corrected to C (4c N(t) - 2 N(t-1)) - N(t-1)", once("block3", 3, 0.25, 45));
    exact("eq11", true, "as printed; phi = 0", once("block4_printed", 4, 0, 0));
    exact("eq11", true, "as printed; phi = 1 degree", once("block4_printed", 4, 1, 1));
    exact("eq11", true, "as printed; phi to 43 degrees", once("block4_printed", 4, 0, 43));
    exact("eq11", false, "the best choice of three signs; phi = 10 degrees", any_signs(10 * CLAIM_DEGREE));
    exact("eq11", false, "corrected to (4 C^2 + 2 C - 1) N(t) - 4 c C N(t-1)", once("block4", 4, 0.25, 43));
    exact("eq13", true, "0.7 L for L; 100 steps of (14)", scaled_ray());
    exact("eq14", true, "one step; phi to 45 degrees", once("eq14", 2, 0.25, 45));
}

/* ----------------------------------------------------------------------------------------------------------------- operations */

static paper_cost pixel_of(const char *name)
{
    paper_cost pixel, span;
    paper_step_cost(paper_step_named(name), &pixel, &span);
    return pixel;
}

static paper_cost span_of(const char *name)
{
    paper_cost pixel, span;
    paper_step_cost(paper_step_named(name), &pixel, &span);
    return span;
}

static bool is(paper_cost c, double multiplications, double additions, double shifts, double divisions, double roots,
               double sines)
{
    return c.multiplications == multiplications && c.additions == additions && c.shifts == shifts && c.divisions == divisions &&
           c.roots == roots && c.sines == sines;
}

/* A normal's cost a pixel, of steps that take the dot product last: without its 3 multiplications and 2 additions. */
static paper_cost normal_of(const char *name)
{
    paper_cost c = pixel_of(name);
    c.multiplications -= 3;
    c.additions -= 2;
    return c;
}

static paper_cost third_of(paper_cost c)
{
    c.multiplications /= 3;
    c.additions /= 3;
    c.shifts /= 3;
    c.divisions /= 3;
    c.roots /= 3;
    c.sines /= 3;
    return c;
}

static void say(claim about, const char *stated, bool met, paper_cost c)
{
    claim_fact(about, stated, met, "%.3g mul %.3g add %.3g shift %.3g div %.3g root %.3g sine", c.multiplications, c.additions,
               c.shifts, c.divisions, c.roots, c.sines);
}

static paper_cost normalising(void)
{
    static const paper_cost nothing;
    const paper_vector v = {0.6, 0.5, 0.3};
    paper_count = nothing;
    unit(v);
    return paper_count;
}

/* A normal by (2), its sines and quotients taken once for the three components. */
static paper_cost shared_sines(void)
{
    static const paper_cost nothing;
    const paper_vector a = {1, 0, 0}, b = {0, 1, 0};
    const double psi = 90 * CLAIM_DEGREE;
    double w_psi = 0.3, s, t;
    paper_count = nothing;
    s = over(sine_of(minus(psi, w_psi)), 1);
    t = over(sine_of(w_psi), 1);
    sum(scaled(a, s), scaled(b, t));
    w_psi = plus(w_psi, 0.1);
    return paper_count;
}

/* (8) and (9) of one component, the factor of N(t) made each time. */
static paper_cost second_by(int equation)
{
    static const paper_cost nothing;
    const double c = 0.9, c2 = 2 * 0.81 - 1, f = 0.5, before = 0.4;
    double factor;
    paper_count = nothing;
    factor = equation == 8 ? minus(twice(twice(times(c, c))), 1) : plus(twice(c2), 1);
    minus(times(f, factor), twice(times(before, c)));
    return paper_count;
}

static void operations(void)
{
    const paper_cost phong = normal_of("normalise"), turn = normal_of("eq7_vector"), slerp = third_of(normal_of("slerp"));
    const paper_cost f = pixel_of("eq14"), second8 = second_by(8), second9 = second_by(9), block = pixel_of("block4"),
                     set = span_of("eq14");
    paper_cost c = normalising();
    say(claim_001("operations-normalising", true, "counted as it runs"), "3 div 3 mul 2 add 1 root", is(c, 3, 2, 0, 3, 1, 0), c);
    say(claim_001("operations-phong", true, "the normal alone; counted"), "3 mul 3 div 5 add 1 root", is(phong, 3, 5, 0, 3, 1, 0),
        phong);
    say(claim_001("operations-eq2", true, "a component; as (2) stands"), "2 div 2 mul 3 add 2 sines", is(slerp, 2, 3, 0, 2, 0, 2),
        slerp);
    c = third_of(shared_sines());
    say(claim_001("operations-eq2", false, "sines and quotients shared by three components"), "2 div 2 mul 3 add 2 sines",
        is(c, 2, 3, 0, 2, 0, 2), c);
    c = third_of(turn);
    say(claim_001("operations-eq7", true, "a component; counted"), "1 mul 1 shift 1 sub", is(c, 1, 1, 1, 0, 0, 0), c);
    say(claim_001("operations-eq7-normal", true, "three components; counted"), "3 mul 3 shift 3 sub", is(turn, 3, 3, 3, 0, 0, 0),
        turn);
    say(claim_001("operations-eq14", true, "counted; N.L and N.H alike"), "1 mul 1 shift 1 sub", is(f, 1, 1, 1, 0, 0, 0), f);
    claim_fact(claim_001("eq9-simpler-than-eq8", true, "factor of N(t) made at each pixel; cos 2phi at hand"),
               "fewer multiplications", second9.multiplications < second8.multiplications, "%g against %g",
               second9.multiplications, second8.multiplications);
    claim_fact(claim_001("eq9-simpler-than-eq8", false, "factor of N(t) made once a span"), "fewer multiplications",
               second9.multiplications < second8.multiplications - 1, "%g against %g", second9.multiplications,
               second8.multiplications - 1);
    claim_fact(claim_001("four-pixels-independent", false, "corrected forms take N(t) and N(t-1) alone"),
               "from the same operands", once("block4", 4, 0.25, 43) < ROUNDING, "yes; right to the last digits");
    claim_fact(claim_001("four-pixels-independent", false, "and cost no more than one after the other"),
               "multiplications a pixel", block.multiplications <= f.multiplications, "%.3g against %.3g", block.multiplications,
               f.multiplications);
    claim_fact(claim_001("no-division-nor-root", true, "a pixel; (14)"), "none", f.divisions + f.roots == 0, "%g",
               f.divisions + f.roots);
    claim_fact(claim_001("no-division-nor-root", false, "a span; preparing (14) by (4)"), "none", set.divisions + set.roots == 0,
               "%g div %g root %g sines", set.divisions, set.roots, set.sines);
}

/* ------------------------------------------------------------------------------------------------------------- (1) and (12) */

/* The largest difference of (R.V)^n and (N.H)^m, the light 60 degrees off the viewer and the normal in their plane or beside. */
static double blinn_for_phong(int n, int m, double lift)
{
    const double light = 60 * CLAIM_DEGREE;
    double worst = 0, x;
    for (x = -80; x <= 80; x += 0.25) {
        const double angle = x * CLAIM_DEGREE + light / 2; /* of the normal's shadow from the viewer */
        const double reflected = fmax(2 * cos(lift) * cos(angle - light) * cos(lift) * cos(angle) - cos(light), 0);
        const double half = fmax(cos(lift) * cos(angle - light / 2), 0);
        worst = fmax(worst, fabs(pow(reflected, n) - pow(half, m)));
    }
    return worst;
}

static void blinn(const char *definition, int m, double lift)
{
    const double e = blinn_for_phong(16, m, lift);
    claim_fact(claim_001("eq12-for-eq1", false, definition), "same highlight", e < CLAIM_HALF_LEVEL, "%.2g", e);
}

static void lighting(void)
{
    blinn("(N.H)^n for cos^n lambda; n = 16; one plane", 16, 0);
    blinn("(N.H)^4n for cos^n lambda; n = 16; one plane", 64, 0);
    blinn("(N.H)^4n for cos^n lambda; n = 16; 10 degrees beside", 64, 10 * CLAIM_DEGREE);
}

void claims_001_equations(void)
{
    turning();
    recurrences();
    operations();
    lighting();
}

void claims_001(const char *report)
{
    claims_001_equations();
    claims_001_rivals();
    claims_001_speed(report);
}
