/* SPDX-License-Identifier: MIT */
/* The planner: what LMB_STEP_PLANNED makes of a triangle against normals that turn evenly along edges and rows, and the exact power, in
 * double. It may differ by the tolerance, which is twice the look's, and by what the arithmetic of arcs and lobes is allowed
 * (lambent.h); never by more.
 *
 *   test_plan [seed [triangles]]     100000 unless said
 */
#include "../firmware/step.h"
#include "arc_reference.h"

#include <string.h>

#define PX 16
#define SIDE 96
#define ONE 1073741824.0
#define LIGHTS 3
#define JUDGED 24 /* pixels of a triangle, at most about */

typedef struct plan_case {
    lmb_vertex v[3];
    lmb_vec light[LIGHTS];
    unsigned lights;
    uint16_t shininess, tolerance;
    uint8_t diffuse, specular;
} plan_case;

/* What is known of a case, prepared for library and reference. */
typedef struct setting {
    lmb_look look;
    lmb_rays rays;
    arc_vector normal[3], lamp[LIGHTS], half[LIGHTS];
    double kd, ks;
} setting;

typedef struct found {
    double share; /* the largest error over what is allowed */
    double error, allowed;
} found;

static void prepare(setting *s, const plan_case *c)
{
    const lmb_material material = {{0, 0, 0}, {c->diffuse, 0, 0}, {c->specular, 0, 0}, c->shininess};
    lmb_light light[LIGHTS];
    unsigned i;
    for (i = 0; i < c->lights; i++) {
        light[i].direction = c->light[i];
        light[i].colour.r = light[i].colour.g = light[i].colour.b = 255;
    }
    if (lmb_look_prepare(&s->look, &material, light, c->lights, LMB_MODEL_GLOSS, LMB_STEP_PLANNED)) abort();
    lmb_look_tolerance(&s->look, c->tolerance);
    lmb_rays_prepare(&s->rays, &s->look, NULL);
    s->kd = c->diffuse / 255.0;
    s->ks = c->specular / 255.0;
    for (i = 0; i < 3; i++) s->normal[i] = arc_from(c->v[i].normal);
    for (i = 0; i < c->lights; i++) {
        s->lamp[i] = arc_from(s->look.light[i].direction);
        s->half[i] = arc_from(s->look.light[i].half);
    }
}

/* Twice the look's tolerance, and the arithmetic of each light. */
static double allowed_error(const setting *s, const plan_case *c)
{
    const double span = c->shininess > 256 ? LMB_SPAN_GLOSS_MAX_ERROR : LMB_SPAN_SPECULAR_MAX_ERROR;
    return 2 * c->tolerance / 65536.0 + c->lights * (s->kd * LMB_SPAN_DIFFUSE_MAX_ERROR + s->ks * (span + LMB_LOBE_MAX_ERROR));
}

/* ----------------------------------------------------------------------------------------------------------------- the reference */

static arc_vector slerp(arc_vector a, arc_vector b, double t)
{
    const double psi = arc_angle(a, b), s = sin(psi);
    if (psi < 1e-9) return a;
    return arc_blend(a, sin(psi * (1 - t)) / s, b, sin(psi * t) / s);
}

/* The normal at a pixel's centre; false where its row meets a corner. */
static bool normal_at(arc_vector *out, const plan_case *c, const setting *s, int px, int py)
{
    const double x = PX * px + 8, y = PX * py + 8;
    arc_vector end[2];
    double at[2];
    int i, ends = 0;
    for (i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const lmb_vertex *a = &c->v[i], *b = &c->v[j];
        double t;
        if ((a->y <= y) == (b->y <= y) || ends == 2) continue;
        t = (y - a->y) / (b->y - a->y);
        at[ends] = a->x + t * (b->x - a->x);
        end[ends++] = slerp(s->normal[i], s->normal[j], t);
    }
    if (ends < 2 || fabs(at[1] - at[0]) < 1e-6) return false;
    *out = slerp(end[0], end[1], (x - at[0]) / (at[1] - at[0]));
    return true;
}

static double reference_at(const plan_case *c, const setting *s, arc_vector n)
{
    double sum = 0;
    unsigned i;
    for (i = 0; i < c->lights; i++) {
        sum += s->kd * fmax(arc_inner(n, s->lamp[i]), 0);
        sum += s->ks * pow(fmin(fmax(arc_inner(n, s->half[i]), 0), 1), c->shininess);
    }
    return sum;
}

