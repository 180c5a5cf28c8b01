/* SPDX-License-Identifier: MIT */
/* Paints: a look in the colours of a format. */
#include "run.h"

/* UQ1.15 times top, as a coefficient whose product with UQ1.15 has the channel's fraction. */
static uint32_t coefficient(uint32_t q15, channel c)
{
    return (lmb_mulu(q15, c.top) + ((uint32_t)1 << (29 - c.fraction))) >> (30 - c.fraction);
}

/* base, which may be NULL, plus q15 times the coefficients, all UQ1.15, as an RGB565 pixel. */
static uint16_t shade_of(const uint16_t base[3], const uint16_t coefficient[3], uint32_t q15)
{
    uint32_t pixel = 0;
    unsigned k;
    for (k = 0; k < 3; k++) {
        const uint32_t top = k == 1 ? 63 : 31, sum_q30 = lmb_mulu(coefficient[k], q15) + (base ? (uint32_t)base[k] << 15 : 0);
        const uint32_t l = (lmb_mulu(sum_q30 >> 14, top) + 0x8000u) >> 16;
        pixel = pixel << (k == 1 ? 6 : 5) | (l > top ? top : l);
    }
    return (uint16_t)pixel;
}

/* Step i stands for values from i to i + 1 steps, so it takes the middle. */
static uint16_t colour_step(const lmb_paint *paint, uint32_t i)
{
    return shade_of(paint->look.ambient_q15, paint->look.light[0].diffuse_q15, i < LMB_RAMP ? 512 * i + 256 : 32768);
}

static uint16_t highlight_step(const lmb_paint *paint, uint32_t i)
{
    uint32_t lobe = (uint32_t)lmb_look_ramp_at(&paint->look, 0, (i << 22) + ((uint32_t)1 << 21));
    return shade_of(NULL, paint->look.light[0].specular_q15, lobe);
}

#if LMB_WITH_RAMPS
static void ramps(lmb_paint *paint)
{
    uint32_t i;
    lmb_look_ramp(&paint->look);
    for (i = 0; i < LMB_RAMP_TOP; i++) paint->colour[i] = colour_step(paint, i);
    for (i = 0; i < LMB_GLEAM_TOP; i++) paint->gleam[i] = highlight_step(paint, i);
}
#else
static void ramps(lmb_paint *paint) { lmb_look_ramp(&paint->look); }
uint16_t lmb_paint_colour(const lmb_paint *paint, uint32_t step) { return colour_step(paint, step); }
uint16_t lmb_paint_gleam(const lmb_paint *paint, uint32_t step) { return highlight_step(paint, step); }
#endif

/* Coefficients of sums, for all that ramps do not serve. */
static void coefficients(lmb_paint *paint, int format)
{
    const lmb_look *look = &paint->look;
    unsigned k;
    int i;
    for (i = 0; i < 3; i++) {
        const channel c = channel_of(format, i);
        const uint32_t half_level = (uint32_t)1 << (c.fraction - 1);
        paint->ambient[i] = lmb_mulu((uint32_t)look->ambient_q15[i] << (c.fraction - 15), c.top) + half_level;
        for (k = 0; k < lmb_look_lights(look); k++) {
            paint->light[k].diffuse[i] = (uint16_t)coefficient(look->light[k].diffuse_q15[i], c);
            paint->light[k].specular[i] = (uint16_t)coefficient(look->light[k].specular_q15[i], c);
        }
    }
}

void lmb_paint_prepare(lmb_paint *paint, const lmb_look *look, enum lmb_format format)
{
    int known = lmb_format_bytes(format) == 2 ? LMB_RGB565 : LMB_RGB888; /* a constant where one is built in */
    paint->look = *look;
    paint->format = (uint8_t)known;
    paint->ramped = known == LMB_RGB565 && lmb_paint_is_simple(paint);
    paint->look.tolerance = known == LMB_RGB565 ? LMB_TOLERANCE_RGB565 : LMB_TOLERANCE_RGB888;
    if (known == LMB_RGB565 && lmb_paint_is_simple(paint)) {
        ramps(paint);
    } else {
        lmb_look_tolerance(&paint->look, paint->look.tolerance);
        coefficients(paint, known);
    }
}
