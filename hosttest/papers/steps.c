/* SPDX-License-Identifier: MIT */
/* The table of ways along a span, and the linear ones: intensities, normals, their lengths. Recurrences: steps_turn.c. */
#include "steps_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

paper_cost paper_count;

/* ------------------------------------------------------------------------------------------------------- of intensities alone */

/* One normal for the span: the middle one, as a face's normal stands for those of its corners. */
static void flat(const paper_span *s, double *f)
{
    const double value = dot(unit(sum(s->from, s->to)), s->ray);
    unsigned t;
    for (t = 0; t <= s->pixels; t++) f[t] = value;
}

/* Gouraud: f = f + (f(m) - f(0)) / m. */
static void linear(const paper_span *s, double *f)
{
    const double step = over(minus(dot(s->to, s->ray), dot(s->from, s->ray)), s->pixels);
    unsigned t;
    f[0] = dot(s->from, s->ray);
    for (t = 1; t <= s->pixels; t++) f[t] = plus(f[t - 1], step);
}

/* Bishop and Weimer's thought along a span: the parabola through f(0), f(m) and the normalised middle, by two differences. With
 * the ends a, b and the middle c it is a + (4c - 3a - b) w + (2a + 2b - 4c) w^2, w = t/m. */
static void quadratic(const paper_span *s, double *f)
{
    const double a = dot(s->from, s->ray), b = dot(s->to, s->ray), c = dot(unit(sum(s->from, s->to)), s->ray);
    const double bend = over(over(twice(minus(plus(a, b), twice(c))), s->pixels), s->pixels), turn = twice(bend);
    double d = plus(over(minus(minus(minus(twice(twice(c)), twice(a)), a), b), s->pixels), bend);
    unsigned t;
    f[0] = a;
    for (t = 1; t <= s->pixels; t++) {
        f[t] = plus(f[t - 1], d);
        d = plus(d, turn);
    }
}

/* ------------------------------------------------------------------------------------------------------- of the linear normal */

/* Runs N linearly and takes f of each: how is what the methods differ in. */
static void along(const paper_span *s, double *f, double (*shade)(paper_vector n, paper_vector ray))
{
    const paper_vector step = divided(difference(s->to, s->from), s->pixels);
    paper_vector n = s->from;
    unsigned t;
    for (t = 0;; t++) {
        f[t] = shade(n, s->ray);
        if (t == s->pixels) break;
        n = sum(n, step);
    }
}

/* Phong: each component over the length. A zero vector stays zero. */
static double normalised(paper_vector n, paper_vector ray) { return dot(unit(n), ray); }
static void normalise(const paper_span *s, double *f) { along(s, f, normalised); }

/* Lyon: 1/sqrt(x) of x = N.N about one, three terms of Taylor's series. */
static double taylor(paper_vector n, paper_vector ray)
{
    const double apart = minus(dot(n, n), 1);
    const double scale = plus(minus(1, apart / 2), times(0.375, times(apart, apart)));
    paper_count.shifts++; /* the half */
    return times(dot(n, ray), scale);
}
static void lyon_taylor(const paper_span *s, double *f) { along(s, f, taylor); }

/* N.N runs quadratically and N.L linearly: their differences take three additions a pixel, the root and the division stay. */
static void forward_length(const paper_span *s, double *f)
{
    const paper_vector step = divided(difference(s->to, s->from), s->pixels);
    const double rise = dot(step, s->ray), bend = twice(dot(step, step));
    double square = dot(s->from, s->from), d = plus(twice(dot(s->from, step)), bend / 2), value = dot(s->from, s->ray);
    unsigned t;
    for (t = 0;; t++) {
        const double length = root_of(fmax(square, 0));
        f[t] = length > 0 ? over(value, length) : 0;
        if (t == s->pixels) break;
        square = plus(square, d);
        d = plus(d, bend);
        value = plus(value, rise);
    }
}

/* ------------------------------------------------------------------------------------------------------------- by tables */

enum { LENGTHS = 256 }; /* of the table of 1/|N| over |N|^2 in 0 to 1 */

/* The middle of the cell that x in -1 to 1 falls into, of so many. */
static double cell_middle(double x, unsigned cells)
{
    const double cell = fmin(fmax(floor((x + 1) / 2 * cells), 0), cells - 1);
    return (2 * cell + 1) / cells - 1;
}

/* What the map holds: the light of the direction in the middle of a cell; z from x and y, which share the length at the rim. */
static double reflected(double x, double y, bool away, paper_vector ray)
{
    const double square = x * x + y * y, scale = square > 1 ? 1 / sqrt(square) : 1;
    const double z = sqrt(fmax(1 - square, 0));
    return scale * (x * ray.x + y * ray.y) + (away ? -z : z) * ray.z;
}

void paper_reflection_map(const paper_span *s, double *f, unsigned cells)
{
    const paper_vector step = divided(difference(s->to, s->from), s->pixels);
    paper_vector n = s->from;
    unsigned t;
    for (t = 0;; t++) {
        const double square = fmin(floor(dot(n, n) * LENGTHS), LENGTHS), scale = 1 / sqrt((square + 0.5) / LENGTHS);
        paper_count.look_ups += 2;
        f[t] = reflected(cell_middle(times(n.x, scale), cells), cell_middle(times(n.y, scale), cells), n.z < 0, s->ray);
        if (t == s->pixels) break;
        n = sum(n, step);
    }
}

static void reflection_map(const paper_span *s, double *f) { paper_reflection_map(s, f, 64); }

/* ------------------------------------------------------------------------------------------------------------------ the table */

