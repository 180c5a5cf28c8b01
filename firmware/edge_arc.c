/* SPDX-License-Identifier: MIT */
/* Normals that turn evenly along the edges of a triangle, and the arcs of its spans between them (paper 001). */
#include "edge_arc.h"

#include "arc_parts.h"
#include "curve.h"
#include "edge.h"
#include "step.h"

#if LMB_WITH_ARC

/* Q28.4 in the unit of arcs; x is not below zero, and an edge is less than 65536 pixels tall. */
static uint32_t arc_unit(int32_t x) { return (uint32_t)x << 12; }
LMB_STATIC_ASSERT(LMB_ARC_PIXEL == 16UL << 12 && 2 * LMB_SCREEN_MAX <= (long)(LMB_ARC_LENGTH_MAX >> 12));

static uint32_t row_start(const lmb_vertex *top) { return arc_unit(lmb_sub(lmb_add(lmb_shl(lmb_row_at(top->y), 4), 8), top->y)); }

static LMB_OUTLINE void component_begin(lmb_edge_arc *e, unsigned i, int32_t from, int32_t to)
{
    int32_t rise = lmb_max(lmb_min(lmb_sub(to, from), 32767), -32767); /* at most 2 in Q2.14; Q2.30 holds just less */
    lmb_arc_start(&e->arc, &e->component[i], lmb_mul(from, 65536), lmb_mul(rise, 65536));
}

static void arc_step(lmb_edge_arc *e)
{
    lmb_arc_step(&e->arc, &e->component[0]);
    lmb_arc_step(&e->arc, &e->component[1]);
    lmb_arc_step(&e->arc, &e->component[2]);
}

static void arc_begin(lmb_edge_arc *e, const lmb_vertex *top, const lmb_vertex *bottom, int32_t row, uint32_t modulus)
{
    int32_t skip = lmb_sub(row, lmb_row_at(top->y)), u_q28;
    lmb_ends ends;
    unsigned shift;
    e->inverse = (int32_t)(lmb_reciprocal(modulus, &shift) >> 1);
    e->inverse_shift = (uint8_t)shift;
    lmb_end_prepare(&ends.from, top->normal);
    lmb_end_prepare(&ends.to, bottom->normal);
    u_q28 = lmb_ends_u_q28(&ends);
    e->straight = u_q28 > LMB_ARC_U_MAX;
    lmb_arc_prepare(&e->arc, u_q28, arc_unit(lmb_sub(bottom->y, top->y)), row_start(top));
    component_begin(e, 0, ends.from.x, ends.to.x);
    component_begin(e, 1, ends.from.y, ends.to.y);
    component_begin(e, 2, ends.from.z, ends.to.z);
    for (; skip > 0; skip--) arc_step(e);
}

static int32_t component_now(const lmb_term *term) { return lmb_shr_round(lmb_shr(term->f, 2), 14); }

static void end_at(const lmb_edge_arc *e, lmb_end *end)
{
    if (e->straight) {
        lmb_vec n = lmb_normalise(lmb_shr(e->component[0].f, 2), lmb_shr(e->component[1].f, 2), lmb_shr(e->component[2].f, 2));
        lmb_end_place(end, n.x, n.y, n.z);
    } else {
        lmb_end_place(end, component_now(&e->component[0]), component_now(&e->component[1]), component_now(&e->component[2]));
    }
}

void lmb_edge_arc_begin(lmb_triangle *t, unsigned side, const lmb_vertex *top, const lmb_vertex *bottom)
{
    arc_begin(side ? &t->u.arc.right : &t->u.arc.left, top, bottom, t->y, (uint32_t)t->walk.edge[side].modulus);
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

/* The highlight's argument is its beam's term and something, which a plane takes in and an arc cannot. */
static void light_terms(lmb_span *span, const lmb_curve *curve, const lmb_ends *ends, const struct lmb_ray *ray, unsigned i)
{
    lmb_term *diffuse = &span->diffuse[i], *specular = &span->specular[i];
    span->exponent[i] = ray->exponent;
    if (span->kind == LMB_SPAN_PLANE) {
        lmb_curve_beam(curve, diffuse, ends, &ray->diffuse);
        if (!ray->shines) return;
        lmb_curve_beam(curve, specular, ends, &ray->specular);
        specular->f = lmb_add_wrap(specular->f, ray->offset_q30);
    } else {
        lmb_arc_beam_rough(&span->arc, diffuse, ends, &ray->diffuse);
        if (!ray->shines) return;
        lmb_arc_beam(&span->arc, specular, ends, &ray->specular);
        specular->c = ray->offset_q30;
    }
}

void lmb_run_exact(const lmb_triangle *t, lmb_span *span, lmb_run *run)
{
    const struct lmb_ray *ray = t->rays->light;
    const int32_t u_q28 = lmb_ends_measure(&run->ends);
    lmb_curve curve;
    unsigned i;
    if (u_q28 <= t->rays->curve_q28 && lmb_curve_prepare(&curve, u_q28, run->length, run->start)) {
        span->kind = LMB_SPAN_PLANE;
    } else {
        lmb_arc_prepare(&span->arc, u_q28, run->length, run->start);
    }
    for (i = 0; i < lmb_look_lights(t->look); i++, ray++) light_terms(span, &curve, &run->ends, ray, i);
}

static LMB_OUTLINE void term_step(const lmb_span *span, lmb_term *term)
{
    if (span->kind == LMB_SPAN_PLANE) {
        lmb_plane_step(term);
    } else {
        lmb_arc_step(&span->arc, term);
    }
}

void lmb_edge_arc_span(const lmb_triangle *t, lmb_span *span, int32_t hidden)
{
    uint32_t from = behind(&t->walk.edge[0], &t->u.arc.left), to = behind(&t->walk.edge[1], &t->u.arc.right);
    lmb_run run;
    unsigned i;
    run.start = from;
    run.length = arc_unit(lmb_shl(lmb_sub(t->walk.edge[1].x, t->walk.edge[0].x), 4)) + from - to; /* at least one: there is a pixel */
    end_at(&t->u.arc.left, &run.ends.from);
    end_at(&t->u.arc.right, &run.ends.to);
    lmb_run_terms(t, span, &run);
    for (; hidden > 0; hidden--) {
        for (i = 0; i < lmb_look_lights(t->look); i++) {
            term_step(span, &span->diffuse[i]);
            if (lmb_bit(t->specular_on, i)) term_step(span, &span->specular[i]);
        }
    }
}

#else
typedef int lmb_no_edge_arc; /* a translation unit needs a declaration */
#endif
