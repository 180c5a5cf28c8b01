/* SPDX-License-Identifier: MIT */
/* Runs of pixels on RGB565 under one light: what the filler's loops are made of. Inside the filler only.
 *
 * N.L picks one of 64 steps of a ramp of pixels, the highlight's argument one of 256, and the two pixels are added. Each has been
 * rounded, to half a level and by half a step: together they are within 1.5 levels of the truth and so within one of it rounded.
 * Constant arguments leave out what a run does not need.
 */
#ifndef LMB_RUN_H
#define LMB_RUN_H

#include "levels.h"

/* From terms in Q2.30 to steps. */
#define RAMP_SHIFT 24
#define GLEAM_SHIFT 22
LMB_STATIC_ASSERT(LMB_RAMP == 1 << (30 - RAMP_SHIFT) && LMB_GLEAM == 1 << (30 - GLEAM_SHIFT));

/* What may happen to N.L: nothing, it lies on the ramp; it may fall below zero; it may leave the ramp at both ends. */
enum ramp_use { RAMP_EVEN, RAMP_LOW, RAMP_UNEVEN };

/* The ramp's step of N.L. */
static ALWAYS_INLINE uint32_t ramp_step(int32_t f, enum ramp_use use)
{
    int32_t step = f >> RAMP_SHIFT;
    if (use != RAMP_EVEN) step &= ~(step >> 31);
    return (uint32_t)(use == RAMP_UNEVEN && step >= LMB_RAMP_TOP ? LMB_RAMP_TOP - 1 : step);
}

/* The ramp's step of a highlight's argument above zero. */
static ALWAYS_INLINE uint32_t gleam_step(int32_t argument, unsigned shift, bool even)
{
    uint32_t step = (uint32_t)argument >> shift;
    return !even && step >= LMB_GLEAM_TOP ? LMB_GLEAM_TOP - 1 : step;
}

#if LMB_WITH_RAMPS

static ALWAYS_INLINE uint32_t colour_at(const lmb_paint *paint, uint32_t step) { return paint->colour[step]; }
static ALWAYS_INLINE uint32_t gleam_at(const lmb_paint *paint, uint32_t step) { return paint->gleam[step]; }

static ALWAYS_INLINE uint16_t *solid_run(uint16_t *pixel, uint32_t n, uint16_t colour)
{
    do *pixel++ = colour;
    while (--n > 0);
    return pixel;
}

/* One pixel of diffuse light. */
static ALWAYS_INLINE void plain_pixel(const uint16_t *colour, uint16_t *pixel, lmb_term *t, enum ramp_use use)
{
    *pixel = STORE_ORDER(colour[ramp_step(t->f, use)]);
    lmb_plane_step(t);
}

/* Diffuse alone, two pixels at a time, or four where N.L is linear: a loop is a fifth of the shorter pixel. */
static ALWAYS_INLINE void plain_run(const uint16_t *colour, uint16_t *pixel, uint32_t n, lmb_term t, enum ramp_use use,
                                    bool straight)
{
    uint16_t *const end = pixel + n;
    if (n & 1) plain_pixel(colour, pixel++, &t, use);
    if (straight && (n & 2)) {
        plain_pixel(colour, pixel, &t, use);
        plain_pixel(colour, pixel + 1, &t, use);
        pixel += 2;
    }
    while (pixel != end) {
        plain_pixel(colour, pixel, &t, use);
        plain_pixel(colour, pixel + 1, &t, use);
        if (straight) {
            plain_pixel(colour, pixel + 2, &t, use);
            plain_pixel(colour, pixel + 3, &t, use);
        }
        pixel += straight ? 4 : 2;
    }
}

/* Diffuse and highlight; saturates: some sum of the two may run over. */
static ALWAYS_INLINE void lit_run(const lmb_paint *paint, uint16_t *pixel, uint32_t n, lmb_term diffuse, lmb_term specular,
                                  unsigned shift, enum ramp_use use, bool saturates)
{
    const uint16_t *const colour = paint->colour;
    uint16_t *const end = pixel + n;
    do {
        const int32_t argument = specular.f;
        uint32_t sum = colour[ramp_step(diffuse.f, use)];
        if (argument > 0) {
            const uint32_t light = colour[LMB_RAMP_TOP + gleam_step(argument, shift, use != RAMP_UNEVEN)];
            sum = saturates ? add_565(sum, light) : sum + light;
        }
        lmb_plane_step(&diffuse);
        lmb_plane_step(&specular);
        *pixel++ = STORE_ORDER(sum);
    } while (pixel != end);
}

#else

/* Steps of the ramps, reckoned (paint.c). */
uint16_t lmb_paint_colour(const lmb_paint *paint, uint32_t step);
uint16_t lmb_paint_gleam(const lmb_paint *paint, uint32_t step);
static ALWAYS_INLINE uint32_t colour_at(const lmb_paint *paint, uint32_t step) { return lmb_paint_colour(paint, step); }
static ALWAYS_INLINE uint32_t gleam_at(const lmb_paint *paint, uint32_t step) { return lmb_paint_gleam(paint, step); }

#endif

/* One pixel of any kind: what the loops above do. */
static ALWAYS_INLINE uint16_t pixel_565(const lmb_paint *paint, int32_t diffuse, int32_t argument, unsigned shift)
{
    const uint32_t sum = colour_at(paint, ramp_step(diffuse, RAMP_UNEVEN));
    return STORE_ORDER(argument > 0 ? add_565(sum, gleam_at(paint, gleam_step(argument, shift, false))) : sum);
}

#endif