/* ------------------------------------------------------------------------------------------------------------------- the library */

static double lobe_of(const lmb_look *look, const lmb_span *span, unsigned i)
{
    double s = span->specular[i].f + (span->kind == LMB_SPAN_ARC ? (double)span->specular[i].c : 0);
    s = floor(ldexp(s, span->exponent[i] - 14));
    return s <= 0 ? 0 : lmb_lobe_at(&look->lobe, (int32_t)fmin(s, 1e9) + look->light[i].dark_q16) / 32768.0;
}

static double library_at(const setting *s, const lmb_span *span, unsigned lights)
{
    double sum = 0;
    unsigned i;
    for (i = 0; i < lights; i++) {
        if (lmb_bit(span->diffuse_on, i)) sum += s->kd * fmin(fmax(span->diffuse[i].f / ONE, 0), 1);
        if (lmb_bit(span->specular_on, i)) sum += s->ks * lobe_of(&s->look, span, i);
    }
    return sum;
}

static void span_step(lmb_span *span, unsigned lights)
{
    unsigned i;
    for (i = 0; i < 2 * lights; i++) {
        lmb_term *term = i & 1 ? &span->specular[i / 2] : &span->diffuse[i / 2];
        if (!lmb_bit(i & 1 ? span->specular_on : span->diffuse_on, i / 2)) continue;
        if (span->kind == LMB_SPAN_PLANE) lmb_plane_step(term);
        if (span->kind == LMB_SPAN_ARC) lmb_arc_step(&span->arc, term);
    }
}

/* Normals more than 100 degrees apart: at 120 arcs end (LMB_ARC_U_MAX), and close to that what is between edges may be farther apart. */
static bool is_beyond(const setting *s)
{
    const arc_vector *n = s->normal;
    return fmin(fmin(arc_inner(n[0], n[1]), arc_inner(n[1], n[2])), arc_inner(n[2], n[0])) < -0.1736;
}

/* Judges some pixels of a triangle. */
static found measure(const plan_case *c, lmb_statistics *statistics)
{
    const lmb_window window = {0, 0, SIDE, SIDE, false};
    found worst = {0, 0, 0};
    setting s;
    lmb_triangle t;
    lmb_span span;
    const double area = fabs((double)(c->v[1].x - c->v[0].x) * (c->v[2].y - c->v[0].y) -
                             (double)(c->v[2].x - c->v[0].x) * (c->v[1].y - c->v[0].y)) /
                        (2.0 * PX * PX);
    const int every = (int)(area / JUDGED) + 1;
    int turn = 0, x;
    prepare(&s, c);
    if (is_beyond(&s)) return worst;
    worst.allowed = allowed_error(&s, c);
    if (!lmb_triangle_begin(&t, &s.look, &s.rays, &c->v[0], &c->v[1], &c->v[2], &window)) return worst;
    if (statistics) lmb_statistics_add(statistics, &t);
    while (lmb_triangle_next(&t, &span)) {
        for (x = span.x; x < span.x + span.length; x++) {
            arc_vector n;
            if (turn-- == 0) {
                turn = every - 1;
                if (normal_at(&n, c, &s, x, span.y))
                    worst.error = fmax(worst.error, fabs(library_at(&s, &span, c->lights) - reference_at(c, &s, n)));
            }
            span_step(&span, c->lights);
        }
    }
    worst.share = worst.error / worst.allowed;
    return worst;
}

/* ------------------------------------------------------------------------------------------------------------------------- cases */

static lmb_vec light_of_half(arc_vector half)
{
    const arc_vector viewer = {0, 0, 1};
    return arc_round(arc_unit(arc_blend(half, 2 * half.z, viewer, -1)), 16384);
}

static bool is_behind(const plan_case *c)
{
    const lmb_vertex *a = &c->v[0], *b = &c->v[1], *d = &c->v[2];
    return (b->x - a->x) * (d->y - a->y) >= (d->x - a->x) * (b->y - a->y);
}

/* Corners anywhere in a square, normals up to some angle apart; most half vectors among the normals. Two of three tolerances are those
 * of the formats. */
