/* SPDX-License-Identifier: MIT */
/* Paper 001's ways along a span and those beside it: definitions against eq. 2, integer kernels against their definitions, and
 * what each does where it must fail. What is expected is in the tables; it was written before anything was measured. */
#include "papers/steps_kernels.h"
#include "test.h"

#include <string.h>

static const double pi = 3.14159265358979323846;

static paper_vector random_unit(test_random *r)
{
    for (;;) {
        paper_vector v = {test_real(r, -1, 1), test_real(r, -1, 1), test_real(r, -1, 1)};
        const double square = paper_dot(v, v), scale = 1 / sqrt(square);
        if (square > 1 || square < 0.01) continue;
        v.x *= scale;
        v.y *= scale;
        v.z *= scale;
        return v;
    }
}

/* Two unit normals psi apart and a ray, all anywhere. */
static paper_span random_span(test_random *r, double psi, unsigned pixels)
{
    const paper_vector a = random_unit(r), b = random_unit(r);
    const double along = paper_dot(a, b), across = sqrt(1 - along * along), c = cos(psi), s = sin(psi) / across;
    paper_span span = {a, a, {0, 0, 0}, 0};
    if (across < 0.1) return random_span(r, psi, pixels);
    span.to.x = a.x * c + (b.x - a.x * along) * s;
    span.to.y = a.y * c + (b.y - a.y * along) * s;
    span.to.z = a.z * c + (b.z - a.z * along) * s;
    span.ray = random_unit(r);
    span.pixels = pixels;
    return span;
}

/* 1 to most, even in its logarithm. */
static unsigned random_pixels(test_random *r, double most) { return (unsigned)pow(most + 0.999, test_real(r, 0, 1)); }

/* The worst of something, and the span where it was. */
typedef struct worst {
    double error;
    double psi;
    unsigned pixels;
} worst;
static void keep(worst *w, double error, double psi, unsigned pixels)
{
    if (!(error > w->error)) return; /* a NaN stays out: forms_finite asks for those */
    w->error = error;
    w->psi = psi * 180 / pi;
    w->pixels = pixels;
}

/* ------------------------------------------------------------------------------------------------- definitions in double */

/* Forms that turn the normal evenly. Rounding by 2^-53 is added up: t times where it stays, t^2 / 2 times where a recurrence adds
 * it up twice, and a block multiplies it by U(k) <= 5 as well. Set-up has some sixteen roundings of its own. */
static void test_forms(test_random *r)
{
    static const struct {
        const char *name;
        double once, twice; /* times m, m^2 */
    } form[] = {{"slerp", 8, 0},   {"kuijk_blake", 8, 0}, {"lambent", 8, 0}, {"eq7_vector", 8, 4},
                {"block2", 8, 20}, {"block3", 8, 20},     {"block4", 8, 20}, {"eq14", 8, 4}};
    unsigned i, k;
    for (i = 0; i < sizeof form / sizeof *form; i++) {
        const paper_step *step = paper_step_named(form[i].name);
        worst w = {-1, 0, 0};
        for (k = 0; k < 400; k++) {
            const double psi = pow(10, test_real(r, -4, 0)) * 175 * pi / 180;
            const unsigned pixels = random_pixels(r, PAPER_PIXELS_MAX);
            const paper_span span = random_span(r, psi, pixels);
            const double room = (16 + form[i].once * pixels + form[i].twice * pixels * pixels) / 4503599627370496.0;
            keep(&w, paper_step_error(step, &span) / (room / sin(psi > pi / 2 ? psi : pi / 2)), psi, pixels);
        }
        test_verdict(w.error <= 1, "form_turns_evenly", "%s: %.2g of the room that rounding has, psi %.4g, %u pixels",
                     form[i].name, w.error, w.psi, w.pixels);
    }
}

/* Every form gives numbers, also where sin(psi) is zero. */
static void test_forms_finite(void)
{
    static const double psi[] = {0, 1e-9, 3.14159265358979323846, 3.1415};
    static double f[PAPER_PIXELS_MAX + 4];
    unsigned i, k, t, bad = 0;
    for (i = 0; i < paper_step_count; i++) {
        if (strstr(paper_steps[i].name, "printed")) continue; /* they grow without bound */
        for (k = 0; k < 4; k++) {
            const paper_span span = paper_span_flat(psi[k], 17, 0.4, 0.3);
            paper_steps[i].run(&span, f);
            for (t = 0; t <= span.pixels; t++) bad += !(fabs(f[t]) <= 1.2);
        }
    }
    test_verdict(bad == 0, "form_finite", "%u values beyond 1.2 or no numbers at psi = 0 and 180 degrees", bad);
}

