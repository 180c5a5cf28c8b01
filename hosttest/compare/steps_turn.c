/* SPDX-License-Identifier: MIT */
/* Spans whose normal turns by recurrence: paper 001's equations 7 to 11 and 14 as they are, and the library's arc. */
#include "steps_parts.h"

/* What arc_papers.c wants: the value at the start and the rise to the end, of a component or of f. */
static uint32_t length_of(unsigned pixels) { return pixels * LMB_ARC_PIXEL; }
static int32_t wide(int32_t x_q14) { return (int32_t)x_q14 * 65536; }
/* Opposite components rise by two, one more than fits. */
static int32_t rise_q30(int32_t from_q30, int32_t to_q30)
{
    const int64_t rise = (int64_t)to_q30 - from_q30;
    return rise > INT32_MAX ? INT32_MAX : rise < INT32_MIN ? INT32_MIN : (int32_t)rise;
}

/* f at both ends; values over one, which vectors off unit have, as the forms' range wants them. */
typedef struct ends {
    int32_t u_q28, a_q30, rise_q30;
} ends;
static ends ends_of(lmb_vec from, lmb_vec to, lmb_vec ray)
{
    ends e;
    e.u_q28 = lmb_min(lmb_vec_half_distance_q28(&from, &to), 0x20000000);
    e.a_q30 = lmb_max(lmb_min(compare_dot_q28(from, ray), 0x11000000), -0x11000000) * 4;
    e.rise_q30 = rise_q30(e.a_q30, lmb_max(lmb_min(compare_dot_q28(to, ray), 0x11000000), -0x11000000) * 4);
    return e;
}

/* ------------------------------------------------------------------------------------------------------- eq. 7: of vectors */

void compare_begin_vector16(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const int32_t u = lmb_min(lmb_vec_half_distance_q28(&from, &to), 0x20000000);
    const uint32_t length = length_of(pixels);
    lmb_plain16 *n = state->as.plain16;
    compare_set_ray(state, ray);
    lmb_plain16_prepare(&n[0], u, length, wide(from.x), rise_q30(wide(from.x), wide(to.x)));
    lmb_plain16_prepare(&n[1], u, length, wide(from.y), rise_q30(wide(from.y), wide(to.y)));
    lmb_plain16_prepare(&n[2], u, length, wide(from.z), rise_q30(wide(from.z), wide(to.z)));
}

void compare_begin_vector32(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const int32_t u = lmb_min(lmb_vec_half_distance_q28(&from, &to), 0x20000000);
    const uint32_t length = length_of(pixels);
    lmb_plain32 *n = state->as.plain32;
    compare_set_ray(state, ray);
    lmb_plain32_prepare(&n[0], u, length, wide(from.x), rise_q30(wide(from.x), wide(to.x)));
    lmb_plain32_prepare(&n[1], u, length, wide(from.y), rise_q30(wide(from.y), wide(to.y)));
    lmb_plain32_prepare(&n[2], u, length, wide(from.z), rise_q30(wide(from.z), wide(to.z)));
}

/* N.L, Q4.28; wraps, as nothing is said of a recurrence that has run away. */
static COMPARE_INLINE int32_t lit(const int32_t ray[3], int32_t x_q14, int32_t y_q14, int32_t z_q14)
{
    return lmb_add_wrap(lmb_add_wrap(lmb_mul_wrap(x_q14, ray[0]), lmb_mul_wrap(y_q14, ray[1])), lmb_mul_wrap(z_q14, ray[2]));
}

COMPARE_APART void compare_run_vector16(compare_step_state *state, int32_t *out, unsigned count)
{
    lmb_plain16 x = state->as.plain16[0], y = state->as.plain16[1], z = state->as.plain16[2];
    const int32_t *ray = state->ray, *end = out + count;
    do {
        *out++ = lit(ray, x.f, y.f, z.f);
        lmb_plain16_step(&x);
        lmb_plain16_step(&y);
        lmb_plain16_step(&z);
    } while (out != end);
}

