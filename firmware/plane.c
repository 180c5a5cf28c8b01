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
 * Linear part: numerators a px + b py are exact integers, multiplied whole by one reciprocal of the area, which dx and dy share.
 * An error of such a factor scales the function and does not tear it, however long and thin the triangle is. (Rounded gradients of
 * lambda were tried first: 99 levels in the worst sliver.)
 * Quadratic part: it is small, so rounded gradients, 15 bits with one exponent, do unless the triangle is as thin as it is bent. With
 * bulges q it is (g1.p)(w.p)/2 + (g2.p)(u.p)/2, w = q0 g1 + q2 g2, u = q1 g2 + q2 g1, and the rounding of w and u grows no faster than
 * the triangle's length over its height. Corner 0 is where l1 = l2 = 0: value and gradient of this part are zero there, and at the
 * anchor, within a pixel of it, they follow from the second differences. Large and very thin triangles, and strong curves across thin
 * ones, take lmb_plane_exact.
 */
#include "plane.h"

#include "edge.h"
#include "step.h"

#define NEAR_BITS 13   /* 512 pixels in 1/16 pixel */
#define ANCHOR_MAX 255 /* pixels: within most displays */
#define BULGE_BITS 27  /* no bulge reaches a half, Q4.28 */
/* Rounded gradients are exact enough up to some product of length over height and the deepest bulge, Q4.28: a half, or, for formats of
 * no more than 6 bits a channel, two. */
#define LIMIT_FINE 27
#define LIMIT_COARSE 29
#define LONG_BITS 7                         /* 128 times: whole products for all their planes */
#define FLAT_BITS (LMB_WITH_LARGE ? 12 : 8) /* 4096 times: they have no curve, as its rounding would exceed it */

unsigned lmb_bits_of(const int32_t *values, unsigned count)
{
    uint32_t all = 0;
    unsigned i;
    LMB_UNROLL
    for (i = 0; i < count; i++) all |= (uint32_t)(values[i] ^ lmb_shr(values[i], 31));
    return 32u - lmb_clz32(all | 1);
}

