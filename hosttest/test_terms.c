/* SPDX-License-Identifier: MIT */
/* What the terms of spans say at each pixel: the same bits through any window, and the model's values in doubles. */
#include <string.h>

#include "shapes.h"

/* -------------------------------------------------------------------------------------------------------- looks for the terms */

static lmb_rgb random_colour(test_random *random)
{
    lmb_rgb c = {(uint8_t)test_integer(random, 0, 255), (uint8_t)test_integer(random, 0, 255),
                 (uint8_t)test_integer(random, 1, 255)};
    return c;
}

/* Returns the tolerance. */
static int random_look(test_random *random, lmb_look *look, lmb_rays *rays, enum lmb_model model, enum lmb_step_kind step)
{
    static const uint16_t tolerances[] = {0, LMB_TOLERANCE_RGB888, LMB_TOLERANCE_RGB565};
    const uint16_t tolerance = tolerances[test_integer(random, 0, 2)];
    lmb_material material;
    lmb_light lights[LMB_LIGHTS];
    unsigned i, n = (unsigned)test_integer(random, 1, LMB_LIGHTS);
    material.ambient = random_colour(random);
    material.diffuse = random_colour(random);
    material.specular = random_colour(random);
    material.shininess = (uint16_t)exp(test_real(random, 0, log(1000.9)));
    for (i = 0; i < n; i++) {
        lights[i].direction = random_unit(random);
        lights[i].colour = random_colour(random);
    }
    if (lmb_look_prepare(look, &material, lights, n, model, step) != 0) abort();
    lmb_look_tolerance(look, tolerance);
    if (test_integer(random, 0, 1)) lmb_look_ramp(look);
    lmb_rays_prepare(rays, look, NULL);
    return tolerance;
}

/* Normals within an angle of a common direction, most of them facing the viewer; depths at random. */
static void random_normals(test_random *random, lmb_vertex v[3], double spread)
{
    lmb_vec axis = random_unit(random);
    int i;
    if (test_integer(random, 0, 3)) axis.z = (int16_t)labs(axis.z);
    for (i = 0; i < 3; i++) {
        const lmb_vec off = random_unit(random);
        double r = tan(spread * test_real(random, 0, 0.999));
        v[i].normal = unit(axis.x + r * off.x, axis.y + r * off.y, axis.z + r * off.z);
        if (spread > 1.5) v[i].normal = off;
        v[i].depth = (uint16_t)test_next(random);
    }
}

/* ------------------------------------------------------------------------------------------- the same bits through any window */

typedef struct pixel_terms {
    int32_t diffuse[LMB_LIGHTS], specular[LMB_LIGHTS], depth;
    uint8_t painted, diffuse_on, specular_on, exponent[LMB_LIGHTS];
} pixel_terms;

static void term_walk(const lmb_span *span, lmb_term *term)
{
    if (span->kind == LMB_SPAN_PLANE) lmb_plane_step(term);
    if (span->kind == LMB_SPAN_ARC) lmb_arc_step(&span->arc, term);
}

static void span_terms(lmb_span span, unsigned lights, bool depth, pixel_terms *out)
{
    unsigned n, i;
    for (n = 0; n < span.length; n++, out++) {
        out->painted = 1;
        out->diffuse_on = span.diffuse_on;
        out->specular_on = span.specular_on;
        if (depth) {
            out->depth = span.depth.f;
            lmb_plane_step(&span.depth);
        }
        for (i = 0; i < lights; i++) {
            if (span.diffuse_on >> i & 1) {
                out->diffuse[i] = span.diffuse[i].f;
                term_walk(&span, &span.diffuse[i]);
            }
            if (span.specular_on >> i & 1) {
                out->exponent[i] = span.exponent[i];
                out->specular[i] = lmb_add_wrap(span.specular[i].f, span.kind == LMB_SPAN_ARC ? span.specular[i].c : 0);
                term_walk(&span, &span.specular[i]);
            }
        }
    }
}

