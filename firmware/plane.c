/* SPDX-License-Identifier: MIT */
/* Linear and quadratic functions over a triangle, from their values at corners and mid-edges.
 *
 * With barycentric coordinates l1, l2 (l0 = 1 - l1 - l2) the quadratic through the corners and mid-edges is
 *
 *     f = f0 + l1 (f1 - f0 + 4 b01) + l2 (f2 - f0 + 4 b20) - 4 b01 l1^2 - 4 b20 l2^2 + 4 (b12 - b01 - b20) l1 l2
 *
 * where b is the bulge of an edge (Bishop & Weimer 1986 take the same six values). In pixels l = g.p with constant gradients g,
 * so f has constant second differences: two additions a pixel.
 *
 * The state is Q2.30 and wraps. Gradients across a sliver leave (-2, 2) and wrap too; what is added up inside the triangle does
 * not, and sums modulo 2^32 do not care about the way. For that to hold every product is formed whole and shifted once, into
 * the wrapping state: shifting a wrapped number would lose its top.
 *
 * Numerators a px + b py are exact integers, in the linear part and in the quadratic one; only what multiplies the whole is
 * rounded: the rises and bulges (14 bits and more) and one reciprocal of the area, or of its square, which all six numbers of a
 * plane share. An error of such a factor scales the function and does not tear it, so errors do not grow with the triangle's
 * length over its height: they stay under 2^-15 of the rise and 2^-13 of four bulges, plus 2^-30 n^2 over n pixels. (Rounded
 * gradients of lambda were tried first: 4 b 2^-14 times that ratio, 99 levels in the worst sliver.)
 *
 * Triangles that reach over more than 512 pixels take 64-bit products for the same, and their anchor, the pixel where planes are
 * set up, is moved from corner 0 into [0, ANCHOR_MAX], so that the rounding of second differences, 2^-31, is not carried over ten
 * thousand pixels. That depends on the triangle alone, never on the window.
 */
#include "plane.h"

#define NEAR_BITS 13    /* 512 pixels in 1/16 pixel */
#define ANCHOR_MAX 1023 /* pixels */
#define CURVATURE_BITS 14
#define HEIGHT_BITS 12 /* triangles some 4096 times longer than high have no curve: there its rounding would exceed it */

/* Bits of the largest magnitude. */
static unsigned bits_of(const int32_t *values, unsigned count)
{
    uint32_t all = 0;
    unsigned i;
    for (i = 0; i < count; i++) all |= (uint32_t)(values[i] < 0 ? -values[i] : values[i]);
    return 32u - lmb_clz32(all);
}

/* Shifts values down so that they lie within 2^bits; returns how far. */
static unsigned fit(int32_t *values, unsigned count, unsigned bits)
{
    unsigned size = bits_of(values, count), drop = size > bits ? size - bits : 0, i;
    for (i = 0; i < count; i++) values[i] = lmb_shr(values[i], drop);
    return drop;
}

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

/* Form i: products of two pairs of numerators, which stand for themselves times 2^shift in all; shifted down where they are
 * long, so that each stays under 2^30. */
