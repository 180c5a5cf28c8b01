/* SPDX-License-Identifier: MIT */
/* Vectors, rotations, sine, reciprocal and reciprocal square root, each against its definition.
 *
 * Arguments: a seed, or the word "exhaustive": then reciprocal and reciprocal square root run over every argument, and the
 * leading zeros over every word (one minute). */
#include "test.h"

#include <string.h>

/* This program's own copy of lmb_clz32 is the binary search that cores without CLZ take; the library keeps the machine's. */
#ifndef __riscv
#define __riscv 1
#endif
#include "../firmware/lambent.h"

static const double pi = 3.14159265358979323846;

static double larger(double a, double b) { return a > b ? a : b; }

static lmb_vec vec(int64_t x, int64_t y, int64_t z)
{
    lmb_vec v;
    v.x = (int16_t)x;
    v.y = (int16_t)y;
    v.z = (int16_t)z;
    return v;
}

/* Random numbers are drawn one a statement, so that a seed gives the same ones whatever order a compiler takes arguments in. */
static lmb_vec random_vec(test_random *random, int64_t low, int64_t high)
{
    int64_t x = test_integer(random, low, high), y = test_integer(random, low, high), z = test_integer(random, low, high);
    return vec(x, y, z);
}

static lmb_matrix random_rotation(test_random *random)
{
    uint16_t x = (uint16_t)test_next(random), y = (uint16_t)test_next(random), z = (uint16_t)test_next(random);
    return lmb_rotation(x, y, z);
}

/* A direction, uniform over the sphere, rounded to Q2.14; length 1 within 1e-4. */
static lmb_vec random_unit(test_random *random)
{
    double z = test_real(random, -1, 1), angle = test_real(random, 0, 2 * pi), r = sqrt(1 - z * z);
    return vec(lround(16384 * r * cos(angle)), lround(16384 * r * sin(angle)), lround(16384 * z));
}

/* -------------------------------------------------------------------------------------------------------------- leading zeros */

static unsigned zeros_of(uint32_t x)
{
    unsigned n = 0;
    while (n < 32 && !(x >> (31 - n))) n++;
    return n;
}

static void test_clz(test_random *random, int exhaustive)
{
    uint64_t last = exhaustive ? UINT32_MAX : 1u << 20, i, x;
    uint32_t bad = 0;
    int failures = 0;
    for (i = 0; i <= last; i++)
        if (lmb_clz32((uint32_t)i) != zeros_of((uint32_t)i)) bad = (uint32_t)i, failures++;
    for (i = 0; i < 32; i++)
        for (x = ((uint64_t)1 << i) - (i > 0 ? 2 : 0); x < ((uint64_t)1 << i) + 2; x++)
            if (lmb_clz32((uint32_t)x) != zeros_of((uint32_t)x)) bad = (uint32_t)x, failures++;
    for (i = 0; i < 1000000; i++) {
        x = test_next(random) >> (32 + i % 32);
        if (lmb_clz32((uint32_t)x) != zeros_of((uint32_t)x)) bad = (uint32_t)x, failures++;
    }
    test_verdict(!failures, "clz: binary search counts as a loop does",
                 "%d wrong, last 0x%08" PRIx32 ", words 0..0x%" PRIx64 " and 1000000 random ones", failures, bad, last);
}

/* -------------------------------------------------------------------------------------------------------- products of vectors */

static void test_dot(test_random *random)
{
    int failures = 0, i;
    int32_t most = 0;
    for (i = 0; i < 2000000; i++) {
        lmb_vec a = random_unit(random), b = i % 3 ? random_unit(random) : i % 2 ? a : vec(-a.x, -a.y, -a.z);
        int32_t got = lmb_dot_q28(a, b);
        int64_t want = (int64_t)a.x * b.x + (int64_t)a.y * b.y + (int64_t)a.z * b.z;
        if (got != want) failures++;
        if (labs((long)got) > most) most = (int32_t)labs((long)got);
    }
    test_verdict(!failures && most < 1 << 30, "dot: exact and under 2^30", "%d wrong, largest 0x%08" PRIx32, failures,
                 (uint32_t)most);
}