/* The terms at every pixel of a window, SIDE to the row. */
static void window_terms(const lmb_look *look, const lmb_rays *rays, const lmb_vertex v[3], const lmb_window *w, pixel_terms *out)
{
    lmb_triangle triangle;
    lmb_span span;
    int y;
    for (y = 0; y < height_of(w); y++) memset(out + y * SIDE, 0, (size_t)width_of(w) * sizeof *out);
    if (!lmb_triangle_begin(&triangle, look, rays, &v[0], &v[1], &v[2], w)) return;
    while (lmb_triangle_next(&triangle, &span)) {
        span_terms(span, look->lights, w->depth, out + (span.y - w->top) * SIDE + (span.x - w->left));
    }
}

static lmb_window part_of(test_random *random, const lmb_window *w, int kind)
{
    lmb_window part = *w;
    part.top = (int16_t)test_integer(random, w->top, w->bottom - 1);
    part.bottom = (int16_t)(kind ? test_integer(random, part.top + 1, w->bottom) : part.top + 1);
    if (kind == 1) return part;
    part.left = (int16_t)test_integer(random, w->left, w->right - 1);
    part.right = (int16_t)test_integer(random, part.left + 1, w->right);
    return part;
}

static int parts_differ(const pixel_terms *whole, const lmb_window *w, const pixel_terms *part, const lmb_window *p)
{
    int y, differ = 0;
    for (y = p->top; y < p->bottom; y++) {
        const pixel_terms *a = whole + (y - w->top) * SIDE + (p->left - w->left), *b = part + (y - p->top) * SIDE;
        differ |= memcmp(a, b, (size_t)width_of(p) * sizeof *a) != 0;
    }
    return differ;
}

static const char *const model_names[] = {"flat", "gouraud", "diffuse", "gloss"};
static const char *const step_names[] = {"linear", "quadratic", "arc"};

static void test_windows(test_random *random, enum lmb_model model, enum lmb_step_kind step)
{
    static pixel_terms whole[SIDE * SIDE], part[SIDE * SIDE];
    static const int shapes[] = {SHAPE_ORDINARY, SHAPE_ORDINARY, SHAPE_ORDINARY, SHAPE_ORDINARY, SHAPE_TINY,
                                 SHAPE_SLIVER,   SHAPE_ALIGNED,  SHAPE_FAR,      SHAPE_HUGE};
    lmb_look look;
    lmb_rays rays;
    shape s;
    int i, k, faults = 0, windows = 0;
    memset(&s, 0, sizeof s);
    for (i = 0; i < 6000; i++) {
        s.window = random_window(random);
        s.window.depth = i % 4 > 0;
        shape_classes[shapes[i % 9]].make(random, &s);
        if (!is_front(s.v)) swap_corners(&s, 1, 2);
        random_look(random, &look, &rays, model, step);
        random_normals(random, s.v, i % 5 ? 0.5 : 2);
        window_terms(&look, &rays, s.v, &s.window, whole);
        for (k = 0; k < 3; k++, windows++) {
            lmb_window p = part_of(random, &s.window, k);
            window_terms(&look, &rays, s.v, &p, part);
            if (parts_differ(whole, &s.window, part, &p) && !faults++) shape_print(&s);
        }
    }
    test_verdict(!faults, "terms of a pixel are the same bits through any window",
                 "%s, %s: %d faults in %d windows of %d triangles", model_names[model], step_names[step], faults, windows, i);
}

/* --------------------------------------------------------------------------------------------------------- terms by the model */

/* A quadratic over a triangle from its values at corners 0, 1, 2 and at the middles of edges 01, 12, 20. */
typedef struct quadratic {
    double corner[3], middle[3];
} quadratic;

static double quadratic_at(const quadratic *q, const double l[3])
{
    double sum = 0;
    int i, j;
    for (i = 0; i < 3; i++) {
        j = i == 2 ? 0 : i + 1;
        sum += q->corner[i] * l[i] * (2 * l[i] - 1) + 4 * q->middle[i] * l[i] * l[j];
    }
    return sum;
}

static double dot_of(lmb_vec a, lmb_vec b) { return ((double)a.x * b.x + (double)a.y * b.y + (double)a.z * b.z) / 268435456.0; }

static double distance_of(lmb_vec a, lmb_vec b)
{
    double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return (x * x + y * y + z * z) / 536870912.0;
}