static plan_case random_case(test_random *r, double degrees)
{
    static const int sides[] = {3, 8, 16, 32, SIDE};
    const arc_vector axis = arc_random_unit(r);
    const int side = sides[test_integer(r, 0, 4)] * PX;
    const int left = (int)test_integer(r, 0, SIDE * PX - side), top = (int)test_integer(r, 0, SIDE * PX - side);
    const double flat = test_integer(r, 0, 7) ? 0.3 : 0;
    arc_vector w = {0, 0, 0};
    plan_case c;
    unsigned i;
    memset(&c, 0, sizeof c);
    for (i = 0; i < 3; i++) {
        arc_vector s = arc_random_unit(r), n;
        s = arc_unit(arc_blend(s, 1, axis, -arc_inner(s, axis)));
        n = arc_unit(arc_blend(axis, 1, s, tan(degrees / 2 * ARC_PI / 180 * test_real(r, flat, 1))));
        c.v[i].x = left + (int32_t)test_integer(r, 0, side);
        c.v[i].y = top + (int32_t)test_integer(r, 0, side);
        c.v[i].normal = arc_round(n, 16384);
        w = arc_blend(w, 1, n, test_real(r, -0.2, 1));
    }
    if (is_behind(&c)) {
        const lmb_vertex v = c.v[1];
        c.v[1] = c.v[2];
        c.v[2] = v;
    }
    c.lights = test_integer(r, 0, 3) ? 1 : (unsigned)test_integer(r, 1, LIGHTS);
    for (i = 0; i < c.lights; i++) c.light[i] = light_of_half(test_integer(r, 0, 3) ? arc_unit(w) : arc_random_unit(r));
    c.shininess = (uint16_t)exp(test_real(r, 0, log(1000.9)));
    c.tolerance = (uint16_t)exp(test_real(r, log(16), log(2048)));
    if (test_integer(r, 0, 2)) c.tolerance = test_integer(r, 0, 1) ? LMB_TOLERANCE_RGB888 : LMB_TOLERANCE_RGB565;
    c.diffuse = (uint8_t)test_integer(r, 0, 255);
    c.specular = (uint8_t)test_integer(r, 0, 255);
    return c;
}

static plan_case nudge_case(test_random *r, plan_case c)
{
    const int k = (int)test_integer(r, 0, 2);
    const int reach = test_integer(r, 0, 1) ? 16 : SIDE * PX;
    switch (test_integer(r, 0, 5)) {
    case 0:
    case 1:
        c.v[k].normal = arc_nudge(r, c.v[k].normal);
        break;
    case 2:
        c.light[test_integer(r, 0, c.lights - 1)] = arc_nudge(r, c.light[0]);
        break;
    case 3:
        c.v[k].x = (int32_t)fmin(fmax(c.v[k].x + (double)test_integer(r, -reach, reach), 0), SIDE * PX);
        break;
    case 4:
        c.v[k].y = (int32_t)fmin(fmax(c.v[k].y + (double)test_integer(r, -reach, reach), 0), SIDE * PX);
        break;
    default:
        c.shininess = (uint16_t)fmin(fmax(c.shininess * test_real(r, 0.8, 1.25), 1), 1000);
    }
    return c;
}

/* As a line of regressions[]. */
static void print_case(const plan_case *c)
{
    unsigned i;
    printf("  {{");
    for (i = 0; i < 3; i++)
        printf("{%d, %d, {%d, %d, %d}, 0}%s", (int)c->v[i].x, (int)c->v[i].y, c->v[i].normal.x, c->v[i].normal.y,
               c->v[i].normal.z, i < 2 ? ", " : "}, {");
    for (i = 0; i < c->lights; i++)
        printf("{%d, %d, %d}%s", c->light[i].x, c->light[i].y, c->light[i].z, i + 1 < c->lights ? ", " : "}");
    printf(", %u, %u, %u, %u, %u}\n", c->lights, c->shininess, c->tolerance, c->diffuse, c->specular);
}

/* ------------------------------------------------------------------------------------------------------------- what is drawn */

static void count_ways(char *out, size_t size, const lmb_statistics *s)
{
    const uint32_t *d = s->diffuse, *g = s->specular;
    snprintf(out, size, "N.L %u off, %u constant, %u linear, %u quadratic; highlights %u, %u, %u, %u; arcs %u", d[0], d[1], d[2],
             d[3], g[0], g[1], g[2], g[3], d[LMB_WAY_ARC]);
}

