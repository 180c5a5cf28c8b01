/* SPDX-License-Identifier: MIT */
/* Triangle edges as one number a row.
 *
 * edge.c walks a remainder and is exact for edges of any size, in five loads and a carry a row. Here x and its step are single numbers
 * with 20 fraction bits, both rounded down. The first pixel whose centre is not left of the edge is the ceiling of the crossing
 * X = N / (16 dy), N whole: that of what is carried, as long as it lies above X - 1 / (16 dy) and not above X. So it may lack 2^16 /
 * dy units of 2^-20, and a step lacks hardly more than one: edges of up to 60 rows need no second thought, higher ones are begun anew
 * before their rows have used it up.
 *
 * The quotient dx / dy is found in two digits of ten bits, by a reciprocal of 17 that is never above the truth:
 *   first digit   |dx| < 2^13 times 2^17. Negative ones take a reciprocal that is not below the truth, so that both are floored
 *   remainder     not negative, and less than dy + 2^-16 2^10 |dx| < dy + 2^7 < 2^14
 *   second digit  less than 2^14 times 2^17; the step lacks less than 1 + 2^-6 + 2^-12 |dx| / dy units, and over all rows of an edge,
 *                 dy / 16 + 1, the last of these adds up to less than 1/8 + 2 / dy, where 2^16 / dy are allowed
 */
#include "stride.h"

#include "edge.h"

#define FIRST 10 /* bits of the first digit; the second has those that are left */
LMB_STATIC_ASSERT(LMB_STRIDE_BITS == 2 * FIRST);
LMB_STATIC_ASSERT(LMB_STRIDE_MAX ==
                  1L << 13); /* 512 pixels, so that x keeps to its 12 bits, one step beyond the edge's end, too */

/* From the exact quotient, for rows far below the edge's top: less than a unit too small. */
static LMB_APART int32_t far_below(const lmb_vertex *top, const lmb_vertex *bottom, int32_t column, int32_t row)
{
    lmb_edge edge;
    uint32_t rest, q = 0;
    unsigned i;
    lmb_edge_begin(&edge, top, bottom, row);
    rest = (uint32_t)edge.gap;
    for (i = 0; i < LMB_STRIDE_BITS; i++) {
        rest <<= 1;
        q <<= 1;
        if (rest >= (uint32_t)edge.modulus) {
            rest -= (uint32_t)edge.modulus;
            q++;
        }
    }
    return lmb_add(lmb_shl(lmb_sub(edge.x, column), LMB_STRIDE_BITS), (1L << LMB_STRIDE_BITS) - 2 - (int32_t)q);
}

/* How far 1 to 2^13 - 1 is to be raised to fill 16 bits. Cores without CLZ search for it, in four steps here. */
static inline unsigned zeros_of(uint32_t x)
{
#if LMB_CLZ
    return lmb_clz32(x) - 16;
#else
    unsigned zeros = 3;
    x <<= 3;
    if (x < 1u << 8) zeros += 8, x <<= 8;
    if (x < 1u << 12) zeros += 4, x <<= 4;
    if (x < 1u << 14) zeros += 2, x <<= 2;
    return x < 1u << 15 ? zeros + 1 : zeros;
#endif
}

/* 2^(32 - zeros) / dy, 17 bits: the first two steps of lmb_reciprocal, of which the second is exact but for rounding down. It is not
 * above the truth, and less than 2^-15 of it below. */
static inline uint32_t inverse_q17(uint32_t dy, unsigned zeros)
{
    const uint32_t m_q15 = dy << zeros, r0_q16 = 92672 - m_q15 + (m_q15 >> 4);
    const uint32_t r1_q10 = (lmb_mulu(r0_q16, (0u - lmb_mulu(m_q15, r0_q16)) >> 16) >> 21) + 2;
    const int32_t e1_q25 = lmb_sub(1L << 25, (int32_t)lmb_mulu(m_q15, r1_q10));
    return (r1_q10 << 7) + (uint32_t)lmb_shr(lmb_mul(e1_q25, (int32_t)r1_q10), 18);
}

/* dx / dy, LMB_STRIDE_BITS of fraction, modulo 2^32; it fits from a dy of 4 on. */
static LMB_APART_IF_FEW int32_t step_of(int32_t dx, int32_t dy)
{
    const unsigned zeros = zeros_of((uint32_t)dy), shift = 32 - FIRST - zeros;
    const uint32_t r_q17 = inverse_q17((uint32_t)dy, zeros);
    const int32_t first = lmb_shr(lmb_mul(dx, (int32_t)r_q17 + (lmb_shr(dx, 31) & 4)), shift);
    const uint32_t rest = (uint32_t)lmb_sub(lmb_shl(dx, FIRST), lmb_mul(first, dy));
    return lmb_add_wrap(lmb_shl_wrap(first, FIRST), (int32_t)(lmb_mulu(rest, r_q17) >> shift));
}

