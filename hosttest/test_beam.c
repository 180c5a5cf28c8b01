/* SPDX-License-Identifier: MIT */
/* Spans from ends and beams: arcs and the curves that stand for them, each to the bound that lambent.h promises. */
#include "../firmware/step.h"
#include "arc_reference.h"

#define RIGHT (ARC_PI / 2)

enum way { ARC, ARC_ROUGH, CURVE, CURVE_ROUGH };

/* The largest error over a span of cos^n, n = 0: of the term itself, as beams give it. */
static double way_error(const arc_case *c, enum way way, uint32_t scale, unsigned n)
{
    const arc_vector from = arc_from(c->from), to = arc_from(c->to), ray = arc_from(c->ray);
    const double psi = arc_angle(from, to), a = arc_inner(from, ray), b = arc_inner(to, ray);
    lmb_ends ends;
    lmb_beam beam;
    lmb_arc arc;
    lmb_curve curve;
    lmb_term term;
    double worst = 0;
    uint32_t x;
    int32_t u;
    lmb_end_prepare(&ends.from, c->from);
    lmb_end_prepare(&ends.to, c->to);
    lmb_beam_prepare(&beam, c->ray, scale);
    u = lmb_ends_u_q28(&ends);
    if (way >= CURVE) {
        if (!lmb_curve_prepare(&curve, u, c->length, c->start)) return INFINITY; /* refused */
        if (way == CURVE) lmb_curve_beam(&curve, &term, &ends, &beam);
        if (way == CURVE_ROUGH) lmb_curve_beam_rough(&curve, &term, &ends, &beam);
    } else {
        lmb_arc_prepare(&arc, u, c->length, c->start);
        if (way == ARC) lmb_arc_beam(&arc, &term, &ends, &beam);
        if (way == ARC_ROUGH) lmb_arc_beam_rough(&arc, &term, &ends, &beam);
    }
    for (x = c->start; x <= c->length; x += LMB_ARC_PIXEL) {
        double t = (double)x / c->length, want = psi < 1e-12 ? a : (sin(psi * (1 - t)) * a + sin(psi * t) * b) / sin(psi), got;
        if (n == 0) {
            got = term.f / 16384.0 / scale;
        } else {
            got = pow(fmin(fmax(1 + ((double)term.f - beam.peak_q30) / 16384 / scale, 0), 1), n);
            want = pow(fmin(fmax(want, 0), 1), n);
        }
        worst = fmax(worst, fabs(got - want));
        if (way >= CURVE) lmb_plane_step(&term);
        if (way < CURVE) lmb_arc_step(&arc, &term);
    }
    return worst;
}

/* Random cases, then small changes to the worst; angles up to psi_max, or up to where curves are good enough for n. */
static void test_way(test_random *r, const char *name, enum way way, unsigned n_min, unsigned n_max, double bound)
{
    arc_case best = arc_random_case(r, 0.1, LMB_ARC_PIXEL), c;
    unsigned n = n_min, n_worst = n_min;
    double worst = 0, error;
    int i;
    for (i = 0; i < 100000; i++) {
        double u_max, psi_max = RIGHT;
        if (i < 60000) n = (unsigned)lround(n_min * pow(fmax(n_max, 1) / fmax(n_min, 1), test_real(r, 0, 1)));
        if (i >= 60000) n = n_worst;
        u_max = (way == CURVE_ROUGH ? LMB_CURVE_U_MAX : lmb_curve_limit_q28(n)) / 268435456.0;
        if (way >= CURVE) psi_max = 2 * asin(sqrt(u_max / 2)) * (1 - 1e-4);
        if (i < 60000) {
            double psi = i & 1 ? psi_max * test_real(r, 0.8, 1) : psi_max * pow(10, test_real(r, -4, 0));
            c = arc_random_case(r, psi, arc_random_length(r, way >= CURVE ? 0.001 : 1, way >= CURVE || i & 7 ? 64 : 1024));
        } else {
            c = best;
            if (i & 1) c.ray = arc_nudge(r, c.ray);
            if (i & 2) c.from = arc_nudge(r, c.from);
            if (i & 4) c.to = arc_nudge(r, c.to);
            if (i % 16 < 2) c.start = arc_random_start(r, c.length);
        }
        if (arc_angle(arc_from(c.from), arc_from(c.to)) > psi_max) continue; /* by rounding, or by climbing */
        error = way_error(&c, way, i & 1 ? 65536 : (uint32_t)test_integer(r, 32768, 65535), n);
        if (error > worst) {
            worst = error;
            n_worst = n;
            best = c;
        }
    }
    test_verdict(worst <= bound, name, "%.3g of %.3g, n = %u, normals (%d %d %d) (%d %d %d), ray (%d %d %d), %.5f px, start %.5f",
                 worst, bound, n_worst, best.from.x, best.from.y, best.from.z, best.to.x, best.to.y, best.to.z, best.ray.x,
                 best.ray.y, best.ray.z, arc_pixels(best.length), arc_pixels(best.start));
}