/* N.L or 1 - N.H by the model: at the corners as they are, linear between or through the normalised mean normals at mid-edge. */
static quadratic model_terms(const lmb_vertex v[3], lmb_vec ray, int highlight, int curved)
{
    quadratic q;
    int i, j;
    for (i = 0; i < 3; i++) q.corner[i] = highlight ? distance_of(v[i].normal, ray) : dot_of(v[i].normal, ray);
    for (i = 0; i < 3; i++) {
        double mean, u, p;
        j = i == 2 ? 0 : i + 1;
        mean = (q.corner[i] + q.corner[j]) / 2;
        u = distance_of(v[i].normal, v[j].normal);
        p = curved ? 1 / sqrt(1 - fmin(u, LMB_ARC_U_MAX / 268435456.0) / 2) : 1;
        q.middle[i] = highlight ? 1 + p * (mean - 1) : p * mean;
    }
    return q;
}

/* Barycentric coordinates of a pixel centre. */
static void weights_at(const lmb_vertex v[3], int x, int y, double l[3])
{
    double area = (double)side_of(&v[0], &v[1], v[2].x, v[2].y);
    int i;
    for (i = 0; i < 3; i++) l[i] = (double)side_of(&v[(i + 1) % 3], &v[(i + 2) % 3], x * PX + PX / 2, y * PX + PX / 2) / area;
}

/* How a triangle lies, as plane.c looks at it. */
typedef struct geometry {
    int bits;    /* corners lie within 2^bits sixteenths of a pixel of the first */
    int length;  /* 2^length and less is how often the triangle is longer than high: 2^(2 bits) over the area's power of two */
    double area; /* twice that of the triangle, in 1/256 pixel^2 */
    double unit; /* of a gradient's mantissa, per pixel */
} geometry;

/* Turns the corners so that the topmost is the first, from which planes are reckoned. */
static void top_first(lmb_vertex v[3])
{
    while (v[1].y < v[0].y || v[2].y < v[0].y) {
        const lmb_vertex first = v[0];
        v[0] = v[1];
        v[1] = v[2];
        v[2] = first;
    }
}

static geometry geometry_of(const lmb_vertex v[3])
{
    geometry g;
    const int32_t way[4] = {v[0].x - v[1].x, v[1].y - v[0].y, v[2].x - v[0].x, v[0].y - v[2].y};
    int i, shift;
    g.bits = 0;
    for (i = 0; i < 4; i++) {
        while (way[i] < -(1L << g.bits) || way[i] >= 1L << g.bits) g.bits++;
    }
    g.area = fabs((double)side_of(&v[0], &v[1], v[2].x, v[2].y));
    frexp(g.area, &shift);
    g.length = 2 * g.bits - (shift - 1);
    g.unit = ldexp(1, g.length - 11 - g.bits);
    return g;
}

/* What lambent.h says of triangles: over 512 pixels. And what plane.c says: 4096 times longer than high they have no curve. */
static bool is_large(const geometry *g) { return g->bits > 13; }
static bool is_thin(const geometry *g) { return g->length > 12; }

/* A function over the triangle and what its error depends on. */
typedef struct field {
    quadratic q;
    double bulges; /* of the three edges, summed up */
    double deepest;
    double rise;   /* the largest of the linear part */
    double bends;  /* factors of the bulges, summed up, in the function's unit */
    double factor; /* power of two that the state is scaled down by, at most */
} field;

static field field_of(const lmb_vertex v[3], quadratic q, double slope, double factor)
{
    field f;
    double bulge[3];
    int i, j;
    f.q = q;
    f.factor = factor;
    f.bulges = f.bends = f.deepest = 0;
    for (i = 0; i < 3; i++) {
        const double u = distance_of(v[i].normal, v[j = i == 2 ? 0 : i + 1].normal);
        const double bend = 1 / sqrt(1 - fmin(u, LMB_ARC_U_MAX / 268435456.0) / 2) - 1;
        bulge[i] = q.middle[i] - (q.corner[i] + q.corner[j]) / 2;
        f.bulges += fabs(bulge[i]);
        f.deepest = larger(f.deepest, fabs(bulge[i]));
        f.bends += bend * slope;
    }
    f.rise = larger(fabs(q.corner[1] - q.corner[0] + 4 * bulge[0]), fabs(q.corner[2] - q.corner[0] + 4 * bulge[2]));
    return f;
}

