/* SPDX-License-Identifier: MIT */
/* Arcs: every bound that lambent.h promises for them, and the inputs that could break them. */
#include "../firmware/step.h"
#include "arc_reference.h"

#define RIGHT (ARC_PI / 2)
#define WIDE (119.9 * ARC_PI / 180) /* what Q2.14 normals 120 degrees apart can exceed is beyond LMB_ARC_U_MAX */

static const int exponents[] = {2, 16, 64, 100, 256, 512, 1000};
enum { DIFFUSE = -1, N_256 = 4, N_1000 = 6, EXPONENTS = 7 };

/* -------------------------------------------------------------------------------------------------------- exact set-up values */

typedef struct phase_case {
    double psi, phase;
    uint32_t length, start;
} phase_case;

static double phase_error(const phase_case *c)
{
    const double step = c->psi / c->length;
    lmb_arc arc;
    lmb_term term;
    double worst = 0;
    uint32_t x;
    lmb_arc_prepare(&arc, arc_u_q28(c->psi), c->length, c->start);
    lmb_arc_start(&arc, &term, arc_q30(cos(c->phase)), arc_q30(cos(c->phase + c->psi) - cos(c->phase)));
    for (x = c->start; x <= c->length; x += LMB_ARC_PIXEL) {
        worst = fmax(worst, fabs(term.f / 1073741824.0 - cos(c->phase + step * x)));
        lmb_arc_step(&arc, &term);
    }
    return worst;
}

/* The worst of many random cases, then of small changes to the worst. */
static phase_case worst_phase(test_random *r, double psi_max, double low_px, double high_px, int random, int climbs)
{
    phase_case best = {1, 0, LMB_ARC_PIXEL, 0}, c;
    double worst = 0, error, reach;
    int i;
    for (i = 0; i < random + climbs; i++) {
        if (i < random) {
            c.psi = i & 1 ? psi_max * test_real(r, 0.9, 1) : psi_max * pow(10, test_real(r, -5, 0));
            c.phase = test_real(r, -ARC_PI, ARC_PI);
            c.length = arc_random_length(r, low_px, high_px);
            c.start = arc_random_start(r, c.length);
        } else {
            reach = pow(10, test_real(r, -5, -1));
            c = best;
            c.psi = fmin(psi_max, c.psi * (1 + test_real(r, -reach, reach)));
            c.phase += test_real(r, -reach, reach);
            if (test_integer(r, 0, 3) == 0) {
                double length = c.length + floor(reach * test_real(r, -LMB_ARC_PIXEL, LMB_ARC_PIXEL));
                if (length >= LMB_ARC_PIXEL * low_px && length <= LMB_ARC_PIXEL * high_px) c.length = (uint32_t)length;
                c.start = arc_random_start(r, c.length);
            }
        }
        error = phase_error(&c);
        if (error > worst) {
            worst = error;
            best = c;
        }
    }
    return best;
}

static void test_phases(test_random *r, const char *name, double psi_max, double low_px, double high_px, double bound, int random)
{
    phase_case c = worst_phase(r, psi_max, low_px, high_px, random, random / 4);
    double error = phase_error(&c);
    test_verdict(error <= bound, name, "%.3g of %.3g, psi %.5f degrees, %.5f px, start %.5f, phase %.5f", error, bound,
                 c.psi * 180 / ARC_PI, arc_pixels(c.length), arc_pixels(c.start), c.phase);
}

/* The amplitude alone, which a highlight multiplies by n: the largest f of an arc that passes its peak; short ones pass it at a
 * pixel. */
static void test_amplitude(test_random *r, const char *name, double low_px, double high_px, int arcs)
{
    double worst = 0;
    int i;
    for (i = 0; i < arcs; i++) {
        double psi = RIGHT * test_real(r, 0.1, 1), peak = psi * test_real(r, 0, 1), f = 0, want = 0;
        uint32_t length = arc_random_length(r, low_px, high_px), x, start = arc_random_start(r, length);
        lmb_arc arc;
        lmb_term term;
        if (high_px < 64) peak = psi * (start + LMB_ARC_PIXEL * floor(peak / psi * (length - start) / LMB_ARC_PIXEL)) / length;
        lmb_arc_prepare(&arc, arc_u_q28(psi), length, start);
        lmb_arc_start(&arc, &term, arc_q30(cos(peak)), arc_q30(cos(psi - peak) - cos(peak)));
        for (x = start; x <= length; x += LMB_ARC_PIXEL) {
            f = fmax(f, term.f / 1073741824.0);
            want = fmax(want, cos(psi * x / length - peak));
            lmb_arc_step(&arc, &term);
        }
        if (want > 1 - 1e-4) worst = fmax(worst, fabs(f - want)); /* near the peak an error of angle counts little */
    }
    test_verdict(worst <= 1.0 / (1 << 18), name, "%.3g at the peak", worst);
}

