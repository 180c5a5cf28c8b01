/* SPDX-License-Identifier: MIT */
/* The begin and run of every way along a span, and what they share. Inside hosttest/compare/ only. */
#ifndef COMPARE_STEPS_PARTS_H
#define COMPARE_STEPS_PARTS_H

#include "steps.h"

#include "../../firmware/vec.h"
#include "walk.h"

typedef void compare_step_begin(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels);
typedef void compare_step_run(compare_step_state *state, int32_t *out, unsigned count);

/* steps_sums.c */
compare_step_begin compare_begin_flat, compare_begin_linear, compare_begin_quadratic;
compare_step_run compare_run_flat, compare_run_linear, compare_run_quadratic;
/* steps_normal.c */
compare_step_begin compare_begin_normal, compare_begin_length, compare_begin_floats;
compare_step_run compare_run_normalise_textbook, compare_run_normalise_sqrt, compare_run_normalise_multiply;
compare_step_run compare_run_taylor, compare_run_length, compare_run_map, compare_run_floats, compare_run_floats_textbook;
/* steps_angle.c */
compare_step_begin compare_begin_kuijk_blake;
compare_step_run compare_run_kuijk_blake;
/* steps_turn.c */
compare_step_begin compare_begin_vector16, compare_begin_vector32, compare_begin_plain16, compare_begin_plain32;
compare_step_begin compare_begin_block16, compare_begin_block32, compare_begin_lambent;
compare_step_run compare_run_vector16, compare_run_vector32, compare_run_plain16, compare_run_plain32, compare_run_block2;
compare_step_begin compare_begin_float_vector;
compare_step_run compare_run_float_vector;
compare_step_run compare_run_block3, compare_run_block4, compare_run_block4_32, compare_run_lambent;

static inline void compare_set_ray(compare_step_state *state, lmb_vec ray)
{
    state->ray[0] = ray.x;
    state->ray[1] = ray.y;
    state->ray[2] = ray.z;
}

/* a.b, Q4.28, as the library takes it: up to 1.41 long each. */
static inline int32_t compare_dot_q28(lmb_vec a, lmb_vec b) { return lmb_vec_dot_q28(&a, &b); }

/* The largest guard with 2^guard at most m. */
static inline unsigned compare_guard(unsigned m) { return 31u - lmb_clz32(m); }

/* x 2^guard / m, exact but for its last digit, in two divisions of 32 bits. m up to 4096, guard up to 12. */
static inline int32_t compare_over(int32_t x, unsigned m, unsigned guard)
{
    const int32_t quotient = x / (int32_t)m, rest = x - quotient * (int32_t)m;
    return quotient * ((int32_t)1 << guard) + rest * ((int32_t)1 << guard) / (int32_t)m;
}

/* floor(sqrt(x)): the usual method, a bit a time. */
static COMPARE_INLINE uint32_t compare_root(uint32_t x)
{
    uint32_t r = 0;
    unsigned shift;
    LMB_UNROLL
    for (shift = 32; shift != 0;) {
        uint32_t t;
        shift -= 2;
        t = r + ((uint32_t)1 << shift);
        r >>= 1;
        if (x >= t) {
            x -= t;
            r += (uint32_t)1 << shift;
        }
    }
    return r;
}

#endif
