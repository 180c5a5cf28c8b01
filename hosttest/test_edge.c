/* SPDX-License-Identifier: MIT */
/* Edges walked row by row against exact quotients in 64 bits: where they begin, wherever they are entered, and every step. */
#include "../firmware/edge.h"
#include "test.h"

/* The first pixel whose centre is not left of the edge on a row: ceil((X - 8) / 16) of the exact crossing X. */
static int64_t exact_x(const lmb_vertex *top, const lmb_vertex *bottom, int32_t row)
{
    int64_t dx = (int64_t)bottom->x - top->x, dy = (int64_t)bottom->y - top->y, modulus = 16 * dy;
    int64_t n = (int64_t)(top->x - 8) * dy + dx * (16 * (int64_t)row + 8 - top->y);
    return n >= 0 ? (n + modulus - 1) / modulus : -(-n / modulus);
}

static int32_t random_size(test_random *r, double most) { return (int32_t)exp(test_real(r, 0, log(most))); }

/* An edge of any length and slope on the screen that crosses at least one row of centres. */
static void random_edge(test_random *r, lmb_vertex *top, lmb_vertex *bottom)
{
    do {
        int32_t dy = random_size(r, 2.0 * LMB_SCREEN_MAX), dx = random_size(r, 2.0 * LMB_SCREEN_MAX);
        top->x = (int32_t)test_integer(r, -LMB_SCREEN_MAX, LMB_SCREEN_MAX - dx);
        top->y = (int32_t)test_integer(r, -LMB_SCREEN_MAX, LMB_SCREEN_MAX - dy);
        bottom->x = top->x + dx;
        bottom->y = top->y + dy;
        if (test_integer(r, 0, 1)) {
            int32_t swap = top->x;
            top->x = bottom->x;
            bottom->x = swap;
        }
    } while (lmb_row_at(top->y) >= lmb_row_at(bottom->y));
}

static void test_rows(test_random *r)
{
    int32_t i, k, faults = 0;
    int64_t rows = 0;
    for (i = 0; i < 3000000; i++) {
        lmb_vertex top = {0, 0, {0, 0, 0}, 0}, bottom = top;
        lmb_edge edge;
        int32_t first, last, row;
        random_edge(r, &top, &bottom);
        first = lmb_row_at(top.y);
        last = lmb_row_at(bottom.y) - 1;
        row = i & 1 ? first : (int32_t)test_integer(r, first, last);
        lmb_edge_begin(&edge, &top, &bottom, row);
        for (k = 0; k < 6 && row <= last; k++, row++, rows++, lmb_edge_step(&edge)) {
            if (edge.x == exact_x(&top, &bottom, row)) continue;
            if (faults++ < 3) {
                printf("edge (%d, %d) (%d, %d) row %d: got %d, want %lld\n", (int)top.x, (int)top.y, (int)bottom.x, (int)bottom.y,
                       (int)row, (int)edge.x, (long long)exact_x(&top, &bottom, row));
            }
        }
    }
    test_verdict(!faults, "edge: first pixel of a row", "%d faults in %lld rows of %d edges, entered anywhere", (int)faults,
                 (long long)rows, (int)i);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_rows(&random);
    return test_end();
}
