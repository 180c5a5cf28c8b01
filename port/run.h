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

/* What a highlight needs of a run: how its argument becomes a step, and what may happen. */
typedef struct gleam_use {
    unsigned shift;
    bool even;      /* the argument stays on its ramp */
    bool saturates; /* some sum of diffuse and highlight may run over, */
    bool glares;    /* and if so, from this argument on: */
    int32_t glare;
} gleam_use;

/* Where a highlight is added, N.L that stays on its ramp is lowered by the length of that: its step then counts from the other ramp,
 * which lies behind, and one register points to both. Otherwise from where its own begins. */
#define LIT_BELOW ((int32_t)LMB_RAMP_TOP << RAMP_SHIFT)

static ALWAYS_INLINE void solid_run(uint16_t *pixel, const uint16_t *end, uint16_t colour)
{
    do *pixel++ = colour;
    while (pixel != end);
}

#if LMB_WITH_RAMPS

static ALWAYS_INLINE uint32_t colour_at(const lmb_paint *paint, uint32_t step) { return paint->ramp[step]; }
static ALWAYS_INLINE uint32_t gleam_at(const lmb_paint *paint, uint32_t step) { return paint->ramp[LMB_RAMP_TOP + step]; }

/* One pixel of diffuse light. */
static ALWAYS_INLINE void plain_pixel(const uint16_t *colour, uint16_t *pixel, lmb_term *t, enum ramp_use use)
{
    *pixel = STORE_ORDER(colour[ramp_step(t->f, use)]);
    lmb_plane_step(t);
}

/* Diffuse alone, two pixels at a time, or four where N.L is linear: a loop is a fifth of the shorter pixel. */
static ALWAYS_INLINE void plain_run(const uint16_t *colour, uint16_t *pixel, uint32_t n, lmb_term *diffuse, enum ramp_use use,
                                    bool straight)
{
    uint16_t *const end = pixel + n;
    lmb_term t = *diffuse;
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
    *diffuse = t;
}

static ALWAYS_INLINE const uint16_t *lit_ramp(const lmb_paint *paint, enum ramp_use use)
{
    return paint->ramp + (use == RAMP_EVEN ? LMB_RAMP_TOP : 0);
}

static ALWAYS_INLINE uint32_t plain_sum(uint32_t a, uint32_t b)
{
#if defined(__thumb__) && !defined(__thumb2__)
    __asm__("add %0, %1" : "+l"(a) : "l"(b) : "cc");
    return a;
#else
    return a + b;
#endif
}

/* Diffuse light, and the highlight where there is any. */
static ALWAYS_INLINE uint32_t lit_sum(const uint16_t *ramp, int32_t diffuse, int32_t argument, enum ramp_use use,
                                      const gleam_use how)
{
    const bool even = use == RAMP_EVEN;
    uint32_t sum = ramp[even ? diffuse >> RAMP_SHIFT : (int32_t)ramp_step(diffuse, use)], light;
    if (even) HIDE(sum);
    if (argument > 0) {
        if (even) HERE();
        light = ramp[gleam_step(argument, how.shift, how.even) + (even ? 0 : LMB_RAMP_TOP)];
        if (even) HIDE(light);
        if (how.glares) {
            sum = argument < how.glare ? plain_sum(sum, light) : GLARE_565(sum, light);
        } else {
            sum = how.saturates ? add_565(sum, light) : plain_sum(sum, light);
        }
    }
    return sum;
}

static ALWAYS_INLINE void lit_run(const lmb_paint *paint, uint16_t *pixel, const uint16_t *end, lmb_term *n_l, lmb_term *n_h,
                                  enum ramp_use use, const gleam_use how)
{
    const uint16_t *const ramp = lit_ramp(paint, use);
    lmb_term diffuse = *n_l, specular = *n_h;
    do {
        const uint32_t sum = lit_sum(ramp, diffuse.f, specular.f, use, how);
        lmb_plane_step(&diffuse);
        lmb_plane_step(&specular);
        *pixel++ = STORE_ORDER(sum);
    } while (pixel != end);
    *n_l = diffuse;
    *n_h = specular;
}

/* What lmb_arc_step needs of an arc, where no store of a pixel can change it. */
static ALWAYS_INLINE lmb_arc arc_of(const lmb_arc *arc)
{
    lmb_arc a;
    a.kappa = arc->kappa;
    a.kappa_shift = arc->kappa_shift;
    a.guard = arc->guard;
    return a;
}

