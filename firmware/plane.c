/* SPDX-License-Identifier: MIT */
/* Linear and quadratic functions over a triangle, from their values at corners and mid-edges.
 *
 * With barycentric coordinates l1, l2 (l0 = 1 - l1 - l2) the quadratic through the corners and mid-edges is
 *
 *     f = f0 + l1 (f1 - f0 + 4 b01) + l2 (f2 - f0 + 4 b20) - 4 b01 l1^2 - 4 b20 l2^2 + 4 (b12 - b01 - b20) l1 l2
 *
 * where b is the bulge of an edge (Bishop & Weimer 1986 take the same six values). In pixels l = g.p with constant gradients g, so f
 * has constant second differences: two additions a pixel.
 *
 * The state is Q2.30 and wraps. Gradients across a sliver leave (-2, 2) and wrap too; what is added up inside the triangle does not,
 * and sums modulo 2^32 do not care about the way. For that to hold every product is formed whole and shifted once, into the
 * wrapping state: shifting a wrapped number would lose its top.
 *
 * Numerators a px + b py are exact integers, in the linear part and in the quadratic one; only what multiplies the whole is rounded:
 * the rises and bulges (14 bits and more) and one reciprocal of the area, or of its square, which all six numbers of a plane share. An
 * error of such a factor scales the function and does not tear it, so errors do not grow with the triangle's length over its height:
 * they stay under 2^-16 of the rise and 2^-14 of the bulge. (Rounded gradients of lambda were tried first: 4 b 2^-14 times that ratio,
 * 99 levels in the worst sliver.)
 *
 * The anchor is the pixel of corner 0; where that lies outside [0, ANCHOR_MAX] it is moved there, so that the rounding of the second
 * differences, 2^-31, is not carried over ten thousand pixels. It depends on the triangle alone, never on the window.
 */
#include "plane.h"

/* Extents are shifted down to this many bits, 1024 and 512 pixels: larger triangles lie on a grid coarser than 1/16 pixel. */
#define LINEAR_BITS 14
#define CURVED_BITS 13
#define CURVATURE_BITS 14
#define ANCHOR_MAX 1023 /* pixels */

static unsigned bits_of(uint32_t x) { return 32u - lmb_clz32(x); }
static uint32_t magnitude(int32_t x) { return x < 0 ? 0u - (uint32_t)x : (uint32_t)x; }

/* (high * 2^16 + low) / 2^shift, floored, modulo 2^32. */
static int32_t join(int32_t high, int32_t low, int32_t shift)
{
    if (shift >= 16) {
        int32_t sum = lmb_add_wrap(high, lmb_shr(low, 16));
        return lmb_shr(sum, (unsigned)lmb_min(shift - 16, 31));
    }
    if (shift >= 0) return lmb_add_wrap(lmb_shl_wrap(high, 16u - (unsigned)shift), lmb_shr(low, (unsigned)shift));
    if (shift <= -32) return 0;
    return lmb_shl_wrap(lmb_add_wrap(lmb_shl_wrap(high, 16), low), (unsigned)-shift);
}

/* numerator times the reciprocal of the area, shifted. high < 2^15 * 2^16, low < 2^32 as unsigned: its low 16 bits go first. */
static int32_t over_area(int32_t numerator, const lmb_lattice *lattice, int32_t shift)
{
    uint32_t low = lmb_mulu((uint32_t)numerator & 0xffffu, lattice->reciprocal_q16);
    int32_t high = lmb_mul(lmb_shr(numerator, 16), (int32_t)lattice->reciprocal_q16);
    return join(lmb_add_wrap(high, (int32_t)(low >> 16)), (int32_t)(low & 0xffffu), shift);
}

static void form_set(int32_t form[3], const int32_t u[2], const int32_t v[2])
{
    form[0] = lmb_mul(u[0], v[0]);
    form[1] = lmb_mul(u[1], v[1]);
    form[2] = lmb_add(lmb_mul(u[0], v[1]), lmb_mul(u[1], v[0]));
}

/* The edges of a triangle from corner 0, on a grid of 2^down / 16 pixel. */
typedef struct edges {
    int32_t x1, y1, x2, y2;
} edges;

static edges edges_down(edges e, unsigned down)
{
    if (down > 0) {
        e.x1 = lmb_shr(e.x1, down);
        e.y1 = lmb_shr(e.y1, down);
        e.x2 = lmb_shr(e.x2, down);
        e.y2 = lmb_shr(e.y2, down);
    }
    return e;
}

static unsigned edges_bits(const edges *e)
{
    return bits_of(magnitude(e->x1) | magnitude(e->y1) | magnitude(e->x2) | magnitude(e->y2));
}

