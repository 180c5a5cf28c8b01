/* SPDX-License-Identifier: MIT */
/* lmb_fill_triangle and lmb_fill_span store exactly what a loop stores that tests, lights and steps one pixel after the other, for any
 * triangle, window, depth, material, format and light.
 *
 * The paint stands between patterns, so that a step of a ramp that is not there shows. */
#include "guarded.h"
#include "shapes.h"

#define PATTERN 64

typedef struct guarded_paint {
    uint32_t before[PATTERN];
    lmb_paint paint;
    uint32_t after[PATTERN];
} guarded_paint;

/* What is drawn, one triangle after the other. */
typedef struct drawing {
    guarded_paint paint;
    lmb_light light[LMB_LIGHTS];
    lmb_rays rays;
    shape s;
    int format, model, step;
    unsigned lights;
    bool depth;
    int runs; /* log2 of the length of runs of equal depth */
} drawing;

static bool one_in(test_random *random, int n) { return test_integer(random, 1, n) == 1; }

/* Any colour; and black, white and full primaries. */
static lmb_rgb any_colour(test_random *random)
{
    const int64_t bits = test_integer(random, 0, 7);
    if (one_in(random, 2)) return random_colour(random);
    return rgb(bits & 1 ? 255 : 0, bits & 2 ? 255 : 0, bits & 4 ? 255 : 0);
}

static void random_paint(test_random *random, drawing *d)
{
    lmb_material material;
    lmb_look look;
    unsigned i;
    material.ambient = one_in(random, 2) ? rgb(9, 6, 3) : any_colour(random);
    material.diffuse = any_colour(random);
    material.specular = any_colour(random);
    material.shininess = (uint16_t)exp(test_real(random, 0, log(LMB_SHININESS_MAX + 0.9)));
    for (i = 0; i < d->lights; i++) {
        d->light[i].direction = random_unit(random);
        d->light[i].colour = one_in(random, 2) ? rgb(255, 255, 255) : any_colour(random);
    }
    if (lmb_look_prepare(&look, &material, d->light, d->lights, (enum lmb_model)d->model, (enum lmb_step_kind)d->step)) abort();
    if (one_in(random, 4)) lmb_look_lobe(&look, (enum lmb_lobe_kind)test_integer(random, 0, 4), 3000);
    memset(&d->paint, GUARD, sizeof d->paint);
    lmb_paint_prepare(&d->paint.paint, &look, (enum lmb_format)d->format);
    lmb_rays_prepare(&d->rays, &d->paint.paint.look, NULL);
}

/* At a right angle to the light, but for rounding: where N.L changes its sign. */
static lmb_vec grazing(test_random *random, lmb_vec l)
{
    const lmb_vec off = random_unit(random);
    double along = ((double)l.x * off.x + (double)l.y * off.y + (double)l.z * off.z) / 268435456.0;
    return unit(off.x - along * l.x, off.y - along * l.y, off.z - along * l.z);
}

/* Normals within an angle of one direction; some about the half vector, some at the edge of the light, some lit from there on. */
static void random_normals(test_random *random, drawing *d)
{
    const double spread = exp(test_real(random, log(0.01), log(1.5)));
    const lmb_vec half = d->rays.light[0].half, light = d->light[0].direction;
    const bool edge = one_in(random, 4), level = one_in(random, 8); /* one normal */
    const lmb_vec axis = edge ? grazing(random, light) : one_in(random, 2) ? half : random_unit(random);
    int i, first = (int)test_integer(random, 0, 2);
    for (i = 0; i < 3; i++) {
        const lmb_vec off = random_unit(random);
        const double r = tan(spread * test_real(random, 0, 0.999)), up = edge && i != first ? 1.5 * r : 0;
        const double part = edge && i == first ? 0 : r;
        d->s.v[i].normal = unit(axis.x + part * off.x + up * light.x, axis.y + part * off.y + up * light.y,
                                axis.z + part * off.z + up * light.z);
        if (one_in(random, 20)) d->s.v[i].normal = grazing(random, light);
        if (one_in(random, 20)) d->s.v[i].normal = half;
        if (level) d->s.v[i].normal = d->s.v[0].normal;
        d->s.v[i].depth = (uint16_t)test_next(random);
        if (one_in(random, 4)) d->s.v[i].depth = one_in(random, 2) ? 0 : 65535;
    }
}

