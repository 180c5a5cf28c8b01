/* SPDX-License-Identifier: MIT */
/* The filler: spans into pixels, in loops that the compiler fuses with the library's inline steps.
 *
 * A channel is level = (ambient + sum of diffuse * d + specular * s) >> shift, one 32-bit sum: d and s are UQ1.15, the
 * coefficients have 15 bits, and each of the three parts is at most 2^30 (one light), so the sum stays under 2^32 and is
 * saturated once at the end. With more lights each light's sum is saturated before the next; all parts are positive, so that
 * changes nothing.
 *
 * One loop is written, lit_run; constant arguments make eight of it: two formats, planes or arcs, highlight or not.
 */
#include "fill.h"

#if defined(__GNUC__)
#define ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define ALWAYS_INLINE inline
#endif

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#define STORE_ORDER(x) ((uint16_t)((uint16_t)(x) >> 8 | (uint16_t)(x) << 8))
#else
#define STORE_ORDER(x) ((uint16_t)(x))
#endif

/* Greatest level of each channel, and fraction bits of its sum: levels * 2^fraction is just under 2^30. */
typedef struct channel {
    uint8_t top, fraction;
} channel;

/* Which of the two; a constant where only one is built in. */
static ALWAYS_INLINE bool is_rgb565(const lmb_surface *surface)
{
    return LMB_WITH_RGB565 && (!LMB_WITH_RGB888 || surface->format == LMB_RGB565);
}

static ALWAYS_INLINE channel channel_of(int format, int i)
{
    channel c;
    c.top = format == LMB_RGB888 ? 255 : i == 1 ? 63 : 31;
    c.fraction = format == LMB_RGB888 ? 22 : i == 1 ? 24 : 25;
    return c;
}
LMB_STATIC_ASSERT(255ull << 22 < 1ull << 30 && 63ull << 24 < 1ull << 30 && 31ull << 25 < 1ull << 30);
LMB_STATIC_ASSERT(3 * (1ull << 30) + (1ull << 24) < 1ull << 32);

/* UQ1.15 times top, as a coefficient whose product with UQ1.15 has the channel's fraction. */
static uint32_t coefficient(uint32_t q15, channel c)
{
    return (lmb_mulu(q15, c.top) + ((uint32_t)1 << (29 - c.fraction))) >> (30 - c.fraction);
}

void lmb_paint_prepare(lmb_paint *paint, const lmb_look *look, enum lmb_format format)
{
    int known = lmb_format_bytes(format) == 2 ? LMB_RGB565 : LMB_RGB888, i; /* a constant where one is built in */
    unsigned k;
    for (i = 0; i < 3; i++) {
        const channel c = channel_of(known, i);
        paint->ambient[i] =
            lmb_mulu((uint32_t)look->ambient_q15[i] << (c.fraction - 15), c.top) + ((uint32_t)1 << (c.fraction - 1));
        for (k = 0; k < lmb_look_lights(look); k++) {
            paint->light[k].diffuse[i] = (uint16_t)coefficient(look->light[k].diffuse_q15[i], c);
            paint->light[k].specular[i] = (uint16_t)coefficient(look->light[k].specular_q15[i], c);
        }
    }
}

/* From a term in Q2.30 to the lobe's entry, Q16.16. */
#define LOBE_ENTRY_SHIFT 14

/* -----------------------------------------------------------------------------------------------------------------------
 * pixels */

static ALWAYS_INLINE uint32_t level(uint32_t sum, channel c)
{
    uint32_t l = sum >> c.fraction;
    return l > c.top ? c.top : l;
}

static ALWAYS_INLINE void store(int format, void *pixel, const uint32_t sum[3])
{
    uint32_t r = level(sum[0], channel_of(format, 0)), g = level(sum[1], channel_of(format, 1)),
             b = level(sum[2], channel_of(format, 2));
    if (format == LMB_RGB565) {
        *(uint16_t *)pixel = STORE_ORDER(r << 11 | g << 5 | b);
    } else {
        ((uint8_t *)pixel)[0] = (uint8_t)r;
        ((uint8_t *)pixel)[1] = (uint8_t)g;
        ((uint8_t *)pixel)[2] = (uint8_t)b;
    }
}