/* 1 / area as 16 bits and a shift; area < 2^(2 * 14 + 1). */
static uint32_t area_reciprocal(const edges *e, unsigned *shift)
{
    uint32_t area = (uint32_t)lmb_max(1, lmb_sub(lmb_mul(e->x1, e->y2), lmb_mul(e->x2, e->y1)));
    return (uint32_t)lmb_min((int32_t)((lmb_reciprocal(area, shift) + 0x4000u) >> 15), 65535);
}

/* The products that quadratics need, from whole numerators. |a|, |b| < 2^13; numerators at the anchor are shifted down to 15 bits, the
 * same in value and first differences; eight of a or b more, half a pixel on, is less than 2^15 + 2^16, and times 2^13, twice, under 2^31. */
static void lattice_curve(lmb_lattice *l, edges e)
{
    unsigned size = edges_bits(&e), down = size > CURVED_BITS ? size - CURVED_BITS : 0, drop, shift, i;
    int32_t x[2], y[2], at[2], on[2], offset_x = l->offset_x, offset_y = l->offset_y;
    uint32_t reciprocal_q16;
    e = edges_down(e, down);
    reciprocal_q16 = area_reciprocal(&e, &shift);
    l->square_q16 = lmb_mulu(reciprocal_q16, reciprocal_q16) >> 16;
    l->square_shift = 2 * (int32_t)(shift + down);
    size = edges_bits(&e) + bits_of(magnitude(offset_x) | magnitude(offset_y)) + 1;
    drop = size > 31 ? size - 31 : 0; /* only after the anchor was moved */
    offset_x = lmb_shr(offset_x, drop);
    offset_y = lmb_shr(offset_y, drop);
    x[0] = e.y2;
    y[0] = lmb_sub(0, e.x2);
    x[1] = lmb_sub(0, e.y1);
    y[1] = e.x1;
    for (i = 0; i < 2; i++) at[i] = lmb_add(lmb_mul(x[i], offset_x), lmb_mul(y[i], offset_y));
    size = bits_of(magnitude(at[0]) | magnitude(at[1]));
    shift = size > 15 ? size - 15 : 0;
    at[0] = lmb_shr(at[0], shift);
    at[1] = lmb_shr(at[1], shift);
    shift += drop;
    l->at_shift = (int32_t)shift;
    form_set(l->form[0], at, at);
    for (i = 0; i < 2; i++) on[i] = lmb_add(at[i], lmb_shr(lmb_shl(x[i], 3), shift));
    form_set(l->form[1], on, x);
    for (i = 0; i < 2; i++) on[i] = lmb_add(at[i], lmb_shr(lmb_shl(y[i], 3), shift));
    form_set(l->form[2], on, y);
    form_set(l->form[3], x, x);
    form_set(l->form[4], y, y);
    form_set(l->form[5], x, y);
}

/* A pixel near corner 0 from which nothing in the frame is far. */
static int32_t anchor(int32_t corner) { return lmb_max(0, lmb_min(lmb_shr(corner, 4), ANCHOR_MAX)); }

void lmb_lattice_begin(lmb_lattice *l, const lmb_vertex *const corner[3], int32_t row, bool curved)
{
    int32_t x0 = corner[0]->x, y0 = corner[0]->y, anchor_row = anchor(y0);
    edges whole = {lmb_sub(corner[1]->x, x0), lmb_sub(corner[1]->y, y0), lmb_sub(corner[2]->x, x0), lmb_sub(corner[2]->y, y0)}, e;
    unsigned size = edges_bits(&whole), down = size > LINEAR_BITS ? size - LINEAR_BITS : 0;
    e = edges_down(whole, down);
    l->a1 = e.y2;
    l->b1 = lmb_sub(0, e.x2);
    l->a2 = lmb_sub(0, e.y1);
    l->b2 = e.x1;
    l->bits = edges_bits(&e);
    l->reciprocal_q16 = area_reciprocal(&e, &l->shift);
    l->shift += down; /* p / 2^down over area / 4^down is p over area times 2^down */
    l->column = anchor(x0);
    l->rows = lmb_sub(row, anchor_row);
    l->offset_x = lmb_sub(lmb_add(lmb_shl(l->column, 4), 8), x0);
    l->offset_y = lmb_sub(lmb_add(lmb_shl(anchor_row, 4), 8), y0);
    size = bits_of(magnitude(l->offset_x) | magnitude(l->offset_y));
    l->offset_drop = size > 4 ? size - 3 : 0;
    l->curved = curved;
    if (curved) lattice_curve(l, whole);
}

/* The sum of a form's three products with the curvatures q, |q| < 2^14, over 2^shift, to nearest. Products are formed in two halves;
 * carries go up at once: high parts sum to less than 3 * 2^29, low ones stay under 2^30. */