const paper_step paper_steps[] = {
    {"flat", "one normal a face", "f = N((0 + m)/2).L", flat},
    {"linear", "Gouraud 1971", "f + (f(m) - f(0)) / m", linear},
    {"normalise", "Phong 1975", "N = (1 - w) Na + w Nb; N.L / sqrt(N.N)", normalise},
    {"slerp", "001 eq. 2", "(sin((1 - w) psi) Na + sin(w psi) Nb) / sin psi", paper_slerp},
    {"kuijk_blake", "Kuijk and Blake 1989", "A cos(t phi - theta)", paper_kuijk_blake},
    {"lyon_taylor", "Lyon 1993", "N.L (1 - (x - 1)/2 + 3/8 (x - 1)^2); x = N.N", lyon_taylor},
    {"forward_length", "001 ref. 5", "N.L / sqrt(N.N); both by differences", forward_length},
    {"reflection_map", "Giloi; Russel and Jackel", "map[N / |N|]; 1/|N| by table", reflection_map},
    {"eq7_vector", "001 eq. 7", "N(t+1) = 2 cos phi N(t) - N(t-1)", paper_eq7_vector},
    {"block2", "001 eq. 7; 9", "(9)", paper_block2},
    {"block3", "001 eq. 7; 9; 10 corrected", "(10) corrected", paper_block3},
    {"block4", "001 eq. 7; 9 to 11 corrected", "(11) corrected", paper_block4},
    {"block3_printed", "001 eq. 7; 9; 10", "cos 2phi (4 N(t) cos phi - N(t-1)) - 3 N(t-1)", paper_block3_printed},
    {"block4_printed", "001 eq. 7; 9; 11; 10 corrected",
     "2 N(t) cos 2phi (2 cos 2phi + 3) - 2 N(t-1) cos phi (cos 2phi + 4) + N(t)", paper_block4_printed},
    {"eq14", "001 eq. 14", "f(t+1) = 2 cos phi f(t) - f(t-1)", paper_eq14},
    {"lambent", "Reinsch's form of eq. 14", "f + d; d - kappa f; kappa = 4 sin^2(phi/2)", paper_lambent},
    {"quadratic", "Bishop and Weimer 1986", "f + d; d + c", quadratic},
};
const unsigned paper_step_count = sizeof paper_steps / sizeof paper_steps[0];

const paper_step *paper_step_named(const char *name)
{
    unsigned i;
    for (i = 0; i < paper_step_count; i++)
        if (!strcmp(paper_steps[i].name, name)) return &paper_steps[i];
    fprintf(stderr, "steps: no step is called %s\n", name);
    exit(EXIT_FAILURE);
}

/* ----------------------------------------------------------------------------------------------------------- costs and errors */

/* (a s + b t) / d, whole numbers until the last. */
static paper_cost weighed(paper_cost a, double s, paper_cost b, double t, double d)
{
    paper_cost c = {(a.multiplications * s + b.multiplications * t) / d,
                    (a.additions * s + b.additions * t) / d,
                    (a.shifts * s + b.shifts * t) / d,
                    (a.divisions * s + b.divisions * t) / d,
                    (a.roots * s + b.roots * t) / d,
                    (a.sines * s + b.sines * t) / d,
                    (a.look_ups * s + b.look_ups * t) / d};
    return c;
}

static paper_cost counted(const paper_step *step, unsigned pixels)
{
    static const paper_cost nothing;
    static double f[PAPER_PIXELS_MAX + 4];
    const paper_span span = paper_span_flat(0.5, pixels, 0.1, 0.2);
    paper_count = nothing;
    step->run(&span, f);
    return paper_count;
}

void paper_step_cost(const paper_step *step, paper_cost *pixel, paper_cost *span)
{
    const paper_cost few = counted(step, 24), many = counted(step, 48);
    *pixel = weighed(many, 1, few, -1, 24);
    *span = weighed(few, 2, many, -1, 1);
}

paper_span paper_span_flat(double psi, unsigned pixels, double phase, double lift)
{
    paper_span s = {{1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0};
    s.to.x = cos(psi);
    s.to.y = sin(psi);
    s.ray.x = cos(lift) * cos(phase);
    s.ray.y = cos(lift) * sin(phase);
    s.ray.z = sin(lift);
    s.pixels = pixels;
    return s;
}

/* sin(psi - x) a + sin(x) b, over sin(psi). Where the sine is zero: the first normal, or for opposite ones its part alone. */
double paper_exact(const paper_span *s, double t)
{
    const paper_vector apart = {s->to.x - s->from.x, s->to.y - s->from.y, s->to.z - s->from.z};
    const paper_vector both = {s->to.x + s->from.x, s->to.y + s->from.y, s->to.z + s->from.z};
    const double psi = 2 * atan2(sqrt(paper_dot(apart, apart)), sqrt(paper_dot(both, both))), x = psi * t / s->pixels;
    const double a = paper_dot(s->from, s->ray), b = paper_dot(s->to, s->ray);
    if (psi < 1e-12) return a;
    return sin(psi) < 1e-12 ? a * cos(x) : (sin(psi - x) * a + sin(x) * b) / sin(psi);
}

double paper_step_error(const paper_step *step, const paper_span *span)
{
    static double f[PAPER_PIXELS_MAX + 4];
    double worst = 0;
    unsigned t;
    step->run(span, f);
    for (t = 0; t <= span->pixels; t++) worst = fmax(worst, fabs(f[t] - paper_exact(span, t)));
    return worst;
}

double paper_step_worst(const paper_step *step, double psi, unsigned pixels)
{
    double worst = 0;
    int i;
    for (i = 0; i < 48; i++) {
        const paper_span span = paper_span_flat(psi, pixels, 2 * acos(-1) * (i / 2) / 24 + psi / 2, i % 2 ? 0.6 : 0);
        worst = fmax(worst, paper_step_error(step, &span));
    }
    return worst;
}
