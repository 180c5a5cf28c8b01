/* SPDX-License-Identifier: MIT */
/* Triangles into spans: culling, the rows between the edges, terms at each span's first pixel (the two stages of paper 001:
 * prepare, here along the edges and over the triangle; shade, along the span, in the caller's loop).
 *
 * Whatever part of the frame the window shows, a pixel gets the same bits: planes are exact modulo 2^32 wherever they are
 * evaluated, and arcs are always stepped from the edge's top and the span's left end, seen or not.
 */
#include "triangle.h"

#include "edge.h"
#include "edge_arc.h"
#include "shade.h"
#include "step.h"

/* The plane of depth; where there is none, nobody asks for it. */
static lmb_plane *depth_of(lmb_triangle *t)
{
#if LMB_WITH_DEPTH
    return &t->depth;
#else
    return &t->u.light[0].diffuse;
#endif
}

#define DEPTH_MARGIN 4 /* keeps a rounded depth inside 16 bits */

/* From corners clockwise, top, middle and bottom; turns the array so that it begins with the top. From there the next one is on the
 * right side, the last on the left. */
static void corners_set(lmb_triangle *t, const lmb_vertex *clockwise[3])
{
    const lmb_vertex *top = clockwise[0], *right = clockwise[1], *left = clockwise[2], *was = top;
    if (left->y < top->y && left->y <= right->y) {
        top = left;
        left = right;
        right = was;
    } else if (right->y < top->y) {
        top = right;
        right = left;
        left = was;
    }
    clockwise[0] = t->corner[0] = top;
    clockwise[1] = right;
    clockwise[2] = left;
    t->long_right = left->y < right->y;
    t->corner[1] = t->long_right ? left : right;
    t->corner[2] = t->long_right ? right : left;
}

static bool on_screen(const lmb_vertex *v)
{
    return v->x >= -LMB_SCREEN_MAX && v->x <= LMB_SCREEN_MAX && v->y >= -LMB_SCREEN_MAX && v->y <= LMB_SCREEN_MAX;
}

/* Whether the corners run counter-clockwise with y up, wherever they are: up to 2047 pixels from each other in 32 bits. */
static bool is_front(const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c)
{
    int32_t bx = lmb_sub(b->x, a->x), by = lmb_sub(b->y, a->y), cx = lmb_sub(c->x, a->x), cy = lmb_sub(c->y, a->y);
    uint32_t half = 0x8000, reach = ((uint32_t)bx + half) | ((uint32_t)by + half) | ((uint32_t)cx + half) | ((uint32_t)cy + half);
    if (reach >> 16) return lmb_product_less(bx, cy, cx, by);
    return lmb_mul(bx, cy) < lmb_mul(cx, by);
}

/* False if no column of the window can be inside. */
static bool in_columns(lmb_triangle *t, const lmb_vertex *const corner[3], const lmb_window *window)
{
    int32_t low = lmb_min(lmb_min(corner[0]->x, corner[1]->x), corner[2]->x);
    int32_t high = lmb_max(lmb_max(corner[0]->x, corner[1]->x), corner[2]->x);
    low = lmb_row_at(low); /* columns round as rows do */
    high = lmb_row_at(high);
    t->inside = low >= window->left && high <= window->right;
    return t->inside || (high > window->left && low < window->right);
}

/* -----------------------------------------------------------------------------------------------------------------------
 * set-up */

/* Walks a side, 0 the left one and 1 the right, from one of the sorted corners to another; the first row to be shown is t->y. */
static void side_begin(lmb_triangle *t, unsigned side, unsigned from, unsigned to)
{
    const lmb_vertex *top = t->corner[from], *bottom = t->corner[to];
    lmb_edge_begin(&t->walk.edge[side], top, bottom, t->y);
    if (LMB_WITH_ARC && t->kind == LMB_SPAN_ARC) { lmb_edge_arc_begin(t, side, top, bottom); }
}

static void depth_begin(lmb_triangle *t, lmb_lattice *lattice)
{
    lmb_net net;
    unsigned i;
    net.curved = false;
    for (i = 0; i < 3; i++) {
        int32_t depth = lattice->corner[i]->depth;
        net.value[i] = lmb_shl(lmb_max(DEPTH_MARGIN, lmb_min(depth, 65535 - DEPTH_MARGIN)), 12);
    }
    lmb_plane_begin(depth_of(t), lattice, &net);
}

/* Terms, at the first row. */
static void terms_begin(lmb_triangle *t, const lmb_vertex *const corner[3])
{
    lmb_lattice lattice;
    int32_t rows;
    unsigned i;
    lmb_shade_begin(t, &lattice, corner);
    if (LMB_WITH_DEPTH && t->depth_on) depth_begin(t, &lattice);
    t->rough = lattice.ready && lattice.rough;
    if (!lattice.ready) return;
    t->column = lattice.column;
    rows = lmb_sub(t->y, lattice.row);
    if (rows == 0) return;
    for (i = 0; i < lmb_look_lights(t->look) && t->kind == LMB_SPAN_PLANE; i++) {
        if (lmb_bit(t->diffuse_on, i)) lmb_plane_down(&t->u.light[i].diffuse, rows);
        if (lmb_bit(t->specular_on, i)) lmb_plane_down(&t->u.light[i].specular, rows);
    }
    if (LMB_WITH_DEPTH && t->depth_on) lmb_plane_down(depth_of(t), rows);
}

