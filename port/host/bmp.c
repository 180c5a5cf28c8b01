/* SPDX-License-Identifier: MIT */
/* A BMP file as the host's display: a surface's pixels, 24 bits deep. */
#include "bmp.h"

#include <stdio.h>
#include <string.h>

#define HEAD 54

lmb_rgb bmp_pixel(const lmb_surface *surface, int x, int y)
{
    const uint8_t *p = (const uint8_t *)surface->pixels + (size_t)y * surface->pitch +
                       (size_t)x * lmb_format_bytes((enum lmb_format)surface->format);
    lmb_rgb c;
    if (surface->format == LMB_RGB888) {
        c.r = p[0];
        c.g = p[1];
        c.b = p[2];
    } else {
        unsigned v = (unsigned)(p[0] | p[1] << 8);
        c.r = (uint8_t)(((v >> 11) * 255 + 15) / 31);
        c.g = (uint8_t)(((v >> 5 & 63u) * 255 + 31) / 63);
        c.b = (uint8_t)(((v & 31u) * 255 + 15) / 31);
    }
    return c;
}

static void put_word(uint8_t *at, unsigned bytes, unsigned long value)
{
    for (; bytes > 0; bytes--, value >>= 8) *at++ = (uint8_t)(value & 255u);
}

static int write_rows(FILE *file, const lmb_surface *surface, int width, int height, size_t padding)
{
    static const uint8_t zero[4] = {0, 0, 0, 0};
    int x, y;
    for (y = height - 1; y >= 0; y--) { /* BMP stands on its head */
        for (x = 0; x < width; x++) {
            lmb_rgb c = bmp_pixel(surface, x, y);
            uint8_t bgr[3];
            bgr[0] = c.b;
            bgr[1] = c.g;
            bgr[2] = c.r;
            if (fwrite(bgr, 3, 1, file) != 1) return -1;
        }
        if (padding && fwrite(zero, padding, 1, file) != 1) return -1;
    }
    return fflush(file) ? -1 : 0;
}

int bmp_write(const char *path, const lmb_surface *surface)
{
    int width = surface->window.right - surface->window.left, height = surface->window.bottom - surface->window.top, result;
    size_t padding = (size_t)(-3 * width) & 3u;
    unsigned long bytes = ((unsigned long)width * 3 + padding) * (unsigned long)height;
    uint8_t head[HEAD] = {'B', 'M'};
    FILE *file = strcmp(path, "-") ? fopen(path, "wb") : stdout;
    if (!file) return -1;
    put_word(head + 2, 4, bytes + HEAD);
    put_word(head + 10, 4, HEAD);
    put_word(head + 14, 4, 40); /* BITMAPINFOHEADER */
    put_word(head + 18, 4, (unsigned long)width);
    put_word(head + 22, 4, (unsigned long)height);
    put_word(head + 26, 2, 1);
    put_word(head + 28, 2, 24);
    put_word(head + 34, 4, bytes);
    result = fwrite(head, HEAD, 1, file) == 1 ? write_rows(file, surface, width, height, padding) : -1;
    if (file != stdout) {
        if (fclose(file)) result = -1;
        if (result) remove(path);
    }
    return result;
}
