/* SPDX-License-Identifier: MIT */
/* Ways along a span in integers, for comparison: what paper 001 proposes, what it compares itself with, and the library's own.
 * hosttest/papers/steps.h defines each in double. The same code gives the errors in arc.csv and the cycles of make profile.
 *
 * HOW TO MEASURE
 *   once a light   compare_step_light, for the methods that look light up
 *   step-*-setup   kernel.begin: from two normals and a ray to the first pixel
 *   step-*         kernel.run: the loop, one word stored a pixel. step-flat is the loop with nothing in it but that.
 * Normals and rays are Q2.14, up to 5 % off unit as all that the library takes; nothing else faults either, but is worth nothing.
 */
#ifndef COMPARE_STEPS_H
#define COMPARE_STEPS_H

#include "compare.h"

#include "../../firmware/arc.h"

/* 0 where memory is too small for the reflection map. */
#ifndef COMPARE_WITH_MAP
#if defined(__AVR__)
#define COMPARE_WITH_MAP 0
#else
#define COMPARE_WITH_MAP 1
#endif
#endif

#define COMPARE_STEP_PIXELS_MAX 4096u
#define COMPARE_STEP_SPARE 4 /* words behind the last pixel that blocks may write */

#define COMPARE_MAP_CELLS 64
#define COMPARE_MAP_LENGTHS 256

/* A reflection map for one ray: 1/|N| by |N|^2, then light by direction, towards the viewer and away. */
typedef struct compare_step_map {
    uint16_t inverse_q12[COMPARE_MAP_LENGTHS + 1];
    int16_t light_q14[2][COMPARE_MAP_CELLS][COMPARE_MAP_CELLS];
} compare_step_map;

/* Fills a map; takes roots and divisions. */
void compare_step_light(compare_step_map *map, lmb_vec ray);

/* A span on its way: the part of it that its method uses. */
typedef struct compare_step_state {
    const compare_step_map *map; /* set before begin, where the method wants it */
    int32_t ray[3];              /* Q2.14 */
    union {
        struct {
            int32_t f, d, c; /* Q4.28, the parabola's Q5.27; d and c times 2^guard */
            unsigned guard;
        } sums;
        struct {
            int32_t n[3], step[3]; /* Q3.29 */
        } normal;
        struct {
            int64_t square, d, c; /* Q12.52 */
            int32_t dot, rise;    /* Q3.29 */
        } length;
        struct {
            uint32_t angle, step; /* 2^32 to a turn */
            int32_t amplitude;    /* Q2.14 */
        } angle;
        struct {
            float n[3], step[3], ray[3]; /* of eq. 7 step is the normal before n, and cosine its factor, doubled */
            float cosine;
        } floats;
        lmb_plain16 plain16[3];
        lmb_plain32 plain32[3];
        lmb_block4 block16;
        struct {
            int32_t f, before, cosine, cosine2; /* Q2.30 */
        } block32;
        struct {
            lmb_arc arc;
            lmb_term term;
        } arc;
    } as;
} compare_step_state;

typedef struct compare_step_kernel {
    const char *name, *form; /* form: the name of its definition in double */
    unsigned fraction_bits;  /* of what it writes */
    void (*begin)(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels);
    /* Writes f(0) ... f(count - 1) and perhaps COMPARE_STEP_SPARE words more. Once after begin. */
    void (*run)(compare_step_state *state, int32_t *out, unsigned count);
} compare_step_kernel;

extern const compare_step_kernel compare_steps[];
extern const unsigned compare_step_count;

#endif
