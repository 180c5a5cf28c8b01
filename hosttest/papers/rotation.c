/* SPDX-License-Identifier: MIT */
/* A triangle turned through a full circle: see rotation.h. */
#include "rotation.h"

#include "../../firmware/lobe.h"
#include "../../firmware/step.h"

#include <string.h>

#define STEPS 360
#define GRID 7 /* points are the inner ones of a grid of that many parts a side */
#define POINTS ((GRID - 1) * (GRID - 2) / 2)
#define MIDDLE 64 /* pixel about which the library's triangles turn */

const char *const rotation_name[ROTATION_WAYS] = {"linear",         "normalise",         "rows",       "slerp", "quadratic",
                                                  "lambent_linear", "lambent_quadratic", "lambent_arc"};

rotation_case rotation_make(double degrees, unsigned shape)
{
    static const double x[3][3] = {{-30, 30, 0}, {-35, 30, 5}, {-30, 30, 2}};
    static const double y[3][3] = {{-17.32, -17.32, 34.64}, {-20, -10, 30}, {-5, -3, 8}};
    const double tilt = asin(2 / sqrt(3) * sin(degrees * ARC_PI / 360));
    rotation_case c;
    int i;
    for (i = 0; i < 3; i++) {
        const double turn = 2 * ARC_PI * i / 3 + 3.6652;
        const arc_vector n = {sin(tilt) * cos(turn), sin(tilt) * sin(turn), cos(tilt)};
        c.x[i] = x[shape][i];
        c.y[i] = y[shape][i];
        c.normal[i] = n;
    }
    /* between the middle and an edge: highlights are steepest beside their peak */
    c.ray = arc_unit(arc_blend(arc_blend(c.normal[0], 0.5, c.normal[1], 0.35), 1, c.normal[2], 0.15));
    return c;
}

/* ------------------------------------------------------------------------------------------------------------- in double */

/* A point by its weights of the corners. */
typedef struct place {
    double l[3];
} place;

static arc_vector slerp(arc_vector a, arc_vector b, double t)
{
    const double psi = arc_angle(a, b), s = sin(psi);
    if (psi < 1e-9) return a;
    return arc_blend(a, sin(psi * (1 - t)) / s, b, sin(psi * t) / s);
}

static arc_vector between(arc_vector a, arc_vector b, double t, bool evenly)
{
    return evenly ? slerp(a, b, t) : arc_unit(arc_blend(a, 1 - t, b, t));
}

/* The point in a row where an edge crosses it. */
typedef struct crossing {
    double x;
    arc_vector normal;
} crossing;

/* Along the row of a point, the triangle turned by an angle. */
static double along_row(const rotation_case *c, place p, double turn, bool evenly)
{
    const double co = cos(turn), si = sin(turn);
    double x[3], y[3], px = 0, py = 0;
    crossing end[2], at;
    int i, j, ends = 0;
    for (i = 0; i < 3; i++) {
        x[i] = co * c->x[i] - si * c->y[i];
        y[i] = si * c->x[i] + co * c->y[i];
        px += p.l[i] * x[i];
        py += p.l[i] * y[i];
    }
    for (i = 0; i < 3; i++) {
        double t;
        j = (i + 1) % 3;
        if ((y[i] <= py) == (y[j] <= py)) continue;
        t = (py - y[i]) / (y[j] - y[i]);
        at.x = x[i] + t * (x[j] - x[i]);
        at.normal = between(c->normal[i], c->normal[j], t, evenly);
        end[ends++] = at;
    }
    return arc_inner(between(end[0].normal, end[1].normal, (px - end[0].x) / (end[1].x - end[0].x), evenly), c->ray);
}

static double linear_at(const rotation_case *c, place p)
{
    double sum = 0;
    int i;
    for (i = 0; i < 3; i++) sum += p.l[i] * arc_inner(c->normal[i], c->ray);
    return sum;
}

