/* SPDX-License-Identifier: MIT */
/* Spans by sums alone: one value, Gouraud's straight line, and the parabola through both ends and the normalised middle. */
#include "steps_parts.h"

/* The normal of the middle; of opposite ones, which have none, what lmb_normalise gives for zero. */
static int32_t middle_q28(lmb_vec from, lmb_vec to, lmb_vec ray)
{
    return compare_dot_q28(lmb_normalise((int32_t)from.x + to.x, (int32_t)from.y + to.y, (int32_t)from.z + to.z), ray);
}

void compare_begin_flat(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    (void)pixels;
    state->as.sums.f = middle_q28(from, to, ray);
}

COMPARE_APART void compare_run_flat(compare_step_state *state, int32_t *out, unsigned count)
{
    const int32_t f = state->as.sums.f, *end = out + count;
    do {
        *out++ = f;
    } while (out != end);
}

void compare_begin_linear(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    state->as.sums.f = compare_dot_q28(from, ray);
    state->as.sums.d = (compare_dot_q28(to, ray) - state->as.sums.f) / (int32_t)pixels;
}

COMPARE_APART void compare_run_linear(compare_step_state *state, int32_t *out, unsigned count)
{
    const int32_t d = state->as.sums.d, *end = out + count;
    int32_t f = state->as.sums.f;
    do {
        *out++ = f;
        f += d;
    } while (out != end);
}

/* With ends a, b and middle c: a + (4c - 3a - b) w + (2a + 2b - 4c) w^2, w = t/m. Both differences carry guard bits: over m pixels
 * the first is added m times and the second m^2 / 2 times. In Q5.27, since the second difference is up to 8. */
void compare_begin_quadratic(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const unsigned guard = compare_guard(pixels);
    const int32_t a = compare_dot_q28(from, ray) >> 1, b = compare_dot_q28(to, ray) >> 1, c = middle_q28(from, to, ray) >> 1;
    const int32_t bend = ((a + b) >> 1) - c; /* a fourth of the factor of w^2 */
    const int32_t once = compare_over(compare_over(bend, pixels, guard), pixels, guard);
    state->as.sums.f = a;
    state->as.sums.guard = guard;
    state->as.sums.c = guard >= 3 ? once >> (guard - 3) : once * ((int32_t)8 >> guard); /* 8 bend / m^2, times 2^guard */
    state->as.sums.d = compare_over(2 * (c - a - bend), pixels, guard) + state->as.sums.c / 2;
}

/* The sums may wrap behind the last pixel, where a span of one or two pixels is steep. */
COMPARE_APART void compare_run_quadratic(compare_step_state *state, int32_t *out, unsigned count)
{
    const int32_t c = state->as.sums.c, *end = out + count;
    const unsigned guard = state->as.sums.guard;
    int32_t f = state->as.sums.f, d = state->as.sums.d;
    do {
        *out++ = f;
        f = lmb_add_wrap(f, d >> guard);
        d = lmb_add_wrap(d, c);
    } while (out != end);
}