/* ---------------------------------------------------------------------------------------------- spans between rounded normals */

static double span_error(const arc_case *c, int which)
{
    arc_errors e = {0, {0}};
    arc_measure(&e, c, exponents, which == DIFFUSE ? 0 : EXPONENTS);
    if (which == DIFFUSE) return e.f;
    if (which == N_1000) return fmax(e.power[5], e.power[6]);
    return fmax(fmax(fmax(e.power[0], e.power[1]), fmax(e.power[2], e.power[3])), e.power[4]);
}

static void test_spans(test_random *r, const char *name, double psi_max, int which, double bound, int random, int climbs)
{
    arc_case best = arc_random_case(r, psi_max, 64), c;
    double worst = 0, error;
    int i;
    for (i = 0; i < random + climbs; i++) {
        if (i < random) {
            double psi = i & 1 ? psi_max * test_real(r, 0.8, 1) : psi_max * pow(10, test_real(r, -4, 0));
            c = arc_random_case(r, psi, arc_random_length(r, 1, i & 7 ? 64 : 1024));
        } else {
            c = best;
            if (i & 1) c.ray = arc_nudge(r, c.ray);
            if (i & 2) c.from = arc_nudge(r, c.from);
            if (i & 4) c.to = arc_nudge(r, c.to);
            if (i % 16 == 0) {
                c.length = (uint32_t)(LMB_ARC_PIXEL * fmin(fmax(1, arc_pixels(c.length) * test_real(r, 0.9, 1.1)), 1024));
            }
            if (i % 16 < 2) c.start = arc_random_start(r, c.length);
            if (arc_angle(arc_from(c.from), arc_from(c.to)) > psi_max) continue;
        }
        error = span_error(&c, which);
        if (error > worst) {
            worst = error;
            best = c;
        }
    }
    test_verdict(worst <= bound, name, "%.3g of %.3g, normals (%d %d %d) (%d %d %d), ray (%d %d %d), %.5f px, start %.5f", worst,
                 bound, best.from.x, best.from.y, best.from.z, best.to.x, best.to.y, best.to.z, best.ray.x, best.ray.y,
                 best.ray.z, arc_pixels(best.length), arc_pixels(best.start));
}

/* The same with the library's lobe in the place of the exact power: what a highlight errs by in all. */
static double lobe_error(const arc_case *c, unsigned n)
{
    const arc_vector from = arc_from(c->from), to = arc_from(c->to), ray = arc_from(c->ray);
    const double psi = arc_angle(from, to), a = arc_inner(from, ray), b = arc_inner(to, ray);
    lmb_lobe lobe;
    lmb_arc arc;
    lmb_term term;
    double worst = 0;
    uint32_t x;
    if (lmb_lobe_prepare(&lobe, LMB_LOBE_TUNED, n, 0) != LMB_OK || psi < 1e-9) return 0;
    lmb_arc_between(&arc, c->from, c->to, c->length, c->start);
    lmb_arc_dot(&arc, &term, c->from, c->to, c->ray, 65536);
    for (x = c->start; x <= c->length; x += LMB_ARC_PIXEL) {
        double t = (double)x / c->length, want = (sin(psi * (1 - t)) * a + sin(psi * t) * b) / sin(psi);
        double got = lmb_lobe_eval(&lobe, lmb_sub(0x40000000, term.f)) / 32768.0;
        worst = fmax(worst, fabs(got - pow(fmin(fmax(want, 0), 1), n)));
        lmb_arc_step(&arc, &term);
    }
    return worst;
}

static void test_lobes(test_random *r)
{
    static const char *name[2] = {"span_specular_lobe", "span_gloss_lobe"};
    static const double bound[2] = {LMB_SPAN_SPECULAR_MAX_ERROR, LMB_SPAN_GLOSS_MAX_ERROR};
    int gloss, i;
    for (gloss = 0; gloss < 2; gloss++) {
        double worst = 0;
        unsigned n_worst = 0;
        for (i = 0; i < 60000; i++) {
            unsigned n = (unsigned)test_integer(r, gloss ? 257 : 1, gloss ? LMB_SHININESS_MAX : 256);
            arc_case c = arc_random_case(r, RIGHT * (i & 1 ? test_real(r, 0.8, 1) : pow(10, test_real(r, -4, 0))),
                                         arc_random_length(r, 1, i & 15 ? 16 : 1024));
            double error = lobe_error(&c, n);
            if (error > worst) n_worst = n;
            worst = fmax(worst, error);
        }
        test_verdict(worst <= bound[gloss], name[gloss], "%.3g of %.3g, n = %u", worst, bound[gloss], n_worst);
    }
}