static double quadratic_at(const rotation_case *c, place p)
{
    double sum = 0;
    int i, j;
    for (i = 0; i < 3; i++) {
        j = (i + 1) % 3;
        sum += arc_inner(c->normal[i], c->ray) * p.l[i] * (2 * p.l[i] - 1);
        sum += arc_inner(arc_unit(arc_blend(c->normal[i], 1, c->normal[j], 1)), c->ray) * 4 * p.l[i] * p.l[j];
    }
    return sum;
}

static double normalised_at(const rotation_case *c, place p)
{
    return arc_inner(arc_unit(arc_blend(arc_blend(c->normal[0], p.l[0], c->normal[1], p.l[1]), 1, c->normal[2], p.l[2])), c->ray);
}

static double value_at(const rotation_case *c, enum rotation_way way, place p, double turn)
{
    switch (way) {
    case ROTATION_LINEAR:
    case ROTATION_OWN_LINEAR:
        return linear_at(c, p);
    case ROTATION_NORMALISE:
        return normalised_at(c, p);
    case ROTATION_QUADRATIC:
    case ROTATION_OWN_QUADRATIC:
        return quadratic_at(c, p);
    default:
        return along_row(c, p, turn, way != ROTATION_ROWS);
    }
}

/* --------------------------------------------------------------------------------------------------------- by the library */

static double power_of(double f, unsigned power) { return pow(fmin(fmax(f, 0), 1), power); }

/* What every pixel of a turned triangle gets: N.R for power 1, else the library's lobe. */
typedef struct picture {
    double value[2 * MIDDLE][2 * MIDDLE];
    bool painted[2 * MIDDLE][2 * MIDDLE];
    lmb_vertex corner[3];
} picture;

/* Corners on the screen, in the middle of the window. */
static void turn_corners(lmb_vertex corner[3], const rotation_case *c, double turn)
{
    int i;
    for (i = 0; i < 3; i++) {
        const double px = cos(turn) * c->x[i] - sin(turn) * c->y[i], py = sin(turn) * c->x[i] + cos(turn) * c->y[i];
        corner[i].x = (int32_t)lround((MIDDLE + px) * 16);
        corner[i].y = (int32_t)lround((MIDDLE - py) * 16);
        corner[i].normal = arc_round(c->normal[i], 16384);
        corner[i].depth = 0;
    }
}

static double intensity(const lmb_look *look, const lmb_span *span)
{
    double s;
    if (look->model == LMB_MODEL_DIFFUSE) return span->diffuse_on ? span->diffuse[0].f / 1073741824.0 : 0;
    if (!span->specular_on) return 0;
    s = span->specular[0].f + (span->kind == LMB_SPAN_ARC ? (double)span->specular[0].c : 0);
    return lmb_lobe_at(&look->lobe, (int32_t)floor(ldexp(s, span->exponent[0] - 14)) + look->light[0].dark_q16) / 32768.0;
}

static void term_step(const lmb_span *span, lmb_term *term)
{
    if (span->kind == LMB_SPAN_PLANE) lmb_plane_step(term);
    if (span->kind == LMB_SPAN_ARC) lmb_arc_step(&span->arc, term);
}

static void paint_span(picture *out, const lmb_look *look, lmb_span *span)
{
    int x;
    for (x = span->x; x < span->x + span->length; x++) {
        out->value[span->y][x] = intensity(look, span);
        out->painted[span->y][x] = true;
        if (span->diffuse_on) term_step(span, &span->diffuse[0]);
        if (span->specular_on) term_step(span, &span->specular[0]);
    }
}

/* The half vector of a light is the ray: the light is the viewer's direction mirrored by it. */
static lmb_light light_of(arc_vector ray, bool highlight)
{
    static const arc_vector viewer = {0, 0, 1};
    lmb_light light = {{0, 0, 0}, {255, 255, 255}};
    light.direction = arc_round(highlight ? arc_blend(ray, 2 * ray.z, viewer, -1) : ray, 16384);
    return light;
}

