/* SPDX-License-Identifier: MIT */
/* A BMP file as the host's display: a surface's pixels, 24 bits deep. */
#ifndef LMB_BMP_H
#define LMB_BMP_H

#include "../fill.h"

/* A pixel of a surface as 8-bit r, g, b; RGB565 levels are widened to 255, rounded. Coordinates count from the window's corner.
 * */
lmb_rgb bmp_pixel(const lmb_surface *surface, int x, int y);

/* Writes a surface as a BMP file; "-" is standard output. Returns 0, or -1 with errno set; a file half written is removed. */
int bmp_write(const char *path, const lmb_surface *surface);

#endif
