/* SPDX-License-Identifier: MIT */
/* The bounds that plans stand on (firmware/plan.c; docs/NUMERICS.md, Plans), in double: linear and quadratic terms over a triangle
 * against normals that turn evenly along edges and rows. Triangles of any shape, corners and rows anywhere, sought by hill climbing; each
 * bound must hold, and be reached within a few parts in a hundred somewhere, or it would be wider than it needs to be.
 */
#include "arc_reference.h"

#include <string.h>

#define BEND_MAX 0.277 /* 77 degrees */

/* Normals at top, middle and bottom corner; how far down the middle one is and the row, 0 to 1; where along the row; and a ray. */
typedef struct place {
    arc_vector n[3], ray;
    double middle, row, along;
} place;

typedef struct values {
    double bend;
    arc_vector arc, linear, quadratic; /* what stands for the normal */
} values;

static arc_vector slerp(arc_vector a, arc_vector b, double t)
{
    const double psi = arc_angle(a, b), s = sin(psi);
    if (psi < 1e-9) return a;
    return arc_blend(a, sin(psi * (1 - t)) / s, b, sin(psi * t) / s);
}

static values values_at(const place *c)
{
    const arc_vector zero = {0, 0, 0}, *n = c->n;
    const bool upper = c->row < c->middle;
    const double u = upper ? c->row / c->middle : (c->row - c->middle) / (1 - c->middle);
    const arc_vector from = slerp(n[0], n[2], c->row), to = upper ? slerp(n[0], n[1], u) : slerp(n[1], n[2], u);
    double weight[3];
    values v = {0, slerp(from, to, c->along), zero, zero};
    int i;
    weight[0] = (1 - c->row) * (1 - c->along) + (upper ? 1 - u : 0) * c->along;
    weight[2] = c->row * (1 - c->along) + (upper ? 0 : u) * c->along;
    weight[1] = 1 - weight[0] - weight[2];
    for (i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const double l = weight[i];
        v.bend = fmax(v.bend, 1 / cos(arc_angle(n[i], n[j]) / 2) - 1);
        v.linear = arc_blend(v.linear, 1, n[i], l);
        v.quadratic = arc_blend(v.quadratic, 1, n[i], l * (2 * l - 1));
        v.quadratic = arc_blend(v.quadratic, 1, arc_unit(arc_blend(n[i], 1, n[j], 1)), 4 * l * weight[j]);
    }
    return v;
}

/* Amplitudes of one: N.L for every ray at once, and the highlight for one ray. */
static double length_between(arc_vector a, arc_vector b)
{
    const arc_vector d = arc_blend(a, 1, b, -1);
    return sqrt(arc_inner(d, d));
}

static double power_between(arc_vector a, arc_vector b, arc_vector ray, double n)
{
    return fabs(pow(fmin(fmax(arc_inner(a, ray), 0), 1), n) - pow(fmin(fmax(arc_inner(b, ray), 0), 1), n));
}

/* What is bounded: an error over its bound. n = 0: N.L. */
typedef struct bounded {
    const char *name;
    bool quadratic;
    double n, a, b; /* quadratic: a sqrt(n) p^(3/2) + b n p^2; linear: a n p */
} bounded;

static double share(const bounded *to, const place *c, double degrees)
{
    const values v = values_at(c);
    const arc_vector model = to->quadratic ? v.quadratic : v.linear;
    const double n = fmax(to->n, 1), p = v.bend;
    const double bound = to->quadratic ? to->a * sqrt(n) * pow(p, 1.5) + to->b * n * p * p : to->a * n * p;
    if (p < 1e-5 || p > BEND_MAX || p > 1 / cos(degrees * ARC_PI / 360) - 1) return 0;
    return (to->n > 0 ? power_between(model, v.arc, c->ray, n) : length_between(model, v.arc)) / bound;
}

static arc_vector beside(test_random *r, arc_vector v, double reach)
{
    return arc_unit(arc_blend(v, 1, arc_random_unit(r), reach));
}

