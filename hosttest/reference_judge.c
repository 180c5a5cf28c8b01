/* SPDX-License-Identifier: MIT */
/* Draws scenes with the library and judges the frames against references. */
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const ref_variant ref_variants[REF_VARIANTS] = {
    {"flat", LMB_MODEL_FLAT, -1, LMB_LOBE_TUNED},
    {"gouraud", LMB_MODEL_GOURAUD, -1, LMB_LOBE_TUNED},
    {"diffuse", LMB_MODEL_DIFFUSE, -1, LMB_LOBE_TUNED},
    {"gloss-linear", LMB_MODEL_GLOSS, LMB_STEP_LINEAR, LMB_LOBE_TUNED},
    {"gloss-quadratic", LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, LMB_LOBE_TUNED},
    {"gloss-arc", LMB_MODEL_GLOSS, LMB_STEP_ARC, LMB_LOBE_TUNED},
    {"gloss-planned", LMB_MODEL_GLOSS, LMB_STEP_PLANNED, LMB_LOBE_TUNED},
    {"gloss", LMB_MODEL_GLOSS, -1, LMB_LOBE_TUNED},
    {"gloss-w2", LMB_MODEL_GLOSS, -1, LMB_LOBE_W2},
    {"gloss-w4", LMB_MODEL_GLOSS, -1, LMB_LOBE_W4},
    {"gloss-w8", LMB_MODEL_GLOSS, -1, LMB_LOBE_W8},
    {"gloss-w16", LMB_MODEL_GLOSS, -1, LMB_LOBE_W16},
};

enum lmb_step_kind ref_step_of(const ref_variant *v, const scene *s)
{
    return v->step < 0 ? s->step : (enum lmb_step_kind)v->step;
}

int ref_top(enum lmb_format format, int channel) { return format == LMB_RGB888 ? 255 : channel == 1 ? 63 : 31; }

void ref_visible(uint8_t *rgb, const uint8_t *levels, size_t pixels, enum lmb_format format)
{
    size_t i;
    for (i = 0; i < 3 * pixels; i++) {
        int top = ref_top(format, (int)(i % 3));
        rgb[i] = (uint8_t)((levels[i] * 255 + top / 2) / top);
    }
}