static void random_drawing(test_random *random, drawing *d)
{
    static const int shapes[] = {SHAPE_ORDINARY, SHAPE_ORDINARY, SHAPE_TINY, SHAPE_SLIVER, SHAPE_ALIGNED, SHAPE_FAR, SHAPE_HUGE};
    memset(&d->s, 0, sizeof d->s);
    do {
        d->s.window = random_window(random);
        shape_classes[shapes[test_integer(random, 0, 6)]].make(random, &d->s);
        if (!is_front(d->s.v)) swap_corners(&d->s, 1, 2);
    } while (!is_front(d->s.v));
    d->depth = one_in(random, 2);
    d->runs = (int)test_integer(random, 0, 6);
    d->s.window.depth = d->depth;
    random_paint(random, d);
    random_normals(random, d);
}

/* The surface of memory that has been copied. */
static void memory_move(memory *m)
{
    m->surface.pixels = m->pixels + m->pixels_at;
    if (m->surface.depth) m->surface.depth = m->depth + m->depth_at;
}

/* A surface with something on it, and depth in runs of any length, half of it behind what is to come. */
static void background(const drawing *d, memory *m, size_t spare)
{
    const int width = width_of(&d->s.window), height = height_of(&d->s.window);
    int i;
    memory_surface(m, d->format, d->s.window, spare, d->depth);
    lmb_clear(&m->surface, rgb(77, 99, 55));
    for (i = 0; d->depth && i < width * height; i++) m->surface.depth[i] = (uint16_t)((i >> d->runs) * 40503);
}

/* --------------------------------------------------------------------------------------------------------------- pixel by pixel */

/* Intensity, UQ1.15, of a term. */
static int64_t intensity_of(int32_t f) { return f < 0 ? 0 : f >> 15 > 32768 ? 32768 : f >> 15; }

/* Two ramps, added and saturated channel by channel. */
static uint32_t looked_up(const lmb_paint *paint, int32_t diffuse, int64_t argument, unsigned exponent)
{
    const int64_t step = argument >> (22 - exponent);
    const int colour = diffuse < 0 ? 0 : diffuse >> 24 > 71 ? 71 : diffuse >> 24;
    const uint32_t a = paint->ramp[colour], b = argument > 0 ? paint->ramp[LMB_RAMP_TOP + (step > 287 ? 287 : step)] : 0;
    uint32_t red = (a >> 11) + (b >> 11), green = (a >> 5 & 63) + (b >> 5 & 63), blue = (a & 31) + (b & 31);
    return (red > 31 ? 31 : red) << 11 | (green > 63 ? 63 : green) << 5 | (blue > 31 ? 31 : blue);
}

static int64_t highlight_of(const lmb_look *look, const lmb_span *span, unsigned i)
{
    const int32_t argument = span->specular[i].f + (span->kind == LMB_SPAN_ARC ? span->specular[i].c : 0);
    if (look->model != LMB_MODEL_GLOSS) return intensity_of(span->specular[i].f);
    if (argument <= 0) return 0;
    return lmb_lobe_at(&look->lobe, (argument >> (14 - span->exponent[i])) + look->light[i].dark_q16);
}

/* A channel as a sum, of which nothing is lost. */
static uint32_t summed(const drawing *d, const lmb_span *span, int channel)
{
    const lmb_paint *paint = &d->paint.paint;
    const int top = top_of(d->format, channel);
    int64_t sum = paint->ambient[channel];
    unsigned i;
    for (i = 0; i < d->lights; i++) {
        if (span->diffuse_on >> i & 1) sum += paint->light[i].diffuse[channel] * intensity_of(span->diffuse[i].f);
        if (span->specular_on >> i & 1) sum += paint->light[i].specular[channel] * highlight_of(&paint->look, span, i);
    }
    sum >>= top == 255 ? 22 : top == 63 ? 24 : 25;
    return (uint32_t)(sum > top ? top : sum);
}

static void pixel_store(const drawing *d, const lmb_surface *surface, const lmb_span *span)
{
    uint8_t *at = (uint8_t *)surface->pixels + (size_t)(span->y - surface->window.top) * surface->pitch +
                  (size_t)(span->x - surface->window.left) * (d->format == LMB_RGB565 ? 2 : 3);
    uint32_t pixel;
    int i;
    if (d->format == LMB_RGB888) {
        for (i = 0; i < 3; i++) at[i] = (uint8_t)summed(d, span, i);
        return;
    }
    if (d->lights == 1 && d->model >= LMB_MODEL_DIFFUSE) {
        const int64_t argument = span->specular[0].f + (int64_t)(span->kind == LMB_SPAN_ARC ? span->specular[0].c : 0);
        pixel = looked_up(&d->paint.paint, span->diffuse_on ? span->diffuse[0].f : 0, span->specular_on ? argument : 0,
                          span->specular_on ? span->exponent[0] : 0);
    } else {
        pixel = summed(d, span, 0) << 11 | summed(d, span, 1) << 5 | summed(d, span, 2);
    }
    at[0] = (uint8_t)pixel;
    at[1] = (uint8_t)(pixel >> 8);
}

