/* SPDX-License-Identifier: MIT */
/* Ways along a span over their whole domain: normals 0.01 to 179 degrees apart, 1 to 4096 pixels. Errors are against normals that
 * turn evenly (paper 001, eq. 2) between the ends as they are given. */
#include "stability.h"

#include "../arc_reference.h"
#include "../compare/steps.h"
#include "steps.h"

#include <string.h>

#define PHASES 8
#define ATTACKS 1500
#define MOST 64

/* Where the ray lies: lift out of the normals' plane, phase past the first normal. */
typedef struct view {
    double phase, lift;
} view;

/* The ray of the sweep, for which the reflection map is filled; attacks take others where a method has no map. */
static const arc_vector fixed_ray = {0.31, 0.52, 0.796};

static const compare_step_map *map_of(lmb_vec ray)
{
    static compare_step_map map;
    static bool filled;
    if (!filled) compare_step_light(&map, ray);
    filled = true;
    return &map;
}

static arc_vector across(arc_vector a, arc_vector b)
{
    const arc_vector v = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return v;
}

/* f is cos(lift) cos(x - phase), x radians past the first normal. */
static arc_case span_of(arc_vector ray, double psi, unsigned pixels, view at, arc_vector any)
{
    const arc_vector r = arc_unit(ray), e = arc_unit(across(r, any)), q = across(r, e);
    const arc_vector p = arc_blend(r, cos(at.lift), q, sin(at.lift));
    arc_case c;
    c.from = arc_round(arc_blend(p, cos(at.phase), e, -sin(at.phase)), 16384);
    c.to = arc_round(arc_blend(p, cos(psi - at.phase), e, sin(psi - at.phase)), 16384);
    c.ray = arc_round(r, 16384);
    c.length = pixels;
    c.start = 0;
    return c;
}

/* A term that is a at the first and b at the last of so many steps, where normals turn evenly by psi. */
typedef struct wanted {
    double psi, a, b;
    unsigned pixels;
} wanted;

static double wanted_at(const wanted *w, unsigned t)
{
    const double x = w->psi * t / w->pixels;
    return w->psi < 1e-9 ? w->a : (sin(w->psi - x) * w->a + sin(x) * w->b) / sin(w->psi);
}

/* From the vectors as they were rounded. */
static double kernel_error(const compare_step_kernel *kernel, const arc_case *c)
{
    static int32_t f[COMPARE_STEP_PIXELS_MAX + 1 + COMPARE_STEP_SPARE];
    const arc_vector from = arc_from(c->from), to = arc_from(c->to), ray = arc_from(c->ray);
    const wanted w = {arc_angle(from, to), arc_inner(from, ray), arc_inner(to, ray), c->length};
    compare_step_state state;
    double worst = 0;
    unsigned t;
    memset(&state, 0, sizeof state);
    state.map = map_of(arc_round(arc_unit(fixed_ray), 16384));
    kernel->begin(&state, c->from, c->to, c->ray, c->length);
    kernel->run(&state, f, c->length + 1);
    for (t = 0; t <= c->length; t++) worst = fmax(worst, fabs(ldexp(f[t], -(int)kernel->fraction_bits) - wanted_at(&w, t)));
    return worst;
}

/* As numbers beyond all bounds are none, they are made one. */
static double form_error(const paper_step *form, const paper_span *span, double psi)
{
    static double f[PAPER_PIXELS_MAX + 1];
    const wanted w = {psi, paper_dot(span->from, span->ray), paper_dot(span->to, span->ray), span->pixels};
    double worst = 0;
    unsigned t;
    form->run(span, f);
    for (t = 0; t <= span->pixels; t++) {
        const double error = fabs(f[t] - wanted_at(&w, t));
        if (!(error <= worst)) worst = error <= 1e30 ? error : 1e30;
    }
    return worst;
}

static view random_view(test_random *r)
{
    view v;
    v.phase = test_real(r, 0, 2 * ARC_PI);
    v.lift = test_real(r, 0, 1) < 0.5 ? 0 : test_real(r, 0, 1.4);
    return v;
}

static view sweep_view(int k)
{
    view v;
    v.phase = 2 * ARC_PI * (k + 0.1) / PHASES;
    v.lift = k & 1 ? 0.6 : 0;
    return v;
}

static double probe_kernel(const stability_subject *s, double x, double y, bool thorough, test_random *r)
{
    const compare_step_kernel *kernel = s->what;
    double worst = 0;
    int k;
    for (k = 0; k < (thorough ? PHASES : 1); k++) {
        const arc_vector ray = thorough || !strcmp(s->method, "reflection_map") ? fixed_ray : arc_random_unit(r);
        const view at = thorough ? sweep_view(k) : random_view(r);
        const arc_case c = span_of(ray, x * ARC_PI / 180, (unsigned)y, at, arc_random_unit(r));
        worst = fmax(worst, kernel_error(kernel, &c));
    }
    return worst;
}

static double probe_form(const stability_subject *s, double x, double y, bool thorough, test_random *r)
{
    const double psi = x * ARC_PI / 180;
    double worst = 0;
    int k;
    for (k = 0; k < (thorough ? PHASES / 2 : 1); k++) {
        const view at = thorough ? sweep_view(2 * k + 1) : random_view(r);
        const paper_span span = paper_span_flat(psi, (unsigned)y, at.phase, at.lift);
        worst = fmax(worst, form_error(s->what, &span, psi));
    }
    return worst;
}

/* The width of what a kernel carries from pixel to pixel, which its name says where there are several. */
static const char *arithmetic_of(const compare_step_kernel *kernel)
{
    if (strstr(kernel->name, "float")) return "float";
    return strstr(kernel->name, "16") || kernel->fraction_bits == 14 ? "16-bit" : "32-bit";
}

const stability_axes *stability_step_axes(void)
{
    static stability_axes axes = {.x_name = "psi", .x_unit = " deg", .y_name = "pixels", .y_unit = "", .y_whole = true};
    if (axes.columns) return &axes;
    axes.columns = stability_spread(axes.x, 43, 0.01, 179, false);
    axes.rows = stability_spread(axes.y, 25, 1, 4096, true);
    return &axes;
}

int stability_step_subjects(const stability_subject **out)
{
    static stability_subject subject[MOST];
    static int count;
    unsigned i;
    *out = subject;
    if (count) return count;
    for (i = 0; i < paper_step_count && count < MOST; i++) {
        const stability_subject s = {paper_steps[i].name, "double", &paper_steps[i], probe_form};
        subject[count++] = s;
    }
    for (i = 0; i < compare_step_count && count < MOST; i++) {
        const stability_subject s = {compare_steps[i].name, arithmetic_of(&compare_steps[i]), &compare_steps[i], probe_kernel};
        subject[count++] = s;
    }
    return count;
}

int stability_of_steps(stability_row *out, int room)
{
    const stability_subject *subject;
    const int count = stability_step_subjects(&subject);
    int i, n = 0;
    for (i = 0; i < count && n + 2 <= room; i++)
        n += stability_report(out + n, "span", stability_step_axes(), &subject[i], ATTACKS);
    return n;
}