static void form_set(lmb_lattice *l, unsigned i, const int32_t u[2], const int32_t v[2], unsigned shift)
{
    int32_t *form = l->form[i];
    unsigned size = LMB_WITH_LARGE && l->large ? bits_of(u, 2) + bits_of(v, 2) : 0, down = size > 30 ? size - 30 : 0;
    l->form_shift[i] = shift + down;
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

/* Numerators at the anchor, shifted down to 15 bits: the whole of lambda moves by that, at most 8 / area, in value and in
 * differences alike. Large: to 30 bits. Returns the shift. */
static unsigned numerators_at(const lmb_lattice *l, int32_t at[2])
{
    const int32_t *step = l->step, *offset = l->offset;
    if (LMB_WITH_LARGE && l->large) {
        int64_t a = lmb_dot_wide(step[0], offset[0], step[2], offset[1]);
        int64_t b = lmb_dot_wide(step[1], offset[0], step[3], offset[1]);
        unsigned size = lmb_bits_wide(a, b), down = size > 30 ? size - 30 : 0;
        at[0] = (int32_t)(a >> down);
        at[1] = (int32_t)(b >> down);
        return down;
    }
    at[0] = lmb_add(lmb_mul(step[0], offset[0]), lmb_mul(step[2], offset[1]));
    at[1] = lmb_add(lmb_mul(step[1], offset[0]), lmb_mul(step[3], offset[1]));
    return fit(at, 2, 15);
}

/* The products that quadratics need: in each direction the first difference takes the numerators half a pixel on, which is half
 * of what lambda's square has for it. Eight steps, half a pixel, are less than 2^16, so with at < 2^15 and steps < 2^13 sums of
 * two products stay under 2^31; of a large triangle products are shifted. */
static void lattice_curve(lmb_lattice *l)
{
    int32_t at[2], on[2];
    unsigned down = numerators_at(l, at), axis, i;
    l->square_q16 = lmb_mulu(l->reciprocal_q16, l->reciprocal_q16) >> 16;
    form_set(l, 0, at, at, 2 * down);
    for (axis = 0; axis < 2; axis++) {
        const int32_t *step = &l->step[2 * axis];
        for (i = 0; i < 2; i++) on[i] = lmb_add(at[i], lmb_shr(lmb_shl(step[i], 3), down));
        form_set(l, 1 + axis, on, step, 5 + down);
        form_set(l, 3 + axis, step, step, 9);
    }
    form_set(l, 5, &l->step[0], &l->step[2], 9);
}

/* The area, the cross product of the steps, and its reciprocal as 16 bits; 1 for none or less. */
static void lattice_area(lmb_lattice *l)
{
    const int32_t *step = l->step;
    uint32_t area;
    unsigned down = 0;
    if (LMB_WITH_LARGE && l->large) {
        int64_t wide = lmb_dot_wide(step[0], step[3], lmb_sub(0, step[1]), step[2]);
        unsigned size = lmb_bits_wide(wide, 0);
        down = size > 32 ? size - 32 : 0;
        area = wide < 1 ? 1 : (uint32_t)(wide >> down);
    } else {
        area = (uint32_t)lmb_max(1, lmb_sub(lmb_mul(step[0], step[3]), lmb_mul(step[1], step[2])));
    }
    l->reciprocal_q16 = (uint32_t)lmb_min((int32_t)((lmb_reciprocal(area, &l->shift) + 0x4000u) >> 15), 65535);
    l->shift += down;
}

/* The pixel of corner 0, and the way to its centre; of a large triangle a pixel from which nothing in the frame is far. */
static int32_t anchor(bool large, int32_t corner, int32_t *offset)
{
    int32_t pixel = lmb_shr(corner, 4);
    if (LMB_WITH_LARGE && large) pixel = lmb_max(0, lmb_min(pixel, ANCHOR_MAX));
    *offset = lmb_sub(lmb_add(lmb_shl(pixel, 4), 8), corner);
    return pixel;
}

void lmb_lattice_begin(lmb_lattice *l, const lmb_vertex *const corner[3], bool curved)
{
    int32_t x0 = corner[0]->x, y0 = corner[0]->y;
    unsigned down = 0;
    l->step[0] = lmb_sub(corner[2]->y, y0);
    l->step[1] = lmb_sub(y0, corner[1]->y);
    l->step[2] = lmb_sub(x0, corner[2]->x);
    l->step[3] = lmb_sub(corner[1]->x, x0);
    if (!LMB_WITH_LARGE) down = fit(l->step, 4, NEAR_BITS); /* a coarser grid */
    l->bits = bits_of(l->step, 4);
    l->large = LMB_WITH_LARGE && l->bits > NEAR_BITS;
    lattice_area(l);
    l->shift += down; /* p / 2^down over area / 4^down is p over area times 2^down */
    l->column = anchor(l->large, x0, &l->offset[0]);
    l->row = anchor(l->large, y0, &l->offset[1]);
    l->curved = curved && l->shift + HEIGHT_BITS >= 2 * l->bits;
    if (l->curved) lattice_curve(l);
}

/* The sum of a form's three products with the curvatures q, |q| < 2^14, over 2^shift, to nearest. Products are formed in two
 * halves; carries go up at once: high parts sum to less than 3 * 2^29, low ones stay under 2^30. */
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
    int i;
    q[0] = lmb_sub(0, net->bulge[0]);
    q[1] = lmb_sub(0, net->bulge[2]);
    q[2] = lmb_shr(lmb_sub(lmb_sub(net->bulge[1], net->bulge[0]), net->bulge[2]), 1);
    for (i = 0; i < 3; i++) q[i] = lmb_mul_q16(q[i], l->square_q16);
    if (!(q[0] | q[1] | q[2])) return;
    /* Q2.30 of 4 * 2^-28 * q 2^(drop + 16) * 2^-(16 + 2 shift) times a form: over 2^base */
    base = 2 * (int32_t)l->shift - 4 - (int32_t)fit(q, 3, CURVATURE_BITS);
    for (i = 0; i < 6; i++) value[i] = form_apply(l->form[i], q, base - (int32_t)l->form_shift[i]);
    plane->f = lmb_add_wrap(plane->f, value[0]);
    plane->dx = lmb_add_wrap(plane->dx, value[1]);
    plane->dy = lmb_add_wrap(plane->dy, value[2]);
    plane->dxx = value[3];
    plane->dyy = value[4];
    plane->dxy = value[5];
}