/* One pixel to the right. */
static void span_step(const drawing *d, lmb_span *span)
{
    unsigned i;
    for (i = 0; i < d->lights && span->kind != LMB_SPAN_FLAT; i++) {
        if (span->kind == LMB_SPAN_ARC) {
            lmb_arc_step(&span->arc, &span->diffuse[i]);
            if (span->specular_on >> i & 1) lmb_arc_step(&span->arc, &span->specular[i]);
        } else {
            if (span->diffuse_on >> i & 1) lmb_plane_step(&span->diffuse[i]);
            if (span->specular_on >> i & 1) lmb_plane_step(&span->specular[i]);
        }
    }
    if (d->depth) lmb_plane_step(&span->depth);
    span->x++;
}

/* Nearer wins. */
static bool pixel_seen(const lmb_surface *surface, const lmb_span *span)
{
    const lmb_window *w = &surface->window;
    const int32_t depth = span->depth.f >> 14;
    uint16_t *stored = surface->depth + (span->y - w->top) * (w->right - w->left) + (span->x - w->left);
    if (depth >= *stored) return false;
    *stored = (uint16_t)(depth < 0 ? 0 : depth);
    return true;
}

static uint32_t by_pixels(const drawing *d, const lmb_surface *surface)
{
    lmb_triangle t;
    lmb_span span;
    uint32_t pixels = 0;
    if (!lmb_triangle_begin(&t, &d->paint.paint.look, &d->rays, &d->s.v[0], &d->s.v[1], &d->s.v[2], &surface->window)) return 0;
    while (lmb_triangle_next(&t, &span)) {
        for (; span.length > 0; span.length--, pixels++) {
            if (!d->depth || pixel_seen(surface, &span)) pixel_store(d, surface, &span);
            span_step(d, &span);
        }
    }
    return pixels;
}

/* ------------------------------------------------------------------------------------------------------------ by the library */

static void by_spans(const drawing *d, const lmb_surface *surface)
{
    lmb_triangle t;
    lmb_span span;
    if (!lmb_triangle_begin(&t, &d->paint.paint.look, &d->rays, &d->s.v[0], &d->s.v[1], &d->s.v[2], &surface->window)) return;
    while (lmb_triangle_next(&t, &span)) lmb_fill_span(surface, &d->paint.paint, &span);
}

static void by_triangle(const drawing *d, const lmb_surface *surface)
{
    lmb_triangle t;
    if (!lmb_triangle_begin(&t, &d->paint.paint.look, &d->rays, &d->s.v[0], &d->s.v[1], &d->s.v[2], &surface->window)) return;
    lmb_fill_triangle(surface, &d->paint.paint, &t);
}

static void describe(const drawing *d)
{
    int i;
    shape_print(&d->s);
    for (i = 0; i < 3; i++) printf("  normal %d %d %d", d->s.v[i].normal.x, d->s.v[i].normal.y, d->s.v[i].normal.z);
    printf("  light %d %d %d, n = %d\n", d->light[0].direction.x, d->light[0].direction.y, d->light[0].direction.z,
           d->paint.paint.look.lobe.shininess);
}

static bool same(const memory *a, const memory *b)
{
    return !memcmp(a->pixels, b->pixels, sizeof a->pixels) && !memcmp(a->depth, b->depth, sizeof a->depth);
}

/* Draws each way and compares; returns the number of pixels. */
typedef struct verdict {
    int differ, spilt;
} verdict;

static uint32_t compare(const drawing *d, size_t spare, verdict *v)
{
    static memory pixels, spans, whole;
    uint32_t drawn;
    background(d, &pixels, spare);
    spans = whole = pixels;
    memory_move(&spans);
    memory_move(&whole);
    drawn = by_pixels(d, &pixels.surface);
    by_spans(d, &spans.surface);
    by_triangle(d, &whole.surface);
    v->spilt += memory_spilt(&spans) || memory_spilt(&whole);
    if (!same(&pixels, &spans) || !same(&pixels, &whole)) {
        if (!v->differ++) describe(d);
    }
    return drawn;
}

