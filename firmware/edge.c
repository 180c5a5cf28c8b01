/* SPDX-License-Identifier: MIT */
/* Triangle edges, walked row by row without error.
 *
 * On the row with centre yc an edge crosses at X = x0 + dx (yc - y0) / dy, in 1/16 pixel. The first pixel whose centre is not left
 * of it is ceil((X - 8) / 16). Bresenham's method keeps that quotient and its remainder: x, and gap = 16 dy x - N with
 * N = (x0 - 8) dy + dx (yc - y0), 0 <= gap < 16 dy. A row adds 16 dx to N, so x grows by floor(dx / dy) and gap shrinks by
 * 16 (dx mod dy), with one carry. Spans take the same ceiling at both ends: that is the top-left rule, and neighbours that share
 * an edge, in whatever direction, get the same number.
 *
 * Quotients come from a reciprocal and one correction of at most one; nothing is approximated in the end.
 */
#include "edge.h"

LMB_STATIC_ASSERT(LMB_SCREEN_MAX < (1L << 19)); /* so dx, dy < 2^20 and modulus < 2^24 */

typedef struct lmb_quotient {
    int32_t floor;
    uint32_t rest;
} lmb_quotient;

/* floor(a / b) and the rest, b = 2^scale * d, from the reciprocal of d.
 * |a| < 2^31, |a / b| < 2^21: the estimate errs by less than 2^21 / 2^28 before it is floored, so by at most one after. */
static lmb_quotient divide(int32_t a, uint32_t d, unsigned scale, uint32_t reciprocal, unsigned shift)
{
    lmb_quotient q;
    int32_t b = (int32_t)(d << scale), rest;
    q.floor = lmb_mul_shr(a, (int32_t)(reciprocal >> 1), 30 + shift + scale);
    rest = lmb_sub(a, lmb_mul(q.floor, b));
    if (rest < 0) {
        q.floor = lmb_sub(q.floor, 1);
        rest = lmb_add(rest, b);
    } else if (rest >= b) {
        q.floor = lmb_add(q.floor, 1);
        rest = lmb_sub(rest, b);
    }
    q.rest = (uint32_t)rest;
    return q;
}

/* Rows that can be skipped at once: rows * part < 128 * 2^24 = 2^31. */
#define SKIP_MAX 127

static void skip(lmb_edge *edge, int32_t rows, uint32_t dy, uint32_t reciprocal, unsigned shift)
{
    while (rows > 0) {
        int32_t n = lmb_min(rows, SKIP_MAX);
        int32_t over = (int32_t)(lmb_mulu((uint32_t)n, edge->part)) - (int32_t)edge->gap;
        edge->x = lmb_add(edge->x, lmb_mul(n, edge->step));
        if (over > 0) { /* carries = ceil(over / modulus) = floor((over - 1) / modulus) + 1 */
            lmb_quotient q = divide(over - 1, dy, 4, reciprocal, shift);
            edge->x = lmb_add(edge->x, lmb_add(q.floor, 1));
            edge->gap = edge->modulus - 1 - q.rest;
        } else {
            edge->gap = (uint32_t)-over;
        }
        rows = lmb_sub(rows, n);
    }
}

void lmb_edge_begin(lmb_edge *edge, int32_t x0, int32_t y0, int32_t x1, int32_t y1, int32_t row)
{
    uint32_t dy = (uint32_t)lmb_sub(y1, y0);
    int32_t dx = lmb_sub(x1, x0), first = lmb_row_at(y0);
    int32_t below = lmb_sub(lmb_add(lmb_shl(first, 4), 8), y0); /* of the first centre, 0 to 15 */
    int32_t left = lmb_sub(x0, 8), n;
    unsigned shift;
    uint32_t reciprocal = lmb_reciprocal(dy, &shift);
    lmb_quotient q = divide(dx, dy, 0, reciprocal, shift);
    edge->step = q.floor;
    edge->part = q.rest << 4;
    edge->modulus = dy << 4;
    /* ceil(n / modulus) = -floor(-n / modulus); |n| <= 15 * 2^20 + 15 * 2^20 < 2^25 */
    n = lmb_add(lmb_mul(left & 15, (int32_t)dy), lmb_mul(dx, below));
    q = divide(-n, dy, 4, reciprocal, shift);
    edge->x = lmb_sub(lmb_shr(left, 4), q.floor);
    edge->gap = q.rest;
    skip(edge, lmb_sub(row, first), dy, reciprocal, shift);
}