/* x so many columns from where they count, Q28.4, and a part of a row further down, in 1/16. */
static inline int32_t start_of(int32_t x, int32_t step, int32_t part)
{
    const int32_t along = lmb_add(lmb_mul(lmb_shr(step, 4), part), lmb_shr(lmb_mul(step & 15, part), 4));
    /* a half more, as that of the first pixel's centre, and a unit less than one, to be rounded up */
    return lmb_add(along, lmb_add(lmb_shl(x, LMB_STRIDE_BITS - 4), (1L << (LMB_STRIDE_BITS - 1)) - 1));
}

/* Rows for which a stride serves: 7/8 of what dy allows, less what its start takes; none if its step does not
 * fit. */
#define LOW 4
#define HIGH 960 /* so 61 rows, which take 63 of 68 units */
static int32_t rows_good(int32_t dy)
{
    return dy < LOW ? 0 : dy < HIGH ? 110 : dy < 1024 ? 54 : dy < 2048 ? 26 : dy < 4096 ? 12 : 5;
}

/* Any side, from row y on; returns the row from where on it must be begun anew, if it reaches that far. */
static LMB_APART int32_t any_begin(lmb_stride *stride, const lmb_vertex *top, const lmb_vertex *bottom, int32_t column, int32_t y)
{
    const int32_t dy = lmb_sub(bottom->y, top->y), below = lmb_sub(lmb_add(lmb_shl(y, 4), 8), top->y), rows = lmb_shr(below, 4);
    const int32_t good = rows_good(dy), step = step_of(lmb_sub(bottom->x, top->x), dy);
    stride->step = step;
    if (rows >= good) {
        stride->x = far_below(top, bottom, column, y);
        return lmb_add(y, lmb_max(good, 1));
    }
    stride->x = lmb_add(start_of(lmb_sub(top->x, lmb_shl(column, 4)), step, below & 15), lmb_mul(step, rows));
    return lmb_add(lmb_sub(y, rows), good);
}

static LMB_APART void any_turn(lmb_triangle *t)
{
    const unsigned lower = t->y >= t->y_switch;
    const lmb_vertex *const *corner = t->corner;
    int32_t good;
    if (t->y >= t->y_long) { t->y_long = any_begin(&t->walk.stride[t->long_right], corner[0], corner[2], t->column, t->y); }
    good = any_begin(&t->walk.stride[!t->long_right], corner[lower], corner[lower + 1], t->column, t->y);
    t->y_turn = lmb_min(lower ? t->y_end : lmb_min(t->y_switch, t->y_end), lmb_min(good, t->y_long));
}

static inline bool is_usual(int32_t dy) { return (uint32_t)lmb_sub(dy, LOW) < HIGH - LOW; }

/* From below the middle corner on, at the first row there. */
static void lower_begin(lmb_triangle *t)
{
    const lmb_vertex *top = t->corner[1], *bottom = t->corner[2];
    lmb_stride *const side = &t->walk.stride[!t->long_right];
    const int32_t x = top->x, y = top->y, dy = lmb_sub(bottom->y, y);
    int32_t step;
    if (dy < LOW) {
        any_turn(t);
        return;
    }
    step = step_of(lmb_sub(bottom->x, x), dy);
    side->step = step;
    side->x = start_of(lmb_sub(x, lmb_shl(t->column, 4)), step, lmb_sub(8, y) & 15);
    t->y_turn = t->y_end;
}

/* Most triangles have no more than 60 rows, and their first one is seen. */
void lmb_strides_begin(lmb_triangle *t)
{
    const lmb_vertex *top = t->corner[0], *middle = t->corner[1], *bottom = t->corner[2];
    const int32_t x = top->x, y = top->y, part = lmb_sub(lmb_add(lmb_shl(t->y, 4), 8), y), in = x & 15;
    const int32_t dy = lmb_sub(bottom->y, y), short_dy = lmb_sub(middle->y, y);
    lmb_stride *side = &t->walk.stride[t->long_right];
    int32_t step;
    t->walked = LMB_WALKED_STRIDES;
    t->column = lmb_shr(x, 4); /* where planes of triangles stand that are no larger than this (plane.c) */
    t->y_long = t->y;
    if (!is_usual(dy) || part > 15 || (short_dy < LOW && t->y < t->y_switch)) {
        any_turn(t);
        return;
    }
    t->y_long = t->y_end;
    step = step_of(lmb_sub(bottom->x, x), dy);
    side->step = step;
    side->x = start_of(in, step, part);
    if (t->y >= t->y_switch) {
        lower_begin(t);
        return;
    }
    side = &t->walk.stride[!t->long_right];
    step = step_of(lmb_sub(middle->x, x), short_dy);
    side->step = step;
    side->x = start_of(in, step, part);
    t->y_turn = lmb_min(t->y_switch, t->y_end);
}

void lmb_strides_turn(lmb_triangle *t)
{
    if (t->y == t->y_switch && t->y_long >= t->y_end) {
        lower_begin(t);
    } else {
        any_turn(t);
    }
}