/* ----------------------------------------------------------------------------------------------------------------- edge cases */

/* Largest |f| from the first pixel to the last, -1 if a pixel or the one after it leaves [-limit, limit]. */
static double span_peak(const arc_case *c, double limit)
{
    lmb_arc arc;
    lmb_term term;
    double peak = 0;
    uint32_t x;
    lmb_arc_between(&arc, c->from, c->to, c->length, c->start);
    lmb_arc_dot(&arc, &term, c->from, c->to, c->ray, 65536);
    for (x = c->start; x <= c->length; x += LMB_ARC_PIXEL) {
        peak = fmax(peak, fabs(term.f / 1073741824.0));
        lmb_arc_step(&arc, &term);
    }
    return peak <= limit ? peak : -1;
}

static void test_equal_normals(test_random *r)
{
    double worst = 0;
    int i;
    for (i = 0; i < 2000; i++) {
        arc_case c = arc_random_case(r, 0, arc_random_length(r, 1.0 / LMB_ARC_PIXEL, 4096));
        c.to = c.from;
        worst = fmax(worst, span_error(&c, DIFFUSE));
    }
    test_verdict(worst <= 1.0 / (1 << 17), "arc_equal_normals", "constant within %.3g, 1/65536 to 4096 px", worst);
}

/* Beyond 120 degrees: linear from end to end within a 2^17th part of a rise of up to two, so never outside what the ends are. */
static void test_opposite_normals(test_random *r)
{
    double off = 0, outside = 0;
    int i;
    for (i = 0; i < 20000; i++) {
        const double psi = i & 1 ? ARC_PI : test_real(r, 2.0951, ARC_PI);
        arc_case c = arc_random_case(r, psi, arc_random_length(r, 0.01, i & 4 ? 1024 : 5));
        lmb_arc arc;
        lmb_term term;
        double a, b;
        uint32_t x;
        if (i % 8 == 6) { /* the steepest: exactly opposite, and a pixel after the end is furthest beyond it */
            if (i & 8) c.from.x = c.from.y = 0, c.from.z = i & 16 ? 16384 : -16384; /* of exactly unit length */
            c.to = arc_round(arc_from(c.from), -16384);
            c.length = (uint32_t)test_integer(r, 1, 4) * LMB_ARC_PIXEL;
            c.start = 0;
        }
        if (i & 2) c.ray = c.to;
        a = arc_inner(arc_from(c.from), arc_from(c.ray));
        b = arc_inner(arc_from(c.to), arc_from(c.ray));
        lmb_arc_between(&arc, c.from, c.to, c.length, c.start);
        lmb_arc_dot(&arc, &term, c.from, c.to, c.ray, 65536);
        for (x = c.start; x <= c.length; x += LMB_ARC_PIXEL) {
            double f = term.f / 1073741824.0;
            outside = fmax(outside, fmax(f - fmax(a, b), fmin(a, b) - f));
            off = fmax(off, fabs(f - (a + (b - a) * x / c.length)));
            lmb_arc_step(&arc, &term);
        }
    }
    test_verdict(fmax(off, outside) <= 1.0 / (1 << 15), "arc_opposite_normals", "off the line by %.3g, outside the ends by %.3g",
                 off, outside);
}

/* Arcs of up to one pixel, to the shortest: each power of two and what is beside it, and any. */
static void test_single_pixels(test_random *r)
{
    arc_errors e = {0, {0}};
    lmb_arc arc;
    lmb_term term;
    uint32_t length, start;
    int i;
    for (i = 0; i < 6000; i++) {
        uint32_t near_power = (2u << i / 2 % 16) + (uint32_t)test_integer(r, -1, 1), kind;
        length = i & 1 ? (uint32_t)fmin(near_power, LMB_ARC_PIXEL) : arc_random_length(r, 1.0 / LMB_ARC_PIXEL, 1);
        arc_case c = arc_random_case(r, RIGHT * test_real(r, 0, 1), length);
        for (kind = 0; kind <= 5; kind++) {
            start = kind == 0 ? 0 : kind == 1 ? length : kind == 2 ? length - 1 : arc_random_start(r, length);
            c.start = start < LMB_ARC_PIXEL ? start : LMB_ARC_PIXEL - 1;
            arc_measure(&e, &c, exponents, EXPONENTS);
        }
        if (length < LMB_ARC_PIXEL) {
            c.start = (uint32_t)test_integer(r, length, LMB_ARC_PIXEL - 1); /* past the end: the end */
            lmb_arc_between(&arc, c.from, c.to, c.length, c.start);
            lmb_arc_dot(&arc, &term, c.from, c.to, c.ray, 65536);
            e.f = fmax(e.f, fabs(term.f / 1073741824.0 - arc_inner(arc_from(c.to), arc_from(c.ray))));
        }
    }
    test_verdict(e.f <= LMB_ARC_MAX_ERROR && e.power[N_1000] <= LMB_SPAN_GLOSS_MAX_ERROR, "arc_single_pixels",
                 "f %.3g, n = 1000 %.3g", e.f, e.power[N_1000]);
}