static void paint(picture *out, const rotation_case *c, enum lmb_step_kind step, double turn, unsigned power)
{
    static const lmb_window window = {0, 0, 2 * MIDDLE, 2 * MIDDLE, false};
    const lmb_material material = {{0, 0, 0}, {255, 255, 255}, {255, 255, 255}, (uint16_t)power};
    const lmb_light light = light_of(c->ray, power > 1);
    lmb_look look;
    lmb_rays rays;
    lmb_triangle triangle;
    lmb_span span;
    memset(out->painted, 0, sizeof out->painted);
    turn_corners(out->corner, c, turn);
    if (lmb_look_prepare(&look, &material, &light, 1, power > 1 ? LMB_MODEL_GLOSS : LMB_MODEL_DIFFUSE, step) != LMB_OK) abort();
    lmb_look_tolerance(&look, 0);
    lmb_rays_prepare(&rays, &look, NULL);
    if (!lmb_triangle_begin(&triangle, &look, &rays, &out->corner[0], &out->corner[1], &out->corner[2], &window)) return;
    while (lmb_triangle_next(&triangle, &span)) paint_span(out, &look, &span);
}

/* The weights of the corners at a pixel's centre. */
static place place_of(const picture *p, int x, int y)
{
    const lmb_vertex *v = p->corner;
    const double px = 16 * x + 8, py = 16 * y + 8;
    double area = (double)(v[1].x - v[0].x) * (v[2].y - v[0].y) - (double)(v[2].x - v[0].x) * (v[1].y - v[0].y);
    place at;
    at.l[1] = ((px - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (py - v[0].y)) / area;
    at.l[2] = ((v[1].x - v[0].x) * (py - v[0].y) - (px - v[0].x) * (v[1].y - v[0].y)) / area;
    at.l[0] = 1 - at.l[1] - at.l[2];
    return at;
}

/* What the library gives at a point: at the centre of its pixel, carried over to the point by the way's own slope in double. NaN
 * where that pixel is not painted. */
static double own_at(const picture *drawn, const rotation_case *c, enum rotation_way way, place p, double turn, unsigned power)
{
    double px = 0, py = 0;
    int i, x, y;
    for (i = 0; i < 3; i++) {
        px += p.l[i] * drawn->corner[i].x / 16;
        py += p.l[i] * drawn->corner[i].y / 16;
    }
    x = (int)px;
    y = (int)py;
    if (!drawn->painted[y][x]) return NAN;
    return drawn->value[y][x] + power_of(value_at(c, way, p, turn), power) -
           power_of(value_at(c, way, place_of(drawn, x, y), turn), power);
}

/* ----------------------------------------------------------------------------------------------------------------- spread */

double rotation_spread(const rotation_case *c, enum rotation_way way, unsigned power)
{
    static picture drawn;
    double low[POINTS], high[POINTS], spread = 0;
    int degrees, i, j, k;
    for (k = 0; k < POINTS; k++) low[k] = 2, high[k] = -2;
    for (degrees = 0; degrees < STEPS; degrees++) {
        const double turn = (degrees + 1e-6) * ARC_PI / 180; /* no edge along a row */
        if (rotation_is_integer(way)) paint(&drawn, c, (enum lmb_step_kind)(way - ROTATION_OWN_LINEAR), turn, power);
        for (k = 0, i = 1; i < GRID - 1; i++) {
            for (j = 1; i + j < GRID; j++, k++) {
                const place p = {{(double)i / GRID, (double)j / GRID, (double)(GRID - i - j) / GRID}};
                const double f = rotation_is_integer(way) ? own_at(&drawn, c, way, p, turn, power)
                                                          : power_of(value_at(c, way, p, turn), power);
                if (isnan(f)) continue;
                low[k] = fmin(low[k], f);
                high[k] = fmax(high[k], f);
            }
        }
    }
    for (k = 0; k < POINTS; k++) spread = fmax(spread, high[k] - low[k]);
    return spread;
}
