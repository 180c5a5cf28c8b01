/* SPDX-License-Identifier: MIT */
/* Quadratics over triangles that are large or very thin, or thin and bent: as plane.c has them, with whole numerators in the quadratic part
 * as well, so that nothing tears however long and thin the triangle is.
 *
 * Numerators are products of up to 64 bits; only what multiplies the whole is rounded: the rises and bulges (14 bits and more)
 * and one reciprocal of the area, or of its square, which all six numbers of a plane share. Errors stay under 2^-15 of the rise
 * and 2^-13 of four bulges, plus 2^-30 n^2 over n pixels.
 *
 * The anchor of a triangle that reaches over more than 512 pixels is moved from corner 0 into [0, ANCHOR_MAX] (plane.c), so that
 * the rounding of second differences, 2^-31, is not carried over ten thousand pixels. That depends on the triangle alone, never
 * on the window.
 */
#include "plane.h"

#if LMB_WITH_LARGE

#define CURVATURE_BITS 14

/* What the six numbers of a quadratic share: the curvatures q, |q| < 2^14, and the shift that the sums of three products take. */
typedef struct curvature {
    int32_t q[3], shift;
} curvature;

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

/* numerator times the reciprocal of the area, over 2^shift, floored, modulo 2^32. Its low 16 bits go first. */
static int32_t over_area(int32_t numerator, uint32_t reciprocal_q16, int32_t shift)
{
    uint32_t low = lmb_mulu((uint32_t)numerator & 0xffffu, reciprocal_q16);
    int32_t high = lmb_add_wrap(lmb_mul(lmb_shr(numerator, 16), (int32_t)reciprocal_q16), (int32_t)(low >> 16));
    return join(high, (int32_t)(low & 0xffffu), shift);
}

/* Two numbers of 64 bits, shifted down until they lie within 2^bits; returns how far. */
static unsigned wide_pair(int32_t out[2], int64_t a, int64_t b, unsigned bits)
{
    unsigned size = lmb_bits_wide(a, b), down = size > bits ? size - bits : 0;
    out[0] = (int32_t)(a >> down);
    out[1] = (int32_t)(b >> down);
    return down;
}

/* The same of a sum a b + c d of which b and d are below 2^13, and a and c below 2^31: in halves, high 2^16 + low. */
static int32_t halves(int32_t *low, int32_t a, int32_t b, int32_t c, int32_t d)
{
    const int32_t below = lmb_add(lmb_mul(a & 0xffff, b), lmb_mul(c & 0xffff, d));
    *low = below & 0xffff;
    return lmb_add(lmb_add(lmb_mul(lmb_shr(a, 16), b), lmb_mul(lmb_shr(c, 16), d)), lmb_shr(below, 16));
}

static unsigned small_pair(int32_t out[2], const int32_t rise[2], const int32_t *step)
{
    int32_t high[2], low[2];
    unsigned size, down, i;
    for (i = 0; i < 2; i++) high[i] = halves(&low[i], rise[0], step[2 * i], rise[1], step[2 * i + 1]);
    size = lmb_bits_of(high, 2);
    down = size > 15 ? size - 15 : 0; /* up to 14: 31 bits are left */
    for (i = 0; i < 2; i++) out[i] = lmb_add(lmb_shl(high[i], 16 - down), lmb_shr(low[i], down));
    return down;
}

/* a b / 2^down, floored, below 2^31; in products of 32 bits where b is below 2^15 and down at most 16. Its upper part alone can pass
 * 2^31 by what the lower takes back. */
static int32_t product(int32_t a, int32_t b, unsigned down, bool narrow)
{
    if (!narrow) return lmb_mul_shr(a, b, down);
    return lmb_add_wrap(lmb_shl_wrap(lmb_mul(lmb_shr(a, 16), b), 16 - down), lmb_shr(lmb_mul(a & 0xffff, b), down));
}

/* One of the six numbers: the quadratic form with numerators u and v in the place of lambda, which stand for themselves times
 * 2^scale in all. The products (lambda1 lambda1, lambda2 lambda2, lambda1 lambda2 twice) are shifted down to stay under 2^30, times q
 * they are formed in two halves; carries go up at once: high parts sum to less than 3 * 2^29, low ones stay under 2^30. To
 * nearest. */
static int32_t form(const curvature *c, const int32_t u[2], const int32_t v[2], unsigned scale)
{
    const unsigned right = lmb_bits_of(v, 2), size = lmb_bits_of(u, 2) + right, down = size > 30 ? size - 30 : 0;
    const bool narrow = right <= 15 && down <= 16;
    int32_t of[3], high = 0, low = 0, shift = c->shift - (int32_t)(scale + down);
    unsigned i;
    of[0] = product(u[0], v[0], down, narrow);
    of[1] = product(u[1], v[1], down, narrow);
    of[2] = lmb_add(product(u[0], v[1], down, narrow), product(u[1], v[0], down, narrow));
    for (i = 0; i < 3; i++) {
        low = lmb_add(low, lmb_mul((int32_t)((uint32_t)of[i] & 0xffffu), c->q[i]));
        high = lmb_add(lmb_add(high, lmb_mul(lmb_shr(of[i], 16), c->q[i])), lmb_shr(low, 16));
        low &= 0xffff;
    }
    if (shift > 0 && shift <= 16) {
        low = lmb_add(low, lmb_shl(1, (unsigned)shift - 1));
    } else if (shift > 16) {
        high = lmb_add_wrap(high, lmb_shl_wrap(1, (unsigned)lmb_min(shift - 17, 31)));
    }
    return join(high, low, shift);
}