static void test_half_distance(test_random *random)
{
    int failures = 0, i;
    double worst = 0;
    for (i = 0; i < 2000000; i++) {
        lmb_vec a = random_unit(random), b = random_unit(random), near = random_vec(random, -9, 9);
        int64_t x, y, z, want;
        int32_t got;
        if (i < 3) a = vec(i == 0 ? 16384 : 0, i == 1 ? 16384 : 0, i == 2 ? 16384 : 0);
        if (i < 3 || i % 4 == 0) b = vec(-a.x, -a.y, -a.z);
        if (i % 4 == 3) b = vec(a.x + near.x, a.y + near.y, a.z + near.z);
        x = a.x - b.x;
        y = a.y - b.y;
        z = a.z - b.z;
        want = (x * x + y * y + z * z) / 2;
        got = lmb_half_distance_q28(a, b);
        if (got != want) failures++;
        worst = larger(worst, got / 268435456.0);
    }
    test_verdict(!failures, "half distance: exact but for the halving, opposite axes included", "%d wrong, largest %.6f",
                 failures, worst);
}

/* ------------------------------------------------------------------------------------------------ reciprocal of a square root */

typedef struct extreme {
    double low, high; /* relative error */
    uint32_t low_at, high_at, least, most;
    uint64_t wrong;
} extreme;

static extreme extreme_start(void)
{
    extreme e = {0, -1, 0, 0, UINT32_MAX, 0, 0};
    return e;
}

static void extreme_take(extreme *e, double error, uint32_t x, uint32_t result)
{
    if (error < e->low) e->low = error, e->low_at = x;
    if (error > e->high) e->high = error, e->high_at = x;
    if (result < e->least) e->least = result;
    if (result > e->most) e->most = result;
}

static void rsqrt_take(extreme *e, uint32_t x)
{
    uint32_t got = lmb_rsqrt_q30(x);
    extreme_take(e, (double)got * sqrt((double)x) / 35184372088832.0 - 1, x, got); /* 2^30 * 2^15 */
}

static void test_rsqrt(test_random *random, int exhaustive)
{
    extreme e = extreme_start();
    uint32_t x, seam;
    for (x = 0x10000000; x < 0x40000000; x += exhaustive ? 1 : 64)
        rsqrt_take(&e, exhaustive ? x : x + (uint32_t)(test_next(random) & 63));
    for (seam = 0x10000000; seam <= 0x40000000; seam += 1u << 23)
        for (x = seam - 2000; x < seam + 2000; x++)
            if (x >= 0x10000000 && x < 0x40000000) rsqrt_take(&e, x);
    test_verdict(larger(-e.low, e.high) <= LMB_RSQRT_MAX_ERROR, "rsqrt: relative error",
                 "-2^%.3f at 0x%08" PRIx32 ", 2^%.3f at 0x%08" PRIx32 ", bound 2^%.3f%s", log2(-e.low), e.low_at, log2(e.high),
                 e.high_at, log2(LMB_RSQRT_MAX_ERROR), exhaustive ? ", all arguments" : "");
    test_verdict(e.least > (1u << 30) - 16 && e.most < 1u << 31, "rsqrt: result in (1 - 2^-26, 2)",
                 "0x%08" PRIx32 " to 0x%08" PRIx32, e.least, e.most);
}

/* Any value will do outside the domain; the sanitisers and the checked twin see to it that no table or word is overrun. */
static void test_rsqrt_outside(test_random *random)
{
    uint32_t i, sum = 0;
    for (i = 0; i < 1u << 20; i++) {
        sum += lmb_rsqrt_q30(i << 12) + lmb_rsqrt_q30(i << 12 | 0xfff);
        sum += lmb_rsqrt_q30((uint32_t)test_next(random)) + lmb_rsqrt_q30(i & 0xff) + lmb_rsqrt_q30(0u - (i & 0xff));
    }
    test_verdict(1, "rsqrt: no fault outside its domain", "sum 0x%08" PRIx32, sum);
}