unsigned lmb_fit(int32_t *values, unsigned count, unsigned bits)
{
    unsigned size = lmb_bits_of(values, count), drop = size > bits ? size - bits : 0, i;
    for (i = 0; i < count; i++) values[i] = lmb_shr(values[i], drop);
    return drop;
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

/* The anchor, pixel by pixel of corner 0, and the way to its centre; of a large triangle a pixel from which nothing in the frame is
 * far. */
static int32_t anchor(const lmb_lattice *l, int32_t corner, int32_t pixel, int32_t *offset)
{
    if (LMB_WITH_LARGE && l->large) pixel = lmb_max(0, lmb_min(pixel, ANCHOR_MAX));
    *offset = lmb_sub(lmb_add(lmb_shl(pixel, 4), 8), corner);
    return pixel;
}

static LMB_APART_IF_FEW void lattice_prepare(lmb_lattice *l)
{
    const lmb_vertex *top = l->corner[0], *next = l->corner[1], *last = l->corner[2];
    int32_t x0 = top->x, y0 = top->y;
    unsigned down = 0;
    l->ready = true;
    l->step[0] = lmb_sub(last->y, y0);
    l->step[1] = lmb_sub(y0, next->y);
    l->step[2] = lmb_sub(x0, last->x);
    l->step[3] = lmb_sub(next->x, x0);
    l->bits = lmb_bits_of(l->step, 4);
    if (!LMB_WITH_LARGE && l->bits > NEAR_BITS) { /* a coarser grid */
        unsigned i;
        down = l->bits - NEAR_BITS;
        l->bits = NEAR_BITS;
        for (i = 0; i < 4; i++) l->step[i] = lmb_shr(l->step[i], down);
    }
    l->large = LMB_WITH_LARGE && l->bits > NEAR_BITS;
    lattice_area(l);
    l->column = anchor(l, x0, lmb_shr(x0, 4), &l->offset[0]);
    l->row = anchor(l, y0, lmb_row_at(y0), &l->offset[1]);
    l->rough = l->large;
    l->exact = LMB_WITH_LARGE && (l->large || l->shift + LONG_BITS < 2 * l->bits);
    l->flat = (l->exact || !LMB_WITH_LARGE) && l->shift + FLAT_BITS < 2 * l->bits;
    l->shift += down; /* p / 2^down over area / 4^down is p over area times 2^down */
}

/* x / 2^shift, shift of any sign, modulo 2^32. */
static LMB_OUTLINE int32_t place(int32_t x, int32_t shift)
{
    if (shift >= 0) return lmb_shr(x, (unsigned)lmb_min(shift, 31));
    return shift > -32 ? lmb_shl_wrap(x, (unsigned)-shift) : 0;
}

/* The gradients as mantissas: steps times the reciprocal, at most 2^(bits + 16), to nearest. */
static void grade(lmb_lattice *l)
{
    unsigned i;
    l->graded = true;
    for (i = 0; i < 4; i++) {
        int32_t product = lmb_add(lmb_mul(l->step[i], (int32_t)l->reciprocal_q16), lmb_shl(1, l->bits));
        l->gradient[i] = lmb_min(lmb_shr(product, l->bits + 1), 32767);
    }
}

/* (a b + c d) / 2^15, to nearest: |.| < 2^14.4 for what plane_curve has. */
static LMB_OUTLINE int32_t mix(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return lmb_shr(lmb_add(lmb_add(lmb_mul16(a, b), lmb_mul16(c, d)), 0x4000), 15);
}

/* place; usual: shift is in 0...31. */
static inline int32_t place_if(int32_t x, int32_t shift, bool usual)
{
    return usual ? lmb_shr(x, (unsigned)shift) : place(x, shift);
}

/* Second differences, and what they make of first ones and the value at the anchor. At the offset o the first differences of half a
 * pixel on are (xx (o + 8) + xy o') / 16, the value (xx o o / 2 + xy o o' + yy o' o' / 2) / 256. */
static inline void curve_place(lmb_plane *plane, const int32_t offset[2], int32_t xx, int32_t xy, int32_t yy, int32_t shift,
                               bool usual)
{
    const int32_t x = offset[0], y = offset[1];
    int32_t sum;
    plane->bow = lmb_half(place_if(xx, shift, usual));
    plane->dxy = place_if(xy, shift, usual);
    plane->dyy = place_if(yy, shift, usual);
    xx = lmb_shr(xx, 5);
    xy = lmb_shr(xy, 5);
    yy = lmb_shr(yy, 5);
    sum = lmb_add(lmb_mul(xx, lmb_add(x, 8)), lmb_mul(xy, y));
    plane->dx = lmb_sub_wrap(lmb_add_wrap(plane->dx, place_if(sum, shift - 1, usual)), plane->bow);
    sum = lmb_add(lmb_mul(yy, lmb_add(y, 8)), lmb_mul(xy, x));
    plane->dy = lmb_add_wrap(plane->dy, place_if(sum, shift - 1, usual));
    sum = lmb_mul(lmb_add(lmb_mul(lmb_shr(xx, 4), x), lmb_mul(lmb_shr(xy, 3), y)), x);
    sum = lmb_add(sum, lmb_mul(lmb_mul(lmb_shr(yy, 4), y), y));
    plane->f = lmb_add_wrap(plane->f, place_if(sum, shift, usual));
}

/* Adds the quadratic part. With bulges raised to q in units of 2^-(15 + up), |q| <= 2^13 and 3 * 2^12, w and u lie within 2^14.4 and a
 * second difference m = g1 w + g2 u within 2^30.4; it is m 2^(2 bits - 2 shift + 11 - up) in Q2.30. */
static LMB_APART void plane_curve(lmb_plane *plane, lmb_lattice *l, const lmb_net *net, unsigned size)
{
    const unsigned up = size < BULGE_BITS ? BULGE_BITS - size : 0;
    const int32_t shift = lmb_mul((int32_t)l->shift - (int32_t)l->bits, 2) - 12 + (int32_t)up;
    int32_t q[3], w[2], u[2], xx, xy, yy, sum;
    unsigned i;
    if (!l->graded) grade(l);
    for (i = 0; i < 3; i++) q[i] = lmb_shr_round(lmb_shl(net->bulge[i], up), 14);
    q[1] = lmb_shr(lmb_sub(lmb_sub(q[1], q[0]), q[2]), 1);
    for (i = 0; i < 2; i++) {
        const int32_t g1 = l->gradient[2 * i], g2 = l->gradient[2 * i + 1];
        w[i] = mix(q[1], g2, lmb_sub(0, q[0]), g1);
        u[i] = mix(q[1], g1, lmb_sub(0, q[2]), g2);
    }
    xx = lmb_add(lmb_mul16(l->gradient[0], w[0]), lmb_mul16(l->gradient[1], u[0]));
    yy = lmb_add(lmb_mul16(l->gradient[2], w[1]), lmb_mul16(l->gradient[3], u[1]));
    xy = lmb_add(lmb_mul16(l->gradient[0], w[1]), lmb_mul16(l->gradient[1], u[1]));
    sum = lmb_add(lmb_mul16(l->gradient[2], w[0]), lmb_mul16(l->gradient[3], u[0])); /* the same but for rounding */
    xy = lmb_add(lmb_shr(xy, 1), lmb_shr(sum, 1));
    if (LMB_SHORT_CUTS && shift > 0 && shift < 32) {
        curve_place(plane, l->offset, xx, xy, yy, shift, true);
    } else {
        curve_place(plane, l->offset, xx, xy, yy, shift, false);
    }
}

/* Rises are below 5.5 in Q4.28, under 2^30.5: over 2^(bits + 1) and times steps two of them stay below 2^30.5, and so does that times
 * the reciprocal over 2^16. What that drops is 2^-27 of the rise times length over height, all along the triangle. */
void lmb_plane_begin(lmb_plane *plane, lmb_lattice *l, const lmb_net *net)
{
    int32_t a, b, x, y, shift;
    unsigned size = 0;
    bool curved, exact;
    if (!l->ready) lattice_prepare(l);
    curved = LMB_WITH_QUADRATIC && net->curved && !l->flat;
    exact = l->exact;
    a = lmb_sub(net->value[1], net->value[0]);
    b = lmb_sub(net->value[2], net->value[0]);
    if (curved) {
        size = lmb_bits_of(net->bulge, 3);
        if (size + 2 * l->bits > l->shift + (l->tolerance < LMB_TOLERANCE_RGB565 ? LIMIT_FINE : LIMIT_COARSE))
            l->rough = exact = true;
        a = lmb_add(a, lmb_shl(net->bulge[0], 2));
        b = lmb_add(b, lmb_shl(net->bulge[2], 2));
    }
    if (LMB_WITH_LARGE && exact) {
        lmb_plane_exact(plane, l, net);
        return;
    }
    a = lmb_shr_round(a, l->bits + 1);
    b = lmb_shr_round(b, l->bits + 1);
    x = lmb_mul_q16(lmb_add(lmb_mul(a, l->step[0]), lmb_mul(b, l->step[1])), l->reciprocal_q16);
    y = lmb_mul_q16(lmb_add(lmb_mul(a, l->step[2]), lmb_mul(b, l->step[3])), l->reciprocal_q16);
    /* per pixel and in Q2.30: numerator * 16 * reciprocal_q16 * 2^-(16 + shift) * 2^(30 - 28 + bits + 1) */
    shift = (int32_t)l->shift - 7 - (int32_t)l->bits;
    plane->dx = place(x, shift);
    plane->dy = place(y, shift);
    /* times the offset over 16: between corner 0 and the anchor */
    x = lmb_add(lmb_mul(lmb_shr(x, 5), l->offset[0]), lmb_mul(lmb_shr(y, 5), l->offset[1]));
    plane->f = lmb_add_wrap(lmb_shl_wrap(net->value[0], 2), place(x, shift - 1));
    plane->bow = plane->dxy = plane->dyy = 0;
    if (curved) plane_curve(plane, l, net, size);
}

/* n (n - 1) / 2: even before it is halved, and below 2^32. |n| < 2^16. */
static int32_t pairs(int32_t n) { return lmb_signed(((uint32_t)n * ((uint32_t)n - 1u)) >> 1); }

void lmb_plane_down(lmb_plane *p, int32_t rows)
{
    p->f = lmb_add_wrap(p->f, lmb_add_wrap(lmb_mul_wrap(rows, p->dy), lmb_mul_wrap(pairs(rows), p->dyy)));
    p->dx = lmb_add_wrap(p->dx, lmb_mul_wrap(rows, p->dxy));
    p->dy = lmb_add_wrap(p->dy, lmb_mul_wrap(rows, p->dyy));
}