static int32_t form_apply(const int32_t form[3], const int32_t q[3], int32_t shift)
{
    int32_t high = 0, low = 0;
    int i;
    for (i = 0; i < 3; i++) {
        low = lmb_add(low, lmb_mul((int32_t)((uint32_t)form[i] & 0xffffu), q[i]));
        high = lmb_add(lmb_add(high, lmb_mul(lmb_shr(form[i], 16), q[i])), lmb_shr(low, 16));
        low &= 0xffff;
    }
    if (shift > 0 && shift <= 16) {
        low = lmb_add(low, lmb_shl(1, (unsigned)shift - 1));
    } else if (shift > 16) {
        high = lmb_add_wrap(high, lmb_shl_wrap(1, (unsigned)lmb_min(shift - 17, 31)));
    }
    return join(high, low, shift);
}

/* Adds the quadratic part. Bulges are below one in magnitude, so |q| < 2^30 in units of 4 * 2^-28. */
static void plane_curve(lmb_plane *plane, const lmb_lattice *l, const lmb_net *net)
{
    int32_t q[3], value[6], base, at = l->at_shift;
    unsigned size, drop;
    int i;
    q[0] = lmb_sub(0, net->bulge[0]);
    q[1] = lmb_sub(0, net->bulge[2]);
    q[2] = lmb_shr(lmb_sub(lmb_sub(net->bulge[1], net->bulge[0]), net->bulge[2]), 1);
    for (i = 0; i < 3; i++) q[i] = lmb_mul_q16(q[i], l->square_q16);
    size = bits_of(magnitude(q[0]) | magnitude(q[1]) | magnitude(q[2]));
    if (size == 0) return;
    drop = size > CURVATURE_BITS ? size - CURVATURE_BITS : 0;
    for (i = 0; i < 3 && drop > 0; i++) q[i] = lmb_shr(q[i], drop);
    /* Q2.30 of 4 * 2^-28 * q 2^(drop + 16) * 2^-(16 + square_shift) times a form: over 2^base */
    base = l->square_shift - 4 - (int32_t)drop;
    value[0] = form_apply(l->form[0], q, base - 2 * at);
    for (i = 1; i < 6; i++) value[i] = form_apply(l->form[i], q, i < 3 ? base - 5 - at : base - 9);
    plane->f = lmb_add_wrap(plane->f, value[0]);
    plane->dx = lmb_add_wrap(plane->dx, value[1]);
    plane->dy = lmb_add_wrap(plane->dy, value[2]);
    plane->dxx = value[3];
    plane->dyy = value[4];
    plane->dxy = value[5];
}

/* n * offset / 2^(4 + offset_drop): at most half of n's range. Where the offset is within a pixel, in 32 bits: the low four bits go
 * apart. */
static int32_t offset_times(int32_t n, int32_t offset, unsigned offset_drop)
{
    if (offset_drop > 0) return lmb_mul_shr(n, offset, 4 + offset_drop);
    return lmb_add(lmb_mul(lmb_shr(n, 4), offset), lmb_shr(lmb_mul(n & 15, offset), 4));
}

static void plane_descend(lmb_plane *plane, int32_t rows)
{
    lmb_term down = lmb_term_move(plane->f, plane->dy, plane->dyy, rows);
    plane->f = down.f;
    plane->dy = down.d;
    plane->dx = lmb_add_wrap(plane->dx, lmb_mul_wrap(rows, plane->dxy));
}

void lmb_plane_begin(lmb_plane *plane, const lmb_lattice *l, const lmb_net *net)
{
    int32_t rise1 = lmb_sub(net->value[1], net->value[0]), rise2 = lmb_sub(net->value[2], net->value[0]), nx, ny, shift;
    unsigned size, room = 30 - l->bits, drop = 0;
    if (l->curved) {
        rise1 = lmb_add(rise1, lmb_shl(net->bulge[0], 2));
        rise2 = lmb_add(rise2, lmb_shl(net->bulge[2], 2));
    }
    size = bits_of(magnitude(rise1) | magnitude(rise2));
    if (size > room) {
        drop = size - room;
        rise1 = lmb_shr_round(rise1, drop);
        rise2 = lmb_shr_round(rise2, drop);
    }
    nx = lmb_add(lmb_mul(rise1, l->a1), lmb_mul(rise2, l->a2));
    ny = lmb_add(lmb_mul(rise1, l->b1), lmb_mul(rise2, l->b2));
    /* per pixel and in Q2.30: numerator * 16 * reciprocal_q16 * 2^-(16 + shift) * 2^(30 - 28 + drop) */
    shift = (int32_t)l->shift + 10 - (int32_t)drop;
    plane->f = lmb_add_wrap(lmb_shl_wrap(net->value[0], 2),
                            over_area(lmb_add(offset_times(nx, l->offset_x, l->offset_drop),
                                              offset_times(ny, l->offset_y, l->offset_drop)),
                                      l, shift - (int32_t)l->offset_drop));
    plane->dx = over_area(nx, l, shift);
    plane->dy = over_area(ny, l, shift);
    plane->dxx = plane->dxy = plane->dyy = 0;
    if (l->curved) plane_curve(plane, l, net);
    plane_descend(plane, l->rows);
}
