/* SPDX-License-Identifier: MIT */
/* Past the end of what a method serves: each entry point is driven over its edge and must take another method, or refuse. What is
 * expected stands first. Edges that other tests have: docs/NUMERICS.md, Where methods end. */
#include "../firmware/step.h"
#include "arc_reference.h"

#define ONE 1073741824.0

static const double right_above = LMB_ARC_U_MAX / 268435456.0; /* 1.5: 120 degrees */

/* ----------------------------------------------------------------------------------------------------------------- arcs */

/* Up to LMB_ARC_U_MAX terms turn; one unit beyond they are straight lines between the same two ends. */
static void test_arc_turn(void)
{
    const double psi = acos(1 - right_above), phase = -0.6;
    const double a = cos(phase), b = cos(phase + psi);
    double off_arc = 0, off_line = 0;
    int beyond, t;
    for (beyond = 0; beyond < 2; beyond++) {
        lmb_arc arc;
        lmb_term term;
        lmb_arc_prepare(&arc, LMB_ARC_U_MAX + beyond, 100 * LMB_ARC_PIXEL, 0);
        lmb_arc_start(&arc, &term, arc_q30(a), arc_q30(b - a));
        for (t = 0; t <= 100; t++) {
            const double f = term.f / ONE, line = a + (b - a) * t / 100;
            if (!beyond) off_arc = fmax(off_arc, fabs(f - cos(phase + psi * t / 100)));
            if (beyond) off_line = fmax(off_line, fabs(f - line));
            lmb_arc_step(&arc, &term);
        }
    }
    test_verdict(off_arc <= LMB_ARC_WIDE_MAX_ERROR && off_line <= LMB_ARC_WIDE_MAX_ERROR, "beyond_arc_turn",
                 "at 120 degrees %.2g from the arc, beyond %.2g from the line", off_arc, off_line);
}

/* No length is too short: none at all counts as the start of the arc. The longest keeps its term in range. */
static void test_arc_length(test_random *r)
{
    double off = 0, most = 0;
    int i, t;
    for (i = 0; i < 2000; i++) {
        const double psi = test_real(r, 0, 3.1), phase = test_real(r, -3.1, 3.1);
        const int32_t a = arc_q30(cos(phase)), rise = arc_q30(cos(phase + psi) - cos(phase));
        lmb_arc arc;
        lmb_term term;
        lmb_arc_prepare(&arc, arc_u_q28(psi), 0, 0);
        lmb_arc_start(&arc, &term, a, rise);
        off = fmax(off, fabs(term.f / ONE - cos(phase)));
        lmb_arc_prepare(&arc, arc_u_q28(psi), LMB_ARC_LENGTH_MAX, (uint32_t)test_integer(r, 0, LMB_ARC_PIXEL - 1));
        lmb_arc_start(&arc, &term, a, rise);
        for (t = 0; t < 65535; t += 1) {
            if (i > 20) break;
            most = fmax(most, fabs(term.f / ONE));
            lmb_arc_step(&arc, &term);
        }
    }
    test_verdict(off <= LMB_ARC_MAX_ERROR && most <= 1.0625, "beyond_arc_length",
                 "no length: %.2g from the start; 65536 pixels: |f| up to %.4f", off, most);
}

/* A curve is refused from one unit past its largest turn and its largest length on, and nothing is written. */
static void test_curve(void)
{
    lmb_curve curve = {1, 2, 3, 4, 5, 6};
    const bool served = lmb_curve_prepare(&curve, LMB_CURVE_U_MAX, LMB_CURVE_LENGTH_MAX, 0);
    lmb_curve kept = {1, 2, 3, 4, 5, 6};
    const bool turned = lmb_curve_prepare(&kept, LMB_CURVE_U_MAX + 1, LMB_ARC_PIXEL, 0);
    const bool longer = lmb_curve_prepare(&kept, 0, LMB_CURVE_LENGTH_MAX + 1, 0);
    test_verdict(served && !turned && !longer && kept.first_q16 == 1 && kept.down == 6, "beyond_curve",
                 "at its limits %d, past its turn %d, past its length %d", served, turned, longer);
}

/* ------------------------------------------------------------------------------------------------------- spans of triangles */

static lmb_look look;
static lmb_rays rays;

static void look_make(enum lmb_step_kind step, arc_vector light, uint16_t tolerance)
{
    static const lmb_material material = {{0, 0, 0}, {255, 255, 255}, {255, 255, 255}, 16};
    lmb_light lamp = {arc_round(arc_unit(light), 16384), {255, 255, 255}};
    if (lmb_look_prepare(&look, &material, &lamp, 1, LMB_MODEL_GLOSS, step)) abort();
    lmb_look_tolerance(&look, tolerance);
    lmb_rays_prepare(&rays, &look, NULL);
}