/* What plane.c says of curves: length over height times the deepest bulge is more than a half or, for looks on RGB565, two. Powers of
 * two: 0 no, 1 perhaps, 2 certainly. */
static int is_rough(const geometry *g, const field *f)
{
    int size;
    frexp(f->deepest / f->factor, &size);
    return g->length + size > 2 ? 2 : g->length + size > -2;
}

/* Numerators times the reciprocal of 16 bits are floored, by less than two of their units: that is for each pixel, and in 1/16 of one
 * over 2^5 for each of the 23 sixteenths, across and down together, to the anchor. A unit of a numerator, over the area, in 1/16
 * pixel: */
static double floor_doubt(const geometry *g, double n) { return (23 * 64 + 32 * n) * ldexp(1, g->bits - 27) / g->area; }

/* How far a term may be off n pixels, across and down together, from corner 0; triangles of up to 512 pixels, none of them thin.
 *
 * The linear part has rises rounded to 2^-(27 - bits) and so is off by half of that; a reciprocal of 16 bits, 2^-16 of the rise;
 * what floor_doubt says; differences floored to 2^-30.
 *
 * A bulge comes from its factor and what bulges, to 1.3e-4 (Taylor's series) and 2^-15 of the factor. What it is multiplied with:
 *   ordinary triangles   gradients of lambda are rounded to nearest in units of a mantissa, so that lambda is off by half a unit
 *                        for each pixel, d = unit n / 2 in all: an error of 16 d bulges. Their products w, u with the bulges are,
 *                        too: 4 d. The bulges themselves are rounded to 2^-15, which is 7 * 2^-16 in the quadratic; three second
 *                        differences are floored to twice the product of two units, 16 d^2; first differences and the value at
 *                        the anchor to 1/32 and 1/512 of it, times offsets of up to 31 and 409 of the units that plane.c has. All
 *                        but the first of these are finer where the deepest bulge is less than 1/16: it is raised to 13 bits
 *   rough ones           one factor for all, within 2^-13; numerators at the anchor are floored by less than four, so lambda is
 *                        off by that over the area
 * and the rounding of second differences to 2^-30 goes with n^2. */
static double bound_at(const geometry *g, const field *f, double n)
{
    const double square = n * n / 2, d = g->unit * n / 2;
    double scaled = ldexp(1, g->bits - 28) + floor_doubt(g, n) + ldexp(n + 2, -30), curve, whole_curve, gradients;
    const double whole = f->rise * 1.02 * ldexp(1, -16);
    if (f->bulges == 0) return f->factor * scaled + whole;
    scaled += ldexp(square, -30);
    curve = 1.3e-4 * f->bulges + ldexp(f->bends, -15);
    whole_curve = 4 * f->bulges * (ldexp(1, -13) + 8 / g->area);
    gradients = f->factor * fmin(1, 16 * f->deepest / f->factor) *
                    (4 * d + ldexp(7, -16) + 16 * d * d + 992 * g->unit * d + 3272 * g->unit * g->unit) +
                f->bulges * (16 * d + ldexp(4, -15));
    curve += is_rough(g, f) == 2 ? whole_curve : is_rough(g, f) ? larger(whole_curve, gradients) : gradients;
    return f->factor * scaled + whole + curve;
}

typedef struct term_errors {
    double diffuse, specular; /* worst error; of the highlight's argument where it is above zero or said to be */
    double share, excess;     /* of the bound for triangles up to 512 pixels; beyond what leaving out the curve costs */
    double bias, squares; /* of ordinary triangles with a curve, errors and their squares, as shares of the bound, summed up */
    double range, dark;   /* largest true value; largest where the bit says that there is none */
    uint64_t pixels, curved, left_out; /* terms; without a curve that would not show */
} term_errors;

/* An error at a pixel. Beyond 512 pixels, and where a triangle is so thin that it may have no curve, a term must be no worse than
 * it would be without, but for 1/256; and for numerators of 31 bits, over the area, n pixels away. */
static void errors_take(term_errors *e, const geometry *g, const field *f, double error, double n)
{
    if (is_large(g) || is_thin(g)) {
        e->excess = larger(e->excess, (fabs(error) - f->bulges) / f->factor - floor_doubt(g, n));
    } else {
        const double share = error / bound_at(g, f, n);
        e->share = larger(e->share, fabs(share));
        if (f->bulges > 0 && !is_rough(g, f)) {
            e->bias += share;
            e->squares += share * share;
            e->curved++;
        }
    }
}

