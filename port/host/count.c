/* SPDX-License-Identifier: MIT */
/* Counts what a frame costs: draws it strip by strip as lmb_draw_mesh does, and before each triangle is filled walks its rows to see
 * which loop will draw it and what that will meet on the way. */
#include "count.h"

#include <stdlib.h>

#include "../run.h"
#include "../sides.h"

#include "../../firmware/screen.h"

/* ------------------------------------------------------------------------------------------------------------- once a frame */

/* Steps of Shell's sort of n triangles by keys, as lmb_mesh_sort takes them. */
static void count_sort(const int16_t *keys, uint32_t n)
{
    uint32_t *order = malloc(n * sizeof *order), gap = 1, i, j, moving;
    if (!order) return;
    for (i = 0; i < n; i++) order[i] = i;
    while (gap < n) gap = gap * 3 + 1;
    for (; gap > 0; gap /= 3) {
        for (i = gap; i < n; i++) {
            moving = order[i];
            for (j = i; j >= gap && keys[order[j - gap]] > keys[moving]; j -= gap) order[j] = order[j - gap];
            order[j] = moving;
            cost_add(COST_SORT_STEP, 1);
            cost_add(COST_SORT_MOVE, (i - j) / gap);
        }
    }
    cost_add(COST_SORT_KEY, n);
    free(order);
}

/* ------------------------------------------------------------------------------------------------------------- once a strip */

static bool misses(const lmb_window *w, int32_t a, int32_t b, int32_t c)
{
    const int32_t above = w->top * 16 + 8, below = w->bottom * 16 - 7;
    return lmb_max(lmb_max(a, b), c) <= above || lmb_min(lmb_min(a, b), c) >= below;
}

/* What lmb_mesh_begin looks at to see whether triangles can simply be read. */
static void count_scan(const lmb_walk *walk)
{
    const lmb_window *w = walk->window;
    const lmb_vertex *v = walk->vertices, *const begin = v, *const end = v ? v + walk->screen.mesh->vertices : v;
    if (!v || walk->order || walk->look->model == LMB_MODEL_FLAT) return;
    while (v != end && v->x >= w->left * 16 && v->x <= w->right * 16 && v->y >= w->top * 16 && v->y <= w->bottom * 16) v++;
    cost_add(COST_SCAN, (double)(v - begin) + 1);
    if (v == end) return;
    for (v = begin; v != end && v->x >= w->left * 16 && v->x <= w->right * 16; v++) {}
    cost_add(COST_SCAN_COLUMNS, (double)(v - begin) + 1);
}

/* Triangles read in a strip, and those of them that the rows of their corners tell to be above or below it. */
static void count_read(const lmb_walk *walk, bool plain)
{
    const lmb_mesh *mesh = walk->screen.mesh;
    cost_counts *const counting = cost_counting;
    double missed = 0;
    uint32_t i;
    cost_counting = NULL;
    for (i = 0; walk->strip && i < mesh->triangles; i++) {
        int32_t y[3];
        unsigned k;
        bool off = false;
        for (k = 0; k < 3; k++) {
            const uint16_t vertex = mesh->indices[3 * i + k];
            y[k] = walk->vertices ? walk->vertices[vertex].y : lmb_screen_y(&walk->screen, vertex);
            off = off || (walk->vertices && walk->vertices[vertex].x == LMB_NOT_ON_SCREEN);
        }
        missed += !off && misses(walk->window, y[0], y[1], y[2]);
    }
    cost_counting = counting;
    if (plain) {
        cost_add(walk->strip ? COST_READ_STRIP : COST_READ, mesh->triangles);
        cost_add(COST_MET, walk->strip ? mesh->triangles - missed : 0);
    } else {
        cost_add(COST_READ_ANY, mesh->triangles);
        cost_add(COST_MET_ANY, mesh->triangles - missed);
        if (walk->order) cost_add(COST_READ_ORDERED, mesh->triangles);
        if (walk->look->model == LMB_MODEL_FLAT) cost_add(COST_FACE, mesh->triangles - missed);
    }
}