static void corner(lmb_vertex *v, double x, double y, arc_vector normal)
{
    v->x = (int32_t)lround(x * 16);
    v->y = (int32_t)lround(y * 16);
    v->depth = 0;
    v->normal = arc_round(arc_unit(normal), 16384);
}

/* A right triangle whose rows are as wide as it is, its normals turning by psi from left to right. */
static void slab(lmb_vertex v[3], double width, double height, double psi)
{
    const arc_vector left = {-sin(psi / 2), 0.1, cos(psi / 2)}, right = {sin(psi / 2), 0.1, cos(psi / 2)};
    corner(&v[0], 0, 0, left);
    corner(&v[1], 0, height, left);
    corner(&v[2], width, 0, right);
}

typedef struct kinds {
    int plane, arc;
    double worst; /* error of N.L against normals that turn evenly along the row, or run linearly beyond 120 degrees */
} kinds;

static void kinds_of(kinds *k, const lmb_vertex v[3])
{
    const lmb_window window = {0, 0, 512, 64, false};
    const arc_vector ray = arc_from(look.light[0].direction);
    lmb_triangle t;
    lmb_span span;
    if (!lmb_triangle_begin(&t, &look, &rays, &v[0], &v[1], &v[2], &window)) return;
    if (!lmb_triangle_next(&t, &span)) return;
    {
        /* the first row: both ends by the edges' own turn, half a pixel down */
        const double down = 0.5 / (v[1].y / 16.0), wide = v[2].x / 16.0 * (1 - down);
        const arc_vector a = arc_from(v[0].normal), c = arc_from(v[2].normal);
        const double psi = arc_angle(a, c);
        const arc_vector end = arc_blend(a, sin(psi * down) / sin(psi), c, sin(psi * (1 - down)) / sin(psi));
        const double turn = psi * (1 - down);
        int x;
        k->plane += span.kind == LMB_SPAN_PLANE;
        k->arc += span.kind == LMB_SPAN_ARC;
        for (x = span.x; x < span.x + span.length; x++) {
            const double at = turn * (x + 0.5) / wide;
            const double want = (sin(turn - at) * arc_inner(a, ray) + sin(at) * arc_inner(end, ray)) / sin(turn);
            k->worst = fmax(k->worst, fabs(span.diffuse[0].f / ONE - want));
            if (span.kind == LMB_SPAN_PLANE) lmb_plane_step(&span.diffuse[0]);
            if (span.kind == LMB_SPAN_ARC) lmb_arc_step(&span.arc, &span.diffuse[0]);
        }
    }
}

/* Spans of arcs run as curves up to a turn and to 64 pixels, and as arcs past either; the error does not jump. */
static void test_span_choice(void)
{
    const arc_vector light = {0.4, 0.2, 0.9};
    static const struct {
        double width, psi;
        int curve;
    } c[] = {{60, 4, 1}, {60, 40, 0}, {68, 4, 0}, {300, 4, 0}, {300, 90, 0}, {8, 10, 1}, {8, 60, 0}};
    double worst = 0;
    unsigned i;
    int wrong = 0;
    look_make(LMB_STEP_ARC, light, 0);
    for (i = 0; i < sizeof c / sizeof c[0]; i++) {
        lmb_vertex v[3];
        kinds k = {0, 0, 0};
        slab(v, c[i].width, 50, c[i].psi * ARC_PI / 180);
        kinds_of(&k, v);
        wrong += c[i].curve ? k.plane != 1 : k.arc != 1;
        worst = fmax(worst, k.worst);
    }
    test_verdict(!wrong && worst <= 2 * LMB_SPAN_DIFFUSE_MAX_ERROR, "beyond_span_choice",
                 "%d of %u spans ran as something else; N.L within %.2g throughout", wrong, i, worst);
}

/* The middle of an edge, lit from straight above it: its normal's cosine is one up to a turn of 120 degrees, and beyond twice the mean
 * of the corners', as if they were 120 degrees apart. */
static void test_quadratic_turn(void)
{
    static const arc_vector light = {0, 0, 1};
    double worst = 0, at[2] = {0, 0};
    int psi;
    look_make(LMB_STEP_QUADRATIC, light, 0);
    for (psi = 40; psi <= 170; psi += 10) {
        const lmb_window window = {0, 0, 512, 1024, false};
        lmb_vertex v[3];
        lmb_triangle t;
        lmb_span span;
        double f, mean, want;
        slab(v, 101, 1000, psi * ARC_PI / 180);
        mean = (arc_inner(arc_from(v[0].normal), light) + arc_inner(arc_from(v[2].normal), light)) / 2;
        want = mean * fmin(2, 1 / cos(arc_angle(arc_from(v[0].normal), arc_from(v[2].normal)) / 2));
        if (!lmb_triangle_begin(&t, &look, &rays, &v[0], &v[1], &v[2], &window) || !lmb_triangle_next(&t, &span)) abort();
        f = (span.diffuse[0].f + 50.0 * span.diffuse[0].d + 50 * 49 / 2.0 * span.diffuse[0].c) / ONE;
        worst = fmax(worst, fabs(f - want));
        if (psi == 120) at[0] = f;
        if (psi == 170) at[1] = f;
    }
    test_verdict(worst <= 0.003, "beyond_quadratic_turn", "within %.2g: %.3f at 120 degrees, %.3f at 170", worst, at[0], at[1]);
}

