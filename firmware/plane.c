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
 * they stay under 2^-15 of the rise and 2^-13 of four bulges, plus 2^-30 n^2 over n pixels. (Rounded gradients of lambda were tried first: 4 b 2^-14 times that ratio,
 * 99 levels in the worst sliver.)
 *
 * Triangles that reach over more than 512 pixels take 64-bit products for the same, and their anchor, the pixel where planes are
 * set up, is moved from corner 0 into [0, ANCHOR_MAX], so that the rounding of second differences, 2^-31, is not carried over ten
 * thousand pixels. That depends on the triangle alone, never on the window.
 */
#include "plane.h"

#define NEAR_BITS 13     /* 512 pixels in 1/16 pixel */
#define ANCHOR_MAX 1023  /* pixels */
#define CURVATURE_BITS 14
#define HEIGHT_BITS 12   /* triangles some 4096 times longer than high have no curve: there its rounding would exceed it */

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

static unsigned pair_bits(const int32_t v[2]) { return bits_of(magnitude(v[0]) | magnitude(v[1])); }

/* Form i: products of two pairs of numerators, shifted down where they are long, so that each stays under 2^30. */
static void form_set(lmb_lattice *l, unsigned i, const int32_t u[2], const int32_t v[2])
{
    int32_t *form = l->form[i];
    unsigned size = LMB_WITH_LARGE && l->large ? pair_bits(u) + pair_bits(v) : 0, down = size > 30 ? size - 30 : 0;
    l->form_shift[i] = down;
    if (LMB_WITH_LARGE && down > 0) {
        form[0] = lmb_mul_shr(u[0], v[0], down);
        form[1] = lmb_mul_shr(u[1], v[1], down);
        form[2] = lmb_add(lmb_mul_shr(u[0], v[1], down), lmb_mul_shr(u[1], v[0], down));
    } else {
        form[0] = lmb_mul(u[0], v[0]);
        form[1] = lmb_mul(u[1], v[1]);
        form[2] = lmb_add(lmb_mul(u[0], v[1]), lmb_mul(u[1], v[0]));
    }
}

/* The numerators half a pixel on in a direction: half of what lambda's square has for its first difference. */
static void half_on(int32_t on[2], const int32_t at[2], const int32_t step[2], unsigned down)
{
    on[0] = lmb_add(at[0], lmb_shr(lmb_shl(step[0], 3), down));
    on[1] = lmb_add(at[1], lmb_shr(lmb_shl(step[1], 3), down));
}

/* Numerators at the anchor, shifted down to 15 bits: the whole of lambda moves by that, at most 8 / area, in value and in differences
 * alike. Large: to 30 bits. Returns the shift. */
static unsigned numerators_at(const lmb_lattice *l, int32_t at[2])
{
    unsigned size, down;
    if (LMB_WITH_LARGE && l->large) {
        int64_t a = lmb_dot_wide(l->x[0], l->offset_x, l->y[0], l->offset_y);
        int64_t b = lmb_dot_wide(l->x[1], l->offset_x, l->y[1], l->offset_y);
        size = lmb_bits_wide(a, b);
        down = size > 30 ? size - 30 : 0;
        at[0] = (int32_t)(a >> down);
        at[1] = (int32_t)(b >> down);
        return down;
    }
    at[0] = lmb_add(lmb_mul(l->x[0], l->offset_x), lmb_mul(l->y[0], l->offset_y));
    at[1] = lmb_add(lmb_mul(l->x[1], l->offset_x), lmb_mul(l->y[1], l->offset_y));
    size = pair_bits(at);
    down = size > 15 ? size - 15 : 0;
    at[0] = lmb_shr(at[0], down);
    at[1] = lmb_shr(at[1], down);
    return down;
}

/* The products that quadratics need. Eight steps, half a pixel, are less than 2^16, so with at < 2^15 and steps < 2^13 sums of two
 * products stay under 2^31; of a large triangle products are shifted. */