/* Equations 2 to 6 are the same unit vector. Eq. 4 takes a root of 1 - cos^2, which cancels: from one degree on. */
static void test_equations(test_random *r)
{
    worst apart = {-1, 0, 0}, length = {-1, 0, 0};
    unsigned k;
    int e;
    for (k = 0; k < 4000; k++) {
        const double psi = test_real(r, 1, 179) * pi / 180;
        const unsigned pixels = random_pixels(r, PAPER_PIXELS_MAX);
        const paper_span span = random_span(r, psi, pixels);
        const double t = (double)test_integer(r, 0, pixels);
        for (e = 2; e <= 6; e++) {
            const paper_vector n = paper_normal(e, &span, t);
            keep(&apart, fabs(paper_dot(n, span.ray) - paper_exact(&span, t)), psi, pixels);
            keep(&length, fabs(paper_dot(n, n) - 1), psi, pixels);
        }
    }
    test_verdict(apart.error < 1e-10, "equations_2_to_6_agree", "%.2g, psi %.4g", apart.error, apart.psi);
    test_verdict(length.error < 1e-10, "equations_2_to_6_unit", "%.2g, psi %.4g", length.error, length.psi);
}

/* One block from exact values: right to 1e-12 at every phi as derived, wrong as printed. */
static void test_blocks(test_random *r)
{
    static const struct {
        const char *name;
        unsigned pixels;
    } block[] = {{"block2", 2}, {"block3", 3}, {"block4", 4}};
    unsigned i, k;
    for (i = 0; i < 3; i++) {
        const paper_step *step = paper_step_named(block[i].name);
        worst w = {-1, 0, 0};
        for (k = 0; k < 20000; k++) {
            const double psi = test_real(r, 0.001, 175) * pi / 180;
            const paper_span span = random_span(r, psi, block[i].pixels);
            keep(&w, paper_step_error(step, &span), psi, block[i].pixels);
        }
        test_verdict(w.error < 1e-12, "block_once", "%s: %.2g, psi %.4g", block[i].name, w.error, w.psi);
    }
}

static void test_printed(void)
{
    const paper_step *three = paper_step_named("block3_printed"), *four = paper_step_named("block4_printed");
    const paper_span still = paper_span_flat(0, 4, 0, 0), turned = paper_span_flat(40 * pi / 180, 4, 0, 0);
    const paper_span still3 = paper_span_flat(0, 3, 0, 0);
    double e = paper_step_error(three, &still3);
    test_verdict(fabs(e - 1) < 1e-12, "printed_10_at_zero", "gives 0 for 1: off by %.4g", e);
    e = paper_step_error(four, &still);
    test_verdict(e < 1e-12, "printed_11_at_zero", "right where nothing turns: off by %.4g", e);
    e = paper_step_error(four, &turned);
    test_verdict(e > 0.1, "printed_11_at_ten_degrees", "wrong where something does: off by %.4g", e);
}

/* What is counted: the paper's own counts for eq. 7 and 14. */
static void test_counts(void)
{
    paper_cost eq14, vector, ours, span;
    paper_step_cost(paper_step_named("eq14"), &eq14, &span);
    paper_step_cost(paper_step_named("eq7_vector"), &vector, &span);
    paper_step_cost(paper_step_named("lambent"), &ours, &span);
    test_verdict(eq14.multiplications == 1 && eq14.shifts == 1 && eq14.additions == 1 && eq14.divisions + eq14.roots == 0,
                 "count_eq14", "%g multiplications, %g shifts, %g additions", eq14.multiplications, eq14.shifts, eq14.additions);
    test_verdict(vector.multiplications == 6 && vector.shifts == 3 && vector.additions == 5, "count_eq7",
                 "%g multiplications, %g shifts, %g additions, the dot product among them", vector.multiplications, vector.shifts,
                 vector.additions);
    test_verdict(ours.multiplications == 1 && ours.additions == 2 && ours.shifts == 0, "count_difference_form",
                 "%g multiplications, %g additions", ours.multiplications, ours.additions);
}

/* -------------------------------------------------------------------------------------------- integer kernels: their bounds */