/* What ends and beams say of themselves: u to 2^-25, and nothing below zero; the peak to 2^-23 of what the rounded beam really
 * gives along the ray, and that to 2^-15 of scale. Vectors that are no units count as what lmb_normalise makes of them. */
static void test_ends(test_random *r)
{
    double u_worst = 0, peak_worst = 0, rounding = 0;
    int i, bad = 0;
    for (i = 0; i < 40000; i++) {
        const arc_vector a = arc_random_unit(r), side = arc_random_unit(r);
        const double reach = i & 3 ? pow(10, test_real(r, -5, 1)) : 0, size = i & 4 ? test_real(r, 0.3, 0.9) : 1;
        const uint32_t scale = i & 8 ? (uint32_t)test_integer(r, 0, 65536) : 65536;
        lmb_vec from = arc_round(a, 16384 * size), to = arc_round(arc_unit(arc_blend(a, 1, side, reach)), 16384);
        lmb_ends ends;
        lmb_beam beam;
        arc_vector f, t, b;
        double half;
        int32_t u;
        lmb_end_prepare(&ends.from, from);
        lmb_end_prepare(&ends.to, to);
        lmb_beam_prepare(&beam, from, scale);
        if (i & 4) from = lmb_normalise(from.x, from.y, from.z);
        f = arc_from(from), t = arc_from(to);
        half = sin(arc_angle(f, t) / 2);
        u = lmb_ends_u_q28(&ends);
        bad += u < 0 || ends.from.excess_q28 != lmb_excess_q28(from);
        u_worst = fmax(u_worst, fabs(u / 268435456.0 - 2 * half * half));
        b.x = beam.x_q16, b.y = beam.y_q16, b.z = beam.z_q16;
        peak_worst = fmax(peak_worst, fabs(beam.peak_q30 / 1073741824.0 - arc_inner(b, f) / 65536));
        rounding = fmax(rounding, fabs(beam.peak_q30 / 1073741824.0 - scale / 65536.0));
    }
    test_verdict(!bad && u_worst <= ldexp(1, -25) && peak_worst <= ldexp(1, -23) && rounding <= ldexp(1, -15), "arc_ends",
                 "u within %.3g, peak within %.3g and %.3g of scale, %d bad", u_worst, peak_worst, rounding, bad);
}

/* Zero and wild vectors: all ends are units; and on the arc from any to any other terms stay between one and minus one, rough
 * ones as well. */
static void test_wild_ends(test_random *r)
{
    double beyond = 0, apart = 0;
    int i, k, bad = 0;
    for (i = 0; i < 40000; i++) {
        const uint32_t length = arc_random_length(r, 0.01, i & 15 ? 8 : 256), start = arc_random_start(r, length);
        lmb_vec v[3];
        lmb_ends ends;
        lmb_beam beam;
        lmb_arc arc;
        lmb_term exact, rough;
        uint32_t x;
        for (k = 0; k < 3; k++) {
            const arc_vector a = arc_random_unit(r);
            v[k] = arc_round(a, i & 1 ? 16384 : test_real(r, 0, 20000));
            if (i % 16 == 2 && k) v[k] = arc_round(arc_from(v[0]), i & 16 ? 16384 : -16384);
        }
        lmb_end_prepare(&ends.from, v[0]);
        lmb_end_prepare(&ends.to, v[1]);
        lmb_beam_prepare(&beam, v[2], 65536);
        bad += fabs(sqrt((double)ends.to.x * ends.to.x + (double)ends.to.y * ends.to.y + (double)ends.to.z * ends.to.z) / 16384 -
                    1) > 1.0 / 4000;
        lmb_arc_prepare(&arc, lmb_ends_u_q28(&ends), length, start);
        lmb_arc_beam(&arc, &exact, &ends, &beam);
        lmb_arc_beam_rough(&arc, &rough, &ends, &beam);
        for (x = start; x <= length; x += LMB_ARC_PIXEL) {
            beyond = fmax(beyond, fabs(exact.f / 1073741824.0) - 1);
            apart = fmax(apart, fabs(exact.f / 1073741824.0 - rough.f / 1073741824.0));
            lmb_arc_step(&arc, &exact);
            lmb_arc_step(&arc, &rough);
        }
    }
    test_verdict(!bad && beyond <= ldexp(1, -15) && apart <= LMB_SPAN_DIFFUSE_MAX_ERROR, "arc_wild_ends",
                 "%d ends are no units; terms up to 1 + %.3g, rough ones %.3g from exact ones", bad, beyond, apart);
}

