/* SPDX-License-Identifier: MIT */
/* Runs the integer kernels beside their definitions. */
#include "steps_kernels.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const compare_step_kernel *kernel_named(const char *name)
{
    unsigned i;
    for (i = 0; i < compare_step_count; i++)
        if (!strcmp(compare_steps[i].name, name)) return &compare_steps[i];
    fprintf(stderr, "steps: no kernel is called %s\n", name);
    exit(EXIT_FAILURE);
}

/* The map of the last ray: spans that follow one another often share it. */
static const compare_step_map *map_of(lmb_vec ray)
{
    static compare_step_map map;
    static lmb_vec last;
    static int made;
    if (!made || last.x != ray.x || last.y != ray.y || last.z != ray.z) compare_step_light(&map, ray);
    made = 1;
    last = ray;
    return &map;
}

void kernel_run(const compare_step_kernel *kernel, const kernel_span *span, double *f)
{
    static int32_t out[COMPARE_STEP_PIXELS_MAX + 1 + COMPARE_STEP_SPARE];
    compare_step_state state;
    unsigned t;
    state.map = strcmp(kernel->form, "reflection_map") ? NULL : map_of(span->ray);
    kernel->begin(&state, span->from, span->to, span->ray, span->pixels);
    kernel->run(&state, out, span->pixels + 1);
    for (t = 0; t <= span->pixels; t++) f[t] = ldexp(out[t], -(int)kernel->fraction_bits);
}

/* The reference of the last span: all kernels are measured on it in turn. */
static const double *reference_of(const kernel_span *span, const paper_span *exact)
{
    static double want[PAPER_PIXELS_MAX + 1];
    static kernel_span last;
    unsigned t;
    if (!memcmp(&last, span, sizeof last)) return want;
    for (t = 0; t <= span->pixels; t++) want[t] = paper_exact(exact, t);
    last = *span;
    return want;
}

void kernel_measure(const compare_step_kernel *kernel, const kernel_span *span, kernel_errors *worst)
{
    static double got[PAPER_PIXELS_MAX + 4], same[PAPER_PIXELS_MAX + 4];
    const paper_span exact = kernel_span_exact(span);
    const double *want = reference_of(span, &exact);
    unsigned t;
    kernel_run(kernel, span, got);
    paper_step_named(kernel->form)->run(&exact, same);
    for (t = 0; t <= span->pixels; t++) {
        worst->whole = fmax(worst->whole, fabs(got[t] - want[t]));
        worst->arithmetic = fmax(worst->arithmetic, fabs(got[t] - same[t]));
    }
}

/* --------------------------------------------------------------------------------------------------------------------- spans */

static lmb_vec rounded(paper_vector v)
{
    lmb_vec r = {(int16_t)lround(v.x * 16384), (int16_t)lround(v.y * 16384), (int16_t)lround(v.z * 16384)};
    return r;
}

static paper_vector normalised(lmb_vec v)
{
    const double length = sqrt((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z);
    paper_vector r = {0, 0, 0};
    if (length > 0) {
        r.x = v.x / length;
        r.y = v.y / length;
        r.z = v.z / length;
    }
    return r;
}

kernel_span kernel_span_of(const paper_span *span)
{
    kernel_span s;
    s.from = rounded(span->from);
    s.to = rounded(span->to);
    s.ray = rounded(span->ray);
    s.pixels = span->pixels;
    return s;
}

paper_span kernel_span_exact(const kernel_span *span)
{
    paper_span s;
    s.from = normalised(span->from);
    s.to = normalised(span->to);
    s.ray = normalised(span->ray);
    s.pixels = span->pixels;
    return s;
}

/* About an axis that leans by 0.7 and goes round by golden angles, so that no component is special. */
static paper_vector leant(paper_vector v, double about)
{
    const double c = cos(0.7), s = sin(0.7), ca = cos(about), sa = sin(about);
    const double x = v.x * c - v.z * s, z = v.x * s + v.z * c;
    paper_vector r = {x * ca - v.y * sa, x * sa + v.y * ca, z};
    return r;
}

kernel_span kernel_span_series(double psi, unsigned pixels, unsigned i)
{
    paper_span s = paper_span_flat(psi, pixels, 2.399963 * i, i % 3 == 0 ? 0 : 0.25 * (i % 5));
    s.from = leant(s.from, 1.7 * i);
    s.to = leant(s.to, 1.7 * i);
    s.ray = leant(s.ray, 1.7 * i);
    return kernel_span_of(&s);
}
