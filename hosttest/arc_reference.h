/* SPDX-License-Identifier: MIT */
/* Arcs in double from their definition, and one span of the library measured against it; for test_arc and the arc reports. */
#ifndef LMB_ARC_REFERENCE_H
#define LMB_ARC_REFERENCE_H

#include "../firmware/lambent.h"
#include "test.h"

#define ARC_PI 3.14159265358979323846

typedef struct arc_vector {
    double x, y, z;
} arc_vector;

static inline double arc_inner(arc_vector a, arc_vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/* a s + b t */
static inline arc_vector arc_blend(arc_vector a, double s, arc_vector b, double t)
{
    arc_vector v = {a.x * s + b.x * t, a.y * s + b.y * t, a.z * s + b.z * t};
    return v;
}

static inline arc_vector arc_unit(arc_vector v)
{
    double length = sqrt(arc_inner(v, v));
    arc_vector zero = {0, 0, 0};
    return arc_blend(v, length > 0 ? 1 / length : 0, zero, 0);
}

static inline arc_vector arc_from(lmb_vec v)
{
    arc_vector r = {v.x, v.y, v.z};
    return arc_unit(r);
}

/* scale is 16384 for a unit vector in Q2.14. */
static inline lmb_vec arc_round(arc_vector v, double scale)
{
    lmb_vec r = {(int16_t)lround(v.x * scale), (int16_t)lround(v.y * scale), (int16_t)lround(v.z * scale)};
    return r;
}

static inline arc_vector arc_random_unit(test_random *r)
{
    for (;;) {
        arc_vector v = {test_real(r, -1, 1), test_real(r, -1, 1), test_real(r, -1, 1)};
        double square = arc_inner(v, v);
        if (square < 1 && square > 0.01) return arc_unit(v);
    }
}

/* The angle between two unit vectors, as exact when it is small as when it is near half a turn. */
static inline double arc_angle(arc_vector a, arc_vector b)
{
    arc_vector apart = arc_blend(a, 1, b, -1), along = arc_blend(a, 1, b, 1);
    return 2 * atan2(sqrt(arc_inner(apart, apart)), sqrt(arc_inner(along, along)));
}

static inline int32_t arc_q30(double x) { return (int32_t)lround(fmin(fmax(x, -2), 2 - 1e-9) * 1073741824.0); }
static inline int32_t arc_u_q28(double psi) { return (int32_t)lround(2 * sin(psi / 2) * sin(psi / 2) * 268435456.0); }

/* v a little aside, rounded anew. */
static inline lmb_vec arc_nudge(test_random *r, lmb_vec v)
{
    double reach = pow(10, test_real(r, -4.5, -0.5));
    return arc_round(arc_unit(arc_blend(arc_from(v), 1, arc_random_unit(r), reach)), 16384);
}

/* A span between two normals, and a ray. */
typedef struct arc_case {
    lmb_vec from, to, ray;
    uint32_t length, start; /* LMB_ARC_PIXEL to a pixel */
} arc_case;

/* A length, in pixels. */
static inline double arc_pixels(uint32_t length) { return (double)length / LMB_ARC_PIXEL; }

/* A length even in its logarithm. */
static inline uint32_t arc_random_length(test_random *r, double low_px, double high_px)
{
    double length = floor(LMB_ARC_PIXEL * low_px * pow(high_px / low_px, test_real(r, 0, 1)) + 0.5);
    return (uint32_t)fmin(fmax(length, 1), LMB_ARC_PIXEL * high_px);
}

/* A start on an arc: any, or one in eight at either end of what a first pixel may have. */
static inline uint32_t arc_random_start(test_random *r, uint32_t length)
{
    uint32_t last = length < LMB_ARC_PIXEL ? length : LMB_ARC_PIXEL - 1;
    int64_t kind = test_integer(r, 0, 15);
    return kind == 0 ? 0 : kind == 1 ? last : (uint32_t)test_integer(r, 0, last);
}

/* One at random: ends psi apart, and a ray that mostly lies close to what the normal passes, where highlights are. */
static inline arc_case arc_random_case(test_random *r, double psi, uint32_t length)
{
    arc_case c;
    arc_vector a = arc_random_unit(r), side = arc_random_unit(r), out, ray;
    int kind = (int)test_integer(r, 0, 3);
    double along = test_real(r, 0, psi), off = kind == 0 ? 0 : test_real(r, 0, kind == 1 ? 0.02 : 0.2);
    side = arc_unit(arc_blend(side, 1, a, -arc_inner(side, a)));
    out.x = a.y * side.z - a.z * side.y;
    out.y = a.z * side.x - a.x * side.z;
    out.z = a.x * side.y - a.y * side.x;
    ray = arc_blend(arc_blend(a, cos(along), side, sin(along)), cos(off), out, sin(off));
    if (kind == 3) ray = arc_random_unit(r);
    c.from = arc_round(a, 16384);
    c.to = arc_round(arc_blend(a, cos(psi), side, sin(psi)), 16384);
    c.ray = arc_round(ray, 16384);
    c.length = length;
    c.start = arc_random_start(r, length);
    return c;
}

/* Errors of a span: of f, and of f^n for each of up to ARC_POWERS exponents, exact power of the integer f. */
#define ARC_POWERS 10
typedef struct arc_errors {
    double f, power[ARC_POWERS];
} arc_errors;

/* Adds the errors of one pixel. Below 2^-16 a power is as good as zero. */
static inline void arc_compare(arc_errors *e, double got, double want, const int *n, int powers)
{
    int i;
    double upper = fmax(got, want), g, w;
    e->f = fmax(e->f, fabs(got - want));
    if (upper <= 0) return;
    g = got > 0 ? log(fmin(got, 1)) : -1e9;
    w = want > 0 ? log(fmin(want, 1)) : -1e9;
    for (i = 0; i < powers; i++)
        if (n[i] * fmax(g, w) > -11.1) e->power[i] = fmax(e->power[i], fabs(exp(n[i] * g) - exp(n[i] * w)));
}

/* The normal turns evenly from one normalised end to the other: f = (sin(psi - x) a + sin(x) b) / sin(psi), paper 001 eq. 2. */
static inline void arc_measure(arc_errors *e, const arc_case *c, const int *n, int powers)
{
    const arc_vector from = arc_from(c->from), to = arc_from(c->to), ray = arc_from(c->ray);
    const double psi = arc_angle(from, to), a = arc_inner(from, ray), b = arc_inner(to, ray);
    lmb_arc arc;
    lmb_term term;
    uint32_t x;
    lmb_arc_between(&arc, c->from, c->to, c->length, c->start);
    lmb_arc_dot(&arc, &term, c->from, c->to, c->ray, 65536);
    for (x = c->start; x <= c->length; x += LMB_ARC_PIXEL) {
        double t = (double)x / c->length;
        double want = psi < 1e-12 ? a : (sin(psi * (1 - t)) * a + sin(psi * t) * b) / sin(psi);
        arc_compare(e, term.f / 1073741824.0, want, n, powers);
        lmb_arc_step(&arc, &term);
    }
}

#endif
