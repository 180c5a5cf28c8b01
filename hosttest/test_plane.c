/* SPDX-License-Identifier: MIT */
/* Planes as polynomials with integer coefficients modulo 2^32: moved down, walked row by row and along a row they say what the
 * polynomial says, wherever that is. It is evaluated from its definition in 64 bits, which wrap to the same 32. */
#include "../firmware/plane.h"
#include "test.h"

/* n (n - 1) / 2. */
static int64_t pairs_of(int64_t n) { return n % 2 ? n * ((n - 1) / 2) : n / 2 * (n - 1); }

static uint64_t times(int64_t a, int32_t b) { return (uint64_t)a * (uint64_t)(int64_t)b; }

/* Columns to the right of the plane's place and rows below it. */
static int32_t value_at(const lmb_plane *p, int64_t columns, int64_t rows)
{
    uint64_t sum = (uint64_t)(int64_t)p->f + times(columns, p->dx) + times(rows, p->dy);
    sum += times(columns * columns, p->bow) + times(columns * rows, p->dxy) + times(pairs_of(rows), p->dyy);
    return lmb_signed((uint32_t)sum);
}

/* Any coefficients; often small ones, and none of the second order. */
static lmb_plane random_plane(test_random *random)
{
    lmb_plane p;
    int32_t *member[6] = {&p.f, &p.dx, &p.dy, &p.bow, &p.dxy, &p.dyy};
    const bool linear = test_integer(random, 0, 3) == 0;
    int i;
    for (i = 0; i < 6; i++) {
        *member[i] = (int32_t)test_integer(random, INT32_MIN, INT32_MAX) >> test_integer(random, 0, 31);
        if (i > 2 && (linear || test_integer(random, 0, 3) == 0)) *member[i] = 0;
    }
    return p;
}

/* Below 2^16 in magnitude, of any magnitude. */
static int32_t random_way(test_random *random)
{
    return (int32_t)test_integer(random, -65535, 65535) >> test_integer(random, 0, 16);
}

static void plane_print(const char *what, const lmb_plane *p)
{
    printf("  %s %d %d %d %d %d %d\n", what, (int)p->f, (int)p->dx, (int)p->dy, (int)p->bow, (int)p->dxy, (int)p->dyy);
}

static void test_down(test_random *random)
{
    int i, k, faults = 0;
    for (i = 0; i < 400000; i++) {
        const lmb_plane plane = random_plane(random);
        const int32_t rows = random_way(random);
        lmb_plane moved = plane;
        lmb_plane_down(&moved, rows);
        for (k = 0; k < 8; k++) {
            const int64_t columns = k ? random_way(random) : 0, down = k ? random_way(random) : 0;
            if (value_at(&moved, columns, down) == value_at(&plane, columns, down + rows)) continue;
            if (faults++ == 0) {
                plane_print("plane", &plane);
                plane_print("moved", &moved);
                printf("  by %d\n", (int)rows);
            }
        }
    }
    test_verdict(!faults, "plane: moved down it is the same polynomial", "%d faults at %d places of %d planes", faults, 8 * i, i);
}

static void test_terms(test_random *random)
{
    int i, k, faults = 0;
    for (i = 0; i < 400000; i++) {
        const lmb_plane plane = random_plane(random);
        const int32_t columns = random_way(random);
        lmb_term term = lmb_plane_term(&plane, columns);
        for (k = 0; k < 40; k++, lmb_plane_step(&term)) faults += term.f != value_at(&plane, (int64_t)columns + k, 0);
    }
    test_verdict(!faults, "plane: a row of pixels from any of them on", "%d faults in %d rows of %d pixels", faults, i, k);
}

/* Row by row down, at another column of each. */
static void test_rows(test_random *random)
{
    int i, row, faults = 0;
    for (i = 0; i < 100000; i++) {
        const lmb_plane plane = random_plane(random);
        lmb_plane walked = plane;
        for (row = 0; row < 80; row++, lmb_plane_row(&walked)) {
            const int32_t columns = random_way(random);
            faults += lmb_plane_term(&walked, columns).f != value_at(&plane, columns, row);
        }
    }
    test_verdict(!faults, "plane: row by row down", "%d faults in %d rows of %d planes", faults, row, i);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_down(&random);
    test_terms(&random);
    test_rows(&random);
    return test_end();
}
