/* SPDX-License-Identifier: MIT */
/* Triangles into spans: culling, the rows between the edges, terms at each span's first pixel (the two stages of paper 001:
 * prepare, here along the edges and over the triangle; shade, along the span, in the caller's loop).
 *
 * Whatever part of the frame the window shows, a pixel gets the same bits: planes are exact modulo 2^32 wherever they are
 * evaluated, and arcs are always stepped from the edge's top and the span's left end, seen or not.
 */
#include "edge.h"
#include "shade.h"
#include "step.h"

#define DEPTH_MARGIN 4 /* keeps a rounded depth inside 16 bits */

static bool on_screen(int32_t q4) { return (uint32_t)q4 + (uint32_t)LMB_SCREEN_MAX <= 2 * (uint32_t)LMB_SCREEN_MAX; }

/* Top, middle, bottom. Returns whether an odd number of swaps was needed, which turns the corners' sense of rotation. */
static bool sort_by_y(const lmb_vertex *corner[3])
{
    bool odd = false;
    unsigned pass;
    for (pass = 0; pass < 3; pass++) {
        const lmb_vertex **pair = &corner[pass & 1u], *swap = pair[0];
        if (pair[1]->y < swap->y) {
            pair[0] = pair[1];
            pair[1] = swap;
            odd = !odd;
        }
    }
    return odd;
}

/* False if a corner lies beyond LMB_SCREEN_MAX or no column of the window can be inside. */
static bool in_window(const lmb_vertex *const corner[3], const lmb_window *window)
{
    int32_t low = LMB_SCREEN_MAX, high = -LMB_SCREEN_MAX;
    unsigned i;
    for (i = 0; i < 3; i++) {
        if (!on_screen(corner[i]->x) || !on_screen(corner[i]->y)) return false;
        low = lmb_min(low, corner[i]->x);
        high = lmb_max(high, corner[i]->x);
    }
    low = lmb_row_at(low); /* columns round as rows do */
    high = lmb_row_at(high);
    return low < high && high > window->left && low < window->right;
}

/* ----------------------------------------------------------------------------------------------------------------- arcs on
 * edges */

/* Q28.4 in the unit of arcs; x is not below zero, and an edge is less than 65536 pixels tall. */
static uint32_t arc_unit(int32_t x) { return (uint32_t)x << 12; }
LMB_STATIC_ASSERT(LMB_ARC_PIXEL == 16UL << 12 && 2 * LMB_SCREEN_MAX <= (long)(LMB_ARC_LENGTH_MAX >> 12));

static uint32_t row_start(const lmb_vertex *top) { return arc_unit(lmb_sub(lmb_add(lmb_shl(lmb_row_at(top->y), 4), 8), top->y)); }

static int32_t component_rise(int32_t from, int32_t to)
{
    int32_t rise = lmb_sub(to, from); /* at most 2 in Q2.14; Q2.30 holds just less */
    return lmb_mul(lmb_max(lmb_min(rise, 32767), -32767), 65536);
}

static void edge_arc_step(lmb_edge_arc *e)
{
    lmb_arc_step(&e->arc, &e->component[0]);
    lmb_arc_step(&e->arc, &e->component[1]);
    lmb_arc_step(&e->arc, &e->component[2]);
}

/* cos(117 degrees), Q4.28. Normals that lmb_arc_between takes for more than 120 degrees apart are certainly beyond it. */
#define STRAIGHT_Q28 (-0x07400000)

static void edge_arc_begin(lmb_edge_arc *e, const lmb_vertex *top, const lmb_vertex *bottom, int32_t row, uint32_t modulus)
{
    const lmb_vec a = top->normal, b = bottom->normal;
    int32_t skip = lmb_sub(row, lmb_row_at(top->y));
    unsigned shift;
    e->inverse = (int32_t)(lmb_reciprocal(modulus, &shift) >> 1);
    e->inverse_shift = (uint8_t)shift;
    e->straight = lmb_dot_q28(a, b) < STRAIGHT_Q28;
    lmb_arc_between(&e->arc, a, b, arc_unit(lmb_sub(bottom->y, top->y)), row_start(top));
    lmb_arc_start(&e->arc, &e->component[0], lmb_mul(a.x, 65536), component_rise(a.x, b.x));
    lmb_arc_start(&e->arc, &e->component[1], lmb_mul(a.y, 65536), component_rise(a.y, b.y));
    lmb_arc_start(&e->arc, &e->component[2], lmb_mul(a.z, 65536), component_rise(a.z, b.z));
    for (; skip > 0; skip--) edge_arc_step(e);
}