static void lattice_curve(lmb_lattice *l)
{
    int32_t at[2], on[2];
    unsigned down = numerators_at(l, at), i;
    l->square_q16 = lmb_mulu(l->reciprocal_q16, l->reciprocal_q16) >> 16;
    form_set(l, 0, at, at);
    half_on(on, at, l->x, down);
    form_set(l, 1, on, l->x);
    half_on(on, at, l->y, down);
    form_set(l, 2, on, l->y);
    form_set(l, 3, l->x, l->x);
    form_set(l, 4, l->y, l->y);
    form_set(l, 5, l->x, l->y);
    l->form_shift[0] += 2 * down;
    l->form_shift[1] += 5 + down;
    l->form_shift[2] += 5 + down;
    for (i = 3; i < 6; i++) l->form_shift[i] += 9;
}

/* The area, x[0] y[1] - x[1] y[0] with what x and y stand for, and its reciprocal as 16 bits; 1 for none or less. */
static void lattice_area(lmb_lattice *l)
{
    uint32_t area;
    unsigned down = 0;
    if (LMB_WITH_LARGE && l->large) {
        int64_t wide = lmb_dot_wide(l->x[0], l->y[1], lmb_sub(0, l->x[1]), l->y[0]);
        unsigned size = lmb_bits_wide(wide, 0);
        down = size > 32 ? size - 32 : 0;
        area = wide < 1 ? 1 : (uint32_t)(wide >> down);
    } else {
        area = (uint32_t)lmb_max(1, lmb_sub(lmb_mul(l->x[0], l->y[1]), lmb_mul(l->x[1], l->y[0])));
    }
    l->reciprocal_q16 = (uint32_t)lmb_min((int32_t)((lmb_reciprocal(area, &l->shift) + 0x4000u) >> 15), 65535);
    l->shift += down;
}

/* The pixel of corner 0; of a large triangle one from which nothing in the frame is far. */
static int32_t anchor(const lmb_lattice *l, int32_t corner)
{
    int32_t pixel = lmb_shr(corner, 4);
    return LMB_WITH_LARGE && l->large ? lmb_max(0, lmb_min(pixel, ANCHOR_MAX)) : pixel;
}

void lmb_lattice_begin(lmb_lattice *l, const lmb_vertex *const corner[3], int32_t row, bool curved)
{
    int32_t x0 = corner[0]->x, y0 = corner[0]->y, anchor_row;
    unsigned down = 0;
    l->x[0] = lmb_sub(corner[2]->y, y0);
    l->y[0] = lmb_sub(x0, corner[2]->x);
    l->x[1] = lmb_sub(y0, corner[1]->y);
    l->y[1] = lmb_sub(corner[1]->x, x0);
    l->bits = bits_of(magnitude(l->x[0]) | magnitude(l->y[0]) | magnitude(l->x[1]) | magnitude(l->y[1]));
    l->large = l->bits > NEAR_BITS;
    if (!LMB_WITH_LARGE && l->large) { /* a coarser grid */
        down = l->bits - NEAR_BITS;
        l->x[0] = lmb_shr(l->x[0], down);
        l->y[0] = lmb_shr(l->y[0], down);
        l->x[1] = lmb_shr(l->x[1], down);
        l->y[1] = lmb_shr(l->y[1], down);
        l->bits = NEAR_BITS;
    }
    lattice_area(l);
    l->shift += down; /* p / 2^down over area / 4^down is p over area times 2^down */
    anchor_row = anchor(l, y0);
    l->column = anchor(l, x0);
    l->rows = lmb_sub(row, anchor_row);
    l->offset_x = lmb_sub(lmb_add(lmb_shl(l->column, 4), 8), x0);
    l->offset_y = lmb_sub(lmb_add(lmb_shl(anchor_row, 4), 8), y0);
    l->curved = curved && l->shift + HEIGHT_BITS >= 2 * l->bits;
    if (l->curved) lattice_curve(l);
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
    int32_t q[3], value[6], base;
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
    /* Q2.30 of 4 * 2^-28 * q 2^(drop + 16) * 2^-(16 + 2 shift) times a form: over 2^base */
    base = 2 * (int32_t)l->shift - 4 - (int32_t)drop;
    for (i = 0; i < 6; i++) value[i] = form_apply(l->form[i], q, base - (int32_t)l->form_shift[i]);
    plane->f = lmb_add_wrap(plane->f, value[0]);
    plane->dx = lmb_add_wrap(plane->dx, value[1]);
    plane->dy = lmb_add_wrap(plane->dy, value[2]);
    plane->dxx = value[3];
    plane->dyy = value[4];
    plane->dxy = value[5];
}

