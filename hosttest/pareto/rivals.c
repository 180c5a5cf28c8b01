/* SPDX-License-Identifier: MIT */
/* What frames of the comparisons err by: the sums that they pack, told pixel by pixel as they draw (COMPARE_TAPPED). They draw
 * the same pixels in the same order as the library does, which says where each is; that what was told is what was stored is
 * checked. */
#include "errors.h"

#include <stdio.h>
#include <stdlib.h>

#define SIDE 240
#define VERTICES 1200

void compare_tap(double red, double green, double blue);

static struct {
    double rgb[SIDE * SIDE][3]; /* levels */
    size_t count;
} told;

void compare_tap(double red, double green, double blue)
{
    double *rgb = told.rgb[told.count < SIDE * SIDE ? told.count++ : 0];
    rgb[0] = red;
    rgb[1] = green;
    rgb[2] = blue;
}

static void fail(const char *name, const char *what)
{
    fprintf(stderr, "pareto: %s %s\n", name, what);
    exit(EXIT_FAILURE);
}

/* The level that is stored: rounded, and no more than there are. */
static unsigned level(double x, double top) { return (unsigned)fmin(fmax(floor(x + 0.5), 0), top); }

static unsigned packed(const double rgb[3]) { return level(rgb[0], 31) << 11 | level(rgb[1], 63) << 5 | level(rgb[2], 31); }

static void add(pareto_errors *e, const ref_frame *frame, size_t pixel, const double rgb[3])
{
    static const double top[3] = {31, 63, 31};
    int k;
    for (k = 0; k < 3; k++) {
        const double got = fmin(fmax(rgb[k] / top[k], 0), 1);
        pareto_add(e, got - (double)frame->fragment[pixel * REF_LAYERS].rgb[k]);
    }
}

/* Goes through the pixels in the order in which they were drawn. */
static void walk(pareto_errors *e, const pareto_truth *truth, const lmb_surface *surface, const lmb_vertex *vertices,
                 const char *name)
{
    const scene *s = truth->s;
    const scene_object *o = &s->object[0];
    const uint16_t *pixels = surface->pixels;
    lmb_look look;
    lmb_walk walk;
    lmb_triangle triangle;
    lmb_span span;
    size_t next = 0;
    if (lmb_look_prepare(&look, &o->material, s->light, 1, LMB_MODEL_DIFFUSE, LMB_STEP_LINEAR)) fail(name, "has no look");
    lmb_mesh_begin(&walk, o->mesh, &o->pose, &s->camera, &look, &surface->window, vertices, NULL);
    while (lmb_mesh_next(&walk, &triangle)) {
        while (lmb_triangle_next(&triangle, &span)) {
            size_t pixel = (size_t)span.y * (size_t)s->width + (size_t)span.x;
            unsigned i;
            for (i = 0; i < span.length; i++, pixel++, next++) {
                if (next >= told.count || packed(told.rgb[next]) != pixels[pixel]) fail(name, "draws other pixels than it tells");
                add(e, &truth->frame, pixel, told.rgb[next]);
            }
        }
    }
    if (next != told.count) fail(name, "draws more pixels than the library");
}

bool pareto_rival_errors(pareto_errors *e, const pareto_truth *truth, const compare_frame *rival)
{
    static uint16_t pixels[SIDE * SIDE];
    static lmb_vertex vertices[VERTICES];
    static compare_room room[VERTICES];
    static compare_look look;
    const scene *s = truth->s;
    const scene_object *o = &s->object[0];
    lmb_surface surface;
    if (s->depth || s->width > SIDE || o->mesh->vertices > VERTICES || compare_look_prepare(&look, &o->material, s->light))
        return false;
    lmb_surface_strip(&surface, LMB_RGB565, pixels, NULL, s->width, 0, s->height);
    lmb_mesh_project(o->mesh, &o->pose, &s->camera, vertices);
    told.count = 0;
    if (!rival->draw(&surface, o->mesh, &o->pose, &look, vertices, room)) return false;
    walk(e, truth, &surface, vertices, rival->name);
    return true;
}