/* Draws a triangle span by span: the largest |N.L| of its pixels. Counts spans. */
static double most_drawn(const lmb_vertex v[3], int *spans)
{
    const lmb_window window = {0, 0, 64, 64, false};
    lmb_triangle t;
    lmb_span span;
    double most = 0;
    int k;
    if (!lmb_triangle_begin(&t, &look, &rays, &v[0], &v[1], &v[2], &window)) return 0;
    for (; lmb_triangle_next(&t, &span); ++*spans) {
        for (k = 0; k < span.length && span.diffuse_on; k++) {
            most = fmax(most, fabs(span.diffuse[0].f / ONE));
            if (span.kind == LMB_SPAN_PLANE) lmb_plane_step(&span.diffuse[0]);
            if (span.kind == LMB_SPAN_ARC) lmb_arc_step(&span.arc, &span.diffuse[0]);
        }
    }
    return most;
}

/* Corners' normals any angle apart, up to opposite ones: terms stay near [-1, 1] and never wrap. */
static void test_wide_turns(test_random *r)
{
    double most[2] = {0, 0}; /* by quadratics, by arcs */
    int i, k, spans = 0;
    for (i = 0; i < 20000; i++) {
        const int arcs = i >> 1 & 1;
        lmb_vertex v[3];
        for (k = 0; k < 3; k++) corner(&v[k], test_real(r, 0, 64), test_real(r, 0, 64), arc_random_unit(r));
        if (i & 1) v[1].normal = arc_round(arc_from(v[0].normal), -16384);
        look_make(arcs ? LMB_STEP_ARC : LMB_STEP_QUADRATIC, arc_random_unit(r), 0);
        most[arcs] = fmax(most[arcs], most_drawn(v, &spans));
    }
    test_verdict(spans > 100000 && most[0] <= 1.1 && most[1] <= 1.001, "beyond_wide_turns",
                 "|N.L| up to %.3f by quadratics, %.4f by arcs, normals anywhere, %d spans", most[0], most[1], spans);
}

/* The same triangle with a zero normal, or three: quadratics and arcs keep |N.L| within one and draw on. */
static void test_zero_normals(test_random *r)
{
    static const lmb_vec zero = {0, 0, 0};
    double most = 0;
    int i, k, spans = 0;
    for (i = 0; i < 4000; i++) {
        lmb_vertex v[3];
        for (k = 0; k < 3; k++) corner(&v[k], test_real(r, 0, 64), test_real(r, 0, 64), arc_random_unit(r));
        for (k = 0; k < 1 + i % 3; k++) v[k].normal = zero;
        look_make(i & 1 ? LMB_STEP_ARC : LMB_STEP_QUADRATIC, arc_random_unit(r), 0);
        most = fmax(most, most_drawn(v, &spans));
    }
    test_verdict(spans > 10000 && most <= 1.001, "beyond_zero_normals", "|N.L| up to %.3f in %d spans", most, spans);
}

/* Light and view that graze: where N.L is nearly zero all over the triangle its terms are as exact as elsewhere. */
static void test_grazing(test_random *r)
{
    double worst = 0;
    int i;
    for (i = 0; i < 3000; i++) {
        const double psi = test_real(r, 0.5, 30) * ARC_PI / 180, tilt = test_real(r, 88, 92) * ARC_PI / 180;
        const arc_vector light = {cos(tilt) * 0.1, 1, cos(tilt)};
        lmb_vertex v[3];
        kinds k = {0, 0, 0};
        slab(v, test_real(r, 4, 200), 50, psi);
        look_make(LMB_STEP_ARC, light, 0);
        kinds_of(&k, v);
        worst = fmax(worst, k.worst);
    }
    test_verdict(worst > 0 && worst <= LMB_SPAN_DIFFUSE_MAX_ERROR, "beyond_grazing", "N.L within %.2g", worst);
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    test_arc_turn();
    test_arc_length(&r);
    test_curve();
    test_span_choice();
    test_quadratic_turn();
    test_wide_turns(&r);
    test_zero_normals(&r);
    test_grazing(&r);
    return test_end();
}
