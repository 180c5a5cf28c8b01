/* SPDX-License-Identifier: MIT */
/* Spans whose normal runs linearly: each pixel makes up for its length, by root and division, by products, by a series, by tables.
 *
 * A normal between two unit ones is at most unit and, where they are less than 120 degrees apart, at least half as long. Ones that
 * cancel are divided by one. */
#include "steps_parts.h"

#include "floats.h"

/* ------------------------------------------------------------------------------------------------------------------ the walk */

static int32_t step_q29(int32_t from, int32_t to, unsigned pixels) { return (to - from) * 32768 / (int32_t)pixels; }

void compare_begin_normal(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    int32_t *n = state->as.normal.n, *step = state->as.normal.step;
    compare_set_ray(state, ray);
    n[0] = (int32_t)from.x * 32768;
    n[1] = (int32_t)from.y * 32768;
    n[2] = (int32_t)from.z * 32768;
    step[0] = step_q29(from.x, to.x, pixels);
    step[1] = step_q29(from.y, to.y, pixels);
    step[2] = step_q29(from.z, to.z, pixels);
}

static COMPARE_INLINE int32_t lit_q28(const int32_t ray[3], int32_t x, int32_t y, int32_t z)
{
    return x * ray[0] + y * ray[1] + z * ray[2];
}
static COMPARE_INLINE uint32_t square_q28(int32_t x, int32_t y, int32_t z) { return (uint32_t)(x * x + y * y + z * z); }

typedef int32_t shade(const compare_step_state *state, int32_t x, int32_t y, int32_t z);

static COMPARE_INLINE void along(compare_step_state *state, int32_t *out, unsigned count, shade *of)
{
    const int32_t *end = out + count, *step = state->as.normal.step;
    int32_t x = state->as.normal.n[0], y = state->as.normal.n[1], z = state->as.normal.n[2];
    do {
        *out++ = of(state, x >> 15, y >> 15, z >> 15);
        x += step[0];
        y += step[1];
        z += step[2];
    } while (out != end);
}

/* ------------------------------------------------------------------------------------------------------------ normalisation */

/* As paper 001 counts it: a root and three divisions. */
static COMPARE_INLINE int32_t textbook(const compare_step_state *state, int32_t x, int32_t y, int32_t z)
{
    int32_t length = (int32_t)compare_root(square_q28(x, y, z));
    length += length == 0;
    return lit_q28(state->ray, x * 16384 / length, y * 16384 / length, z * 16384 / length);
}
COMPARE_APART void compare_run_normalise_textbook(compare_step_state *state, int32_t *out, unsigned count)
{
    along(state, out, count, textbook);
}

/* As one writes it: the dot product is divided, once. Q2.14. */
static COMPARE_INLINE int32_t divide(const compare_step_state *state, int32_t x, int32_t y, int32_t z)
{
    int32_t length = (int32_t)compare_root(square_q28(x, y, z));
    length += length == 0;
    return lit_q28(state->ray, x, y, z) / length;
}
COMPARE_APART void compare_run_normalise_sqrt(compare_step_state *state, int32_t *out, unsigned count)
{
    along(state, out, count, divide);
}

/* By the library's reciprocal root, in products alone. A quarter of N.N is raised by an even number of bits into what that takes,
 * [1/4, 1): one raise for normals of half a unit and more, the usual case. Q2.14. */
static COMPARE_INLINE int32_t multiply(const compare_step_state *state, int32_t x, int32_t y, int32_t z)
{
    uint32_t square_q30 = square_q28(x, y, z);
    unsigned fall = 16;
    int32_t product;
    if (square_q30 == 0) return 0;
    if (square_q30 > 0x3fffffff) square_q30 >>= 2, fall++; /* longer than two */
    for (; square_q30 < 0x10000000; fall--) square_q30 <<= 2;
    product = (lit_q28(state->ray, x, y, z) >> 13) * (int32_t)(lmb_rsqrt_q30(square_q30) >> 16);
    return product >> fall; /* Q15 times Q14, and a half */
}
COMPARE_APART void compare_run_normalise_multiply(compare_step_state *state, int32_t *out, unsigned count)
{
    along(state, out, count, multiply);
}

/* Lyon's series about one, 1 - e/2 + 3/8 e^2 with e = N.N - 1. Q4.28. */
static COMPARE_INLINE int32_t taylor(const compare_step_state *state, int32_t x, int32_t y, int32_t z)
{
    const int32_t e_q14 = ((int32_t)square_q28(x, y, z) - ((int32_t)1 << 28)) >> 14;
    const int32_t scale_q14 = 16384 - (e_q14 >> 1) + ((e_q14 * e_q14 >> 14) * 3 >> 3);
    return (lit_q28(state->ray, x, y, z) >> 14) * scale_q14;
}
COMPARE_APART void compare_run_taylor(compare_step_state *state, int32_t *out, unsigned count)
{
    along(state, out, count, taylor);
}

/* --------------------------------------------------------------------------------------------------- lengths by differences */

/* |A + tD/m|^2 = A.A + 2 A.D t/m + D.D t^2/m^2 and A.L + D.L t/m. Over m pixels the second difference is added m^2/2 times, hence
 * 52 fraction bits. D.D is up to 4.4, and so is held as half of it. */