static void test_drawn(test_random *r, double degrees, int triangles)
{
    plan_case best = random_case(r, degrees);
    found worst = measure(&best, NULL);
    lmb_statistics statistics;
    char ways[160];
    int i;
    memset(&statistics, 0, sizeof statistics);
    for (i = 0; i < triangles; i++) {
        const plan_case c = i % 4 ? random_case(r, degrees) : nudge_case(r, best);
        const found f = measure(&c, &statistics);
        if (f.share > worst.share) worst = f, best = c;
    }
    if (worst.share > 1) print_case(&best);
    count_ways(ways, sizeof ways, &statistics);
    test_verdict(worst.share <= 1, "plan_drawn", "normals up to %.1f degrees apart: error %.5f of %.5f allowed; %s", degrees,
                 worst.error, worst.allowed, ways);
}

/* Worst cases that searches have come upon while bounds were sought. */
static const plan_case regressions[] = {
    /* slivers, whose planes take no curve */
    {{{1435, 512, {-9016, -4781, 12817}, 0}, {1283, 502, {-8357, -5107, 13135}, 0}, {7, 424, {-9032, -4466, 12919}, 0}},
     {{-4508, 15563, -2391}},
     1,
     73,
     16,
     214,
     56},
    {{{116, 144, {-5845, 1485, 15234}, 0}, {763, 160, {-5431, 1179, 15413}, 0}, {1374, 174, {-6353, 1050, 15066}, 0}},
     {{-10867, 2530, 11997}},
     1,
     935,
     16,
     148,
     145},
    /* the end of a highlight, where N.L errs as well */
    {{{184, 839, {-6103, -10936, 10563}, 0}, {10, 0, {-6536, -4630, 14292}, 0}, {153, 1534, {130, -8332, 14106}, 0}},
     {{-3895, -4648, 15220}},
     1,
     29,
     1575,
     149,
     139},
    {{{1424, 106, {3121, -15754, 3240}, 0}, {644, 414, {590, -14746, -7116}, 0}, {1536, 1536, {-7193, -14717, 317}, 0}},
     {{-2754, -15441, -4735}},
     1,
     7,
     572,
     26,
     19},
    {{{362, 240, {-11032, 6681, 10104}, 0}, {38, 1186, {-9412, 11540, 6832}, 0}, {1449, 1407, {-6013, 9869, 11613}, 0}},
     {{-11775, 11110, 2517}},
     1,
     99,
     1632,
     220,
     129},
    {{{1097, 138, {8887, 10423, 8989}, 0}, {736, 991, {9989, 12707, 2677}, 0}, {1536, 904, {13626, 7591, 5014}, 0}},
     {{11151, 11834, 2007}},
     1,
     23,
     1559,
     187,
     111},
    {{{872, 287, {-15072, -4697, 4381}, 0}, {668, 1215, {-12923, -8039, 6065}, 0}, {1294, 1527, {-13393, -4405, 8345}, 0}},
     {{-14871, -6531, 2149}},
     1,
     25,
     260,
     79,
     17},
    /* a faint highlight, linear beside a quadratic */
    {{{999, 1134, {5198, 12243, 9566}, 0}, {1177, 542, {-768, -133, 16365}, 0}, {600, 0, {13076, -904, 9830}, 0}},
     {{13829, 7915, 3812}},
     1,
     2,
     786,
     151,
     4},
    {{{852, 1127, {4882, 12277, 9688}, 0}, {1536, 538, {-806, -73, 16364}, 0}, {416, 11, {12945, -537, 10028}, 0}},
     {{13607, 8208, 3987}},
     1,
     2,
     786,
     151,
     4},
};

static void test_regressions(void)
{
    found worst = {0, 0, 1};
    unsigned i;
    for (i = 0; i < sizeof regressions / sizeof regressions[0]; i++) {
        const found f = measure(&regressions[i], NULL);
        if (f.share >= worst.share) worst = f;
    }
    test_verdict(worst.share <= 1, "plan_regressions", "%u cases: error %.5f of %.5f allowed", i, worst.error, worst.allowed);
}

