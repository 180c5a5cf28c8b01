/* SPDX-License-Identifier: MIT */
/* Gouraud on RGB565 under one light: runs of pixels whose two terms are linear. Inside the filler only.
 *
 * Channels are sums as everywhere (levels.h), of intensities f >> 15. Where nothing is to be clamped a pixel takes no product: its
 * sums are those before it plus a constant, and a light's own step where the fraction of its term carries. That is exact.
 */
#ifndef LMB_CORNER_H
#define LMB_CORNER_H

#include "levels.h"

#define GOURAUD_ROWS (LMB_WITH_GOURAUD && LMB_LOOPS)

/* What sums gain from one pixel to the next, all over a triangle. */
typedef struct corner_steps {
    uint32_t rise[3];                     /* of the sums, without carries */
    uint32_t diffuse[3], specular[3];     /* for a carry */
    uint32_t diffuse_part, specular_part; /* of the fractions, 2^-32 */
} corner_steps;

#if GOURAUD_ROWS

/* Any two linear terms. */
static ALWAYS_INLINE void corner_run(const lmb_paint *paint, uint16_t *pixel, uint32_t n, lmb_term diffuse, lmb_term specular)
{
    do {
        uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
        add_light(sum, paint->light[0].diffuse, intensity(diffuse.f));
        add_light(sum, paint->light[0].specular, intensity(specular.f));
        *pixel++ = STORE_ORDER(pixel_of_565(sum));
        diffuse.f = lmb_add_wrap(diffuse.f, diffuse.d);
        specular.f = lmb_add_wrap(specular.f, specular.d);
    } while (--n > 0);
}

static ALWAYS_INLINE void corner_steps_set(corner_steps *steps, const lmb_paint *paint, int32_t diffuse_dx, int32_t specular_dx)
{
    const uint32_t d = (uint32_t)(diffuse_dx >> 15), s = (uint32_t)(specular_dx >> 15);
    unsigned i;
    for (i = 0; i < 3; i++) {
        steps->diffuse[i] = paint->light[0].diffuse[i];
        steps->specular[i] = paint->light[0].specular[i];
        steps->rise[i] = steps->diffuse[i] * d + steps->specular[i] * s;
    }
    steps->diffuse_part = (uint32_t)diffuse_dx << 17;
    steps->specular_part = (uint32_t)specular_dx << 17;
}

/* The greatest intensity over n pixels, that of one end, or more than one if the term leaves [0, 1]. */
static ALWAYS_INLINE uint32_t intensity_most(lmb_term term, uint32_t n)
{
    const uint32_t first = (uint32_t)term.f >> 15;
    const uint32_t last = (uint32_t)lmb_add_wrap(term.f, lmb_mul_wrap((int32_t)n - 1, term.d)) >> 15;
    return first > last ? first : last;
}

/* Whether both terms stay in [0, 1] over n pixels and no sum reaches 2^30, the first level that is too much. */
static ALWAYS_INLINE bool corners_even(const lmb_paint *paint, uint32_t n, lmb_term diffuse, lmb_term specular, bool highlight)
{
    const uint32_t d = intensity_most(diffuse, n), s = highlight ? intensity_most(specular, n) : 0;
    uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
    if (d > 32768 || s > 32768) return false;
    add_light(sum, paint->light[0].diffuse, d);
    if (highlight) add_light(sum, paint->light[0].specular, s);
    return !((sum[0] | sum[1] | sum[2]) >> 30);
}

/* The same where corners_even says so. */
static ALWAYS_INLINE void corner_run_even(const lmb_paint *paint, const corner_steps *steps, uint16_t *pixel, uint32_t n,
                                          int32_t diffuse, int32_t specular, bool highlight)
{
    uint16_t *const end = pixel + n;
    uint32_t d = (uint32_t)diffuse >> 15, s = highlight ? (uint32_t)specular >> 15 : 0;
    uint32_t red = paint->ambient[0] + steps->diffuse[0] * d + steps->specular[0] * s;
    uint32_t green = paint->ambient[1] + steps->diffuse[1] * d + steps->specular[1] * s;
    uint32_t blue = paint->ambient[2] + steps->diffuse[2] * d + steps->specular[2] * s;
    d = (uint32_t)diffuse << 17;
    s = (uint32_t)specular << 17;
    for (;;) {
        *pixel++ = STORE_ORDER(red >> 25 << 11 | green >> 24 << 5 | blue >> 25);
        if (pixel == end) return;
        red += steps->rise[0];
        green += steps->rise[1];
        blue += steps->rise[2];
        d += steps->diffuse_part;
        if (d < steps->diffuse_part) {
            red += steps->diffuse[0];
            green += steps->diffuse[1];
            blue += steps->diffuse[2];
        }
        if (!highlight) continue;
        s += steps->specular_part;
        if (s < steps->specular_part) {
            red += steps->specular[0];
            green += steps->specular[1];
            blue += steps->specular[2];
        }
    }
}

/* Gouraud's pixels: of any terms, and without products. */
static NOINLINE void corner_any(const lmb_paint *paint, uint16_t *pixel, uint32_t n, lmb_term n_l, lmb_term n_h)
{
    corner_run(paint, pixel, n, n_l, n_h);
}

static NOINLINE void corner_lit(const lmb_paint *paint, const corner_steps *steps, uint16_t *pixel, uint32_t n, int32_t n_l,
                                int32_t n_h)
{
    corner_run_even(paint, steps, pixel, n, n_l, n_h, true);
}

static ALWAYS_INLINE void corner_pixels(const lmb_paint *paint, const corner_steps *steps, uint16_t *pixel, uint32_t n,
                                        lmb_term n_l, lmb_term n_h, bool highlight)
{
    if (!corners_even(paint, n, n_l, n_h, highlight)) {
        corner_any(paint, pixel, n, n_l, n_h);
    } else if (highlight) {
        corner_lit(paint, steps, pixel, n, n_l.f, n_h.f);
    } else {
        corner_run_even(paint, steps, pixel, n, n_l.f, 0, false);
    }
}

#endif

#endif