static ALWAYS_INLINE void add_light(uint32_t sum[3], const uint16_t coefficients[3], uint32_t intensity_q15)
{
    sum[0] += coefficients[0] * intensity_q15;
    sum[1] += coefficients[1] * intensity_q15;
    sum[2] += coefficients[2] * intensity_q15;
}

/* A term in Q2.30 as an intensity, UQ1.15. */
static ALWAYS_INLINE uint32_t intensity(int32_t f)
{
    int32_t q15 = f >> 15;
    return (uint32_t)(q15 < 0 ? 0 : q15 > 32768 ? 32768 : q15);
}

/* True where the pixel is nearer than what is there; then it takes the place. */
static ALWAYS_INLINE bool depth_pass(uint16_t *stored, lmb_term *depth)
{
    int32_t now = depth->f >> 14;
    lmb_plane_step(depth);
    if (now >= *stored) return false;
    *stored = (uint16_t)(now < 0 ? 0 : now);
    return true;
}

/* One light; diffuse, with or without a highlight. */
static ALWAYS_INLINE void lit_run(const lmb_look *look, const lmb_paint *paint, const lmb_span *span, uint8_t *pixel,
                                  uint16_t *stored, int format, bool arc, bool highlight)
{
    const unsigned shift = LOBE_ENTRY_SHIFT - (highlight ? span->exponent[0] : 0);
    static const lmb_term none = {0, 0, 0};
    lmb_term diffuse = span->diffuse_on ? span->diffuse[0] : none, specular = span->specular[0], depth = span->depth;
    const lmb_lobe lobe = look->lobe;
    unsigned n;
    for (n = span->length; n > 0; n--, pixel += format == LMB_RGB565 ? 2 : 3) {
        if (!LMB_WITH_DEPTH || !stored || depth_pass(stored++, &depth)) {
            uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
            add_light(sum, paint->light[0].diffuse, intensity(diffuse.f));
            if (highlight) {
                int32_t s = arc ? lmb_add_wrap(specular.f, specular.c) : specular.f;
                if (s > 0) add_light(sum, paint->light[0].specular, (uint32_t)lmb_lobe_at(&lobe, s >> shift));
            }
            store(format, pixel, sum);
        }
        if (arc) {
            lmb_arc_step(&span->arc, &diffuse);
            if (highlight) lmb_arc_step(&span->arc, &specular);
        } else {
            lmb_plane_step(&diffuse);
            if (highlight) lmb_plane_step(&specular);
        }
    }
}

/* What one light adds at one pixel of any kind of span. */
static void light_pixel(uint32_t sum[3], const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                        const lmb_term *diffuse, const lmb_term *specular, unsigned i)
{
    if (lmb_bit(span->diffuse_on, i)) add_light(sum, paint->light[i].diffuse, intensity(diffuse->f));
    if (lmb_bit(span->specular_on, i)) {
        if (look->model != LMB_MODEL_GLOSS) {
            add_light(sum, paint->light[i].specular, intensity(specular->f));
        } else {
            int32_t s = span->kind == LMB_SPAN_ARC ? lmb_add_wrap(specular->f, specular->c) : specular->f;
            unsigned shift = LOBE_ENTRY_SHIFT - span->exponent[i];
            if (s > 0) add_light(sum, paint->light[i].specular, (uint32_t)lmb_lobe_at(&look->lobe, s >> shift));
        }
    }
}

static void saturate(uint32_t sum[3], int format)
{
    int i;
    for (i = 0; i < 3; i++) {
        const channel c = channel_of(format, i);
        const uint32_t most = ((uint32_t)c.top << c.fraction) + ((uint32_t)1 << (c.fraction - 1));
        if (sum[i] > most) sum[i] = most;
    }
}

static void terms_step(const lmb_span *span, lmb_term *term)
{
    if (span->kind == LMB_SPAN_PLANE) {
        lmb_plane_step(term);
    } else if (span->kind == LMB_SPAN_ARC) {
        lmb_arc_step(&span->arc, term);
    }
}

