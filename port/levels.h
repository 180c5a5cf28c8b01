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
#define FORGET() __asm__ volatile("" ::: "memory")
#else
#define ALWAYS_INLINE inline
#define NOINLINE
#define FORGET() ((void)0)
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

/* One light that is reckoned for each pixel: what ramps serve. */
static ALWAYS_INLINE bool lmb_paint_is_simple(const lmb_paint *paint)
{
    return lmb_look_lights(&paint->look) == 1 && (!LMB_WITH_CORNERS || paint->look.model >= LMB_MODEL_DIFFUSE);
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
static ALWAYS_INLINE uint32_t add_565(uint32_t a, uint32_t b)
{
    uint32_t sum = a + b, over = carries_565(a, b);
    if (over) {
        const uint32_t full = (over - (over >> 5)) | (over >> 6 & 0x20);
        sum = ((sum | full) - over) | full;
    }
    return sum;
}

#endif
