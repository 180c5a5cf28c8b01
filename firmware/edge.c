/* SPDX-License-Identifier: MIT */
/* Triangle edges, walked row by row without error.
 *
 * On the row with centre yc an edge crosses at X = x0 + dx (yc - y0) / dy, in 1/16 pixel. The first pixel whose centre is not
 * left of it is ceil((X - 8) / 16). Bresenham's method keeps that quotient and its remainder: x, and gap = 16 dy x - N with N =
 * (x0 - 8) dy + dx (yc - y0), 0 <= gap < 16 dy. A row adds 16 dx to N, so x grows by floor(dx / dy) and gap shrinks by 16 (dx
 * mod dy), with one carry. Spans take the same ceiling at both ends: that is the top-left rule, and neighbours that share an
 * edge, in whatever direction, get the same number.
 *
 * Quotients by 16 dy come from a reciprocal of 16 bits, twice, and one correction of at most one; nothing is approximated in the
 * end. No product needs 64 bits.
 */
#include "edge.h"

LMB_STATIC_ASSERT(LMB_SCREEN_MAX < (1L << 19)); /* so dx, dy < 2^20 and modulus < 2^24 */

/* modulus * reciprocal_q16 = 2^(16 + shift) (1 - e), 0 < e < 2^-14 */
typedef struct divisor {
    int32_t modulus;
    uint32_t reciprocal_q16;
    unsigned shift;
} divisor;

/* floor(a / modulus); the rest goes to *rest. |a| < 2^31, |a / modulus| < 2^21: the first estimate errs by at most 2^-14 of
 * itself and one for the floor, so what is left is under 2^17 + modulus, and under 130 times the modulus; the second errs by at
 * most one. */
static int32_t divide(int32_t a, const divisor *by, uint32_t *rest)
{
    int32_t quotient = 0;
    int pass;
    for (pass = 0; pass < 2; pass++) {
        int32_t estimate = lmb_shr(lmb_mul_q16(a, by->reciprocal_q16), by->shift);
        quotient = lmb_add(quotient, estimate);
        a = lmb_sub(a, lmb_mul(estimate, by->modulus));
    }
    if (a < 0) {
        quotient = lmb_sub(quotient, 1);
        a = lmb_add(a, by->modulus);
    } else if (a >= by->modulus) {
        quotient = lmb_add(quotient, 1);
        a = lmb_sub(a, by->modulus);
    }
    *rest = (uint32_t)a;
    return quotient;
}

/* Rows that can be skipped at once: rows * part < 128 * 2^24 = 2^31. */
#define SKIP_MAX 127

static void skip(lmb_edge *edge, int32_t rows, const divisor *by)
{
    while (rows > 0) {
        int32_t n = lmb_min(rows, SKIP_MAX);
        /* gap - n part, negative: N grows, x by the ceiling, -floor(-n / modulus) */
        int32_t left = (int32_t)edge->gap - (int32_t)lmb_mulu((uint32_t)n, edge->part);
        edge->x = lmb_sub(lmb_add(edge->x, lmb_mul(n, edge->step)), divide(left, by, &edge->gap));
        rows = lmb_sub(rows, n);
    }
}

void lmb_edge_begin(lmb_edge *edge, const lmb_vertex *top, const lmb_vertex *bottom, int32_t row)
{
    int32_t dx = lmb_sub(bottom->x, top->x), dy = lmb_sub(bottom->y, top->y), first = lmb_row_at(top->y);
    int32_t below = lmb_sub(lmb_add(lmb_shl(first, 4), 8), top->y); /* of the first centre, 0 to 15 */
    int32_t left = lmb_sub(top->x, 8);
    divisor by;
    by.modulus = lmb_shl(dy, 4);
    by.reciprocal_q16 = lmb_reciprocal((uint32_t)by.modulus, &by.shift) >> 15;
    edge->modulus = (uint32_t)by.modulus;
    edge->step = divide(lmb_shl(dx, 4), &by, &edge->part);
    /* ceil(N / modulus) = -floor(-N / modulus) of the part of N beyond whole pixels; |N| <= 15 * 2^20 + 15 * 2^20 < 2^25 */
    edge->x = lmb_sub(lmb_shr(left, 4), divide(lmb_sub(0, lmb_add(lmb_mul(left & 15, dy), lmb_mul(dx, below))), &by, &edge->gap));
    skip(edge, lmb_sub(row, first), &by);
}
