/* SPDX-License-Identifier: MIT */
/* Paints: a look in the colours of a format. */
#include "run.h"

/* UQ1.15 times top, as a coefficient whose product with UQ1.15 has the channel's fraction. */
static uint32_t coefficient(uint32_t q15, channel c)
{
    return (lmb_mulu(q15, c.top) + ((uint32_t)1 << (29 - c.fraction))) >> (30 - c.fraction);
}

static uint32_t half_level(channel c) { return (uint32_t)1 << (c.fraction - 1); }

/* base plus q15 times the coefficients, as a pixel. */
static uint16_t shade_of(const uint32_t base[3], const uint16_t coefficients[3], uint32_t q15)
{
    uint32_t sum[3];
    unsigned k;
    for (k = 0; k < 3; k++) sum[k] = base[k] + lmb_mulu(coefficients[k], q15);
    return (uint16_t)pixel_of_565(sum);
}

/* Step i stands for values from i to i + 1 steps, so it takes the middle. */
static uint16_t colour_step(const lmb_paint *paint, uint32_t i)
{
    return shade_of(paint->ambient, paint->light[0].diffuse, i < LMB_RAMP ? 512 * i + 256 : 32768);
}

static uint16_t highlight_step(const lmb_paint *paint, uint32_t i)
{
    const uint32_t half[3] = {half_level(channel_of(LMB_RGB565, 0)), half_level(channel_of(LMB_RGB565, 1)),
                              half_level(channel_of(LMB_RGB565, 2))};
    uint32_t lobe = (uint32_t)lmb_look_ramp_at(&paint->look, 0, (i << 22) + ((uint32_t)1 << 21));
    return shade_of(half, paint->light[0].specular, lobe);
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

void lmb_paint_prepare(lmb_paint *paint, const lmb_look *look, enum lmb_format format)
{
    int known = lmb_format_bytes(format) == 2 ? LMB_RGB565 : LMB_RGB888, i; /* a constant where one is built in */
    unsigned k;
    paint->look = *look;
    paint->format = (uint8_t)known;
    for (i = 0; i < 3; i++) {
        const channel c = channel_of(known, i);
        paint->ambient[i] = lmb_mulu((uint32_t)look->ambient_q15[i] << (c.fraction - 15), c.top) + half_level(c);
        for (k = 0; k < lmb_look_lights(look); k++) {
            paint->light[k].diffuse[i] = (uint16_t)coefficient(look->light[k].diffuse_q15[i], c);
            paint->light[k].specular[i] = (uint16_t)coefficient(look->light[k].specular_q15[i], c);
        }
    }
    lmb_look_tolerance(&paint->look, known == LMB_RGB565 ? LMB_TOLERANCE_RGB565 : LMB_TOLERANCE_RGB888);
    paint->ramped = known == LMB_RGB565 && lmb_paint_is_simple(paint);
    if (paint->ramped) ramps(paint);
}
