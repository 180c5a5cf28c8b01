/* SPDX-License-Identifier: MIT */
/* Edges walked row by row against exact quotients in 64 bits: where they begin, wherever they are entered, and every step; with
 * remainders and as strides. */
#include "../firmware/edge.h"
#include "../firmware/stride.h"
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

/* Corners of any size and shape less than LMB_STRIDE_MAX apart, from top to bottom, with rows to fill. */
static void random_corners(test_random *r, lmb_vertex v[3])
{
    const double wide = 1 + random_size(r, LMB_STRIDE_MAX - 1.0), high = 1 + random_size(r, LMB_STRIDE_MAX - 1.0);
    const int32_t x = (int32_t)test_integer(r, -20000, 20000), y = (int32_t)test_integer(r, -20000, 20000);
    int i, k;
    do {
        for (i = 0; i < 3; i++) {
            v[i].x = x + (int32_t)test_integer(r, 0, (int64_t)wide - 1);
            v[i].y = y + (int32_t)test_integer(r, 0, (int64_t)high - 1);
            if (test_integer(r, 0, 7) == 0) v[i].x = v[0].x, v[i].y = i == 2 ? v[1].y : v[i].y; /* upright, or level */
            for (k = i; k > 0 && v[k].y < v[k - 1].y; k--) {
                const lmb_vertex swap = v[k];
                v[k] = v[k - 1];
                v[k - 1] = swap;
            }
        }
        if (v[2].y - v[0].y < 16) v[2].y = v[0].y + 16;
    } while (lmb_row_at(v[0].y) >= lmb_row_at(v[2].y));
}

/* Turns the edge from v[0] to v[2] so that on some row it crosses as little to the right of a pixel's centre as it can: there it shows
 * what a stride lacks. */
static void tighten(test_random *r, lmb_vertex v[3])
{
    static const int32_t limit[] = {960, 1024, 2048, 4096, LMB_STRIDE_MAX};
    const int32_t dy = limit[test_integer(r, 0, 4)] - (int32_t)test_integer(r, 1, 9), first = lmb_row_at(v[0].y);
    const int32_t row = first + (int32_t)test_integer(r, 0, dy / 16 < 120 ? dy / 16 : 120) - 1;
    int64_t below = 16 * (int64_t)row + 8 - v[0].y, a = dy, b = below % dy, u = 0, w = 1, dx;
    while (b > 0) { /* u below = a, w below = b, modulo dy */
        const int64_t q = a / b, rest = a - q * b, next = u - q * w;
        a = b;
        b = rest;
        u = w;
        w = next;
    }
    if (a != 1 || below <= 0) return;
    dx = (u % dy + dy) % dy; /* dx below is one more than some dy's */
    if (test_integer(r, 0, 1)) dx -= dy;
    while (((v[0].x - 8) * (int64_t)dy + dx * below - 1) % (16 * (int64_t)dy)) v[0].x++;
    v[2].x = v[0].x + (int32_t)dx;
    v[2].y = v[0].y + dy;
    v[1].x = v[0].x;
    v[1].y = v[0].y + (int32_t)test_integer(r, 0, dy);
}

static int faulty(const lmb_triangle *t, unsigned side, int32_t got, const lmb_vertex *top, const lmb_vertex *bottom)
{
    const int64_t want = exact_x(top, bottom, t->y);
    if (got + t->column == want) return 0;
    printf("stride %u (%d, %d) (%d, %d) row %d: got %d, want %lld\n", side, (int)top->x, (int)top->y, (int)bottom->x,
           (int)bottom->y, (int)t->y, (int)(got + t->column), (long long)want);
    return 1;
}

/* All rows of a triangle from some row on, as a filler walks them. */
static int walk_faults(lmb_triangle *t, int64_t *rows, int64_t *turns)
{
    int faults = 0;
    lmb_strides_begin(t);
    for (;;) {
        for (; t->y < t->y_turn; t->y++, ++*rows) {
            const unsigned lower = t->y >= t->y_switch, l = t->long_right;
            int32_t x[2];
            x[0] = lmb_stride_step(&t->walk.stride[0]);
            x[1] = lmb_stride_step(&t->walk.stride[1]);
            if (faults > 2) continue;
            faults += faulty(t, l, x[l], t->corner[0], t->corner[2]);
            faults += faulty(t, !l, x[!l], t->corner[lower], t->corner[lower + 1]);
        }
        if (t->y == t->y_end) return faults;
        ++*turns;
        lmb_strides_turn(t);
    }
}

static void test_strides(test_random *r)
{
    int64_t rows = 0, turns = 0;
    int i, faults = 0;
    for (i = 0; i < 300000; i++) {
        static lmb_triangle t;
        lmb_vertex v[3];
        int k;
        random_corners(r, v);
        if (i & 4) tighten(r, v);
        for (k = 0; k < 3; k++) t.corner[k] = &v[k];
        t.long_right = test_integer(r, 0, 1);
        t.y = lmb_row_at(v[0].y);
        t.y_switch = lmb_row_at(v[1].y);
        t.y_end = lmb_row_at(v[2].y);
        if (i & 1) t.y = (int32_t)test_integer(r, t.y, t.y_end - 1);
        if (i & 2) t.y_end = (int32_t)test_integer(r, t.y + 1, t.y_end);
        if (faults < 3) faults += walk_faults(&t, &rows, &turns);
    }
    test_verdict(!faults, "strides: first pixel of a row",
                 "%d faults in %lld rows and %lld turns of %d triangles, entered anywhere", faults, (long long)rows,
                 (long long)turns, i);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_rows(&random);
    test_strides(&random);
    return test_end();
}