void lmb_triangle_turn(lmb_triangle *t) { side_begin(t, !t->long_right, 1, 2); }

void lmb_triangle_walk(lmb_triangle *t)
{
    const unsigned lower = t->y >= t->y_switch;
    t->walked = LMB_WALKED_EDGES;
    side_begin(t, t->long_right, 0, 2);
    side_begin(t, !t->long_right, lower, lower + 1);
}

bool lmb_triangle_front(lmb_triangle *t, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c, const lmb_window *window)
{
    const lmb_vertex *clockwise[3];
    clockwise[0] = a;
    clockwise[1] = c;
    clockwise[2] = b;
    if (!t->inside && !in_columns(t, clockwise, window)) return false;
    corners_set(t, clockwise);
    t->y = lmb_max(lmb_row_at(t->corner[0]->y), window->top);
    t->y_end = lmb_min(lmb_row_at(t->corner[2]->y), window->bottom);
    if (t->y >= t->y_end) return false;
    t->y_switch = lmb_row_at(t->corner[1]->y);
    t->depth_on = LMB_WITH_DEPTH && window->depth;
    t->window_left = window->left;
    t->window_right = window->right;
    t->walked = 0;
    terms_begin(t, clockwise);
    return true;
}

bool lmb_triangle_seen(lmb_triangle *t, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c, const lmb_window *window)
{
    t->inside = false;
    return is_front(a, b, c) && lmb_triangle_front(t, a, b, c, window);
}

bool lmb_triangle_begin(lmb_triangle *t, const lmb_look *look, const lmb_rays *rays, const lmb_vertex *a, const lmb_vertex *b,
                        const lmb_vertex *c, const lmb_window *window)
{
    t->look = look;
    t->rays = rays;
    return on_screen(a) && on_screen(b) && on_screen(c) && lmb_triangle_seen(t, a, b, c, window);
}

/* ------------------------------------------------------------------------------------------------------------------------
 * spans */

static void plane_span(const lmb_triangle *t, lmb_span *span)
{
    const int32_t columns = lmb_sub(span->x, t->column);
    unsigned i;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        if (lmb_bit(t->diffuse_on, i)) span->diffuse[i] = lmb_plane_term(&t->u.light[i].diffuse, columns);
        if (lmb_bit(t->specular_on, i)) span->specular[i] = lmb_plane_term(&t->u.light[i].specular, columns);
        span->exponent[i] = t->exponent[i];
    }
}

static void flat_span(const lmb_triangle *t, lmb_span *span)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        span->diffuse[i].f = t->u.light[i].diffuse.f;
        span->specular[i].f = t->u.light[i].specular.f;
        span->diffuse[i].d = span->diffuse[i].c = span->specular[i].d = span->specular[i].c = 0;
        span->exponent[i] = t->exponent[i];
    }
}

static void row_step(lmb_triangle *t)
{
    unsigned i;
    lmb_edge_step(&t->walk.edge[0]);
    lmb_edge_step(&t->walk.edge[1]);
    t->y = lmb_add(t->y, 1);
    for (i = 0; i < lmb_look_lights(t->look) && t->kind == LMB_SPAN_PLANE; i++) {
        if (lmb_bit(t->diffuse_on, i)) lmb_plane_row(&t->u.light[i].diffuse);
        if (lmb_bit(t->specular_on, i)) lmb_plane_row(&t->u.light[i].specular);
    }
    if (LMB_WITH_DEPTH && t->depth_on) lmb_plane_row(depth_of(t));
    if (LMB_WITH_ARC && t->kind == LMB_SPAN_ARC) { lmb_edge_arc_step(t); }
    if (t->y == t->y_switch && t->y < t->y_end) lmb_triangle_turn(t);
}

bool lmb_triangle_next(lmb_triangle *t, lmb_span *span)
{
    bool found = false;
    if (t->walked != LMB_WALKED_EDGES && t->y < t->y_end) lmb_triangle_walk(t);
    while (!found && t->y < t->y_end) {
        int32_t x = lmb_max(t->walk.edge[0].x, t->window_left), length = lmb_sub(lmb_min(t->walk.edge[1].x, t->window_right), x);
        found = length > 0;
        if (found) {
            span->x = (int16_t)x;
            span->y = (int16_t)t->y;
            span->length = (uint16_t)length;
            span->kind = t->kind;
            span->diffuse_on = t->diffuse_on;
            span->specular_on = t->specular_on;
            if (LMB_WITH_ARC && t->kind == LMB_SPAN_ARC) {
                lmb_edge_arc_span(t, span, lmb_sub(x, t->walk.edge[0].x));
            } else if ((LMB_WITH_CORNERS || LMB_WITH_PLANS) && t->kind == LMB_SPAN_FLAT) {
                flat_span(t, span);
            } else if (LMB_WITH_PIXELS || LMB_WITH_GOURAUD) {
                plane_span(t, span);
            }
            if (LMB_WITH_DEPTH && t->depth_on) span->depth = lmb_plane_term(depth_of(t), lmb_sub(x, t->column));
        }
        row_step(t);
    }
    return found;
}