/* Lengths of vectors within 5 % of one: bounded by one and a hair; and vectors that are no normals at all: the step stays in its
 * range, which the checked twin watches. */
static void test_bad_normals(test_random *r)
{
    static const double sizes[] = {0, 0.5, 0.9, 1.1, 1.2};
    double peak = 0, wild = 0;
    int i, bad = 0;
    for (i = 0; i < 60000; i++) {
        double psi = (i & 1 ? WIDE : ARC_PI) * test_real(r, 0, 1), p, raw;
        arc_case c = arc_random_case(r, psi, arc_random_length(r, 0.01, i & 15 ? 32 : 1024));
        arc_case d = c;
        c.from = arc_round(arc_from(d.from), 16384 * test_real(r, 0.95, 1.05));
        c.to = arc_round(arc_from(d.to), 16384 * test_real(r, 0.95, 1.05));
        c.ray = arc_round(arc_from(d.ray), 16384 * test_real(r, 0.95, 1.05));
        p = span_peak(&c, 1.002);
        d.from = arc_round(arc_from(d.from), 16384 * sizes[test_integer(r, 0, 4)]);
        d.to = arc_round(arc_from(d.to), 16384 * sizes[test_integer(r, 0, 4)]);
        raw = span_peak(&d, 1.0625);
        bad += p < 0 || raw < 0;
        peak = fmax(peak, p);
        wild = fmax(wild, raw);
    }
    test_verdict(!bad, "arc_bad_normals", "|f| up to %.6f when 5 %% off, %.6f when anything from 0 to 1.2; %d out of range", peak,
                 wild, bad);
}

/* Equal vectors rounded to more than one, met head on: never above one by more than the arc's error. */
static void test_above_one(test_random *r)
{
    double above = 0;
    int i;
    for (i = 0; i < 20000; i++) {
        arc_case c = arc_random_case(r, RIGHT * pow(10, test_real(r, -4, 0)), arc_random_length(r, 1, 64));
        c.ray = i & 1 ? c.to : c.from;
        above = fmax(above, span_peak(&c, 2) - 1);
    }
    test_verdict(above <= 1.0 / (1 << 17), "arc_above_one", "f exceeds one by %.3g at most", above);
}

/* A scaled term is the term, scaled, pixel by pixel. */
static void test_scale(test_random *r)
{
    double worst = 0;
    int i;
    for (i = 0; i < 4000; i++) {
        arc_case c = arc_random_case(r, RIGHT * test_real(r, 0, 1), arc_random_length(r, 1, 256));
        uint32_t scale = (uint32_t)test_integer(r, 32768, 65535), x;
        lmb_arc arc;
        lmb_term whole, scaled;
        lmb_arc_between(&arc, c.from, c.to, c.length, c.start);
        lmb_arc_dot(&arc, &whole, c.from, c.to, c.ray, 65536);
        lmb_arc_dot(&arc, &scaled, c.from, c.to, c.ray, scale);
        for (x = c.start; x <= c.length; x += LMB_ARC_PIXEL) {
            worst = fmax(worst, fabs(scaled.f / 1073741824.0 / scale * 65536 - whole.f / 1073741824.0));
            lmb_arc_step(&arc, &whole);
            lmb_arc_step(&arc, &scaled);
        }
    }
    test_verdict(worst <= 1.0 / (1 << 17), "arc_scale", "%.3g from the unscaled term", worst);
}

/* ---------------------------------------------------------------------------------------------- the forms of paper 001 itself */

