/* SPDX-License-Identifier: MIT */
/* Triangle edges, walked row by row without error.
 *
 * On the row with centre yc an edge crosses at X = x0 + dx (yc - y0) / dy, in 1/16 pixel. The first pixel whose centre is not
 * left of it is ceil((X - 8) / 16). Bresenham's method keeps that quotient and its remainder: x, and gap = 16 dy x - N with N =
 * (x0 - 8) dy + dx (yc - y0), 0 <= gap < 16 dy. A row adds 16 dx to N, so x grows by floor(dx / dy) and gap shrinks by 16 (dx
 * mod dy), with one carry. Spans take the same ceiling at both ends: that is the top-left rule, and neighbours that share an
 * edge, in whatever direction, get the same number.
 *
 * The quotients are small, a bit or two for most edges, so they are found bit by bit: five instructions each, where a reciprocal
 * would take a hundred before the first.
 */
#include "edge.h"

LMB_STATIC_ASSERT(LMB_SCREEN_MAX < (1L << 19)); /* so dx, dy < 2^20 and modulus < 2^24 */

/* floor(a / by); the rest goes to *rest. by is in 1...2^24; the doubled one stops above |a|, so below 2^32. */
static int32_t quotient(int32_t a, uint32_t by, int32_t *rest)
{
    uint32_t left = (uint32_t)(a < 0 ? ~a : a), part = by, q = 0;
    while (part <= left) part <<= 1;
    while (part != by) {
        part >>= 1;
        q <<= 1;
        if (left >= part) {
            left -= part;
            q++;
        }
    }
    *rest = (int32_t)(a < 0 ? by - 1 - left : left); /* -1 - a = q by + left, so a = (-1 - q) by + by - 1 - left */
    return a < 0 ? ~(int32_t)q : (int32_t)q;
}

/* Rows that can be skipped at once: rows * part < 128 * 2^24 = 2^31. */
#define SKIP_MAX 127

static LMB_APART void skip(lmb_edge *edge, int32_t rows)
{
    while (rows > 0) {
        int32_t n = lmb_min(rows, SKIP_MAX);
        /* gap - n part, negative: N grows, x by the ceiling, -floor(-n / modulus) */
        int32_t left = lmb_sub(edge->gap, lmb_mul(n, edge->part));
        edge->x = lmb_sub(lmb_add(edge->x, lmb_mul(n, edge->step)), quotient(left, (uint32_t)edge->modulus, &edge->gap));
        rows = lmb_sub(rows, n);
    }
}

void lmb_edge_begin(lmb_edge *edge, const lmb_vertex *top, const lmb_vertex *bottom, int32_t row)
{
    int32_t dx = lmb_sub(bottom->x, top->x), dy = lmb_sub(bottom->y, top->y), first = lmb_row_at(top->y);
    int32_t below = lmb_sub(lmb_add(lmb_shl(first, 4), 8), top->y); /* of the first centre, 0 to 15 */
    int32_t left = lmb_sub(top->x, 8), part;
    edge->modulus = lmb_shl(dy, 4);
    edge->step = lmb_shr(dx, 31);
    part = dx < 0 ? lmb_add(dx, dy) : dx;
    if ((uint32_t)part >= (uint32_t)dy) edge->step = quotient(dx, (uint32_t)dy, &part);
    edge->part = lmb_shl(part, 4);
    /* ceil(N / modulus) = -floor(-N / modulus) of the part of N beyond whole pixels; |N| <= 15 * 2^20 + 15 * 2^20 < 2^25 */
    edge->x = lmb_sub(lmb_shr(left, 4), quotient(lmb_sub(0, lmb_add(lmb_mul(left & 15, dy), lmb_mul(dx, below))),
                                                 (uint32_t)edge->modulus, &edge->gap));
    if (row > first) skip(edge, lmb_sub(row, first));
}