static void count_strip(const lmb_walk *walk)
{
    const bool plain = walk->plain != walk->end;
    cost_add(COST_STRIP, 1);
    cost_add(COST_WALKED, 1);
    if (!walk->vertices) cost_add(COST_STRIP_ANEW, 1);
    cost_add(COST_RAYS, walk->look->lights);
    if (walk->look->step >= LMB_STEP_ARC) cost_add(COST_BEAMS, walk->look->lights);
    count_scan(walk);
    count_read(walk, plain);
}

/* ---------------------------------------------------------------------------------------------------------- once a triangle */

/* How a triangle is filled by rows. */
typedef struct rows {
    enum cost_loop loop;
    bool by_runs;  /* depth by runs */
    int32_t glare; /* argument from where on sums may run over */
    bool carries;  /* each sum that runs over is found so */
} rows;

static bool is_curved(const lmb_plane *plane) { return (plane->bow | plane->dxy | plane->dyy) != 0; }

/* The first step of the highlight whose sum with a step of diffuse light runs over, up to most. */
static int32_t runs_over_from(const lmb_paint *paint, int32_t diffuse, int32_t most)
{
    int32_t i;
    for (i = 0; i < most && !carries_565(paint->ramp[diffuse], paint->ramp[LMB_RAMP_TOP + i]); i++) {}
    return i;
}

/* One light by ramps: what fill_highlight and fill_diffuse of rows.c choose. */
static rows rows_of_ramps(const lmb_surface *surface, const lmb_paint *paint, const lmb_triangle *t)
{
    rows r = {LOOP_SOLID, surface->depth != NULL, 0, false};
    const int32_t ramp = t->high >> (RAMP_SHIFT - 2), gleam = t->specular_on ? t->gleam >> (GLEAM_SHIFT - 2 - t->exponent[0]) : 0;
    const bool even = t->inside && !t->rough && ramp < LMB_RAMP_TOP - 1, low = t->low >> (RAMP_SHIFT - 2) < 1;
    const bool scaled = low || t->exponent[0], curved = t->diffuse_on && is_curved(&t->u.light[0].diffuse);
    if (!t->diffuse_on && !t->specular_on) {
        r.loop = t->inside && !surface->depth && is_small(t) ? LOOP_SOLID : LOOP_SOLID_ANY;
    } else if (!t->specular_on) {
        r.by_runs = surface->depth != NULL;
        r.loop = !even            ? LOOP_PLAIN_ANY
                 : surface->depth ? LOOP_PLAIN_DEEP
                 : low            ? LOOP_PLAIN_LOW
                 : curved         ? LOOP_PLAIN
                                  : LOOP_PLAIN_STRAIGHT;
    } else if (!even || gleam >= LMB_GLEAM_TOP - 4) {
        r.loop = LOOP_LIT_ANY;
        r.carries = true;
    } else {
        const bool bright = scaled || carries_565(paint->ramp[ramp + 1], paint->ramp[LMB_RAMP_TOP + gleam + 4]);
        r.by_runs = false;
        r.carries = surface->depth ? bright : scaled;
        r.loop = surface->depth ? (bright ? LOOP_LIT_DEEP_BRIGHT : LOOP_LIT_DEEP)
                 : scaled       ? LOOP_LIT_SCALED
                 : bright       ? LOOP_LIT_BRIGHT
                 : curved       ? LOOP_LIT
                                : LOOP_LIT_STRAIGHT;
        if (r.loop == LOOP_LIT_BRIGHT) r.glare = runs_over_from(paint, ramp + 1, gleam + 4) * ((int32_t)1 << GLEAM_SHIFT);
    }
    return r;
}