void compare_begin_length(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const unsigned guard = compare_guard(pixels);
    const int32_t half = lmb_vec_half_distance_q28(&from, &to), square = compare_dot_q28(from, from);
    const int32_t along_q28 = compare_dot_q28(from, to) - square, a = compare_dot_q28(from, ray);
    const int64_t bend =
        (int64_t)compare_over(compare_over(half, pixels, guard), pixels, guard) * ((int64_t)1 << (24 - 2 * guard));
    state->as.length.square = (int64_t)square * ((int64_t)1 << 24);
    state->as.length.c = 4 * bend;
    state->as.length.d = (int64_t)compare_over(along_q28, pixels, guard) * ((int64_t)1 << (25 - guard)) + 2 * bend;
    state->as.length.dot = a * 2;
    state->as.length.rise = (compare_dot_q28(to, ray) - a) * 2 / (int32_t)pixels;
}

COMPARE_APART void compare_run_length(compare_step_state *state, int32_t *out, unsigned count)
{
    const int64_t c = state->as.length.c;
    int64_t square = state->as.length.square, d = state->as.length.d;
    const int32_t rise = state->as.length.rise, *end = out + count;
    int32_t dot = state->as.length.dot;
    do {
        int32_t whole = (int32_t)(square >> 24), length = (int32_t)compare_root((uint32_t)(whole > 0 ? whole : 0));
        length += length == 0;
        *out++ = (dot >> 1) / length;
        square += d;
        d += c;
        dot += rise;
    } while (out != end);
}

/* --------------------------------------------------------------------------------------------------------- reflection map */

#if COMPARE_WITH_MAP

void compare_step_light(compare_step_map *map, lmb_vec ray)
{
    int32_t i, k;
    for (i = 0; i <= COMPARE_MAP_LENGTHS; i++) /* 1 / sqrt((i + 1/2) / 256); the root of Q30 is Q15 */
        map->inverse_q12[i] = (uint16_t)(((uint32_t)1 << 27) / compare_root((uint32_t)(2 * i + 1) << 21));
    for (i = 0; i < COMPARE_MAP_CELLS; i++) {
        for (k = 0; k < COMPARE_MAP_CELLS; k++) {
            int32_t x = (2 * k + 1) * (16384 / COMPARE_MAP_CELLS) - 16384, y = (2 * i + 1) * (16384 / COMPARE_MAP_CELLS) - 16384;
            int32_t square = x * x + y * y, one = (int32_t)1 << 28, z = 0, flat;
            if (square <= one) {
                z = (int32_t)compare_root((uint32_t)(one - square));
                flat = (x * ray.x + y * ray.y) >> 14;
            } else { /* the rim */
                flat = (x * ray.x + y * ray.y) / (int32_t)compare_root((uint32_t)square);
            }
            z = z * ray.z >> 14;
            map->light_q14[0][i][k] = (int16_t)(flat + z);
            map->light_q14[1][i][k] = (int16_t)(flat - z);
        }
    }
}

static COMPARE_INLINE int32_t cell(int32_t x_q14)
{
    x_q14 += 16384;
    return x_q14 < 0 ? 0 : x_q14 > 32767 ? COMPARE_MAP_CELLS - 1 : x_q14 / (32768 / COMPARE_MAP_CELLS);
}

static COMPARE_INLINE int32_t mapped(const compare_step_state *state, int32_t x, int32_t y, int32_t z)
{
    const uint32_t square = square_q28(x, y, z) >> 20;
    const int32_t inverse = state->map->inverse_q12[square < COMPARE_MAP_LENGTHS ? square : COMPARE_MAP_LENGTHS];
    return state->map->light_q14[z < 0][cell(y * inverse >> 12)][cell(x * inverse >> 12)];
}
COMPARE_APART void compare_run_map(compare_step_state *state, int32_t *out, unsigned count) { along(state, out, count, mapped); }

#endif

/* ------------------------------------------------------------------------------------------------------------------- floats */

#if COMPARE_WITH_LIBM

void compare_begin_floats(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const float part = 1.0f / 16384, over = part / (float)pixels;
    float *n = state->as.floats.n, *step = state->as.floats.step, *light = state->as.floats.ray;
    n[0] = from.x * part;
    n[1] = from.y * part;
    n[2] = from.z * part;
    step[0] = (float)(to.x - from.x) * over;
    step[1] = (float)(to.y - from.y) * over;
    step[2] = (float)(to.z - from.z) * over;
    light[0] = ray.x * (part * 268435456.0f);
    light[1] = ray.y * (part * 268435456.0f);
    light[2] = ray.z * (part * 268435456.0f);
}

COMPARE_APART void compare_run_floats(compare_step_state *state, int32_t *out, unsigned count)
{
    const int32_t *end = out + count;
    const float *step = state->as.floats.step, *light = state->as.floats.ray;
    float x = state->as.floats.n[0], y = state->as.floats.n[1], z = state->as.floats.n[2];
    do {
        const float square = x * x + y * y + z * z;
        *out++ = square > 0 ? (int32_t)((x * light[0] + y * light[1] + z * light[2]) / COMPARE_ROOT(square)) : 0;
        x += step[0];
        y += step[1];
        z += step[2];
    } while (out != end);
}

/* As the paper counts it: the vector is normalised by three divisions, then multiplied. */
COMPARE_APART void compare_run_floats_textbook(compare_step_state *state, int32_t *out, unsigned count)
{
    const int32_t *end = out + count;
    const float *step = state->as.floats.step, *light = state->as.floats.ray;
    float x = state->as.floats.n[0], y = state->as.floats.n[1], z = state->as.floats.n[2];
    do {
        const float square = x * x + y * y + z * z, length = square > 0 ? COMPARE_ROOT(square) : 1;
        *out++ = (int32_t)(x / length * light[0] + y / length * light[1] + z / length * light[2]);
        x += step[0];
        y += step[1];
        z += step[2];
    } while (out != end);
}

#endif