/* From values instead of vectors, on arcs and curves: the error of a term of amplitude one. */
static void test_starts(test_random *r)
{
    double rough = 0, curve_worst = 0;
    int i;
    for (i = 0; i < 40000; i++) {
        const bool curved = i & 1;
        const double most = curved ? 0.17 : RIGHT, psi = most * (i & 2 ? 1 : pow(10, test_real(r, -4, 0)));
        const double phase = test_real(r, -ARC_PI, ARC_PI), step = psi * LMB_ARC_PIXEL;
        const uint32_t length = arc_random_length(r, curved ? 0.01 : 1, curved ? 64 : 1024), start = arc_random_start(r, length);
        const int32_t a = arc_q30(cos(phase)), rise = arc_q30(cos(phase + psi) - cos(phase));
        lmb_curve curve;
        lmb_arc arc;
        lmb_term term;
        uint32_t x;
        if (curved) {
            if (!lmb_curve_prepare(&curve, arc_u_q28(psi), length, start)) abort();
            lmb_curve_start(&curve, &term, a, rise);
        } else {
            lmb_arc_prepare(&arc, arc_u_q28(psi), length, start);
            lmb_arc_start_rough(&arc, &term, a, rise);
        }
        for (x = start; x <= length; x += LMB_ARC_PIXEL) {
            double error = fabs(term.f / 1073741824.0 - cos(phase + step / length * x / LMB_ARC_PIXEL));
            if (curved) curve_worst = fmax(curve_worst, error);
            if (!curved) rough = fmax(rough, error);
            if (curved) lmb_plane_step(&term);
            if (!curved) lmb_arc_step(&arc, &term);
        }
    }
    test_verdict(rough <= LMB_SPAN_DIFFUSE_MAX_ERROR / 2, "arc_start_rough", "%.3g", rough);
    test_verdict(curve_worst <= LMB_SPAN_DIFFUSE_MAX_ERROR / 4, "curve_start", "%.3g up to %.3g degrees", curve_worst,
                 0.17 * 180 / ARC_PI);
}

/* Limits fall as n grows, and never pass what lmb_curve_prepare takes. */
static void test_limits(void)
{
    unsigned n;
    int bad = 0;
    for (n = 1; n <= LMB_SHININESS_MAX; n++) {
        const int32_t limit = lmb_curve_limit_q28(n);
        bad += limit <= 0 || limit > LMB_CURVE_U_MAX || (n > 1 && limit > lmb_curve_limit_q28(n - 1));
    }
    test_verdict(!bad, "curve_limits", "%d of %d exponents", bad, LMB_SHININESS_MAX);
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    test_ends(&r);
    test_wild_ends(&r);
    test_way(&r, "beam_diffuse", ARC, 0, 0, LMB_SPAN_DIFFUSE_MAX_ERROR);
    test_way(&r, "beam_specular", ARC, 2, 256, LMB_SPAN_SPECULAR_MAX_ERROR);
    test_way(&r, "beam_gloss", ARC, 257, 1000, LMB_SPAN_GLOSS_MAX_ERROR);
    test_way(&r, "beam_rough_diffuse", ARC_ROUGH, 0, 0, LMB_SPAN_DIFFUSE_MAX_ERROR);
    test_way(&r, "curve_diffuse", CURVE, 0, 0, LMB_SPAN_DIFFUSE_MAX_ERROR);
    test_way(&r, "curve_specular", CURVE, 2, 256, LMB_SPAN_SPECULAR_MAX_ERROR);
    test_way(&r, "curve_gloss", CURVE, 257, 1000, LMB_SPAN_GLOSS_MAX_ERROR);
    test_way(&r, "curve_rough_diffuse", CURVE_ROUGH, 0, 0, LMB_CURVE_ROUGH_MAX_ERROR);
    test_way(&r, "curve_rough_gloss", CURVE_ROUGH, 2, LMB_CURVE_ROUGH_SHININESS, LMB_CURVE_ROUGH_MAX_ERROR);
    test_limits();
    test_starts(&r);
    return test_end();
}