/* Adds the quadratic part. Bulges are below one in magnitude, so |q| < 2^30 in units of 4 * 2^-28. In each direction the first
 * difference takes the numerators half a pixel on, which is half of what lambda's square has for it. */
static void exact_curve(lmb_plane *plane, const lmb_lattice *l, const lmb_net *net)
{
    const uint32_t square_q16 =
        lmb_mulu(l->reciprocal_q16, l->reciprocal_q16) >> 16; /* 1 / area^2 = square * 2^-(16 + 2 shift) */
    const int32_t *x = &l->step[0], *y = &l->step[2];
    int32_t at[2], on[2][2];
    unsigned down, i;
    curvature c;
    c.q[0] = lmb_sub(0, net->bulge[0]);
    c.q[1] = lmb_sub(0, net->bulge[2]);
    c.q[2] = lmb_shr(lmb_sub(lmb_sub(net->bulge[1], net->bulge[0]), net->bulge[2]), 1);
    for (i = 0; i < 3; i++) c.q[i] = lmb_mul_q16(c.q[i], square_q16);
    if (!(c.q[0] | c.q[1] | c.q[2])) return;
    /* Q2.30 of 4 * 2^-28 * q 2^(drop + 16) * 2^-(16 + 2 shift) times a form */
    c.shift = 2 * (int32_t)l->shift - 4 - (int32_t)lmb_fit(c.q, 3, CURVATURE_BITS);
    if (l->large) {
        down = wide_pair(at, lmb_dot_wide(x[0], l->offset[0], y[0], l->offset[1]),
                         lmb_dot_wide(x[1], l->offset[0], y[1], l->offset[1]), 30);
    } else {
        down = 0;
        for (i = 0; i < 2; i++) at[i] = lmb_add(lmb_mul(x[i], l->offset[0]), lmb_mul(y[i], l->offset[1]));
    }
    for (i = 0; i < 2; i++) {
        on[0][i] = lmb_add(at[i], lmb_shr(lmb_shl(x[i], 3), down));
        on[1][i] = lmb_add(at[i], lmb_shr(lmb_shl(y[i], 3), down));
    }
    plane->f = lmb_add_wrap(plane->f, form(&c, at, at, 2 * down));
    plane->dx = lmb_add_wrap(plane->dx, form(&c, on[0], x, 5 + down));
    plane->dy = lmb_add_wrap(plane->dy, form(&c, on[1], y, 5 + down));
    plane->bow = form(&c, x, x, 8);
    plane->dx = lmb_sub_wrap(plane->dx, plane->bow);
    plane->dyy = form(&c, y, y, 9);
    plane->dxy = form(&c, x, y, 9);
}

void lmb_plane_exact(lmb_plane *plane, const lmb_lattice *l, const lmb_net *net)
{
    const int32_t *step = l->step;
    const bool curved = net->curved && !l->flat;
    int32_t rise[2], n[2], offset, shift, far;
    unsigned drop, i;
    for (i = 0; i < 2; i++) {
        rise[i] = lmb_sub(net->value[1 + i], net->value[0]);
        if (curved) rise[i] = lmb_add(rise[i], lmb_shl(net->bulge[2 * i], 2));
    }
    if (l->large) {
        drop =
            wide_pair(n, lmb_dot_wide(rise[0], step[0], rise[1], step[1]), lmb_dot_wide(rise[0], step[2], rise[1], step[3]), 31);
    } else {
        drop = small_pair(n, rise, step);
    }
    /* per pixel and in Q2.30: numerator * 16 * reciprocal_q16 * 2^-(16 + shift) * 2^(30 - 28 + drop) */
    shift = (int32_t)l->shift + 10 - (int32_t)drop;
    far = lmb_max(0, (int32_t)lmb_bits_of(l->offset, 2) - 3);
    offset = lmb_add(product(n[0], l->offset[0], (unsigned)(4 + far), !l->large),
                     product(n[1], l->offset[1], (unsigned)(4 + far), !l->large));
    plane->f = lmb_add_wrap(lmb_shl_wrap(net->value[0], 2), over_area(offset, l->reciprocal_q16, shift - far));
    plane->dx = over_area(n[0], l->reciprocal_q16, shift);
    plane->dy = over_area(n[1], l->reciprocal_q16, shift);
    plane->bow = plane->dxy = plane->dyy = 0;
    if (curved) exact_curve(plane, l, net);
}

#else
typedef int lmb_no_plane_exact; /* a translation unit needs a declaration */
#endif
