/* SPDX-License-Identifier: MIT */
/* Steps along which the normal turns evenly: paper 001's equations 2 to 14, Kuijk and Blake's angle, and the difference form. */
#include "steps_parts.h"

/* What a span's preparation stage finds: a = Na.L, k = Nk.L with Nk unit and at right angles to Na (eq. 4, figure 2), psi. */
typedef struct turn {
    double psi, phi, a, k;
    paper_vector across; /* Nk */
} turn;

/* Nk = (Nb - Na (Nb.Na)) / sqrt(1 - (Nb.Na)^2). Equal and opposite normals have none: zero, so that f is a cos(t phi). */
static turn turn_of(const paper_span *s)
{
    const double cosine = dot(s->from, s->to);
    const paper_vector away = difference(s->to, scaled(s->from, cosine));
    const double sine = root_of(dot(away, away));
    turn r = {0, 0, 0, 0, {0, 0, 0}};
    r.psi = angle_of(sine, cosine);
    if (sine > 1e-12) r.across = divided(away, sine);
    r.phi = over(r.psi, s->pixels);
    r.a = dot(s->from, s->ray);
    r.k = dot(r.across, s->ray);
    return r;
}

/* ------------------------------------------------------------------------------------------------------- equations 2 to 6 */

/* One component by eq. 2 as it stands; w psi accumulates, so it is an addition of its own. */
static double eq2(double a, double b, double psi, double step, double *w_psi, double sine_psi)
{
    const double f = plus(times(over(sine_of(minus(psi, *w_psi)), sine_psi), a), times(over(sine_of(*w_psi), sine_psi), b));
    *w_psi = plus(*w_psi, step);
    return f;
}

void paper_slerp(const paper_span *s, double *f)
{
    const turn r = turn_of(s);
    const double sine_psi = sine_of(r.psi);
    double x = 0, y = 0, z = 0;
    unsigned t;
    for (t = 0; t <= s->pixels; t++) {
        paper_vector n = s->from;
        if (sine_psi > 1e-12) {
            n.x = eq2(s->from.x, s->to.x, r.psi, r.phi, &x, sine_psi);
            n.y = eq2(s->from.y, s->to.y, r.psi, r.phi, &y, sine_psi);
            n.z = eq2(s->from.z, s->to.z, r.psi, r.phi, &z, sine_psi);
        }
        f[t] = dot(n, s->ray);
    }
}

static paper_vector blend(paper_vector a, double s, paper_vector b, double t) { return sum(scaled(a, s), scaled(b, t)); }

paper_vector paper_normal(int equation, const paper_span *s, double t)
{
    const turn r = turn_of(s);
    const double w = t / s->pixels, sine = sin(r.psi), cosine = dot(s->from, s->to);
    const paper_vector apart = difference(s->to, scaled(s->from, cosine));
    switch (equation) {
    case 2:
        return blend(s->from, sin((1 - w) * r.psi) / sine, s->to, sin(w * r.psi) / sine);
    case 3:
        return blend(s->from, cos(w * r.psi), difference(s->to, scaled(s->from, cos(r.psi))), sin(w * r.psi) / sine);
    case 4:
        return blend(s->from, cos(w * r.psi), apart, sin(w * r.psi) / sqrt(1 - cosine * cosine));
    case 5:
        return blend(s->from, cos(w * r.psi), r.across, sin(w * r.psi));
    default:
        return blend(s->from, cos(t * r.phi), r.across, sin(t * r.phi));
    }
}

/* Per line the angle to the ray's shadow in the plane of the normals and the shadow's length, then a cosine a pixel. */
void paper_kuijk_blake(const paper_span *s, double *f)
{
    const turn r = turn_of(s);
    const double amplitude = root_of(plus(times(r.a, r.a), times(r.k, r.k)));
    double angle = -angle_of(r.k, r.a);
    unsigned t;
    for (t = 0; t <= s->pixels; t++) {
        f[t] = times(amplitude, cosine_of(angle));
        angle = plus(angle, r.phi);
    }
}

/* ------------------------------------------------------------------------------------------------------- the recurrences */

/* 2 cos(phi) f(t) - f(t-1): a multiplication, a shift, a subtraction (eq. 7 of components, eq. 14 of f). */
static double next(double cosine, double f, double before) { return minus(twice(times(f, cosine)), before); }

void paper_eq7_vector(const paper_span *s, double *f)
{
    const turn r = turn_of(s);
    const double cosine = cosine_of(r.phi), sine = sine_of(r.phi);
    paper_vector n = s->from, before = blend(s->from, cosine, r.across, -sine);
    unsigned t;
    for (t = 0;; t++) {
        const paper_vector last = n;
        f[t] = dot(n, s->ray);
        if (t == s->pixels) break;
        n.x = next(cosine, n.x, before.x);
        n.y = next(cosine, n.y, before.y);
        n.z = next(cosine, n.z, before.z);
        before = last;
    }
}