/* n times the offset over 2^(4 + *drop), below 2^31: what lies between corner 0 and the anchor. Within a pixel in 32 bits,
 * where the low four bits of the numerators go apart. */
static int32_t offset_of(const lmb_lattice *l, const int32_t n[2], int32_t *drop)
{
    int32_t sum = 0;
    unsigned i;
    *drop = LMB_WITH_LARGE && l->large ? (int32_t)bits_of(l->offset, 2) - 3 : 0;
    for (i = 0; i < 2; i++) {
        int32_t offset = l->offset[i];
        sum = lmb_add(sum, LMB_WITH_LARGE && l->large
                               ? lmb_mul_shr(n[i], offset, (unsigned)(4 + *drop))
                               : lmb_add(lmb_mul(lmb_shr(n[i], 4), offset), lmb_shr(lmb_mul(n[i] & 15, offset), 4)));
    }
    return sum;
}

/* Numerators of the gradient, rises times steps, in units of 2^-28 times 2^drop and below 2^31; returns drop. */
static unsigned numerators(const lmb_lattice *l, int32_t rise[2], int32_t n[2])
{
    const int32_t *step = l->step;
    unsigned drop = 0, size, i;
    if (LMB_WITH_LARGE && l->large) {
        int64_t x = lmb_dot_wide(rise[0], step[0], rise[1], step[1]), y = lmb_dot_wide(rise[0], step[2], rise[1], step[3]);
        size = lmb_bits_wide(x, y);
        drop = size > 31 ? size - 31 : 0;
        n[0] = (int32_t)(x >> drop);
        n[1] = (int32_t)(y >> drop);
        return drop;
    }
    size = bits_of(rise, 2) + l->bits;
    if (size > 30) {
        drop = size - 30;
        for (i = 0; i < 2; i++) rise[i] = lmb_shr_round(rise[i], drop);
    }
    n[0] = lmb_add(lmb_mul(rise[0], step[0]), lmb_mul(rise[1], step[1]));
    n[1] = lmb_add(lmb_mul(rise[0], step[2]), lmb_mul(rise[1], step[3]));
    return drop;
}

void lmb_plane_begin(lmb_plane *plane, const lmb_lattice *l, const lmb_net *net)
{
    int32_t rise[2], n[2], offset, offset_drop, shift;
    unsigned i;
    for (i = 0; i < 2; i++) {
        rise[i] = lmb_sub(net->value[1 + i], net->value[0]);
        if (l->curved) rise[i] = lmb_add(rise[i], lmb_shl(net->bulge[2 * i], 2));
    }
    /* per pixel and in Q2.30: numerator * 16 * reciprocal_q16 * 2^-(16 + shift) * 2^(30 - 28 + drop) */
    shift = (int32_t)l->shift + 10 - (int32_t)numerators(l, rise, n);
    offset = offset_of(l, n, &offset_drop);
    plane->f = lmb_add_wrap(lmb_shl_wrap(net->value[0], 2), over_area(offset, l, shift - offset_drop));
    plane->dx = over_area(n[0], l, shift);
    plane->dy = over_area(n[1], l, shift);
    plane->dxx = plane->dxy = plane->dyy = 0;
    if (l->curved) plane_curve(plane, l, net);
}

/* n (n - 1) is even and below 2^32, so its half is exact. */
static int32_t pairs(int32_t n) { return lmb_signed(((uint32_t)n * ((uint32_t)n - 1u)) >> 1); }

void lmb_plane_term(lmb_term *term, const lmb_plane *plane, int32_t columns, int32_t rows)
{
    int32_t f = lmb_add_wrap(plane->f, lmb_mul_wrap(rows, plane->dy)), d = plane->dx, c = plane->dxx;
    if (c | plane->dxy | plane->dyy) {
        f = lmb_add_wrap(f, lmb_mul_wrap(pairs(rows), plane->dyy));
        f = lmb_add_wrap(f, lmb_mul_wrap(pairs(columns), c));
        d = lmb_add_wrap(d, lmb_mul_wrap(rows, plane->dxy));
    }
    term->f = lmb_add_wrap(f, lmb_mul_wrap(columns, d));
    term->d = lmb_add_wrap(d, lmb_mul_wrap(columns, c));
    term->c = c;
}