/* Whether a triangle is filled by rows, and how. */
static bool choose_rows(rows *r, const lmb_surface *surface, const lmb_paint *paint, const lmb_triangle *t)
{
    const rows solid = {t->inside && !surface->depth && is_small(t) ? LOOP_SOLID : LOOP_SOLID_ANY, surface->depth != NULL, 0,
                        false};
    if (surface->format != LMB_RGB565) return false;
    if (paint->ramped && t->kind == LMB_SPAN_PLANE) {
        *r = rows_of_ramps(surface, paint, t);
        return true;
    }
    *r = solid;
    if (lmb_paint_is_simple(paint)) {
        cost_add(COST_LEVEL_COLOUR, t->kind == LMB_SPAN_FLAT);
        return t->kind == LMB_SPAN_FLAT;
    }
    if (paint->look.model == LMB_MODEL_FLAT || !(t->diffuse_on | t->specular_on)) {
        cost_add(COST_FLAT_COLOUR, 1);
        cost_add(COST_FLAT_LIGHT, paint->look.lights);
        return true;
    }
    r->loop = t->specular_on ? LOOP_CORNERS : LOOP_CORNERS_DULL;
    return paint->look.model == LMB_MODEL_GOURAUD && paint->look.lights == 1;
}

/* The depth buffer's row at a span, at its first pixel; NULL for none. */
static const uint16_t *depth_at(const lmb_surface *surface, const lmb_span *span)
{
    const lmb_window *w = &surface->window;
    return surface->depth ? surface->depth + (ptrdiff_t)(span->y - w->top) * (w->right - w->left) + (span->x - w->left) : NULL;
}

/* Whether Gouraud's pixels of a run may be clamped (corners_even of corner.h). */
static bool may_clamp(const lmb_paint *paint, const lmb_term *d, const lmb_term *s, uint32_t n, bool lit)
{
    const int64_t last_d = d->f + (int64_t)(n - 1) * d->d, last_s = s->f + (int64_t)(n - 1) * s->d;
    const int64_t most_d = (d->f > last_d ? d->f : last_d) >> 15, most_s = lit ? (s->f > last_s ? s->f : last_s) >> 15 : 0;
    unsigned k;
    if (d->f < 0 || last_d < 0 || (lit && (s->f < 0 || last_s < 0)) || most_d > 32768 || most_s > 32768) return true;
    for (k = 0; k < 3; k++) {
        const int64_t sum = paint->ambient[k] + paint->light[0].diffuse[k] * most_d + paint->light[0].specular[k] * most_s;
        if (sum >> 30) return true;
    }
    return false;
}

/* How often the fraction of a term carries into its intensity along a run (corner_run_even). */
static double carries_of(const lmb_term *term, double pixels)
{
    const uint64_t steps = pixels > 0 ? (uint64_t)pixels - 1 : 0;
    return (double)(((uint64_t)((uint32_t)term->f << 17) + steps * ((uint32_t)term->d << 17)) >> 32);
}

/* What a pixel of ramps comes to: 0 without a highlight, 1 with one, 2 where its sum runs over. */
static int gleam_of(const lmb_paint *paint, const rows *r, int32_t diffuse, int32_t argument, unsigned shift)
{
    if (argument <= 0) return 0;
    if (r->loop == LOOP_LIT_BRIGHT) return argument < r->glare ? 1 : 2;
    if (!r->carries) return 1;
    return carries_565(paint->ramp[ramp_step(diffuse, RAMP_UNEVEN)],
                       paint->ramp[LMB_RAMP_TOP + gleam_step(argument, shift, false)])
               ? 2
               : 1;
}

