/* SPDX-License-Identifier: MIT */
/* Normals that turn evenly along the edges of a triangle, and the arcs of its spans between them (paper 001). */
#include "edge_arc.h"

#include "arc.h"
#include "edge.h"
#include "shade.h"
#include "step.h"

#if LMB_WITH_ARC

/* Q28.4 in the unit of arcs; x is not below zero, and an edge is less than 65536 pixels tall. */
static uint32_t arc_unit(int32_t x) { return (uint32_t)x << 12; }
LMB_STATIC_ASSERT(LMB_ARC_PIXEL == 16UL << 12 && 2 * LMB_SCREEN_MAX <= (long)(LMB_ARC_LENGTH_MAX >> 12));

static uint32_t row_start(const lmb_vertex *top) { return arc_unit(lmb_sub(lmb_add(lmb_shl(lmb_row_at(top->y), 4), 8), top->y)); }

static int32_t component_rise(int32_t from, int32_t to)
{
    int32_t rise = lmb_sub(to, from); /* at most 2 in Q2.14; Q2.30 holds just less */
    return lmb_mul(lmb_max(lmb_min(rise, 32767), -32767), 65536);
}

static void arc_step(lmb_edge_arc *e)
{
    lmb_arc_step(&e->arc, &e->component[0]);
    lmb_arc_step(&e->arc, &e->component[1]);
    lmb_arc_step(&e->arc, &e->component[2]);
}

/* cos(117 degrees), Q4.28. Normals that lmb_arc_between takes for more than 120 degrees apart are certainly beyond it. */
#define STRAIGHT_Q28 (-0x07400000)

static void arc_begin(lmb_edge_arc *e, const lmb_vertex *top, const lmb_vertex *bottom, int32_t row, uint32_t modulus)
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
    for (; skip > 0; skip--) arc_step(e);
}

static int16_t component_now(const lmb_term *term)
{
    return (int16_t)lmb_max(lmb_min(lmb_shr_round(lmb_shr(term->f, 2), 14), 32767), -32767);
}

static lmb_vec normal_at(const lmb_edge_arc *e)
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

void lmb_edge_arc_begin(lmb_triangle *t, unsigned side, const lmb_vertex *top, const lmb_vertex *bottom)
{
    arc_begin(side ? &t->u.arc.right : &t->u.arc.left, top, bottom, t->y, (uint32_t)t->edge[side].modulus);
}

void lmb_edge_arc_step(lmb_triangle *t)
{
    arc_step(&t->u.arc.left);
    arc_step(&t->u.arc.right);
}

/* How far left of the centre of pixel edge->x the edge crosses, in the unit of arcs: gap / modulus, less than a pixel.
 * gap < modulus < 2^(shift + 1), so gap raised by 31 - shift fits 32 bits. Its upper 16 are enough, and all there is on edges of
 * up to 255 pixels. inverse is 2^(30 + shift) / modulus, so the product has 29 fraction bits.
 *   error  never above the true value; short of it by less than 3 units */
static uint32_t behind(const lmb_edge *edge, const lmb_edge_arc *e)
{
    return (uint32_t)lmb_shr(lmb_mul_q16(e->inverse, (uint32_t)edge->gap << (31 - e->inverse_shift) >> 16), 13);
}

void lmb_edge_arc_span(const lmb_triangle *t, lmb_span *span, int32_t hidden)
{
    uint32_t from = behind(&t->edge[0], &t->u.arc.left), to = behind(&t->edge[1], &t->u.arc.right);
    uint32_t length = arc_unit(lmb_shl(lmb_sub(t->edge[1].x, t->edge[0].x), 4)) + from - to; /* at least one: there is a pixel */
    unsigned i;
    lmb_shade_arc(t, span, normal_at(&t->u.arc.left), normal_at(&t->u.arc.right), length, from);
    for (; hidden > 0; hidden--) {
        for (i = 0; i < lmb_look_lights(t->look); i++) {
            lmb_arc_step(&span->arc, &span->diffuse[i]);
            if (lmb_bit(t->specular_on, i)) lmb_arc_step(&span->arc, &span->specular[i]);
        }
    }
}

#else
typedef int lmb_no_edge_arc; /* a translation unit needs a declaration */
#endif