static int16_t component_now(const lmb_term *term)
{
    return (int16_t)lmb_max(lmb_min(lmb_shr_round(lmb_shr(term->f, 2), 14), 32767), -32767);
}

static lmb_vec edge_arc_normal(const lmb_edge_arc *e)
{
    lmb_vec n;
    if (e->straight) {
        return lmb_normalise(lmb_shr(e->component[0].f, 2), lmb_shr(e->component[1].f, 2), lmb_shr(e->component[2].f, 2));
    }
    n.x = component_now(&e->component[0]);
    n.y = component_now(&e->component[1]);
    n.z = component_now(&e->component[2]);
    return n;
}

/* -----------------------------------------------------------------------------------------------------------------------
 * set-up */

/* Walks a side, 0 the left one and 1 the right, from one of the sorted corners to another; the first row to be shown is t->y. */
static void side_begin(lmb_triangle *t, unsigned side, unsigned from, unsigned to)
{
    const lmb_vertex *top = t->corner[from], *bottom = t->corner[to];
    lmb_edge_begin(&t->edge[side], top, bottom, t->y);
    if (LMB_WITH_ARC && t->kind == LMB_SPAN_ARC) {
        edge_arc_begin(side ? &t->u.arc.right : &t->u.arc.left, top, bottom, t->y, t->edge[side].modulus);
    }
}

static void depth_begin(lmb_triangle *t, const lmb_lattice *lattice, const lmb_vertex *const corner[3])
{
    lmb_net net = {{0, 0, 0}, {0, 0, 0}};
    int i;
    for (i = 0; i < 3; i++) net.value[i] = lmb_shl(lmb_max(DEPTH_MARGIN, lmb_min(corner[i]->depth, 65535 - DEPTH_MARGIN)), 12);
    lmb_plane_begin(&t->depth, lattice, &net);
}

/* Terms from the first row on. */
static void terms_begin(lmb_triangle *t, const lmb_vertex *const corner[3])
{
    bool curved = t->look->step == LMB_STEP_QUADRATIC && t->look->model >= LMB_MODEL_DIFFUSE;
    lmb_lattice lattice;
    lmb_lattice_begin(&lattice, corner, curved);
    t->column = lattice.column;
    t->row = lattice.row;
    lmb_shade_begin(t, &lattice, corner);
    if (LMB_WITH_DEPTH) depth_begin(t, &lattice, corner);
}

bool lmb_triangle_begin(lmb_triangle *t, const lmb_look *look, const lmb_rays *rays, const lmb_vertex *a, const lmb_vertex *b,
                        const lmb_vertex *c, const lmb_window *window)
{
    const lmb_vertex *const clockwise[3] = {a, c, b};
    unsigned lower;
    if (!in_window(clockwise, window)) return false;
    if (!lmb_product_less(lmb_sub(b->x, a->x), lmb_sub(c->y, a->y), lmb_sub(c->x, a->x), lmb_sub(b->y, a->y))) {
        return false; /* seen from behind, or a line */
    }
    t->corner[0] = a;
    t->corner[1] = b;
    t->corner[2] = c;
    /* counter-clockwise from the top the middle corner is left of the long edge, clockwise it is right of it */
    t->long_right = !sort_by_y(t->corner);
    t->y = lmb_max(lmb_row_at(t->corner[0]->y), window->top);
    t->y_switch = lmb_row_at(t->corner[1]->y);
    t->y_end = lmb_min(lmb_row_at(t->corner[2]->y), window->bottom);
    if (t->y >= t->y_end) return false;
    t->look = look;
    t->rays = rays;
    t->window_left = window->left;
    t->window_right = window->right;
    terms_begin(t, clockwise);
    side_begin(t, t->long_right, 0, 2);
    lower = t->y >= t->y_switch;
    side_begin(t, !t->long_right, lower, lower + 1);
    if (lower) t->y_switch = t->y_end; /* no change of sides to come */
    return true;
}