/* One row of a triangle that is filled by rows. */
static void count_row(const lmb_surface *surface, const lmb_paint *paint, const rows *r, const lmb_span *span)
{
    static const lmb_term none = {0, 0, 0};
    lmb_term d = span->diffuse_on ? span->diffuse[0] : none, s = span->specular_on ? span->specular[0] : none, z = span->depth;
    const uint16_t *depth = depth_at(surface, span);
    const unsigned shift = (unsigned)(GLEAM_SHIFT - (span->specular_on ? span->exponent[0] : 0));
    const bool corners = r->loop == LOOP_CORNERS || r->loop == LOOP_CORNERS_DULL,
               lit = span->specular_on && !corners && span->kind != LMB_SPAN_FLAT;
    double seen = 0, hidden = 0, gleams = 0, more = 0, runs = 0;
    bool was_seen = false;
    uint32_t i;
    for (i = 0; i < span->length; i++) {
        const bool is_seen = !depth || z.f >> 14 < depth[i];
        seen += is_seen;
        hidden += !is_seen;
        runs += is_seen && !was_seen;
        if (is_seen && lit) {
            const int gleam = gleam_of(paint, r, d.f, s.f, shift);
            gleams += gleam > 0;
            more += gleam == 2;
        }
        was_seen = is_seen;
        if (lit) {
            lmb_plane_step(&d);
            lmb_plane_step(&s);
        }
        lmb_plane_step(&z);
    }
    if (corners && may_clamp(paint, &d, &s, span->length, span->specular_on)) {
        more = seen;
    } else if (corners) {
        gleams = carries_of(&d, seen) + (span->specular_on ? carries_of(&s, seen) : 0);
    }
    cost_add(cost_of(r->loop, LOOP_pixel), seen);
    cost_add(cost_of(r->loop, LOOP_gleam), gleams);
    cost_add(cost_of(r->loop, LOOP_more), more);
    cost_add(cost_of(r->loop, LOOP_run), r->by_runs ? runs : 1);
    if (!depth) return;
    if (r->by_runs && r->loop != LOOP_PLAIN_DEEP) {
        cost_add(COST_DEPTH_ROW, 1);
        cost_add(COST_DEPTH_PIXEL, seen);
        cost_add(COST_DEPTH_HIDDEN, hidden);
    } else {
        cost_add(cost_of(r->loop, LOOP_hidden), hidden);
    }
}

/* A triangle about to be filled. */
static void count_triangle(const lmb_surface *surface, const lmb_paint *paint, const lmb_triangle *t)
{
    cost_counts *const counting = cost_counting;
    lmb_triangle copy = *t;
    lmb_span span;
    uint32_t spans = 0, pixels = 0;
    rows r = {LOOP_SOLID, false, 0, false};
    const bool by_rows = choose_rows(&r, surface, paint, t);
    if (by_rows) {
        cost_add(COST_FILLED, 1);
        cost_add(cost_of(r.loop, LOOP_triangle), 1);
        cost_add(cost_of(r.loop, LOOP_row), t->y_end - t->y);
        if (r.loop == LOOP_LIT_BRIGHT) cost_add(COST_GLARE, 1);
    } else {
        cost_add(COST_SPANNED, 1);
    }
    for (;;) {
        bool found;
        cost_counting = NULL; /* this walk is ours, not the library's */
        found = inside_lmb_triangle_next(&copy, &span);
        cost_counting = counting;
        if (!found) break;
        spans++;
        pixels += span.length;
        if (by_rows) count_row(surface, paint, &r, &span);
    }
    counting->spans += spans;
    counting->pixels += pixels;
}

/* --------------------------------------------------------------------------------------------------------------- by spans */

/* Whether a span has one colour: is_level of fill.c. */
static bool has_one_colour(const lmb_paint *paint, const lmb_span *span)
{
    unsigned i;
    if (span->kind != LMB_SPAN_PLANE) return span->kind == LMB_SPAN_FLAT;
    for (i = 0; i < paint->look.lights; i++) {
        if (span->diffuse_on >> i & 1 && (span->diffuse[i].d | span->diffuse[i].c)) return false;
        if (span->specular_on >> i & 1 && (span->specular[i].d | span->specular[i].c)) return false;
    }
    return true;
}

static enum cost_loop loop_of_span(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span)
{
    const bool arc = span->kind == LMB_SPAN_ARC, lit = span->specular_on, simple = lmb_paint_is_simple(paint);
    if (simple && surface->format == LMB_RGB565)
        return arc ? (lit ? LOOP_SPAN_ARC_LIT : LOOP_SPAN_ARC) : lit ? LOOP_SPAN_LIT : LOOP_SPAN_PLAIN;
    if (has_one_colour(paint, span)) return surface->format == LMB_RGB565 ? LOOP_SPAN_SOLID : LOOP_SPAN_888_SOLID;
    if (!simple) return LOOP_SPAN_GENERAL;
    return arc ? (lit ? LOOP_SPAN_888_ARC_LIT : LOOP_SPAN_888_ARC) : lit ? LOOP_SPAN_888_LIT : LOOP_SPAN_888;
}

