/* SPDX-License-Identifier: MIT */
/* Surfaces in guarded memory, for the tests of the filler: memory is larger than the surface and holds a pattern; what is not the
 * surface's must keep it. */
#ifndef LMB_TEST_GUARDED_H
#define LMB_TEST_GUARDED_H

#include <string.h>

#include "../port/fill.h"
#include "test.h"

#define GUARD 0xa5
#define MEMORY 40000

/* Half words, so that RGB565 is aligned; looked at as bytes. */
typedef struct memory {
    uint16_t pixels[MEMORY / 2], depth[MEMORY / 2];
    lmb_surface surface;
    size_t pixels_at, depth_at; /* where the surface begins, in half words */
} memory;

static inline lmb_window window_of(int left, int top, int right, int bottom)
{
    lmb_window w = {(int16_t)left, (int16_t)top, (int16_t)right, (int16_t)bottom, false};
    return w;
}

static inline lmb_rgb rgb(int64_t r, int64_t g, int64_t b)
{
    lmb_rgb c = {(uint8_t)r, (uint8_t)g, (uint8_t)b};
    return c;
}

static inline lmb_rgb random_colour(test_random *random)
{
    return rgb(test_integer(random, 0, 255), test_integer(random, 0, 255), test_integer(random, 0, 255));
}

static inline const char *format_name(int format) { return format == LMB_RGB565 ? "RGB565" : "RGB888"; }

/* The greatest level of channel i. */
static inline int top_of(int format, int i) { return format == LMB_RGB888 ? 255 : i == 1 ? 63 : 31; }

static inline void memory_surface(memory *m, int format, lmb_window w, size_t spare, bool depth)
{
    size_t width = (size_t)(w.right - w.left);
    memset(m, 0, sizeof *m);
    memset(m->pixels, GUARD, sizeof m->pixels);
    memset(m->depth, GUARD, sizeof m->depth);
    m->pixels_at = m->depth_at = 64;
    m->surface.pixels = m->pixels + m->pixels_at;
    m->surface.depth = depth ? m->depth + m->depth_at : NULL;
    m->surface.pitch = width * lmb_format_bytes((enum lmb_format)format) + spare * 2;
    m->surface.format = (uint8_t)format;
    m->surface.window = w;
    m->surface.window.depth = depth;
}

/* Bytes outside the surface that have changed. */
static inline int memory_spilt(const memory *m)
{
    const lmb_surface *s = &m->surface;
    const uint8_t *bytes = (const uint8_t *)m->pixels;
    size_t width = (size_t)(s->window.right - s->window.left), height = (size_t)(s->window.bottom - s->window.top), i;
    size_t row = width * lmb_format_bytes((enum lmb_format)s->format);
    int spilt = 0;
    for (i = 0; i < sizeof m->pixels; i++) {
        size_t at = i - 2 * m->pixels_at; /* wraps before the surface, and is then beyond its end */
        if (at >= s->pitch * height || at % s->pitch >= row) spilt += bytes[i] != GUARD;
    }
    for (i = 0; i < MEMORY / 2; i++) {
        size_t at = i - m->depth_at;
        if (!s->depth || at >= width * height) spilt += m->depth[i] != GUARD * 257;
    }
    return spilt;
}

static inline const uint8_t *pixel_of(const lmb_surface *s, int x, int y)
{
    return (const uint8_t *)s->pixels + (size_t)(y - s->window.top) * s->pitch +
           (size_t)(x - s->window.left) * lmb_format_bytes((enum lmb_format)s->format);
}

/* A pixel's levels. */
static inline void levels_at(const uint8_t *p, int format, int level[3])
{
    if (format == LMB_RGB888) {
        level[0] = p[0], level[1] = p[1], level[2] = p[2];
    } else {
        int word = p[0] | p[1] << 8;
        level[0] = word >> 11, level[1] = word >> 5 & 63, level[2] = word & 31;
    }
}

#endif