/* What all lights add at one pixel, saturated. */
static void all_lights(uint32_t sum[3], int format, const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                       const lmb_term *diffuse, const lmb_term *specular)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(look); i++) {
        light_pixel(sum, look, paint, span, &diffuse[i], &specular[i], i);
        saturate(sum, format);
    }
}

/* A pixel whose format is known at run time only. */
static void store_as(const lmb_surface *surface, uint8_t *pixel, const uint32_t sum[3])
{
    if (is_rgb565(surface)) {
        store(LMB_RGB565, pixel, sum);
    } else {
        store(LMB_RGB888, pixel, sum);
    }
}

/* One colour: the triangle is flat, or no light reaches it. */
static void solid_run(const lmb_surface *surface, const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                      uint8_t *pixel, uint16_t *stored)
{
    lmb_term depth = span->depth;
    uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
    unsigned step = lmb_format_bytes((enum lmb_format)surface->format), n;
    if (LMB_WITH_CORNERS) all_lights(sum, surface->format, look, paint, span, span->diffuse, span->specular);
    for (n = span->length; n > 0; n--, pixel += step) {
        if (!LMB_WITH_DEPTH || !stored || depth_pass(stored++, &depth)) store_as(surface, pixel, sum);
    }
}

/* Any number of lights, any kind, any model. */
static void general_run(const lmb_surface *surface, const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                        uint8_t *pixel, uint16_t *stored)
{
    lmb_term diffuse[LMB_LIGHTS], specular[LMB_LIGHTS], depth = span->depth;
    unsigned step = lmb_format_bytes((enum lmb_format)surface->format), n, i;
    for (i = 0; i < lmb_look_lights(look); i++) {
        diffuse[i] = span->diffuse[i];
        specular[i] = span->specular[i];
    }
    for (n = span->length; n > 0; n--, pixel += step) {
        if (!LMB_WITH_DEPTH || !stored || depth_pass(stored++, &depth)) {
            uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
            all_lights(sum, surface->format, look, paint, span, diffuse, specular);
            store_as(surface, pixel, sum);
        }
        for (i = 0; i < lmb_look_lights(look); i++) {
            if (lmb_bit(span->diffuse_on, i)) terms_step(span, &diffuse[i]);
            if (lmb_bit(span->specular_on, i)) terms_step(span, &specular[i]);
        }
    }
}

static ALWAYS_INLINE void one_light_run(const lmb_look *look, const lmb_paint *paint, const lmb_span *span, uint8_t *pixel,
                                        uint16_t *stored, int format)
{
    if (LMB_WITH_ARC && span->kind == LMB_SPAN_ARC) {
        if (span->specular_on) {
            lit_run(look, paint, span, pixel, stored, format, true, true);
        } else {
            lit_run(look, paint, span, pixel, stored, format, true, false);
        }
    } else if (span->specular_on) {
        lit_run(look, paint, span, pixel, stored, format, false, true);
    } else {
        lit_run(look, paint, span, pixel, stored, format, false, false);
    }
}

void lmb_fill_span(const lmb_surface *surface, const lmb_look *look, const lmb_paint *paint, const lmb_span *span)
{
    size_t row = (size_t)lmb_sub(span->y, surface->window.top), column = (size_t)lmb_sub(span->x, surface->window.left);
    size_t width = (size_t)lmb_sub(surface->window.right, surface->window.left);
    uint8_t *pixel =
        (uint8_t *)surface->pixels + row * surface->pitch + column * lmb_format_bytes((enum lmb_format)surface->format);
    uint16_t *stored = LMB_WITH_DEPTH && surface->depth ? surface->depth + row * width + column : NULL;
    bool fast = lmb_look_lights(look) == 1 && (!LMB_WITH_CORNERS || look->model >= LMB_MODEL_DIFFUSE);
    if ((LMB_WITH_CORNERS && span->kind == LMB_SPAN_FLAT) || !(span->diffuse_on | span->specular_on)) {
        solid_run(surface, look, paint, span, pixel, stored);
    } else if (!fast) {
        general_run(surface, look, paint, span, pixel, stored);
    } else if (is_rgb565(surface)) {
        one_light_run(look, paint, span, pixel, stored, LMB_RGB565);
    } else {
        one_light_run(look, paint, span, pixel, stored, LMB_RGB888);
    }
}