/* What a light's terms are to be over a triangle. */
typedef struct wanted {
    field f, straight; /* N.L, and N.L without a curve */
    field s;           /* the highlight's argument */
    bool may_be_straight;
} wanted;

/* Bends that change N.L by less than the tolerance may be left out. */
static void want_diffuse(wanted *w, const lmb_vertex v[3], const lmb_look *look, const lmb_rays *rays, unsigned k,
                         double tolerance)
{
    const int curved = look->step == LMB_STEP_QUADRATIC;
    const uint16_t *c = look->light[k].diffuse_q15;
    const double strength = larger(larger(c[0], c[1]), c[2]) / 32768;
    double most = 0;
    int i;
    w->f = field_of(v, model_terms(v, rays->light[k].direction, 0, curved), 1, 1);
    w->straight = field_of(v, model_terms(v, rays->light[k].direction, 0, 0), 1, 1);
    for (i = 0; i < 3; i++) most = larger(most, distance_of(v[i].normal, v[(i + 1) % 3].normal));
    most = 1 / sqrt(1 - fmin(most, LMB_ARC_U_MAX / 268435456.0) / 2) - 1;
    w->may_be_straight = most * strength <= tolerance * 1.001;
}

/* top - slope v of a line; the state is scaled down until the largest v, or eight of the largest bulge, fits. */
static void want_specular(wanted *w, const lmb_vertex v[3], const lmb_look *look, const lmb_rays *rays, unsigned k)
{
    const double slope = ldexp(look->light[k].line.slope, look->light[k].line.shift - 15);
    quadratic q = model_terms(v, rays->light[k].half, 1, look->step == LMB_STEP_QUADRATIC);
    double high = 0;
    int i;
    for (i = 0; i < 3; i++) {
        const double u = distance_of(v[i].normal, v[(i + 1) % 3].normal), mean = (q.corner[i] + q.corner[(i + 1) % 3]) / 2;
        const double bend = 1 / sqrt(1 - fmin(u, LMB_ARC_U_MAX / 268435456.0) / 2) - 1;
        high = larger(larger(high, q.corner[i]), larger(2 * q.middle[i] - mean, 8 * bend));
    }
    for (i = 0; i < 3; i++) {
        q.corner[i] = ldexp(look->light[k].line.top_q30, -30) - slope * q.corner[i];
        q.middle[i] = ldexp(look->light[k].line.top_q30, -30) - slope * q.middle[i];
    }
    w->s = field_of(v, q, slope, larger(1, 1.01 * slope * high));
}

/* The terms of light k at all pixels of a window. */
static void errors_of_light(term_errors *e, const shape *s, const lmb_look *look, const wanted *w, unsigned k,
                            const pixel_terms *p)
{
    const geometry g = geometry_of(s->v);
    const double doubt_f = is_thin(&g) ? w->f.bulges : 0, doubt_s = is_thin(&g) ? w->s.bulges : 0;
    int x, y;
    for (y = s->window.top; y < s->window.bottom; y++, p += SIDE - width_of(&s->window)) {
        for (x = s->window.left; x < s->window.right; x++, p++) {
            const double n = (fabs(x + 0.5 - s->v[0].x / 16.0) + fabs(y + 0.5 - s->v[0].y / 16.0)) + 1;
            double l[3], want, got;
            if (!p->painted) continue;
            e->pixels++;
            weights_at(s->v, x, y, l);
            want = quadratic_at(&w->f.q, l);
            e->range = larger(e->range, fabs(want));
            got = p->diffuse_on >> k & 1 ? ldexp(p->diffuse[k], -30) : fmin(0, want);
            e->dark = larger(e->dark, p->diffuse_on >> k & 1 ? 0 : want - doubt_f);
            if (w->may_be_straight && p->diffuse_on >> k & 1) {
                const double straight = quadratic_at(&w->straight.q, l);
                e->left_out += fabs(got - straight) < fabs(got - want);
                if (fabs(got - straight) < fabs(got - want)) want = straight;
            }
            e->diffuse = larger(e->diffuse, fabs(got - want));
            errors_take(e, &g, &w->f, got - want, n);
            if (!(look->specular_on >> k & 1)) continue;
            want = quadratic_at(&w->s.q, l);
            got = p->specular_on >> k & 1 ? ldexp(p->specular[k], p->exponent[k] - 30) : fmin(0, want);
            e->dark = larger(e->dark, p->specular_on >> k & 1 ? 0 : (want - doubt_s) / w->s.factor);
            if (want <= 0 && got <= 0) continue;
            e->specular = larger(e->specular, fabs(got - want) / w->s.factor);
            errors_take(e, &g, &w->s, got - want, n);
        }
    }
}

