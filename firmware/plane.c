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
 * Errors. Linear part: numerators are exact sums of products of the rounded rises, times one reciprocal that all of them share, so
 * its relative error (2^-16) scales the function and does not tear it: the error stays under 2^-16 of the rise, whatever the
 * triangle's shape. Quadratic part: gradients of 14 bits, products exact after that: 4 b times 2^-14 times the triangle's length over
 * its height.
 */
#include "plane.h"

/* Extents are shifted down to this many bits, 1024 pixels, so that areas fit 32 bits. */
#define LATTICE_BITS 14
#define GRADIENT_BITS 14
#define CURVATURE_BITS 13

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

/* Gradients of lambda per pixel as integers of GRADIENT_BITS with one exponent, and the six products that planes need.
 * |g| <= 2^14, |at| <= 2^14, |2 at + g| <= 3 * 2^14: products <= 3 * 2^28, their sums < 2^31. */
static void lattice_curve(lmb_lattice *l)
{
    int32_t gx[2], gy[2], at[2], up[2];
    int drop = (int)l->bits + 16 - GRADIENT_BITS; /* a * reciprocal_q16 < 2^(bits + 16) */
    int i;
    gx[0] = over_area(l->a1, l, drop);
    gy[0] = over_area(l->b1, l, drop);
    gx[1] = over_area(l->a2, l, drop);
    gy[1] = over_area(l->b2, l, drop);
    l->exponent = (unsigned)(12 + (int)l->shift - drop + 64); /* biased by 64: slivers have gradients far above one */
    for (i = 0; i < 2; i++) {
        at[i] = lmb_shr_round(lmb_add(lmb_mul(gx[i], l->offset_x), lmb_mul(gy[i], l->offset_y)), 4);
    }
    form_set(l->form[0], at, at);
    for (i = 0; i < 2; i++) up[i] = lmb_add(lmb_shl(at[i], 1), gx[i]);
    form_set(l->form[1], up, gx);
    for (i = 0; i < 2; i++) up[i] = lmb_add(lmb_shl(at[i], 1), gy[i]);
    form_set(l->form[2], up, gy);
    form_set(l->form[3], gx, gx);
    form_set(l->form[4], gy, gy);
    form_set(l->form[5], gx, gy);
}

void lmb_lattice_begin(lmb_lattice *l, const lmb_vertex *const corner[3], int32_t row, bool curved)
{
    int32_t x0 = corner[0]->x, y0 = corner[0]->y;
    int32_t x1 = lmb_sub(corner[1]->x, x0), y1 = lmb_sub(corner[1]->y, y0);
    int32_t x2 = lmb_sub(corner[2]->x, x0), y2 = lmb_sub(corner[2]->y, y0);
    unsigned size = bits_of(magnitude(x1) | magnitude(y1) | magnitude(x2) | magnitude(y2));
    unsigned down = size > LATTICE_BITS ? size - LATTICE_BITS : 0;
    uint32_t area, reciprocal;
    if (down > 0) { /* a grid coarser than 1/16 pixel, for triangles of more than 1024 pixels */
        x1 = lmb_shr(x1, down);
        y1 = lmb_shr(y1, down);
        x2 = lmb_shr(x2, down);
        y2 = lmb_shr(y2, down);
    }
    l->a1 = y2;
    l->b1 = lmb_sub(0, x2);
    l->a2 = lmb_sub(0, y1);
    l->b2 = x1;
    l->bits = bits_of(magnitude(x1) | magnitude(y1) | magnitude(x2) | magnitude(y2));
    area = (uint32_t)lmb_max(1, lmb_sub(lmb_mul(x1, y2), lmb_mul(x2, y1)));
    reciprocal = lmb_reciprocal(area, &l->shift);
    l->reciprocal_q16 = (uint32_t)lmb_min((int32_t)((reciprocal + 0x4000u) >> 15), 65535);
    l->shift += down; /* p / 2^down over area / 4^down is p over area times 2^down */
    l->offset_x = lmb_sub(8, x0 & 15);
    l->offset_y = lmb_sub(8, y0 & 15);
    l->rows = lmb_sub(row, lmb_shr(y0, 4));
    l->curved = curved;
    if (l->curved) lattice_curve(l);
}

/* The sum of a form's three products with the curvatures q, |q| < 2^13: low parts sum to less than 3 * 2^29. */
static int32_t form_apply(const int32_t form[3], const int32_t q[3], int32_t shift)
{
    int32_t high = 0, low = 0;
    int i;
    for (i = 0; i < 3; i++) {
        high = lmb_add(high, lmb_mul(lmb_shr(form[i], 16), q[i]));
        low = lmb_add(low, lmb_mul((int32_t)((uint32_t)form[i] & 0xffffu), q[i]));
    }
    if (shift > 0 && shift <= 16) { /* to nearest */
        low = lmb_add(low, lmb_shl(1, (unsigned)shift - 1));
    } else if (shift > 16) {
        high = lmb_add_wrap(high, lmb_shl_wrap(1, (unsigned)lmb_min(shift - 17, 31)));
    }
    return join(high, low, shift);
}

static void plane_curve(lmb_plane *plane, const lmb_lattice *l, const lmb_net *net)
{
    int32_t q[3], value[6];
    unsigned size, drop;
    int32_t shift;
    int i;
    /* in units of 4 * 2^-28: |bulge| <= 1, so |q| < 2^30 */
    q[0] = lmb_sub(0, net->bulge01);
    q[1] = lmb_sub(0, net->bulge20);
    q[2] = lmb_shr(lmb_sub(lmb_sub(net->bulge12, net->bulge01), net->bulge20), 1);
    size = bits_of(magnitude(q[0]) | magnitude(q[1]) | magnitude(q[2]));
    if (size == 0) return;
    drop = size > CURVATURE_BITS ? size - CURVATURE_BITS : 0;
    for (i = 0; i < 3 && drop > 0; i++) q[i] = lmb_shr_round(q[i], drop);
    shift = 2 * ((int32_t)l->exponent - 64) + 26 - (int32_t)drop - 30;
    for (i = 0; i < 6; i++) value[i] = form_apply(l->form[i], q, i < 3 ? shift : shift - 1);
    plane->f = lmb_add_wrap(plane->f, value[0]);
    plane->dx = lmb_add_wrap(plane->dx, value[1]);
    plane->dy = lmb_add_wrap(plane->dy, value[2]);
    plane->dxx = value[3];
    plane->dyy = value[4];
    plane->dxy = value[5];
}

/* (n * offset) / 16 with |offset| <= 8, whatever n: the low four bits go apart. */
static int32_t sixteenths(int32_t n, int32_t offset)
{
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
    int32_t rise1 = net->rise1, rise2 = net->rise2, nx, ny, shift;
    unsigned size, room = 30 - l->bits, drop = 0;
    if (l->curved) {
        rise1 = lmb_add(rise1, lmb_shl(net->bulge01, 2));
        rise2 = lmb_add(rise2, lmb_shl(net->bulge20, 2));
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
    plane->f = lmb_add_wrap(lmb_shl_wrap(net->value, 2),
                            over_area(lmb_add(sixteenths(nx, l->offset_x), sixteenths(ny, l->offset_y)), l, shift));
    plane->dx = over_area(nx, l, shift);
    plane->dy = over_area(ny, l, shift);
    plane->dxx = plane->dxy = plane->dyy = 0;
    if (l->curved) plane_curve(plane, l, net);
    plane_descend(plane, l->rows);
}