/* ------------------------------------------------------------------------------------------------------------------ normalise */

typedef struct normalise_worst {
    double error, length;
    int32_t x, y, z;
} normalise_worst;

static void normalise_take(normalise_worst *w, int32_t x, int32_t y, int32_t z)
{
    long double length = sqrtl((long double)x * x + (long double)y * y + (long double)z * z), scale = 16384 / length;
    lmb_vec got = lmb_normalise(x, y, z);
    double ex = (double)fabsl(got.x - x * scale), ey = (double)fabsl(got.y - y * scale), ez = (double)fabsl(got.z - z * scale);
    double error = larger(larger(ex, ey), ez), n = sqrt((double)got.x * got.x + (double)got.y * got.y + (double)got.z * got.z);
    if (error > w->error) {
        w->error = error;
        w->x = x;
        w->y = y;
        w->z = z;
    }
    w->length = larger(w->length, fabs(n / 16384 - 1));
}

static void normalise_verdict(const normalise_worst *w, const char *name)
{
    test_verdict(w->error <= LMB_NORMALISE_MAX_ERROR * 16384, name,
                 "%.6f/16384 at (%" PRId32 ", %" PRId32 ", %" PRId32 "), bound %.4f; length within %.2g", w->error, w->x, w->y,
                 w->z, LMB_NORMALISE_MAX_ERROR * 16384, w->length);
}

static void test_normalise_lattice(void)
{
    normalise_worst w = {0, 0, 0, 0, 0};
    int32_t x, y, z;
    for (x = -128; x < 128; x++)
        for (y = -128; y < 128; y++)
            for (z = x | y ? -128 : 1; z < 128; z++) normalise_take(&w, x, y, z);
    normalise_verdict(&w, "normalise: all vectors of int8");
}

/* Each component has its own number of bits, or all of them the same. */
static void test_normalise_random(test_random *random)
{
    normalise_worst w = {0, 0, 0, 0, 0};
    const int64_t top = 1 << 30;
    int64_t c[3];
    int i, k;
    for (i = 0; i < 6000000; i++) {
        int64_t bits = test_integer(random, 0, 30);
        for (k = 0; k < 3; k++) {
            int64_t limit = ((int64_t)1 << (i & 1 ? bits : test_integer(random, 0, 30))) - (i & 2 ? 1 : 0);
            c[k] = i % 8 == 7 ? limit * test_integer(random, -1, 1) + test_integer(random, -2, 2)
                              : test_integer(random, -limit, limit);
            if (c[k] >= top) c[k] = top - 1;
            if (c[k] < -top) c[k] = -top;
        }
        if (c[0] | c[1] | c[2]) normalise_take(&w, (int32_t)c[0], (int32_t)c[1], (int32_t)c[2]);
    }
    normalise_verdict(&w, "normalise: random, every magnitude to 2^30");
}

/* Sums whose square lies just beside a power of four, where the shift and the root change their interval. */
static void test_normalise_seams(void)
{
    static const int32_t small[] = {-2, -1, 0, 1, 2, 16383, -16383, 32767, -32768};
    normalise_worst w = {0, 0, 0, 0, 0};
    int bit, d, i, k;
    for (bit = 0; bit < 30; bit++)
        for (d = -3; d <= 3; d++)
            for (i = 0; i < 9; i++)
                for (k = 0; k < 9; k++) {
                    int32_t x = ((int32_t)1 << bit) + d;
                    if (x == 0) continue;
                    normalise_take(&w, x, small[i], small[k]);
                    normalise_take(&w, small[i], -x, small[k]);
                    normalise_take(&w, small[i], -x, x);
                    normalise_take(&w, -x, x, small[k]);
                }
    normalise_verdict(&w, "normalise: beside powers of two");
}

static int same(lmb_vec a, int x, int y, int z) { return a.x == x && a.y == y && a.z == z; }