/* One pixel of diffuse light along an arc. */
static ALWAYS_INLINE void arc_pixel(const uint16_t *colour, uint16_t *pixel, const lmb_arc *arc, lmb_term *t, enum ramp_use use)
{
    *pixel = STORE_ORDER(colour[ramp_step(t->f, use)]);
    lmb_arc_step(arc, t);
}

static ALWAYS_INLINE void arc_pixels(const uint16_t *colour, uint16_t *pixel, uint32_t n, const lmb_arc *from, lmb_term *diffuse,
                                     enum ramp_use use)
{
    uint16_t *const end = pixel + n;
    const lmb_arc arc = arc_of(from);
    lmb_term t = *diffuse;
    if (n & 1) arc_pixel(colour, pixel++, &arc, &t, use);
    if (LMB_LOOPS && (n & 2)) {
        arc_pixel(colour, pixel, &arc, &t, use);
        arc_pixel(colour, pixel + 1, &arc, &t, use);
        pixel += 2;
    }
    while (pixel != end) {
        arc_pixel(colour, pixel, &arc, &t, use);
        arc_pixel(colour, pixel + 1, &arc, &t, use);
        if (LMB_LOOPS) {
            arc_pixel(colour, pixel + 2, &arc, &t, use);
            arc_pixel(colour, pixel + 3, &arc, &t, use);
        }
        pixel += LMB_LOOPS ? 4 : 2;
    }
    *diffuse = t;
}

/* Whether a term certainly stays above zero over n pixels of an arc. f is at most 1.0625 (lmb_arc_step), so d loses at most
 * c = 1.0625 kappa a pixel and f(t) >= f + t d - c t (t - 1) / 2, which is concave: its ends tell. Over the n - 1 steps of an arc the
 * middle part is at most psi, 2.1, and the last half of its square, 2.4: they are added up in Q4.28. Shifts that round down lose
 * less than n in Q2.30 each. */
static ALWAYS_INLINE bool arc_stays_above(const lmb_arc *arc, const lmb_term *term, uint32_t n)
{
    const uint32_t margin = 4096, steps = n - 1;
    const uint32_t loss = lmb_mulu(arc->kappa, 139264) >> arc->kappa_shift >> arc->guard;
    int32_t last;
    if (n > 1024 || term->f < 4 * (int32_t)margin) return false;
    last = lmb_add_wrap(term->f >> 2, lmb_mul_wrap((int32_t)steps, term->d >> arc->guard >> 2));
    last = lmb_sub_wrap(last, lmb_signed(((steps * (steps - 1)) >> 1) * (loss + 1) >> 2));
    return last > (int32_t)margin;
}

/* Diffuse alone along an arc, which never leaves the ramp at its top: 1.0625 is step 68. */
static ALWAYS_INLINE void arc_run(const uint16_t *colour, uint16_t *pixel, uint32_t n, const lmb_arc *arc, lmb_term *diffuse)
{
    if (LMB_LOOPS && arc_stays_above(arc, diffuse, n)) {
        arc_pixels(colour, pixel, n, arc, diffuse, RAMP_EVEN);
    } else {
        arc_pixels(colour, pixel, n, arc, diffuse, RAMP_UNEVEN);
    }
}

/* Whether a highlight certainly stays dark over n pixels of an arc. While f >= 0 d does not grow, so f lies below its first tangent;
 * and an arc, of 120 degrees at most, does not return from below zero, where the argument f + c is dark as well. */
static ALWAYS_INLINE bool arc_stays_dark(const lmb_arc *arc, const lmb_term *term, uint32_t n)
{
    const int32_t slope = (term->d >> arc->guard >> 2) + 1, margin = 16;
    const int32_t most = lmb_add_wrap(term->f >> 2, slope > 0 ? lmb_mul_wrap((int32_t)n - 1, slope) : 0);
    return n <= 1024 && term->f >= 0 && term->c <= 0 && lmb_add_wrap(most, (term->c >> 2) + margin) < 0;
}

/* The highlight along an arc, on top of what is there: both terms at once would want thirteen registers. */
static ALWAYS_INLINE void arc_gleam_run(const uint16_t *gleam, uint16_t *pixel, uint32_t n, const lmb_arc *from,
                                        lmb_term *specular, unsigned shift)
{
    uint16_t *const end = pixel + n;
    const lmb_arc arc = arc_of(from);
    lmb_term t = *specular;
    do {
        const int32_t argument = lmb_add_wrap(t.f, t.c);
        if (argument > 0) *pixel = STORE_ORDER(add_565(STORE_ORDER(*pixel), gleam[gleam_step(argument, shift, false)]));
        lmb_arc_step(&arc, &t);
    } while (++pixel != end);
    *specular = t;
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
