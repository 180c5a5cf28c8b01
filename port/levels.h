/* SPDX-License-Identifier: MIT */
/* Levels of channels: sums of light with a fraction, and pixels in the byte order of every machine. Inside the filler only.
 *
 * A channel is level = (ambient + sum of diffuse * d + specular * s) >> fraction, one 32-bit sum: d and s are UQ1.15, the
 * coefficients have 15 bits, and each of the three parts is at most 2^30 (one light), so the sum stays under 2^32 and is
 * saturated once at the end. With more lights each light's sum is saturated before the next; all parts are positive, so that
 * changes nothing.
 */
#ifndef LMB_LEVELS_H
#define LMB_LEVELS_H

#include "fill.h"

#if defined(__GNUC__)
#define ALWAYS_INLINE inline __attribute__((always_inline))
#define NOINLINE __attribute__((noinline))
/* Keeps a compiler from carrying in registers, of which small cores have too few, what lies ready in memory. */
#if defined(__arm__)
#define FORGET() __asm__ volatile("" ::: "memory")
#else
#define FORGET() ((void)0)
#endif
/* Keeps a compiler from knowing how narrow x is, and so from narrowing what comes of it before it is stored. */
#if defined(__thumb__) && !defined(__thumb2__)
#define HIDE(x) __asm__("" : "+l"(x)) /* in one of the eight registers that all instructions reach */
#else
#define HIDE(x) __asm__("" : "+r"(x))
#endif
/* Keeps a compiler from doing before a test what only one of its branches needs. */
#define HERE() __asm__ volatile("")
/* Has what is not needed for a while wait in memory, where registers are too few for what is. */
#if defined(__thumb__) && !defined(__thumb2__)
#define PUT_BY(x) __asm__("" : "+m"(x))
#else
#define PUT_BY(x) ((void)0)
#endif
#else
#define ALWAYS_INLINE inline
#define NOINLINE
#define FORGET() ((void)0)
#define HIDE(x) ((void)0)
#define HERE() ((void)0)
#define PUT_BY(x) ((void)0)
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

static ALWAYS_INLINE channel channel_of(int format, int i)
{
    channel c;
    c.top = format == LMB_RGB888 ? 255 : i == 1 ? 63 : 31;
    c.fraction = format == LMB_RGB888 ? 22 : i == 1 ? 24 : 25;
    return c;
}
LMB_STATIC_ASSERT(255ull << 22 < 1ull << 30 && 63ull << 24 < 1ull << 30 && 31ull << 25 < 1ull << 30);
LMB_STATIC_ASSERT(3 * (1ull << 30) + (1ull << 24) < 1ull << 32);

static ALWAYS_INLINE uint32_t level(uint32_t sum, channel c)
{
    uint32_t l = sum >> c.fraction;
    return l > c.top ? c.top : l;
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

static ALWAYS_INLINE void saturate(uint32_t sum[3], int format)
{
    int i;
    for (i = 0; i < 3; i++) {
        const channel c = channel_of(format, i);
        const uint32_t most = ((uint32_t)c.top << c.fraction) + ((uint32_t)1 << (c.fraction - 1));
        if (sum[i] > most) sum[i] = most;
    }
}

/* Which of the two formats; a constant where only one is built in. */
static ALWAYS_INLINE bool is_rgb565(const lmb_surface *surface)
{
    return LMB_WITH_RGB565 && (!LMB_WITH_RGB888 || surface->format == LMB_RGB565);
}

/* The pixel in column 0 of a row. */
static ALWAYS_INLINE uint8_t *row_of(const lmb_surface *surface, int32_t y)
{
    return (uint8_t *)surface->pixels + (size_t)lmb_sub(y, surface->window.top) * surface->pitch;
}

/* One light that is reckoned for each pixel: what ramps serve. */
static ALWAYS_INLINE bool lmb_paint_is_simple(const lmb_paint *paint)
{
    return LMB_WITH_PIXELS && lmb_look_lights(&paint->look) == 1 && (!LMB_WITH_CORNERS || paint->look.model >= LMB_MODEL_DIFFUSE);
}

/* Three sums as an RGB565 pixel. */
static ALWAYS_INLINE uint32_t pixel_of_565(const uint32_t sum[3])
{
    return level(sum[0], channel_of(LMB_RGB565, 0)) << 11 | level(sum[1], channel_of(LMB_RGB565, 1)) << 5 |
           level(sum[2], channel_of(LMB_RGB565, 2));
}

/* The carries out of the three fields when RGB565 pixels a and b are added: into bits 5, 11 and 16. */
static ALWAYS_INLINE uint32_t carries_565(uint32_t a, uint32_t b) { return (a ^ b ^ (a + b)) & 0x10820; }

/* The sum of two RGB565 pixels, each field saturated. A field that runs over has added one to the next, which may run over by that
 * alone: fields that are to be full are filled before that one is taken back, so that nothing is borrowed, and again after. */
static ALWAYS_INLINE uint32_t saturated_565(uint32_t a, uint32_t b)
{
    const uint32_t over = carries_565(a, b), full = (over - (over >> 5)) | (over >> 6 & 0x20);
    return (((a + b) | full) - over) | full;
}

/* The same with a test before. Left out where most sums run over, and where registers are few: 38 instructions for 46 there. */
static ALWAYS_INLINE uint32_t add_565(uint32_t a, uint32_t b) { return carries_565(a, b) ? saturated_565(a, b) : a + b; }
#if defined(__thumb__) && !defined(__thumb2__)
#define GLARE_565 saturated_565
#else
#define GLARE_565 add_565
#endif

#endif