static void test_normalise_axes(void)
{
    int failures = 0;
    int32_t size;
    if (!same(lmb_normalise(0, 0, 0), 0, 0, 16384)) failures++;
    for (size = 1; size < 1 << 30; size += size / 7 + 1) {
        if (!same(lmb_normalise(size, 0, 0), 16384, 0, 0) || !same(lmb_normalise(-size, 0, 0), -16384, 0, 0)) failures++;
        if (!same(lmb_normalise(0, size, 0), 0, 16384, 0) || !same(lmb_normalise(0, -size, 0), 0, -16384, 0)) failures++;
        if (!same(lmb_normalise(0, 0, size), 0, 0, 16384) || !same(lmb_normalise(0, 0, -size), 0, 0, -16384)) failures++;
    }
    if (!same(lmb_normalise(-(1 << 30), 0, 0), -16384, 0, 0)) failures++;
    test_verdict(!failures, "normalise: zero gives +z, axes stay axes exactly", "%d wrong", failures);
}

/* ---------------------------------------------------------------------------------------------------------------------- turns */

static int64_t element(const lmb_matrix *m, int row, int column)
{
    const lmb_vec *v = &m->row[row];
    return column == 0 ? v->x : column == 1 ? v->y : v->z;
}

static int64_t component(lmb_vec v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

/* Rounded to nearest and saturated: no representable value is nearer to the exact product. */
static int is_nearest(int64_t got, int64_t exact_q14)
{
    int64_t error = got * 16384 - exact_q14;
    if (got == INT16_MAX) return error <= 8192;
    if (got == INT16_MIN) return error >= -8192;
    return error >= -8192 && error <= 8192;
}

static void test_rotate(test_random *random)
{
    int wide_wrong = 0, wrong = 0, back_wrong = 0, saturated = 0, i, row;
    for (i = 0; i < 500000; i++) {
        lmb_matrix m = random_rotation(random);
        int64_t limit = i % 2 ? 32768 : 16384;
        lmb_vec v = random_vec(random, -limit, limit - 1), out, back;
        int32_t wide[3];
        if (i % 8 == 1) v = vec(i & 16 ? -32768 : 32767, i & 32 ? -32768 : 32767, i & 64 ? -32768 : 32767);
        out = lmb_rotate(&m, v);
        back = lmb_rotate_back(&m, v);
        lmb_rotate_wide(&m, v, wide);
        for (row = 0; row < 3; row++) {
            int64_t exact = element(&m, row, 0) * v.x + element(&m, row, 1) * v.y + element(&m, row, 2) * v.z;
            int64_t exact_back = element(&m, 0, row) * v.x + element(&m, 1, row) * v.y + element(&m, 2, row) * v.z;
            if (wide[row] != exact) wide_wrong++;
            if (!is_nearest(component(out, row), exact)) wrong++;
            if (!is_nearest(component(back, row), exact_back)) back_wrong++;
            if (component(out, row) == INT16_MAX || component(out, row) == INT16_MIN) saturated++;
        }
    }
    test_verdict(!wide_wrong, "rotate wide: exact", "%d wrong", wide_wrong);
    test_verdict(!wrong && saturated, "rotate: nearest, saturated", "%d wrong, %d saturated", wrong, saturated);
    test_verdict(!back_wrong, "rotate back: the transpose, nearest, saturated", "%d wrong", back_wrong);
}

static void test_rotate_there_and_back(test_random *random)
{
    int i, k;
    double worst = 0;
    for (i = 0; i < 300000; i++) {
        lmb_matrix m = random_rotation(random);
        lmb_vec v = random_unit(random), w = lmb_rotate_back(&m, lmb_rotate(&m, v));
        for (k = 0; k < 3; k++) worst = larger(worst, fabs((double)(component(v, k) - component(w, k))));
    }
    /* 0.5 sqrt(3) of the first rounding, 0.5 of the second, 2 * sqrt(3) * sqrt(3) * LMB_ROTATION_MAX_ERROR of R^T R - 1 */
    test_verdict(worst <= 1.4 + 6 * 16384 * LMB_ROTATION_MAX_ERROR, "rotate: there and back again", "%.0f/16384", worst);
}

static void multiply(double out[3][3], double a[3][3], double b[3][3])
{
    int i, k;
    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) out[i][k] = a[i][0] * b[0][k] + a[i][1] * b[1][k] + a[i][2] * b[2][k];
}