/* A term one pixel on. */
static void step(const lmb_span *span, lmb_term *term)
{
    if (span->kind == LMB_SPAN_PLANE) lmb_plane_step(term);
    if (span->kind == LMB_SPAN_ARC) lmb_arc_step(&span->arc, term);
}

/* Highlights at one pixel: how many, and what costs more. */
static void count_gleams(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span, const lmb_term *d,
                         const lmb_term *s, double *gleams, double *more)
{
    const bool ramped = paint->ramped, gloss = paint->look.model == LMB_MODEL_GLOSS;
    const rows every = {LOOP_SPAN_LIT, false, 0, true};
    unsigned i;
    (void)surface;
    for (i = 0; i < paint->look.lights; i++) {
        const int32_t argument = span->kind == LMB_SPAN_ARC ? lmb_add_wrap(s[i].f, s[i].c) : s[i].f;
        if (!(span->specular_on >> i & 1) || !gloss || argument <= 0) continue;
        (*gleams)++;
        if (ramped) {
            *more += gleam_of(paint, &every, d[i].f, argument, (unsigned)(GLEAM_SHIFT - span->exponent[i])) == 2;
        } else {
            *more += paint->look.lobe.multiplications;
        }
    }
}

void count_span(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span)
{
    const enum cost_loop loop = loop_of_span(surface, paint, span);
    const bool solid = loop == LOOP_SPAN_SOLID || loop == LOOP_SPAN_888_SOLID;
    const uint16_t *depth = depth_at(surface, span);
    lmb_term d[LMB_LIGHTS] = {{0, 0, 0}}, s[LMB_LIGHTS] = {{0, 0, 0}}, z = span->depth;
    double seen = 0, hidden = 0, left = 0, gleams = 0, more = 0, runs = 0, terms = 0;
    bool was_seen = false;
    uint32_t n;
    unsigned i;
    for (i = 0; i < paint->look.lights; i++) {
        if (span->diffuse_on >> i & 1) d[i] = span->diffuse[i], terms++;
        if (span->specular_on >> i & 1) s[i] = span->specular[i], terms++;
    }
    for (n = 0; n < span->length; n++) {
        const bool is_seen = !depth || z.f >> 14 < depth[n];
        seen += is_seen;
        hidden += !is_seen;
        runs += is_seen && !was_seen;
        if (is_seen) left = hidden;
        if (is_seen && (!solid || !was_seen)) count_gleams(surface, paint, span, d, s, &gleams, &more);
        was_seen = is_seen;
        for (i = 0; i < paint->look.lights; i++) {
            step(span, &d[i]);
            step(span, &s[i]);
        }
        lmb_plane_step(&z);
    }
    cost_add(cost_of(loop, LOOP_row), 1);
    cost_add(cost_of(loop, LOOP_pixel), seen);
    cost_add(cost_of(loop, LOOP_gleam), gleams);
    cost_add(cost_of(loop, LOOP_more), more);
    if (solid) {
        cost_add(COST_LIGHTS_SPAN, runs * paint->look.lights);
        cost_add(COST_TERM_SPAN, runs * terms);
    }
    if (loop == LOOP_SPAN_ARC_LIT && (depth || !arc_stays_dark(&span->arc, &span->specular[0], span->length))) {
        cost_add(COST_GLEAM_WALKED, seen);
    }
    if (loop == LOOP_SPAN_GENERAL) {
        cost_add(COST_LIGHTS_PIXEL, seen * paint->look.lights);
        cost_add(span->kind == LMB_SPAN_ARC ? COST_TERM_PIXEL_ARC : COST_TERM_PIXEL, seen * terms);
    }
    if (!depth) return;
    cost_add(COST_SPAN_DEPTH, 1);
    cost_add(cost_of(loop, LOOP_run), runs);
    cost_add(COST_SPAN_DEPTH_PIXEL, seen);
    cost_add(COST_SPAN_DEPTH_HIDDEN, hidden);
    cost_add(COST_STEP_HIDDEN, left * paint->look.lights);
    if (span->kind != LMB_SPAN_FLAT)
        cost_add(span->kind == LMB_SPAN_ARC ? COST_STEP_HIDDEN_ARC : COST_STEP_HIDDEN_TERM, left * terms);
}