COMPARE_APART void compare_run_vector32(compare_step_state *state, int32_t *out, unsigned count)
{
    lmb_plain32 x = state->as.plain32[0], y = state->as.plain32[1], z = state->as.plain32[2];
    const int32_t *ray = state->ray, *end = out + count;
    do {
        *out++ = lit(ray, x.f >> 16, y.f >> 16, z.f >> 16);
        lmb_plain32_step(&x);
        lmb_plain32_step(&y);
        lmb_plain32_step(&z);
    } while (out != end);
}

#if COMPARE_WITH_LIBM

/* In floats, as the paper's own trial on a desktop computer must have been. */
void compare_begin_float_vector(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const float part = 1.0f / 1073741824;
    lmb_plain32 n[3];
    unsigned i;
    compare_begin_vector32(state, from, to, ray, pixels);
    for (i = 0; i < 3; i++) n[i] = state->as.plain32[i];
    for (i = 0; i < 3; i++) {
        state->as.floats.n[i] = (float)n[i].f * part;
        state->as.floats.step[i] = (float)n[i].before * part;
        state->as.floats.ray[i] = (float)state->ray[i] * 16384;
    }
    state->as.floats.cosine = (float)n[0].cosine * (2 * part);
}

/* 2 cos(phi) n - before; n becomes before. */
static COMPARE_INLINE void turn_float(float cosine, float *n, float *before)
{
    const float next = cosine * *n - *before;
    *before = *n;
    *n = next;
}

COMPARE_APART void compare_run_float_vector(compare_step_state *state, int32_t *out, unsigned count)
{
    const int32_t *end = out + count;
    const float *n = state->as.floats.n, *last = state->as.floats.step, *ray = state->as.floats.ray;
    const float cosine = state->as.floats.cosine, rx = ray[0], ry = ray[1], rz = ray[2];
    float x = n[0], y = n[1], z = n[2], x_before = last[0], y_before = last[1], z_before = last[2];
    do {
        *out++ = (int32_t)(x * rx + y * ry + z * rz);
        turn_float(cosine, &x, &x_before);
        turn_float(cosine, &y, &y_before);
        turn_float(cosine, &z, &z_before);
    } while (out != end);
}

#endif

/* ----------------------------------------------------------------------------------------------------------- eq. 14: of f */

void compare_begin_plain16(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const ends e = ends_of(from, to, ray);
    lmb_plain16_prepare(&state->as.plain16[0], e.u_q28, length_of(pixels), e.a_q30, e.rise_q30);
}
COMPARE_APART void compare_run_plain16(compare_step_state *state, int32_t *out, unsigned count)
{
    lmb_plain16 f = state->as.plain16[0];
    const int32_t *end = out + count;
    do {
        *out++ = f.f;
        lmb_plain16_step(&f);
    } while (out != end);
}

void compare_begin_plain32(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const ends e = ends_of(from, to, ray);
    lmb_plain32_prepare(&state->as.plain32[0], e.u_q28, length_of(pixels), e.a_q30, e.rise_q30);
}
COMPARE_APART void compare_run_plain32(compare_step_state *state, int32_t *out, unsigned count)
{
    lmb_plain32 f = state->as.plain32[0];
    const int32_t *end = out + count;
    do {
        *out++ = f.f;
        lmb_plain32_step(&f);
    } while (out != end);
}

/* ------------------------------------------------------------------------------------------------ eq. 9 to 11: blocks of f */

void compare_begin_block16(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const ends e = ends_of(from, to, ray);
    lmb_block4_prepare(&state->as.block16, e.u_q28, length_of(pixels), e.a_q30, e.rise_q30);
}