void paper_eq14(const paper_span *s, double *f)
{
    const turn r = turn_of(s);
    const double cosine = cosine_of(r.phi);
    double before = minus(times(r.a, cosine), times(r.k, sine_of(r.phi)));
    unsigned t;
    f[0] = r.a;
    for (t = 1; t <= s->pixels; t++) {
        f[t] = next(cosine, f[t - 1], before);
        before = f[t - 1];
    }
}

/* f <- f + d, d <- d - kappa f with kappa = 4 sin^2(phi/2): the same numbers, but the angle is not lost beside two. The first
 * difference is f(1) - f(0) = k sin(phi) - a kappa/2. */
void paper_lambent(const paper_span *s, double *f)
{
    const turn r = turn_of(s);
    const double half = sine_of(r.phi / 2), kappa = twice(twice(times(half, half)));
    double d = minus(times(r.k, sine_of(r.phi)), times(r.a, kappa / 2));
    unsigned t;
    f[0] = r.a;
    for (t = 1; t <= s->pixels; t++) {
        f[t] = plus(f[t - 1], d);
        d = minus(d, times(kappa, f[t]));
    }
}

/* ------------------------------------------------------------------------------------------------------------------ blocks
 * With c = cos(phi) and C = cos(2 phi) = 2c^2 - 1, f(t+k) = U(k) f(t) - U(k-1) f(t-1), where U are Chebyshev's polynomials of the
 * second kind, U(0) = 1, U(1) = 2c, U(k+1) = 2c U(k) - U(k-1): by induction from eq. 7. Hence
 *     U(2) = 4c^2 - 1 = 2C + 1                         (8), (9):  f(t+2) = (2C + 1) f(t) - 2c f(t-1), right as printed
 *     U(3) = 8c^3 - 4c = 4c C                          (10):      f(t+3) = 4c C f(t) - (2C + 1) f(t-1)
 *                                                                        = C (4c f(t) - 2 f(t-1)) - f(t-1)
 *     U(4) = 16c^4 - 12c^2 + 1 = 4C^2 + 2C - 1         (11):      f(t+4) = (4C^2 + 2C - 1) f(t) - 4c C f(t-1)
 * f(t) and f(t-1) are independent unless sin(phi) = 0, so no other factors will do. The print has in (10) f(t-1) where 2 f(t-1)
 * belongs and 3 f(t-1) where f(t-1) does: at phi = 0 it gives 0 for 1. In (11) it has C (2C + 3) + 1/2 for C (2C + 1) - 1/2 and
 * C + 4 for 2C: right at phi = 0, and 6 (f(t) - f(t-1)) too much beside it. */
typedef struct block {
    double c, c2, f, before;
} block;

static double second(const block *b) { return minus(times(b->f, plus(twice(b->c2), 1)), twice(times(b->before, b->c))); }
static double third(const block *b)
{
    return minus(times(b->c2, minus(twice(twice(times(b->f, b->c))), twice(b->before))), b->before);
}
static double third_printed(const block *b)
{
    const double inner = minus(twice(twice(times(b->f, b->c))), b->before);
    return minus(times(b->c2, inner), plus(twice(b->before), b->before));
}
static double fourth(const block *b)
{
    const double factor = minus(plus(twice(twice(times(b->c2, b->c2))), twice(b->c2)), 1);
    return minus(times(factor, b->f), twice(twice(times(times(b->c, b->c2), b->before))));
}
static double fourth_printed(const block *b)
{
    const double first = times(twice(times(b->f, b->c2)), plus(twice(b->c2), 3));
    return plus(minus(first, times(twice(times(b->before, b->c)), plus(b->c2, 4))), b->f);
}

/* Blocks of so many pixels from the two before: every formula takes f(t) and f(t-1) alone, as the paper wants it. */
static void blocks(const paper_span *s, double *f, unsigned size, double (*three)(const block *), double (*four)(const block *))
{
    const turn r = turn_of(s);
    block b = {cosine_of(r.phi), cosine_of(twice(r.phi)), r.a, 0};
    unsigned t;
    b.before = minus(times(r.a, b.c), times(r.k, sine_of(r.phi)));
    f[0] = r.a;
    for (t = 0; t < s->pixels; t += size) {
        double out[4] = {0, 0, 0, 0};
        unsigned i;
        out[0] = next(b.c, b.f, b.before);
        out[1] = second(&b);
        if (size > 2) out[2] = three(&b);
        if (size > 3) out[3] = four(&b);
        for (i = 0; i < size && t + i < s->pixels; i++) f[t + i + 1] = out[i];
        b.before = out[size - 2];
        b.f = out[size - 1];
    }
}

void paper_block2(const paper_span *s, double *f) { blocks(s, f, 2, third, fourth); }
void paper_block3(const paper_span *s, double *f) { blocks(s, f, 3, third, fourth); }
void paper_block4(const paper_span *s, double *f) { blocks(s, f, 4, third, fourth); }
void paper_block3_printed(const paper_span *s, double *f) { blocks(s, f, 3, third_printed, fourth); }
void paper_block4_printed(const paper_span *s, double *f) { blocks(s, f, 4, third, fourth_printed); }