/* ------------------------------------------------------------------------------------------------------------------ frames */

typedef struct memory {
    lmb_vertex *vertices;
    uint8_t *pixels;
    uint16_t *depth, *order;
    int16_t *keys;
} memory;

static bool memory_get(memory *m, const cost_frame *f)
{
    const size_t strip = (size_t)f->width * (size_t)f->rows;
    m->vertices = f->anew ? NULL : malloc(f->mesh->vertices * sizeof *m->vertices + 1);
    m->pixels = malloc(strip * 3);
    m->depth = f->depth ? malloc(strip * sizeof *m->depth) : NULL;
    m->order = f->painter ? malloc(f->mesh->triangles * sizeof *m->order) : NULL;
    m->keys = f->painter ? malloc(f->mesh->triangles * sizeof *m->keys) : NULL;
    return (f->anew || m->vertices) && m->pixels && (!f->depth || m->depth) && (!f->painter || (m->order && m->keys));
}

static void memory_free(memory *m)
{
    free(m->vertices);
    free(m->pixels);
    free(m->depth);
    free(m->order);
    free(m->keys);
}

static void draw_strip(const cost_frame *f, const memory *m, int top, int bottom)
{
    static const lmb_rgb black = {0, 0, 0};
    lmb_surface surface;
    lmb_walk walk;
    lmb_triangle triangle;
    lmb_surface_strip(&surface, (enum lmb_format)f->paint->format, m->pixels, m->depth, f->width, top, bottom);
    lmb_clear(&surface, black);
    lmb_mesh_begin(&walk, f->mesh, f->pose, f->camera, &f->paint->look, &surface.window, m->vertices, m->order);
    count_strip(&walk);
    while (lmb_mesh_next(&walk, &triangle)) {
        cost_counting->drawn++;
        count_triangle(&surface, f->paint, &triangle);
        lmb_fill_triangle(&surface, f->paint, &triangle);
    }
}

/* What is chosen for the triangles of the whole frame. */
static void count_chosen(lmb_statistics *chosen, const cost_frame *f)
{
    const lmb_window all = {0, 0, (int16_t)f->width, (int16_t)f->height, false};
    lmb_walk walk;
    cost_counting = NULL; /* nobody draws it */
    lmb_mesh_begin(&walk, f->mesh, f->pose, f->camera, &f->paint->look, &all, NULL, NULL);
    lmb_mesh_statistics(&walk, chosen);
}

int cost_count(cost_counts *counts, const cost_frame *f)
{
    static const cost_counts none;
    memory m;
    lmb_screen screen = {.mesh = f->mesh, .pose = f->pose, .camera = f->camera};
    int top, result = memory_get(&m, f) ? 0 : -1;
    *counts = none;
    cost_counting = counts;
    if (!result && f->painter) result = lmb_mesh_sort(f->mesh, f->pose, m.order, m.keys);
    if (!result && f->painter) count_sort(m.keys, f->mesh->triangles);
    if (!result && m.vertices) {
        lmb_screen_begin(&screen);
        cost_add(COST_PROJECTION, 1);
        cost_add(screen.direct ? COST_VERTEX : f->camera->perspective ? COST_VERTEX_FAR : COST_VERTEX_LARGE, f->mesh->vertices);
        lmb_mesh_project(f->mesh, f->pose, f->camera, m.vertices);
    }
    for (top = 0; top < f->height && !result; top += f->rows) draw_strip(f, &m, top, lmb_min(top + f->rows, f->height));
    count_chosen(&counts->chosen, f);
    memory_free(&m);
    return result;
}