static double paper_error(int form, double psi, uint32_t pixels, double phase)
{
    const int32_t u = arc_u_q28(psi), a = arc_q30(cos(phase)), rise = arc_q30(cos(phase + psi) - cos(phase));
    lmb_plain16 p16;
    lmb_plain32 p32;
    lmb_block4 b4;
    int32_t next[4] = {0, 0, 0, 0};
    double worst = 0, got;
    uint32_t t;
    lmb_plain16_prepare(&p16, u, pixels * LMB_ARC_PIXEL, a, rise);
    lmb_plain32_prepare(&p32, u, pixels * LMB_ARC_PIXEL, a, rise);
    lmb_block4_prepare(&b4, u, pixels * LMB_ARC_PIXEL, a, rise);
    next[3] = b4.f;
    for (t = 0; t <= pixels; t++) {
        if (t % 4 == 1) lmb_block4_step(&b4, next);
        got = form == 0 ? p16.f / 16384.0 : form == 1 ? p32.f / 1073741824.0 : next[(t + 3) % 4] / 16384.0;
        worst = fmax(worst, fabs(got - cos(phase + psi * t / pixels)));
        lmb_plain16_step(&p16);
        lmb_plain32_step(&p32);
    }
    return worst;
}

/* Where they hold. The figures are twice what was measured; longer spans are in report_arc. */
static void test_papers(test_random *r)
{
    static const char *name[3] = {"arc_plain16", "arc_plain32", "arc_block4"};
    static const double bound[3] = {0.0135, 0.0025, 0.0115};
    int form, i;
    for (form = 0; form < 3; form++) {
        double worst = 0;
        for (i = 0; i < 20000; i++) {
            uint32_t pixels = (uint32_t)test_integer(r, 1, form == 1 ? 1024 : 16);
            if (form == 1 && i % 16) continue;
            worst = fmax(worst, paper_error(form, RIGHT * test_real(r, 0, 1), pixels, test_real(r, -ARC_PI, ARC_PI)));
        }
        test_verdict(worst <= bound[form], name[form], "%.3g up to 90 degrees and %d px", worst, form == 1 ? 1024 : 16);
    }
}

#ifdef LMB_CHECKED
static void test_cost(void)
{
    lmb_arc arc;
    lmb_term term;
    lmb_counts before;
    lmb_arc_prepare(&arc, 0x10000000, 100 * LMB_ARC_PIXEL, LMB_ARC_PIXEL / 2);
    lmb_arc_start(&arc, &term, 0x40000000, -0x40000000);
    before = lmb_count;
    lmb_arc_step(&arc, &term);
    test_verdict(lmb_count.multiplications - before.multiplications == 1 && lmb_count.additions - before.additions == 2,
                 "arc_cost", "one multiplication, two additions a pixel");
}
#endif

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    test_phases(&r, "arc_error", RIGHT, 1, 1024, LMB_ARC_MAX_ERROR, 40000);
    test_phases(&r, "arc_error_short", RIGHT, 1, 4, LMB_ARC_MAX_ERROR, 400000);
    test_phases(&r, "arc_error_wide", WIDE, 1, 1024, LMB_ARC_WIDE_MAX_ERROR, 40000);
    test_phases(&r, "arc_error_long", WIDE, 1024, 4096, LMB_ARC_WIDE_MAX_ERROR, 3000);
    test_amplitude(&r, "arc_amplitude", 2, 1024, 4000);
    test_amplitude(&r, "arc_amplitude_steep", 2, 12, 40000);
    test_spans(&r, "span_diffuse", RIGHT, DIFFUSE, LMB_SPAN_DIFFUSE_MAX_ERROR, 60000, 40000);
    test_spans(&r, "span_specular", RIGHT, N_256, LMB_SPAN_SPECULAR_MAX_ERROR, 60000, 40000);
    test_spans(&r, "span_gloss", RIGHT, N_1000, LMB_SPAN_GLOSS_MAX_ERROR, 60000, 60000);
    test_spans(&r, "span_diffuse_wide", WIDE, DIFFUSE, 2 * LMB_SPAN_DIFFUSE_MAX_ERROR, 30000, 10000);
    test_spans(&r, "span_specular_wide", WIDE, N_256, 2 * LMB_SPAN_SPECULAR_MAX_ERROR, 30000, 20000);
    test_spans(&r, "span_gloss_wide", WIDE, N_1000, 2 * LMB_SPAN_GLOSS_MAX_ERROR, 30000, 40000);
    test_lobes(&r);
    test_equal_normals(&r);
    test_opposite_normals(&r);
    test_single_pixels(&r);
    test_bad_normals(&r);
    test_above_one(&r);
    test_scale(&r);
    test_papers(&r);
#ifdef LMB_CHECKED
    test_cost();
#endif
    return test_end();
}