/* ------------------------------------------------------------------------------------------------------------------------
 * spans */

/* How far left of the centre of pixel edge->x the edge crosses, in the unit of arcs: gap / modulus, less than a pixel.
 * gap < modulus < 2^(shift + 1), so gap raised by 31 - shift fits 32 bits. Its upper 16 are enough, and all there is on edges of
 * up to 255 pixels. inverse is 2^(30 + shift) / modulus, so the product has 29 fraction bits.
 *   error  never above the true value; short of it by less than 3 units */
static uint32_t behind(const lmb_edge *edge, const lmb_edge_arc *e)
{
    return (uint32_t)lmb_shr(lmb_mul_q16(e->inverse, edge->gap << (31 - e->inverse_shift) >> 16), 13);
}

static void arc_span(const lmb_triangle *t, lmb_span *span, int32_t hidden)
{
    uint32_t from = behind(&t->edge[0], &t->u.arc.left), to = behind(&t->edge[1], &t->u.arc.right);
    uint32_t length = arc_unit(lmb_shl(lmb_sub(t->edge[1].x, t->edge[0].x), 4)) + from - to; /* at least one: there is a pixel */
    unsigned i;
    lmb_shade_arc(t, span, edge_arc_normal(&t->u.arc.left), edge_arc_normal(&t->u.arc.right), length, from);
    for (; hidden > 0; hidden--) {
        for (i = 0; i < lmb_look_lights(t->look); i++) {
            lmb_arc_step(&span->arc, &span->diffuse[i]);
            if (lmb_bit(t->specular_on, i)) lmb_arc_step(&span->arc, &span->specular[i]);
        }
    }
}

static void plane_span(const lmb_triangle *t, lmb_span *span)
{
    int32_t columns = lmb_sub(span->x, t->column), rows = lmb_sub(span->y, t->row);
    unsigned i;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        if (lmb_bit(t->diffuse_on, i)) lmb_plane_term(&span->diffuse[i], &t->u.plane.diffuse[i], columns, rows);
        if (lmb_bit(t->specular_on, i)) lmb_plane_term(&span->specular[i], &t->u.plane.specular[i], columns, rows);
        span->exponent[i] = t->exponent[i];
    }
}

static void flat_span(const lmb_triangle *t, lmb_span *span)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        span->diffuse[i].f = t->u.plane.diffuse[i].f;
        span->specular[i].f = t->u.plane.specular[i].f;
        span->exponent[i] = 0;
    }
}

static void row_step(lmb_triangle *t)
{
    unsigned i;
    t->y = lmb_add(t->y, 1);
    for (i = 0; i < 2; i++) lmb_edge_step(&t->edge[i]);
    if (LMB_WITH_ARC && t->kind == LMB_SPAN_ARC) {
        edge_arc_step(&t->u.arc.left);
        edge_arc_step(&t->u.arc.right);
    }
    if (t->y == t->y_switch && t->y < t->y_end) side_begin(t, !t->long_right, 1, 2);
}

bool lmb_triangle_next(lmb_triangle *t, lmb_span *span)
{
    bool found = false;
    while (!found && t->y < t->y_end) {
        int32_t x = lmb_max(t->edge[0].x, t->window_left), length = lmb_sub(lmb_min(t->edge[1].x, t->window_right), x);
        found = length > 0;
        if (found) {
            span->x = (int16_t)x;
            span->y = (int16_t)t->y;
            span->length = (uint16_t)length;
            span->kind = t->kind;
            span->diffuse_on = t->diffuse_on;
            span->specular_on = t->specular_on;
            if (LMB_WITH_ARC && t->kind == LMB_SPAN_ARC) {
                arc_span(t, span, lmb_sub(x, t->edge[0].x));
            } else if (LMB_WITH_CORNERS && t->kind == LMB_SPAN_FLAT) {
                flat_span(t, span);
            } else {
                plane_span(t, span);
            }
            if (LMB_WITH_DEPTH) lmb_plane_term(&span->depth, &t->depth, lmb_sub(x, t->column), lmb_sub(t->y, t->row));
        }
        row_step(t);
    }
    return found;
}