/* Rotation about axis 0, 1 or 2 from the definition: the next axis turns towards the one after it. */
static void about(double out[3][3], int axis, uint16_t angle)
{
    double c = cos(angle * pi / 32768), s = sin(angle * pi / 32768);
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    memset(out, 0, 9 * sizeof out[0][0]);
    out[axis][axis] = 1;
    out[u][u] = c;
    out[v][u] = s;
    out[u][v] = -s;
    out[v][v] = c;
}

static void test_rotation(test_random *random)
{
    double worst = 0, length = 0, slant = 0, x[3][3], y[3][3], z[3][3], zy[3][3], want[3][3];
    unsigned at[3] = {0, 0, 0};
    int i, row, column;
    for (i = 0; i < 500000; i++) {
        uint16_t a[3];
        lmb_matrix m;
        for (row = 0; row < 3; row++) a[row] = (uint16_t)(i % 4 ? test_next(random) : (test_next(random) & 7) * 8192);
        m = lmb_rotation(a[0], a[1], a[2]);
        about(x, 0, a[0]);
        about(y, 1, a[1]);
        about(z, 2, a[2]);
        multiply(zy, z, y);
        multiply(want, zy, x);
        for (row = 0; row < 3; row++) {
            const lmb_vec *r = &m.row[row], *s = &m.row[(row + 1) % 3];
            length = larger(length, fabs(sqrt((double)r->x * r->x + (double)r->y * r->y + (double)r->z * r->z) / 16384 - 1));
            slant = larger(slant, fabs(((double)r->x * s->x + (double)r->y * s->y + (double)r->z * s->z) / 268435456.0));
            for (column = 0; column < 3; column++) {
                double error = fabs((double)element(&m, row, column) / 16384 - want[row][column]);
                if (error > worst) worst = error, at[0] = a[0], at[1] = a[1], at[2] = a[2];
            }
        }
    }
    test_verdict(worst <= LMB_ROTATION_MAX_ERROR, "rotation: against Rz Ry Rx", "%.5f/16384 at 0x%04x 0x%04x 0x%04x, bound %.2f",
                 worst * 16384, at[0], at[1], at[2], LMB_ROTATION_MAX_ERROR * 16384);
    test_verdict(length <= sqrt(3) * LMB_ROTATION_MAX_ERROR && slant <= 2 * sqrt(3) * LMB_ROTATION_MAX_ERROR,
                 "rotation: rows unit and at right angles", "length %.2g, cosine %.2g", length, slant);
}

static void test_rotation_quarters(void)
{
    lmb_matrix none = lmb_rotation(0, 0, 0), x = lmb_rotation(16384, 0, 0), y = lmb_rotation(0, 16384, 0),
               z = lmb_rotation(0, 0, 16384);
    lmb_vec right = vec(16384, 0, 0), up = vec(0, 16384, 0), near = vec(0, 0, 16384);
    int ok = same(none.row[0], 16384, 0, 0) && same(none.row[1], 0, 16384, 0) && same(none.row[2], 0, 0, 16384);
    ok = ok && same(lmb_rotate(&x, up), 0, 0, 16384) && same(lmb_rotate(&y, near), 16384, 0, 0) &&
         same(lmb_rotate(&z, right), 0, 16384, 0);
    test_verdict(ok, "rotation: none is the identity; quarters about x, y, z take y to z, z to x, x to y", "exact");
}

/* ----------------------------------------------------------------------------------------------------------------------- sine */

