/* SPDX-License-Identifier: MIT */
/* Paints: a look in the colours of a format. */
#include "paint.h"
#include "run.h"

#include "../firmware/look.h"

/* UQ1.15 times top, as a coefficient whose product with UQ1.15 has the channel's fraction. */
static uint32_t coefficient(uint32_t q15, channel c)
{
    return (lmb_mulu(q15, c.top) + ((uint32_t)1 << (29 - c.fraction))) >> (30 - c.fraction);
}

uint16_t lmb_shade_565(const uint16_t base[3], const uint16_t coefficient[3], uint32_t q15)
{
    uint32_t pixel = 0;
    unsigned k, bits = 5;
    for (k = 0; k < 3; k++) {
        const int32_t sum_q16 = (int32_t)((lmb_mulu(coefficient[k], q15) + (base ? (uint32_t)base[k] << 15 : 0)) >> 14);
        const uint32_t q16 = (uint32_t)lmb_min(sum_q16, 65536);
        pixel = pixel << bits | ((q16 << bits) - q16 + 0x8000u) >> 16; /* q16 times 31 or 63, rounded */
        bits ^= 5 ^ 6;
    }
    return (uint16_t)pixel;
}

/* Step i stands for values from i to i + 1 steps, so it takes the middle. */
static uint16_t colour_step(const lmb_look *look, int32_t i)
{
    return lmb_shade_565(look->ambient_q15, look->light[0].diffuse_q15, (uint32_t)lmb_min(512 * i + 256, 32768));
}

/* The same of the highlight, whose argument rises from zero at quiet to one at v = 0. */
static uint16_t highlight_step(const lmb_look *look, int32_t i)
{
    const int32_t v_q30 = lmb_mul(lmb_shr(look->light[0].quiet_q30, 9), lmb_max(2 * LMB_GLEAM - 1 - 2 * i, 0));
    return lmb_shade_565(NULL, look->light[0].specular_q15, (uint32_t)lmb_highlight_q15(look, v_q30));
}

#if LMB_WITH_RAMPS
static LMB_OUTLINE void ramps(lmb_paint *paint, const lmb_look *look)
{
    int32_t i;
    for (i = 0; i < lmb_max(LMB_RAMP_TOP, LMB_GLEAM_TOP); i++) {
        if (i < LMB_RAMP_TOP) paint->ramp[i] = colour_step(look, i);
        if (LMB_WITH_GLOSS && i < LMB_GLEAM_TOP) paint->ramp[LMB_RAMP_TOP + i] = highlight_step(look, i);
    }
}
#else
static void ramps(lmb_paint *paint, const lmb_look *look)
{
    (void)paint;
    (void)look;
}
uint16_t lmb_paint_colour(const lmb_paint *paint, uint32_t step) { return colour_step(&paint->look, (int32_t)step); }
uint16_t lmb_paint_gleam(const lmb_paint *paint, uint32_t step) { return highlight_step(&paint->look, (int32_t)step); }
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

void lmb_paint_within(lmb_paint *paint, const lmb_look *look, enum lmb_format format, uint16_t tolerance)
{
    int known = lmb_format_bytes(format) == 2 ? LMB_RGB565 : LMB_RGB888; /* a constant where one is built in */
    bool ramped;
    paint->look = *look;
    paint->format = (uint8_t)known;
    ramped = known == LMB_RGB565 && lmb_paint_is_simple(paint);
    paint->ramped = ramped;
    if (LMB_WITH_PLANS && ramped && look->step == LMB_STEP_PLANNED && tolerance < LMB_TOLERANCE_RGB565)
        tolerance = LMB_TOLERANCE_RGB565;
    lmb_look_tolerance(&paint->look, tolerance);
    if (ramped) {
        if (LMB_WITH_LOBES) lmb_look_ramp(&paint->look);
        ramps(paint, &paint->look);
    } else {
        coefficients(paint, known);
    }
}