static void *room(size_t bytes)
{
    void *p = malloc(bytes);
    if (!p) {
        fprintf(stderr, "reference: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return p;
}

/* ----------------------------------------------------------------------------------------------------------------------- draw */

/* scene_draw with another lobe than the tuned one. */
static void draw_lobe(const scene *s, const lmb_surface *surface, const ref_variant *v)
{
    unsigned i;
    lmb_clear(surface, s->background);
    for (i = 0; i < s->objects; i++) {
        const scene_object *o = &s->object[i];
        lmb_look look;
        lmb_paint paint;
        if (lmb_look_prepare(&look, &o->material, s->light, s->lights, v->model, ref_step_of(v, s))) return;
        if (lmb_look_lobe(&look, v->lobe, 0)) return;
        lmb_paint_prepare(&paint, &look, (enum lmb_format)surface->format);
        lmb_draw_mesh(surface, o->mesh, &o->pose, &s->camera, &paint, NULL, NULL);
    }
}

static uint64_t draw_over(uint8_t *levels, scene s, lmb_rgb background, const ref_variant *v, enum lmb_format format)
{
    size_t pixels = (size_t)s.width * (size_t)s.height, i;
    uint8_t *bytes = room(pixels * lmb_format_bytes(format));
    uint16_t *depth = s.depth ? room(pixels * sizeof *depth) : NULL;
    lmb_surface surface;
    uint64_t shaded;
    s.background = background;
    lmb_surface_strip(&surface, format, bytes, depth, s.width, 0, s.height);
    if (v->lobe == LMB_LOBE_TUNED) {
        scene_draw(&s, &surface, v->model, ref_step_of(v, &s));
    } else {
        draw_lobe(&s, &surface, v);
    }
    shaded = scene_pixels(&s, &surface.window);
    if (format == LMB_RGB888) memcpy(levels, bytes, pixels * 3);
    for (i = 0; i < pixels && format == LMB_RGB565; i++) {
        unsigned word = (unsigned)(bytes[2 * i] | bytes[2 * i + 1] << 8);
        levels[3 * i] = (uint8_t)(word >> 11);
        levels[3 * i + 1] = (uint8_t)(word >> 5 & 63u);
        levels[3 * i + 2] = (uint8_t)(word & 31u);
    }
    free(bytes);
    free(depth);
    return shaded;
}

void ref_draw_variant(ref_drawn *drawn, const scene *s, const ref_variant *v, enum lmb_format format)
{
    static const lmb_rgb other = {237, 235, 229};
    size_t pixels = (size_t)s->width * (size_t)s->height, i;
    uint8_t *over = room(pixels * 3);
    drawn->width = s->width;
    drawn->height = s->height;
    drawn->format = format;
    drawn->levels = room(pixels * 3);
    drawn->painted = room(pixels * sizeof *drawn->painted);
    drawn->shaded = draw_over(drawn->levels, *s, s->background, v, format);
    draw_over(over, *s, other, v, format);
    for (i = 0; i < pixels; i++) drawn->painted[i] = !memcmp(over + 3 * i, drawn->levels + 3 * i, 3);
    free(over);
}

void ref_draw(ref_drawn *drawn, const scene *s, enum lmb_model model, enum lmb_step_kind step, enum lmb_format format)
{
    const ref_variant v = {"", model, (int)step, LMB_LOBE_TUNED};
    ref_draw_variant(drawn, s, &v, format);
}

void ref_drawn_end(ref_drawn *drawn)
{
    free(drawn->levels);
    free(drawn->painted);
}

/* ---------------------------------------------------------------------------------------------------------------------- judge */

static int largest_error(const ref_fragment *fragment, const uint8_t drawn[3], enum lmb_format format, int wanted[3])
{
    int largest = 0, c;
    for (c = 0; c < 3; c++) {
        wanted[c] = (int)floor((double)fragment->rgb[c] * ref_top(format, c) + 0.5);
        largest = abs(drawn[c] - wanted[c]) > largest ? abs(drawn[c] - wanted[c]) : largest;
    }
    return largest;
}

/* The layer that is taken for the nearest: the closest to what was drawn of those within the slack. */
static int choose(const ref_frame *frame, size_t pixel, const uint8_t drawn[3], enum lmb_format format)
{
    const ref_fragment *layer = frame->fragment + pixel * REF_LAYERS;
    int best = 0, k, wanted[3], least = largest_error(layer, drawn, format, wanted);
    for (k = 1; k < frame->layers[pixel] && layer[k].depth - layer[0].depth <= frame->slack; k++) {
        int error = largest_error(&layer[k], drawn, format, wanted);
        if (error < least) {
            least = error;
            best = k;
        }
    }
    return best;
}

static void judge_pixel(ref_score *score, const ref_frame *frame, const ref_drawn *drawn, size_t pixel, uint8_t *levels,
                        double *sum)
{
    const uint8_t *got = drawn->levels + 3 * pixel;
    int layer = choose(frame, pixel, got, drawn->format), wanted[3], error, c;
    const ref_fragment *fragment = &frame->fragment[pixel * REF_LAYERS + (size_t)layer];
    error = largest_error(fragment, got, drawn->format, wanted);
    score->pixels++;
    score->ambiguous += layer > 0;
    score->within_1 += error <= 1;
    for (c = 0; c < 3; c++) {
        double part = (double)(got[c] - wanted[c]) / ref_top(drawn->format, c);
        *sum += part * part;
        if (levels) levels[3 * pixel + (size_t)c] = (uint8_t)wanted[c];
    }
    if (error <= score->max_error) return;
    score->max_error = error;
    score->x = (int)(pixel % (size_t)frame->width);
    score->y = (int)(pixel / (size_t)frame->width);
    score->triangle = fragment->triangle;
    for (c = 0; c < 3; c++) {
        score->drawn[c] = got[c];
        score->wanted[c] = wanted[c];
    }
}

void ref_judge(ref_score *score, const ref_frame *frame, const ref_drawn *drawn, uint8_t *levels)
{
    size_t pixels = (size_t)frame->width * (size_t)frame->height, i;
    double sum = 0;
    memset(score, 0, sizeof *score);
    if (levels) memcpy(levels, drawn->levels, pixels * 3);
    for (i = 0; i < pixels; i++) {
        if (drawn->painted[i] != (frame->layers[i] > 0)) {
            score->coverage_mismatch++;
        } else if (drawn->painted[i]) {
            judge_pixel(score, frame, drawn, i, levels, &sum);
        }
    }
    score->share_within_1 = score->pixels ? (double)score->within_1 / (double)score->pixels : 1;
    score->psnr_db = sum > 0 ? fmin(99, -10 * log10(sum / (3 * (double)score->pixels))) : 99;
}
