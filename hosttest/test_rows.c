/* SPDX-License-Identifier: MIT */
/* lmb_fill_triangle stores exactly what lmb_fill_span stores span by span, for any triangle, window, material, format and light.
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
    const bool edge = one_in(random, 4);
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
        d->s.v[i].depth = (uint16_t)test_next(random);
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
    d->depth = one_in(random, 4);
    d->s.window.depth = d->depth;
    random_paint(random, d);
    random_normals(random, d);
}

/* A surface with something on it, and the depth of half of it behind what is to come. */
static void background(const drawing *d, memory *m, size_t spare)
{
    const int width = width_of(&d->s.window), height = height_of(&d->s.window);
    int i;
    memory_surface(m, d->format, d->s.window, spare, d->depth);
    lmb_clear(&m->surface, rgb(77, 99, 55));
    for (i = 0; d->depth && i < width * height; i++) m->surface.depth[i] = (uint16_t)(i * 40503);
}

static uint32_t by_spans(const drawing *d, const lmb_surface *surface)
{
    lmb_triangle t;
    lmb_span span;
    uint32_t pixels = 0;
    if (!lmb_triangle_begin(&t, &d->paint.paint.look, &d->rays, &d->s.v[0], &d->s.v[1], &d->s.v[2], &surface->window)) return 0;
    while (lmb_triangle_next(&t, &span)) {
        lmb_fill_span(surface, &d->paint.paint, &span);
        pixels += span.length;
    }
    return pixels;
}

static uint32_t by_triangle(const drawing *d, const lmb_surface *surface)
{
    lmb_triangle t;
    if (!lmb_triangle_begin(&t, &d->paint.paint.look, &d->rays, &d->s.v[0], &d->s.v[1], &d->s.v[2], &surface->window)) return 0;
    return lmb_fill_triangle(surface, &d->paint.paint, &t);
}

static void describe(const drawing *d)
{
    int i;
    shape_print(&d->s);
    for (i = 0; i < 3; i++) printf("  normal %d %d %d", d->s.v[i].normal.x, d->s.v[i].normal.y, d->s.v[i].normal.z);
    printf("  light %d %d %d, n = %d\n", d->light[0].direction.x, d->light[0].direction.y, d->light[0].direction.z,
           d->paint.paint.look.lobe.shininess);
}

/* Draws both ways and compares; returns the number of pixels. */
typedef struct verdict {
    int differ, miscounted, spilt;
} verdict;

static uint32_t compare(const drawing *d, size_t spare, verdict *v)
{
    static memory spans, whole;
    uint32_t a, b;
    background(d, &spans, spare);
    background(d, &whole, spare);
    a = by_spans(d, &spans.surface);
    b = by_triangle(d, &whole.surface);
    v->miscounted += a != b;
    v->spilt += memory_spilt(&whole) != 0;
    if (memcmp(spans.pixels, whole.pixels, sizeof whole.pixels) || memcmp(spans.depth, whole.depth, sizeof whole.depth)) {
        if (!v->differ++) describe(d);
    }
    return a;
}

static const char *const model_names[] = {"flat", "gouraud", "diffuse", "gloss"};
static const char *const step_names[] = {"linear", "quadratic", "arc"};

static void test_rows(test_random *random, int format, int model, int step, bool several)
{
    static drawing d;
    const bool looked_up = format == LMB_RGB565 && !several && model >= LMB_MODEL_DIFFUSE && step != LMB_STEP_ARC;
    verdict v = {0, 0, 0};
    uint64_t pixels = 0;
    int i;
    d.format = format;
    d.model = model;
    d.step = step;
    for (i = 0; i < (looked_up ? 20000 : 500); i++) { /* most of them where rows have loops of their own */
        const size_t spare = one_in(random, 2) ? 0 : (size_t)test_integer(random, 0, 20);
        d.lights = several ? (unsigned)test_integer(random, 2, LMB_LIGHTS) : 1;
        random_drawing(random, &d);
        pixels += compare(&d, spare, &v);
    }
    test_verdict(!v.differ && !v.miscounted && !v.spilt, "rows: a triangle is stored as its spans are",
                 "%s, %s, %s, %s: of %d triangles, %" PRIu64 " pixels, %d differ, %d counted otherwise, %d spilt",
                 model_names[model], step_names[step], format_name(format), several ? "several lights" : "one light", i, pixels,
                 v.differ, v.miscounted, v.spilt);
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
    verdict v = {0, 0, 0};
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
        d.light[0].direction = known[i].light;
        d.light[0].colour = rgb(255, 255, 255);
        if (lmb_look_prepare(&look, &material, d.light, 1, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC)) abort();
        memset(&d.paint, GUARD, sizeof d.paint);
        lmb_paint_prepare(&d.paint.paint, &look, LMB_RGB565);
        lmb_rays_prepare(&d.rays, &d.paint.paint.look, NULL);
        pixels += compare(&d, 0, &v);
    }
    test_verdict(!v.differ && !v.miscounted && !v.spilt && pixels > 0, "rows: terms that leave their ramps",
                 "of %u triangles, %" PRIu64 " pixels, %d differ, %d counted otherwise, %d spilt", i, pixels, v.differ,
                 v.miscounted, v.spilt);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    int i;
    test_known();
    for (i = 0; i < 48; i++) test_rows(&random, i & 1, i / 4 % 4, i / 16, i >> 1 & 1);
    return test_end();
}
