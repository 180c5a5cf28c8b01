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

static void random_look(test_random *random, lmb_look *look, lmb_rays *rays, enum lmb_model model, enum lmb_step_kind step)
{
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
    lmb_rays_prepare(rays, look, NULL);
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

static void span_terms(lmb_span span, unsigned lights, pixel_terms *out)
{
    unsigned n, i;
    for (n = 0; n < span.length; n++, out++) {
        out->painted = 1;
        out->diffuse_on = span.diffuse_on;
        out->specular_on = span.specular_on;
        out->depth = span.depth.f;
        lmb_plane_step(&span.depth);
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
        span_terms(span, look->lights, out + (span.y - w->top) * SIDE + (span.x - w->left));
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

/* The extent in screen units. */
static double extent(const lmb_vertex v[3])
{
    double size = 0;
    int i;
    for (i = 1; i < 3; i++) size = larger(size, larger(fabs((double)v[i].x - v[0].x), fabs((double)v[i].y - v[0].y)));
    return size;
}

/* What plane.c says of corners up to 512 pixels apart, whatever the shape: a linear part within 2^-16 of rises up to two, a
 * quadratic one within 2^-13 of its coefficients, four times the bulges, floored to 14 bits; numerators at the anchor are
 * floored by less than four, so barycentric coordinates may be off by that over the area; and second differences are rounded.
 * Beyond, and where a triangle is so thin that plane.c leaves its curve out, a term must be no worse than it would be without
 * its curve, but for 1/256. */
#define LINEAR_ERROR ldexp(1, -15)
#define CURVED_ERROR ldexp(1, -13)

typedef struct term_errors {
    double diffuse, specular; /* worst error, s where it is above zero or said to be */
    double share, excess;     /* of the bound for triangles up to 512 pixels; beyond what leaving out the curve costs */
    double range, dark;       /* largest true value; largest where the bit says that there is none */
    uint64_t pixels;
} term_errors;

static double bulge_of(const quadratic *q)
{
    double bulge = 0;
    int i;
    for (i = 0; i < 3; i++) bulge += fabs(q->middle[i] - (q->corner[i] + q->corner[(i + 1) % 3]) / 2);
    return bulge;
}

/* Whether a triangle may be drawn without its curve: at least 1024 times longer than high. */
static int is_thin(double size, double area) { return area < size * size / 1024; }

static void errors_take(term_errors *e, const quadratic *q, double factor, double error, double size, double area)
{
    double bulge = bulge_of(q), bound = LINEAR_ERROR * (1 + 64 / area) + 4 * bulge * (CURVED_ERROR + 8 / area);
    if (bulge > 0) bound += ldexp(size / PX * (size / PX), -30); /* second differences, half a unit of 2^-30 each */
    if (size < 512 * PX && !is_thin(size, area)) e->share = larger(e->share, error / factor / bound);
    e->excess = larger(e->excess, error / factor - bulge);
}

/* The terms of light k at all pixels of a window. */
static void errors_of_light(term_errors *e, const shape *s, const lmb_look *look, const lmb_rays *rays, unsigned k,
                            const pixel_terms *p)
{
    const int curved = look->step == LMB_STEP_QUADRATIC;
    const quadratic f = model_terms(s->v, rays->light[k].direction, 0, curved),
                    v = model_terms(s->v, rays->light[k].half, 1, curved);
    const double slope = ldexp(look->lobe.slope, look->lobe.slope_shift - 15), alpha = ldexp(look->lobe.alpha_q30, -30);
    const double zero = look->lobe.floor_q15 / 32768.0; /* where the lobe ends */
    double size = extent(s->v), area = fabs((double)side_of(&s->v[0], &s->v[1], s->v[2].x, s->v[2].y)), l[3], want, got;
    const double doubt_f = is_thin(size, area) ? bulge_of(&f) : 0, doubt_v = is_thin(size, area) ? slope * bulge_of(&v) : 0;
    int x, y;
    for (y = s->window.top; y < s->window.bottom; y++, p += SIDE - width_of(&s->window)) {
        for (x = s->window.left; x < s->window.right; x++, p++) {
            if (!p->painted) continue;
            e->pixels++;
            weights_at(s->v, x, y, l);
            want = quadratic_at(&f, l);
            e->range = larger(e->range, fabs(want));
            got = p->diffuse_on >> k & 1 ? ldexp(p->diffuse[k], -30) : fmin(0, want);
            e->dark = larger(e->dark, p->diffuse_on >> k & 1 ? 0 : want - doubt_f);
            e->diffuse = larger(e->diffuse, fabs(got - want));
            errors_take(e, &f, 1, fabs(got - want), size, area);
            want = alpha - slope * quadratic_at(&v, l);
            if (!(look->specular_on >> k & 1)) continue;
            got = p->specular_on >> k & 1 ? ldexp(p->specular[k], p->exponent[k] - 30) : fmin(zero, want);
            e->dark = larger(e->dark, p->specular_on >> k & 1 ? 0 : want - zero - doubt_v);
            if (want <= zero && got <= zero) continue;
            e->specular = larger(e->specular, fabs(got - want));
            errors_take(e, &v, larger(slope, 1), fabs(got - want), size, area);
        }
    }
}

static void test_terms(test_random *random, const shape_class *class, enum lmb_step_kind step, double spread, int frame)
{
    static pixel_terms pixels[SIDE * SIDE];
    term_errors e = {0, 0, 0, 0, 0, 0, 0};
    lmb_look look;
    lmb_rays rays;
    shape s;
    int i;
    memset(&s, 0, sizeof s);
    for (i = 0; e.pixels < 400000 && i < 200000; i++) {
        unsigned k;
        s.window = random_window(random);
        if (s.window.left < 0 || s.window.top < 0 || s.window.right > frame || s.window.bottom > frame) continue;
        class->make(random, &s);
        if (!is_front(s.v)) swap_corners(&s, 1, 2);
        if (!is_front(s.v)) continue;
        random_look(random, &look, &rays, LMB_MODEL_GLOSS, step);
        random_normals(random, s.v, spread);
        window_terms(&look, &rays, s.v, &s.window, pixels);
        for (k = 0; k < look.lights; k++) errors_of_light(&e, &s, &look, &rays, k, pixels);
    }
    test_verdict(e.share <= 1 && e.excess <= 1.0 / 256 && e.range < 2 && e.dark < 1e-4, "terms against the model in doubles",
                 "%s, %s, normals within %.1f, frame of %d: N.L errs %.2g, s %.2g, %.2f of the bound, %.2g worse than without "
                 "the curve; |N.L| up to %.4f, unlit up to %.2g",
                 class->name, step_names[step], spread, frame, e.diffuse, e.specular, e.share, larger(0, e.excess), e.range,
                 e.dark);
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