static place random_place(test_random *r, double degrees)
{
    static const arc_vector axis = {0, 0, 1};
    place c;
    int i;
    for (i = 0; i < 3; i++) c.n[i] = beside(r, axis, degrees * ARC_PI / 180 * test_real(r, 0.2, 0.7));
    c.ray = beside(r, axis, test_real(r, 0, 2));
    c.middle = test_real(r, 0.01, 0.99);
    c.row = test_real(r, 0, 1);
    c.along = test_real(r, 0, 1);
    return c;
}

static double moved(test_random *r, double x, double reach)
{
    return fmin(fmax(x + test_real(r, -reach, reach), 1e-4), 1 - 1e-4);
}

static place nudged(test_random *r, const place *from)
{
    const double reach = pow(10, test_real(r, -3.5, 0)),
                 turn = arc_angle(from->n[0], from->n[1]) + arc_angle(from->n[1], from->n[2]);
    place c = *from;
    int i;
    for (i = 0; i < 3; i++)
        if (test_integer(r, 0, 2) == 0) c.n[i] = beside(r, c.n[i], reach * turn);
    if (test_integer(r, 0, 2) == 0) c.middle = moved(r, c.middle, reach);
    if (test_integer(r, 0, 2) == 0) c.row = moved(r, c.row, reach);
    if (test_integer(r, 0, 2) == 0) c.along = moved(r, c.along, reach);
    if (test_integer(r, 0, 1)) c.ray = beside(r, c.ray, reach);
    return c;
}

static double climb(test_random *r, const bounded *to, double degrees)
{
    place best = random_place(r, degrees);
    double most = 0;
    int i;
    for (i = 0; i < 16000; i++) {
        const place c = i < 3000 ? random_place(r, degrees) : nudged(r, &best);
        const double s = share(to, &c, degrees);
        if (s > most) most = s, best = c;
    }
    return most;
}

static void test_bound(test_random *r, const bounded *to)
{
    static const double degrees[] = {3, 10, 28, 48, 77};
    double most = 0, where = 0;
    unsigned i, k;
    for (i = 0; i < sizeof degrees / sizeof degrees[0]; i++) {
        for (k = 0; k < 6; k++) {
            const double s = climb(r, to, degrees[i]);
            if (s > most) most = s, where = degrees[i];
        }
    }
    test_verdict(most <= 1 && most > 0.85, to->name, "n = %g: %.3f of %g%s, normals up to %g degrees apart", to->n, most, to->a,
                 to->quadratic ? " sqrt(n) p^(3/2) and its square" : " n p", where);
}

int main(int argc, char **argv)
{
    static const bounded all[] = {
        {"bound_linear_diffuse", false, 0, 16.0 / 11, 0},
        {"bound_linear_highlight", false, 1, 16.0 / 11, 0},
        {"bound_linear_highlight", false, 16, 16.0 / 11, 0},
        {"bound_linear_highlight", false, 300, 16.0 / 11, 0},
        {"bound_diffuse", true, 0, 0.372, 0.22},
        {"bound_highlight", true, 1, 0.372, 0.22},
        {"bound_highlight", true, 2, 0.264, 0.51},
        {"bound_highlight", true, 3, 0.264, 0.51},
        {"bound_highlight", true, 4, 0.242, 0.51},
        {"bound_highlight", true, 8, 0.242, 0.51},
        {"bound_highlight", true, 15, 0.242, 0.51},
        {"bound_highlight", true, 16, 0.228, 0.51},
        {"bound_highlight", true, 17, 0.228, 0.595},
        {"bound_highlight", true, 60, 0.228, 0.595},
        {"bound_highlight", true, 300, 0.228, 0.595},
        {"bound_highlight", true, 1000, 0.228, 0.595},
    };
    test_random r = test_seed(argc, argv);
    unsigned i;
    for (i = 0; i < sizeof all / sizeof all[0]; i++) test_bound(&r, &all[i]);
    return test_end();
}