static void test_sine(void)
{
    double worst = 0;
    int at = 0, a, asymmetric = 0;
    for (a = 0; a < 65536; a++) {
        int32_t s = lmb_sin_q14((uint16_t)a), c = lmb_cos_q14((uint16_t)a);
        double error = larger(fabs(s - 16384 * sin(a * pi / 32768)), fabs(c - 16384 * cos(a * pi / 32768)));
        if (error > worst) worst = error, at = a;
        if (s != -lmb_sin_q14((uint16_t)-a) || s != lmb_sin_q14((uint16_t)(32768 - a)) || c != lmb_cos_q14((uint16_t)-a))
            asymmetric++;
    }
    test_verdict(worst <= LMB_SINE_MAX_ERROR * 16384, "sine, cosine: every angle", "%.5f/16384 at 0x%04x, bound %.2f", worst,
                 (unsigned)at, LMB_SINE_MAX_ERROR * 16384);
    test_verdict(!asymmetric, "sine, cosine: odd, even, mirrored", "%d wrong", asymmetric);
    test_verdict(lmb_sin_q14(0) == 0 && lmb_sin_q14(16384) == 16384 && lmb_sin_q14(32768) == 0 && lmb_sin_q14(49152) == -16384,
                 "sine: exact at quarter turns", "0, 1, 0, -1");
}

/* ----------------------------------------------------------------------------------------------------------------- reciprocal */

static void reciprocal_take(extreme *e, uint32_t x)
{
    unsigned shift = 99;
    uint32_t got = lmb_reciprocal(x, &shift);
    uint64_t one;
    if (shift != 31 - zeros_of(x)) e->wrong++;
    one = (uint64_t)1 << (31 + (shift & 31));
    if (x * (uint64_t)got > one) e->wrong++;
    extreme_take(e, (double)(int64_t)(x * (uint64_t)got - one) / (double)one, x, got);
}

static void test_reciprocal(test_random *random, int exhaustive)
{
    extreme e = extreme_start();
    unsigned shift = 99;
    uint32_t zero;
    uint64_t x, seam;
    for (x = 1; x < 1u << 24; x++) reciprocal_take(&e, (uint32_t)x);
    for (x = 1u << 24; x <= UINT32_MAX; x += exhaustive ? 1 : 199 + (test_next(random) & 127)) reciprocal_take(&e, (uint32_t)x);
    for (seam = 1u << 31; seam <= 1ull << 32; seam += 1u << 24)
        for (x = seam - 3000; x < seam + 3000; x++)
            if (x <= UINT32_MAX) reciprocal_take(&e, (uint32_t)x);
    test_verdict(-e.low <= LMB_RECIPROCAL_MAX_ERROR, "reciprocal: relative error", "-2^%.3f at 0x%08" PRIx32 ", bound 2^%.3f%s",
                 log2(-e.low), e.low_at, log2(LMB_RECIPROCAL_MAX_ERROR), exhaustive ? ", all arguments" : "");
    test_verdict(!e.wrong, "reciprocal: never above, shift is right", "%" PRIu64 " wrong, nearest %.2g at 0x%08" PRIx32, e.wrong,
                 e.high, e.high_at);
    test_verdict(e.least >= 1u << 30 && e.most < 1u << 31, "reciprocal: result in [2^30, 2^31)",
                 "0x%08" PRIx32 " to 0x%08" PRIx32, e.least, e.most);
    zero = lmb_reciprocal(0, &shift);
    test_verdict(shift == 0 && zero == lmb_reciprocal(1, &shift), "reciprocal: zero is taken as one", "0x%08" PRIx32, zero);
}

int main(int argc, char **argv)
{
    int exhaustive = argc > 1 && strcmp(argv[1], "exhaustive") == 0;
    test_random random = test_seed(exhaustive ? 1 : argc, argv);
    test_clz(&random, exhaustive);
    test_dot(&random);
    test_half_distance(&random);
    test_rsqrt(&random, exhaustive);
    test_rsqrt_outside(&random);
    test_normalise_lattice();
    test_normalise_random(&random);
    test_normalise_seams();
    test_normalise_axes();
    test_rotate(&random);
    test_rotate_there_and_back(&random);
    test_sine();
    test_rotation(&random);
    test_rotation_quarters();
    test_reciprocal(&random, exhaustive);
    return test_end();
}