/* Arithmetic alone, psi up to 90 degrees. A normal and a ray rounded to Q2.14 are up to sqrt(3)/2 2^-14 off unit each: 1.06e-4
 * for whoever takes them as they are. The rest, in units of 2^-14:
 *   normalise_*        the interpolated normal is cut to Q2.14, up to a unit a component: sqrt(3) at right angles to it, over 0.7
 *   _sqrt, _length     the root is cut, a unit, over 0.7, and so is the quotient; _multiply: N.L is cut to a half, the root, and the
 *                      product to a unit
 *   kuijk_blake        0.8 of the angle and 0.56 of the sine, half a unit of the amplitude
 * Recurrences of 32 bits err by rounding added up, m^2 / 2 times 2^-30, from the first value before the span, 2^-30 m / sin(phi)
 * of which is m^2 / psi: 2e-3 at 1024 pixels and small angles. Those of 16 bits have no bound at all. */
static const struct bound {
    const char *name;
    double arithmetic, wide; /* up to 1024 and up to 4096 pixels; 0: none */
} bounds[] = {
    {"flat", 1.7e-4, 1.7e-4},
    {"linear", 1.2e-4, 1.3e-4},
    {"quadratic", 2.2e-4, 2.4e-4},
    {"normalise_textbook", 3.2e-4, 3.2e-4},
    {"normalise_sqrt", 3.2e-4, 3.2e-4},
    {"normalise_multiply", 3.5e-4, 3.5e-4},
    {"float_normalise", 1.2e-4, 2.4e-4},
    {"lyon_taylor", 3.5e-4, 3.5e-4},
    {"forward_length", 2.5e-4, 2.7e-4},
    {"kuijk_blake", 2.5e-4, 2.5e-4},
    {"eq7_vector32", 2e-3, 3.2e-2},
    {"block4_32", 2e-3, 3.2e-2},
    {"plain32", 2e-3, 3.2e-2},
    {"lambent", LMB_SPAN_DIFFUSE_MAX_ERROR, LMB_SPAN_DIFFUSE_MAX_ERROR},
};
#define BOUNDS (sizeof bounds / sizeof bounds[0])

static kernel_span random_kernel_span(test_random *r, double psi, unsigned pixels)
{
    const paper_span span = random_span(r, psi, pixels);
    return kernel_span_of(&span);
}

static void test_kernel_bounds(test_random *r, unsigned least, unsigned most, bool wide)
{
    unsigned i, k;
    for (i = 0; i < BOUNDS; i++) {
        const double bound = wide ? bounds[i].wide : bounds[i].arithmetic;
        worst w = {-1, 0, 0};
        for (k = 0; k < (wide ? 60 : 400); k++) {
            const double psi = pow(10, test_real(r, -3, 0)) * 89.99 * pi / 180;
            const unsigned pixels = k % 8 == 0 ? most : least + random_pixels(r, most - least);
            const kernel_span span = random_kernel_span(r, psi, pixels);
            kernel_errors e = {0, 0};
            kernel_measure(kernel_named(bounds[i].name), &span, &e);
            keep(&w, e.arithmetic, psi, pixels);
        }
        test_verdict(w.error <= bound, wide ? "kernel_arithmetic_4096" : "kernel_arithmetic_1024",
                     "%s: %.3g of %.3g, psi %.4g, %u pixels", bounds[i].name, w.error, bound, w.psi, w.pixels);
    }
}

/* Failures that are known, as intervals: psi and pixels, worst error of 96 spans. */
static void test_known_failures(void)
{
    static const struct {
        const char *name;
        double psi;
        unsigned pixels;
        double low, high;
    } known[] = {
        {"plain16", 90, 240, 0.5, 0.8},       {"plain16", 45, 100, 0.06, 0.13},      {"plain16", 15, 240, 0.02, 0.06},
        {"block4", 90, 800, 0.8, 4},          {"block4", 90, 240, 0.05, 0.8},        {"eq7_vector16", 90, 240, 0.4, 0.9},
        {"linear", 90, 240, 0.28, 0.30},      {"quadratic", 90, 240, 0.029, 0.031},  {"normalise_sqrt", 90, 240, 0.070, 0.073},
        {"lyon_taylor", 90, 240, 0.07, 0.09}, {"reflection_map", 45, 240, 0.02, 0.3}};
    unsigned i, k;
    for (i = 0; i < sizeof known / sizeof *known; i++) {
        kernel_errors e = {0, 0};
        for (k = 0; k < 96; k++) {
            const kernel_span span = kernel_span_series(known[i].psi * pi / 180, known[i].pixels, k);
            kernel_measure(kernel_named(known[i].name), &span, &e);
        }
        test_verdict(e.whole >= known[i].low && e.whole <= known[i].high, "known_failure",
                     "%s at %g degrees, %u pixels: %.3g in %g to %g", known[i].name, known[i].psi, known[i].pixels, e.whole,
                     known[i].low, known[i].high);
    }
}