/* (nx offset_x + ny offset_y) / 2^(4 + *drop), below 2^31: what lies between corner 0 and the anchor. Within a pixel in 32 bits, where the
 * low four bits of the numerators go apart. */
static int32_t offset_of(const lmb_lattice *l, int32_t nx, int32_t ny, int32_t *drop)
{
    int32_t x = l->offset_x, y = l->offset_y;
    *drop = 0;
    if (LMB_WITH_LARGE && l->large) {
        *drop = (int32_t)bits_of(magnitude(x) | magnitude(y)) - 3;
        return lmb_add(lmb_mul_shr(nx, x, (unsigned)(4 + *drop)), lmb_mul_shr(ny, y, (unsigned)(4 + *drop)));
    }
    nx = lmb_add(lmb_mul(lmb_shr(nx, 4), x), lmb_shr(lmb_mul(nx & 15, x), 4));
    return lmb_add(nx, lmb_add(lmb_mul(lmb_shr(ny, 4), y), lmb_shr(lmb_mul(ny & 15, y), 4)));
}

static void plane_descend(lmb_plane *plane, int32_t rows)
{
    lmb_term down = lmb_term_move(plane->f, plane->dy, plane->dyy, rows);
    plane->f = down.f;
    plane->dy = down.d;
    plane->dx = lmb_add_wrap(plane->dx, lmb_mul_wrap(rows, plane->dxy));
}

/* Numerators of the gradient, rises times edges, in units of 2^-28 times 2^drop and below 2^31; returns drop. */
static unsigned numerators(const lmb_lattice *l, int32_t rise1, int32_t rise2, int32_t *nx, int32_t *ny)
{
    unsigned drop = 0, size;
    if (LMB_WITH_LARGE && l->large) {
        int64_t x = lmb_dot_wide(rise1, l->x[0], rise2, l->x[1]), y = lmb_dot_wide(rise1, l->y[0], rise2, l->y[1]);
        size = lmb_bits_wide(x, y);
        drop = size > 31 ? size - 31 : 0;
        *nx = (int32_t)(x >> drop);
        *ny = (int32_t)(y >> drop);
        return drop;
    }
    size = bits_of(magnitude(rise1) | magnitude(rise2)) + l->bits;
    if (size > 30) {
        drop = size - 30;
        rise1 = lmb_shr_round(rise1, drop);
        rise2 = lmb_shr_round(rise2, drop);
    }
    *nx = lmb_add(lmb_mul(rise1, l->x[0]), lmb_mul(rise2, l->x[1]));
    *ny = lmb_add(lmb_mul(rise1, l->y[0]), lmb_mul(rise2, l->y[1]));
    return drop;
}

void lmb_plane_begin(lmb_plane *plane, const lmb_lattice *l, const lmb_net *net)
{
    int32_t rise1 = lmb_sub(net->value[1], net->value[0]), rise2 = lmb_sub(net->value[2], net->value[0]);
    int32_t nx, ny, offset, offset_drop, shift;
    if (l->curved) {
        rise1 = lmb_add(rise1, lmb_shl(net->bulge[0], 2));
        rise2 = lmb_add(rise2, lmb_shl(net->bulge[2], 2));
    }
    /* per pixel and in Q2.30: numerator * 16 * reciprocal_q16 * 2^-(16 + shift) * 2^(30 - 28 + drop) */
    shift = (int32_t)l->shift + 10 - (int32_t)numerators(l, rise1, rise2, &nx, &ny);
    offset = offset_of(l, nx, ny, &offset_drop);
    plane->f = lmb_add_wrap(lmb_shl_wrap(net->value[0], 2), over_area(offset, l, shift - offset_drop));
    plane->dx = over_area(nx, l, shift);
    plane->dy = over_area(ny, l, shift);
    plane->dxx = plane->dxy = plane->dyy = 0;
    if (l->curved) plane_curve(plane, l, net);
    plane_descend(plane, l->rows);
}
