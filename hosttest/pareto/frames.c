/* SPDX-License-Identifier: MIT */
/* What frames err by: triangles and spans as the library hands them out, terms by its own inline steps, looked up or reckoned as
 * the filler does, and no pixel. Coverage is that of the reference to the pixel (test_image). */
#include "errors.h"

#include "../../firmware/step.h"

#include <stdio.h>
#include <stdlib.h>

#define ONE_Q15 32768.0

/* One frame on its way: the intensities of the nearest surface. */
typedef struct canvas {
    double (*rgb)[3];
    uint16_t *depth;
    bool *painted;
    int width, height;
} canvas;

static void *room(size_t count, size_t bytes)
{
    void *p = calloc(count, bytes);
    if (!p) {
        fprintf(stderr, "pareto: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return p;
}

static void canvas_begin(canvas *c, const scene *s, double (*rgb)[3], bool *painted)
{
    const size_t pixels = (size_t)s->width * (size_t)s->height;
    size_t i;
    c->width = s->width;
    c->height = s->height;
    c->rgb = rgb;
    c->painted = painted;
    c->depth = room(pixels, sizeof *c->depth);
    for (i = 0; i < pixels; i++) {
        c->depth[i] = 65535;
        painted[i] = false;
    }
}

/* ----------------------------------------------------------------------------------------------------------------------- ours */

/* N.L and the lobe at a pixel. A step of a ramp stands for its middle. */
static void lit_ramped(const lmb_paint *paint, int32_t diffuse, int32_t argument, unsigned exponent, double lit[2])
{
    const int32_t step = diffuse >> 24, index = step < 0 ? 0 : step < LMB_RAMP_TOP ? step : LMB_RAMP_TOP - 1;
    const uint32_t gleam = (uint32_t)argument >> (22 - exponent);
    lit[0] = fmin(512 * index + 256, ONE_Q15) / ONE_Q15;
    lit[1] = 0;
    if (argument > 0) lit[1] = lmb_look_ramp_at(&paint->look, 0, gleam < LMB_GLEAM ? (2 * gleam + 1) << 21 : 1u << 30) / ONE_Q15;
}

static double intensity(int32_t f_q30) { return fmin(fmax(f_q30 >> 15, 0), ONE_Q15) / ONE_Q15; }

static void lit_reckoned(const lmb_look *look, int32_t diffuse, int32_t specular, unsigned exponent, double lit[2])
{
    lit[0] = intensity(diffuse);
    lit[1] = 0;
    if (look->model != LMB_MODEL_GLOSS) {
        lit[1] = intensity(specular);
    } else if (specular > 0) {
        const int32_t s = (specular >> (14 - exponent)) + look->light[0].dark_q16;
        lit[1] = lmb_lobe_at(&look->lobe, s) / ONE_Q15;
    }
}

static void put(canvas *c, const lmb_look *look, size_t pixel, const double lit[2])
{
    int k;
    for (k = 0; k < 3; k++) {
        const double sum =
            look->ambient_q15[k] + look->light[0].diffuse_q15[k] * lit[0] + look->light[0].specular_q15[k] * lit[1];
        c->rgb[pixel][k] = fmin(sum / ONE_Q15, 1);
    }
    c->painted[pixel] = true;
}

static void step(const lmb_span *span, lmb_term *term)
{
    if (span->kind == LMB_SPAN_PLANE) lmb_plane_step(term);
    if (span->kind == LMB_SPAN_ARC) lmb_arc_step(&span->arc, term);
}

static bool is_nearer(canvas *c, size_t pixel, int32_t depth_f)
{
    const int32_t now = depth_f >> 14;
    if (now >= c->depth[pixel]) return false;
    c->depth[pixel] = (uint16_t)(now < 0 ? 0 : now);
    return true;
}

static void paint_span(canvas *c, const lmb_paint *paint, const lmb_span *span, bool deep)
{
    static const lmb_term off = {0, 0, 0};
    lmb_term diffuse = span->diffuse_on ? span->diffuse[0] : off, specular = span->specular_on ? span->specular[0] : off;
    lmb_term depth = span->depth;
    const unsigned exponent = span->specular_on ? span->exponent[0] : 0;
    size_t pixel = (size_t)span->y * (size_t)c->width + (size_t)span->x;
    unsigned i;
    for (i = 0; i < span->length; i++, pixel++) {
        const int32_t argument = span->kind == LMB_SPAN_ARC ? lmb_add_wrap(specular.f, specular.c) : specular.f;
        double lit[2];
        if (!deep || is_nearer(c, pixel, depth.f)) {
            if (paint->ramped) lit_ramped(paint, diffuse.f, argument, exponent, lit);
            if (!paint->ramped) lit_reckoned(&paint->look, diffuse.f, argument, exponent, lit);
            put(c, &paint->look, pixel, lit);
        }
        if (span->diffuse_on) step(span, &diffuse);
        if (span->specular_on) step(span, &specular);
        if (deep) lmb_plane_step(&depth);
    }
}

static lmb_vertex *project(const scene *s)
{
    const scene_object *o = &s->object[0];
    lmb_vertex *vertices = room(o->mesh->vertices, sizeof *vertices);
    lmb_mesh_project(o->mesh, &o->pose, &s->camera, vertices);
    return vertices;
}

static lmb_window window_of(const scene *s)
{
    lmb_window w = {0, 0, 0, 0, false};
    w.right = (int16_t)s->width;
    w.bottom = (int16_t)s->height;
    w.depth = s->depth;
    return w;
}

static void paint_scene(canvas *c, const scene *s, const lmb_paint *paint)
{
    const scene_object *o = &s->object[0];
    const lmb_window window = window_of(s);
    lmb_vertex *vertices = project(s);
    lmb_walk walk;
    lmb_triangle triangle;
    lmb_span span;
    lmb_mesh_begin(&walk, o->mesh, &o->pose, &s->camera, &paint->look, &window, vertices, NULL);
    while (lmb_mesh_next(&walk, &triangle)) {
        while (lmb_triangle_next(&triangle, &span)) paint_span(c, paint, &span, s->depth);
    }
    free(vertices);
}

/* ------------------------------------------------------------------------------------------------------------------ the truth */

void pareto_truth_begin(pareto_truth *truth, const scene *s)
{
    truth->s = s;
    ref_same_model(&truth->frame, s, LMB_MODEL_GLOSS, LMB_STEP_ARC);
}

void pareto_truth_end(pareto_truth *truth) { ref_frame_end(&truth->frame); }

static double apart(const ref_fragment *fragment, const double rgb[3])
{
    double most = 0;
    int k;
    for (k = 0; k < 3; k++) most = fmax(most, fabs(rgb[k] - (double)fragment->rgb[k]));
    return most;
}

/* Of surfaces whose depths cannot be told apart the one that was painted counts: the closest (reference_judge.c). */
static const ref_fragment *fragment_of(const ref_frame *frame, size_t pixel, const double rgb[3])
{
    const ref_fragment *layer = frame->fragment + pixel * REF_LAYERS, *best = layer;
    int k;
    for (k = 1; k < frame->layers[pixel] && layer[k].depth - layer[0].depth <= frame->slack; k++) {
        if (apart(&layer[k], rgb) < apart(best, rgb)) best = &layer[k];
    }
    return best;
}

void pareto_frame_intensities(double (*rgb)[3], bool *painted, const scene *s, enum lmb_format format,
                              const pareto_method *method)
{
    static lmb_paint paint;
    canvas c;
    if (!pareto_paint(&paint, s, format, method)) {
        fprintf(stderr, "pareto: no paint for %s\n", method->name);
        exit(EXIT_FAILURE);
    }
    canvas_begin(&c, s, rgb, painted);
    paint_scene(&c, s, &paint);
    free(c.depth);
}

void pareto_frame_errors(pareto_errors *e, const pareto_truth *truth, enum lmb_format format, const pareto_method *method)
{
    const ref_frame *frame = &truth->frame;
    const size_t pixels = (size_t)frame->width * (size_t)frame->height;
    double(*rgb)[3] = room(pixels, sizeof *rgb);
    bool *painted = room(pixels, sizeof *painted);
    size_t i;
    int k;
    pareto_frame_intensities(rgb, painted, truth->s, format, method);
    for (i = 0; i < pixels; i++) {
        const ref_fragment *wanted;
        if (painted[i] != (frame->layers[i] > 0)) {
            fprintf(stderr, "pareto: pixel %lu is painted by one alone\n", (unsigned long)i);
            exit(EXIT_FAILURE);
        }
        if (!painted[i]) continue;
        wanted = fragment_of(frame, i, rgb[i]);
        for (k = 0; k < 3; k++) pareto_add(e, rgb[i][k] - (double)wanted->rgb[k]);
    }
    free(rgb);
    free(painted);
}