/* ------------------------------------------------------------------------------------------------ integer kernels: the edges */

static double f[PAPER_PIXELS_MAX + 4];

static bool is(unsigned kernel, const char *part) { return strstr(compare_steps[kernel].name, part) != NULL; }

/* How far a kernel whose f should stay may go: not at all, but for
 *   lambent      its swing about 2^-18
 *   quadratic    ends are as they were rounded, the middle is normalised: up to sqrt(3)/2 2^-14 of vectors off unit, and 2^-15
 *   plain32, eq7_vector32   what arc.h adds for products that are rounded down it adds to exact ones, too: 2^-30 a pixel, added up
 *                m^2 / 2 times, and by a dot product up to sqrt(3) times that */
static double still_bound(unsigned kernel, double pixels)
{
    const double drift = (pixels + 1) * (pixels + 1) / 2 / 1073741824;
    if (is(kernel, "plain32")) return drift;
    if (is(kernel, "vector32")) return 1.74 * drift;
    return is(kernel, "lambent") ? 1.0 / (1 << 18) : is(kernel, "quadratic") ? 1e-4 : 0;
}

/* Equal normals: f is their dot product with the ray, and stays. */
static void test_still(test_random *r)
{
    unsigned i, k, t;
    for (i = 0; i < compare_step_count; i++) {
        double apart = 0, off = 0;
        for (k = 0; k < 40; k++) {
            const kernel_span span = random_kernel_span(r, 0, k % 4 ? random_pixels(r, 4096) : 4096);
            kernel_run(&compare_steps[i], &span, f);
            for (t = 1; t <= span.pixels; t++) apart = fmax(apart, fabs(f[t] - f[0]));
            {
                const paper_span exact = kernel_span_exact(&span);
                off = fmax(off, fabs(f[0] - paper_exact(&exact, 0)));
            }
        }
        test_verdict(apart <= still_bound(i, 4096) && off <= (is(i, "map") ? 0.3 : 3e-4), "equal_normals",
                     "%s: moves by %.2g, off by %.2g", compare_steps[i].name, apart, off);
    }
}

/* One pixel: from the first normal to the second, whatever is between. */
static void test_one_pixel(test_random *r)
{
    unsigned i, k;
    for (i = 0; i < compare_step_count; i++) {
        double off = 0;
        if (is(i, "flat") || is(i, "map")) continue;
        for (k = 0; k < 400; k++) {
            const kernel_span span = random_kernel_span(r, test_real(r, 0, 90) * pi / 180, 1);
            const paper_span exact = kernel_span_exact(&span);
            kernel_run(&compare_steps[i], &span, f);
            off = fmax(off, fmax(fabs(f[0] - paper_exact(&exact, 0)), fabs(f[1] - paper_exact(&exact, 1))));
        }
        test_verdict(off <= 3.2e-4, "one_pixel", "%s: ends off by %.2g", compare_steps[i].name, off);
    }
}

/* What may come of normals that cancel, or are none. Sums of ends, and the library's arc, which then runs straight, stay within one.
 * A length of a few units of 2^-14 is cut by up to one of them: quotients double; without a root N.L is cut, by half a unit. The
 * parabola's middle is then any normal at all, and so may be the shadow that CORDIC finds. Recurrences have what their registers have. */
static double stray_bound(unsigned kernel)
{
    if (is(kernel, "plain") || is(kernel, "block") || is(kernel, "eq7")) return 8;
    if (is(kernel, "float")) return 1.001;
    if (is(kernel, "textbook") || is(kernel, "sqrt") || is(kernel, "forward_length") || is(kernel, "lyon")) return 2;
    return is(kernel, "quadratic") || is(kernel, "normalise_multiply") || is(kernel, "kuijk") ? 1.5 : 1.001;
}