static const char *const model_names[] = {"flat", "gouraud", "diffuse", "gloss"};
static const char *const step_names[] = {"linear", "quadratic", "arc", "planned"};

static void test_rows(test_random *random, int format, int model, int step, bool several)
{
    static drawing d;
    const bool fast = format == LMB_RGB565 && !several;
    verdict v = {0, 0};
    uint64_t pixels = 0;
    int i;
    d.format = format;
    d.model = model;
    d.step = step;
    for (i = 0; i < (!fast                  ? 400
                     : step == LMB_STEP_ARC ? 4000
                                            : 8000);
         i++) { /* most of them where there are loops of their own */
        const size_t spare = one_in(random, 2) ? 0 : (size_t)test_integer(random, 0, 20);
        d.lights = several ? (unsigned)test_integer(random, 2, LMB_LIGHTS) : 1;
        random_drawing(random, &d);
        pixels += compare(&d, spare, &v);
    }
    test_verdict(!v.differ && !v.spilt, "rows: a triangle and its spans are stored as pixel by pixel",
                 "%s, %s, %s, %s: of %d triangles, %" PRIu64 " pixels, %d differ, %d spilt", model_names[model], step_names[step],
                 format_name(format), several ? "several lights" : "one light", i, pixels, v.differ, v.spilt);
}

/* Triangles whose terms leave what their corners and bulges bound them by, where ramps end: N.L just below zero where no corner
 * is unlit; a faint highlight, of which little shows, far above its centre; terms in the corner of the world that wrap. */
static void test_known(void)
{
    static const struct {
        lmb_vertex v[3];
        lmb_vec light;
        uint16_t shininess;
        uint8_t specular;
        int16_t left, top;
    } known[] = {
        {{{3464, 232, {-6421, 6868, 13418}, 0}, {3624, 488, {14256, -929, 8021}, 0}, {3688, 536, {9733, 2622, 12916}, 0}},
         {-7326, -8332, 12056},
         10,
         0,
         216,
         18},
        {{{24, 168, {13857, -1813, 8552}, 0}, {40, 184, {12689, 9661, 3755}, 0}, {216, 88, {3080, 3122, 15786}, 0}},
         {14413, -1933, -7548},
         344,
         3,
         0,
         0},
        {{{-454116, 420198, {-3501, -10284, 12265}, 0},
          {-384279, 284730, {-3719, -9834, 12566}, 0},
          {-524272, 291984, {-3729, -9922, 12494}, 0}},
         {-5534, -15263, 2205},
         623,
         200,
         -28644,
         20769},
        {{{-420061, 338248, {2175, -6349, 14947}, 0},
          {-420609, 325275, {7937, -12197, 7527}, 0},
          {-431570, 332236, {-2536, -8862, 13545}, 0}},
         {4001, -3108, 15581},
         253,
         0,
         -26505,
         20745},
    };
    static drawing d;
    verdict v = {0, 0};
    uint64_t pixels = 0;
    unsigned i, k;
    for (i = 0; i < sizeof known / sizeof *known; i++) {
        const lmb_material material = {
            {10, 20, 30}, {200, 180, 160}, {known[i].specular, known[i].specular, known[i].specular}, known[i].shininess};
        lmb_look look;
        memset(&d.s, 0, sizeof d.s);
        for (k = 0; k < 3; k++) d.s.v[k] = known[i].v[k];
        if (!is_front(d.s.v)) swap_corners(&d.s, 1, 2);
        d.s.window = window_of(known[i].left, known[i].top, known[i].left + SIDE, known[i].top + SIDE);
        d.format = LMB_RGB565;
        d.model = LMB_MODEL_GLOSS;
        d.lights = 1;
        d.light[0].direction = known[i].light;
        d.light[0].colour = rgb(255, 255, 255);
        if (lmb_look_prepare(&look, &material, d.light, 1, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC)) abort();
        memset(&d.paint, GUARD, sizeof d.paint);
        lmb_paint_prepare(&d.paint.paint, &look, LMB_RGB565);
        lmb_rays_prepare(&d.rays, &d.paint.paint.look, NULL);
        pixels += compare(&d, 0, &v);
    }
    test_verdict(!v.differ && !v.spilt && pixels > 0, "rows: terms that leave their ramps",
                 "of %u triangles, %" PRIu64 " pixels, %d differ, %d spilt", i, pixels, v.differ, v.spilt);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    int i;
    test_known();
    for (i = 0; i < 64; i++) test_rows(&random, i & 1, i / 4 % 4, i / 16, i >> 1 & 1);
    return test_end();
}