/* (9) with 2 cos(2 phi) f + f, so that each factor stays within 16 bits and a sign. */
static COMPARE_INLINE int32_t second(const lmb_block4 *b)
{
    const int32_t along = lmb_shr_round(b->twice_cos2 * b->f, 14), back = lmb_shr_round(b->twice_cos * b->before, 14);
    return lmb_wrap16(along - back + b->f);
}
static COMPARE_INLINE int32_t first(const lmb_block4 *b)
{
    return lmb_wrap16(lmb_shr_round(b->twice_cos * b->f, 14) - b->before);
}

COMPARE_APART void compare_run_block2(compare_step_state *state, int32_t *out, unsigned count)
{
    lmb_block4 b = state->as.block16;
    const int32_t *end = out + count;
    *out++ = b.f;
    while (out < end) {
        const int32_t one = first(&b), two = second(&b);
        *out++ = b.before = one;
        *out++ = b.f = two;
    }
}

/* (10), corrected, as 2 cos(2 phi) f(t+1) - f(t-1). */
COMPARE_APART void compare_run_block3(compare_step_state *state, int32_t *out, unsigned count)
{
    lmb_block4 b = state->as.block16;
    const int32_t *end = out + count;
    *out++ = b.f;
    while (out < end) {
        const int32_t one = first(&b), two = second(&b);
        const int32_t three = lmb_wrap16(lmb_shr_round(b.twice_cos2 * one, 14) - b.before);
        *out++ = one;
        *out++ = b.before = two;
        *out++ = b.f = three;
    }
}

COMPARE_APART void compare_run_block4(compare_step_state *state, int32_t *out, unsigned count)
{
    lmb_block4 b = state->as.block16;
    const int32_t *end = out + count;
    *out++ = b.f;
    while (out < end) {
        lmb_block4_step(&b, out);
        out += 4;
    }
}

/* The same in 32 bits with 64-bit products, cosines and f in Q2.30. */
void compare_begin_block32(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const ends e = ends_of(from, to, ray);
    lmb_plain32 f;
    lmb_plain32_prepare(&f, e.u_q28, length_of(pixels), e.a_q30, e.rise_q30);
    state->as.block32.f = f.f;
    state->as.block32.before = f.before;
    state->as.block32.cosine = f.cosine;
    state->as.block32.cosine2 = (int32_t)((((int64_t)f.cosine * f.cosine) >> 29) - 0x40000000);
}

/* 2 x y - z: the sums wrap on purpose, their result is in range again. */
static COMPARE_INLINE int32_t less(int32_t x_q30, int32_t y_q30, int32_t z_q30)
{
    return lmb_sub_wrap(lmb_signed((uint32_t)(((uint64_t)((int64_t)x_q30 * y_q30) + ((uint32_t)1 << 28)) >> 29)), z_q30);
}

COMPARE_APART void compare_run_block4_32(compare_step_state *state, int32_t *out, unsigned count)
{
    const int32_t c = state->as.block32.cosine, c2 = state->as.block32.cosine2, *end = out + count;
    int32_t f = state->as.block32.f, before = state->as.block32.before;
    *out++ = f;
    while (out < end) {
        out[0] = less(c, f, before);
        out[1] = lmb_add_wrap(less(c2, f, less(c, before, 0)), f);
        out[2] = less(c2, out[0], before);
        out[3] = less(c2, out[1], f);
        before = out[2];
        f = out[3];
        out += 4;
    }
}

/* ------------------------------------------------------------------------------------------------------------ the library */

void compare_begin_lambent(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    lmb_arc_between(&state->as.arc.arc, from, to, length_of(pixels), 0);
    lmb_arc_dot(&state->as.arc.arc, &state->as.arc.term, from, to, ray, 65536);
}

COMPARE_APART void compare_run_lambent(compare_step_state *state, int32_t *out, unsigned count)
{
    const lmb_arc arc = state->as.arc.arc;
    lmb_term term = state->as.arc.term;
    const int32_t *end = out + count;
    do {
        *out++ = term.f;
        lmb_arc_step(&arc, &term);
    } while (out != end);
}