/* Nearly opposite normals. */
static void test_opposite(test_random *r)
{
    static const double psi[] = {120.5, 150, 179, 179.99, 180};
    unsigned i, k, t;
    for (i = 0; i < compare_step_count; i++) {
        const double bound = stray_bound(i);
        double most = 0;
        for (k = 0; k < 200; k++) {
            const kernel_span span = random_kernel_span(r, psi[k % 5] * pi / 180, random_pixels(r, 1024));
            kernel_run(&compare_steps[i], &span, f);
            for (t = 0; t <= span.pixels; t++) most = fmax(most, fabs(f[t]));
        }
        test_verdict(most <= bound, "opposite_normals", "%s: up to %.4g of %g", compare_steps[i].name, most, bound);
    }
}

/* Normals 5 % off unit: those that normalise, and the library, do not care; the others are 5 % off themselves. Where the lengths of
 * both ends differ, a normalised linear normal leaves its even turn, by up to 0.05 / 4 of psi. */
static void test_off_unit(test_random *r)
{
    unsigned i, k;
    for (i = 0; i < compare_step_count; i++) {
        const bool minds =
            is(i, "linear") || is(i, "quadratic") || is(i, "eq7") || is(i, "plain") || is(i, "block") || is(i, "kuijk");
        double off = 0;
        if (is(i, "16") || is(i, "block") || is(i, "map") || is(i, "flat")) continue;
        for (k = 0; k < 300; k++) {
            kernel_span span = random_kernel_span(r, test_real(r, 0, 5) * pi / 180, random_pixels(r, 512));
            paper_span exact = kernel_span_exact(&span);
            const double a = test_real(r, 0.95, 1.05), b = test_real(r, 0.95, 1.05);
            span.from.x = (int16_t)lround(exact.from.x * a * 16384);
            span.from.y = (int16_t)lround(exact.from.y * a * 16384);
            span.from.z = (int16_t)lround(exact.from.z * a * 16384);
            span.to.x = (int16_t)lround(exact.to.x * b * 16384);
            span.to.y = (int16_t)lround(exact.to.y * b * 16384);
            span.to.z = (int16_t)lround(exact.to.z * b * 16384);
            {
                kernel_errors e = {0, 0};
                kernel_measure(&compare_steps[i], &span, &e);
                off = fmax(off, e.whole);
            }
        }
        test_verdict(minds ? off > 0.03 && off <= 0.056 : off <= 2.5e-3, "off_unit", "%s: off by %.3g", compare_steps[i].name,
                     off);
    }
}

/* A zero normal at either end or both: numbers in range, no fault. */
static void test_zero(test_random *r)
{
    unsigned i, k, t;
    for (i = 0; i < compare_step_count; i++) {
        const double bound = stray_bound(i);
        double most = 0;
        for (k = 0; k < 60; k++) {
            static const lmb_vec zero;
            kernel_span span = random_kernel_span(r, 0.5, random_pixels(r, 1024));
            if (k % 3 != 0) span.from = zero;
            if (k % 3 != 1) span.to = zero;
            kernel_run(&compare_steps[i], &span, f);
            for (t = 0; t <= span.pixels; t++) most = fmax(most, fabs(f[t]));
        }
        test_verdict(most <= bound, "zero_normal", "%s: up to %.4g of %g", compare_steps[i].name, most, bound);
    }
}

/* Light at right angles to all normals of the span: f stays zero, so nothing flickers at the terminator. */
static void test_grazing(test_random *r)
{
    unsigned i, k, t;
    for (i = 0; i < compare_step_count; i++) {
        double most = 0;
        for (k = 0; k < 200; k++) {
            paper_span s = paper_span_flat(test_real(r, 0, 90) * pi / 180, random_pixels(r, 1024), 0, pi / 2);
            kernel_span span = kernel_span_of(&s);
            kernel_run(&compare_steps[i], &span, f);
            for (t = 0; t <= span.pixels; t++) most = fmax(most, fabs(f[t]));
        }
        test_verdict(most <= (is(i, "map") ? 0.25 : still_bound(i, 1024)), "grazing_light", "%s: up to %.2g",
                     compare_steps[i].name, most);
    }
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    test_forms(&r);
    test_forms_finite();
    test_equations(&r);
    test_blocks(&r);
    test_printed();
    test_counts();
    test_kernel_bounds(&r, 1, 1024, false);
    test_kernel_bounds(&r, 1024, 4096, true);
    test_known_failures();
    test_still(&r);
    test_one_pixel(&r);
    test_opposite(&r);
    test_off_unit(&r);
    test_zero(&r);
    test_grazing(&r);
    return test_end();
}