/* The bound adds up all that may come together. What does is less: -0.011 and 0.049 of it for any seed; products rounded down, or
 * bulges raised to a bit less, are beyond these. */
#define SPREAD_MEAN 0.02
#define SPREAD_RMS 0.06

static void test_terms(test_random *random, const shape_class *class, enum lmb_step_kind step, double spread, int frame)
{
    static pixel_terms pixels[SIDE * SIDE];
    term_errors e;
    lmb_look look;
    lmb_rays rays;
    shape s;
    int i;
    memset(&e, 0, sizeof e);
    memset(&s, 0, sizeof s);
    for (i = 0; e.pixels < 400000 && i < 200000; i++) {
        unsigned k;
        int tolerance;
        s.window = random_window(random);
        if (s.window.left < 0 || s.window.top < 0 || s.window.right > frame || s.window.bottom > frame) continue;
        class->make(random, &s);
        if (!is_front(s.v)) swap_corners(&s, 1, 2);
        if (!is_front(s.v)) continue;
        tolerance = random_look(random, &look, &rays, LMB_MODEL_GLOSS, step);
        random_normals(random, s.v, spread);
        window_terms(&look, &rays, s.v, &s.window, pixels);
        top_first(s.v);
        for (k = 0; k < look.lights; k++) {
            wanted w;
            want_diffuse(&w, s.v, &look, &rays, k, tolerance / 65536.0);
            want_specular(&w, s.v, &look, &rays, k);
            errors_of_light(&e, &s, &look, &w, k, pixels);
        }
    }
    test_verdict(
        e.share <= 1 && e.excess <= 1.0 / 256 && e.range < 2 && e.dark < 1e-4, "terms against the model in doubles",
        "%s, %s, normals within %.1f, frame of %d: N.L errs %.2g, the highlight %.2g, %.2f of the bound, %.2g worse than "
        "without the curve; |N.L| up to %.4f, unlit up to %.2g; %" PRIu64 " of %" PRIu64 " straight",
        class->name, step_names[step], spread, frame, e.diffuse, e.specular, e.share, larger(0, e.excess), e.range, e.dark,
        e.left_out, e.pixels);
    if (class == &shape_classes[SHAPE_ALIGNED] && step == LMB_STEP_QUADRATIC && spread < 1) {
        const double mean = e.bias / (double)e.curved, rms = sqrt(e.squares / (double)e.curved);
        test_verdict(fabs(mean) <= SPREAD_MEAN && rms <= SPREAD_RMS, "terms: rounding to nearest averages out",
                     "%s, %s: of the bound the mean error is %.4f, rms %.4f, %" PRIu64 " terms", class->name, step_names[step],
                     mean, rms, e.curved);
    }
}

int main(int argc, char **argv)
{
    static const int fat_to_slim[] = {SHAPE_ORDINARY, SHAPE_TINY, SHAPE_ALIGNED, SHAPE_SLIVER, SHAPE_FAR, SHAPE_HUGE};
    test_random random = test_seed(argc, argv);
    int i, k;
    for (i = 0; i < 12; i++) test_windows(&random, (enum lmb_model)(i / 3), (enum lmb_step_kind)(i % 3));
    for (i = 0; i < 6; i++) {
        for (k = 0; k < 4; k++) {
            test_terms(&random, &shape_classes[fat_to_slim[i]], (enum lmb_step_kind)(k & 1), k < 2 ? 0.5 : 2, 1024);
        }
    }
    for (k = 0; k < 2; k++) test_terms(&random, &shape_classes[SHAPE_ORDINARY], (enum lmb_step_kind)k, 0.5, 32767);
    return test_end();
}