/* ------------------------------------------------------------------------------------------------------------------- the rules */

/* The largest p up to 77 degrees at which a bound is within e: strengths times A sqrt(n) p^(3/2) + B n p^2. */
static double bend_within(double a, double b, double e)
{
    double low = 0, high = 0.2773;
    int i;
    for (i = 0; i < 60; i++) {
        const double p = (low + high) / 2;
        if (a * pow(p, 1.5) + b * p * p <= e) low = p;
        if (a * pow(p, 1.5) + b * p * p > e) high = p;
    }
    return low;
}

typedef struct limits {
    double straight, gloss_straight, curved, gloss_curved;
    bool close; /* two bends that the rules compare are nearly the same */
} limits;

/* What docs/NUMERICS.md, Plans, has, in double, of a look with lobes and one light or several; as it says, exact. */
static limits limits_of(const setting *s, const plan_case *c)
{
    const double n = c->shininess, kd = s->kd, ks = s->ks;
    const double e = floor(c->tolerance / (c->lights == 1 ? 1.0 : c->lights == 2 ? 2 : 4)) / 65536, h = e / fmax(ks, 1e-9);
    const double a = n < 2 ? 0.372 : n < 4 ? 0.264 : n < 16 ? 0.242 : 0.228, b = n < 2 ? 0.22 : n <= 16 ? 0.51 : 0.595;
    const double rho = h >= 1 ? 0 : n < 4 || h > 0.1526 ? 1 : 6 * h + 0.04;
    const double lobe = s->look.lobe.error_uq16 > 69 ? s->look.lobe.error_uq16 / 65536.0 * ks : 0;
    const double left = fmax(e - lobe, 0), gloss = e * (1 - rho / 2), straight = fmax(left - rho * gloss, 0);
    const double ad = kd * 0.372, bd = kd * 0.22, ag = ks * a * sqrt(n), bg = ks * b * n;
    const double alone = bend_within(ag, bg, gloss);
    const double together = fmin(bend_within(ad + ag, bd + bg, left + e), bend_within(ad + rho * ag, bd + rho * bg, left));
    limits to;
    to.straight = 0.6875 * fmin(straight / fmax(kd, 1e-9), 1);
    to.gloss_straight = fmin(0.6875 * fmin(gloss / fmax(ks, 1e-9), 1) / n, bend_within(ad, bd, straight));
    to.curved = bend_within(ad, bd, left);
    to.close = fabs(together / fmax(to.straight, 1e-9) - 1) < 0.05;
    to.gloss_curved = together > to.straight ? together : fmin(together, alone);
    if (together > to.straight) to.straight = fmin(to.straight, alone);
    return to;
}

/* got is never above want by more than rounding. */
static void limit_judge(double *above, int32_t got_q28, double want)
{
    const double got = got_q28 / 268435456.0;
    *above = fmax(*above, (got - want) / (want + 2e-6));
}

static void test_limits(test_random *r)
{
    double above = 0;
    int i, k, judged = 0;
    for (i = 0; i < 60000; i++) {
        const plan_case c = random_case(r, 10);
        const struct lmb_look_light *light;
        setting s;
        limits want;
        prepare(&s, &c);
        if (c.tolerance < 400 || s.look.lobe.error_uq16 > 69)
            continue; /* smaller ones are rounded more, as parts of themselves */
        want = limits_of(&s, &c);
        if (want.close) continue;
        judged++;
        for (k = 0; k < (int)c.lights; k++) {
            light = &s.look.light[k];
            limit_judge(&above, light->straight_q28, want.straight);
            limit_judge(&above, light->plan.gloss_straight_q28, want.gloss_straight);
            limit_judge(&above, light->plan.curved_q28, want.curved);
            limit_judge(&above, light->plan.gloss_curved_q28, want.gloss_curved);
        }
    }
    test_verdict(above < 0.03 && judged > 1000, "plan_limits", "%d looks: bends up to %.2f %% above those of the rules", judged,
                 100 * above);
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    const int triangles = argc > 2 ? atoi(argv[2]) : 100000;
    double degrees;
    test_limits(&r);
    test_regressions();
    for (degrees = 0.1; degrees < 180; degrees *= 1.9) test_drawn(&r, degrees, triangles / 12);
    return test_end();
}
