/* SPDX-License-Identifier: MIT */
/* Integer values linear over triangles: set up by one division a triangle, two additions and a product a row.
 *
 * A value is given at the corners with 16 fraction bits to come and runs in 32 bits, modulo 2^32: slopes of slivers wrap, and
 * what they are multiplied by brings them back, since inside the triangle the true value fits. */
#ifndef COMPARE_PLANES_H
#define COMPARE_PLANES_H

#include "walk.h"

/* 2^31 / area_2 = inverse * 2^(-shift), inverse in (2^15, 2^16] */
typedef struct compare_inverse {
    uint32_t inverse;
    int shift;
} compare_inverse;

static COMPARE_INLINE compare_inverse compare_invert(int32_t area_2)
{
    compare_inverse by;
    by.shift = 16 - (int)lmb_clz32((uint32_t)area_2);
    by.inverse = 0x80000000u / (by.shift > 0 ? (uint32_t)area_2 >> by.shift : (uint32_t)area_2 << -by.shift);
    return by;
}

/* numerator 2^16 / area_2, modulo 2^32. |numerator| < 2^30. */
static COMPARE_INLINE uint32_t compare_quotient(int32_t numerator, const compare_inverse *by)
{
    int32_t q = (numerator >> 16) * (int32_t)by->inverse + (int32_t)((((uint32_t)numerator & 0xffffu) * by->inverse) >> 16);
    return by->shift > 0 ? (uint32_t)(q >> (by->shift - 1)) : (uint32_t)q << (1 - by->shift);
}

/* The steps of a value along x (a pixel) and y (a row), and the value at the centre of pixel (x, y). */
typedef struct compare_plane {
    uint32_t value, dx, dy;
} compare_plane;

/* px, py: of that centre from corner a, 1/16 pixel; a, b, c: the value at the corners, Q1.15 or smaller */
static COMPARE_INLINE void compare_plane_begin(compare_plane *plane, const compare_walk *walk, const compare_inverse *by,
                                               int32_t px, int32_t py, int32_t a, int32_t b, int32_t c)
{
    uint32_t dx = compare_quotient((c - a) * walk->by - (b - a) * walk->cy, by);
    uint32_t dy = compare_quotient((b - a) * walk->cx - (c - a) * walk->bx, by);
    plane->value = ((uint32_t)a << 16) + dx * (uint32_t)px + dy * (uint32_t)py;
    plane->dx = dx << 4;
    plane->dy = dy << 4;
}

/* Down a row: the value at its first pixel, moved pixels right of the last row's. */
static COMPARE_INLINE void compare_plane_row(compare_plane *plane, int32_t *value, int32_t moved)
{
    plane->value += plane->dx * (uint32_t)moved;
    *value = lmb_signed(plane->value);
    plane->value += plane->dy;
}

/* All rows of a triangle: see compare_draw_planes. */
static COMPARE_INLINE uint32_t compare_rows(const lmb_surface *surface, compare_walk *walk, compare_plane plane[3],
                                            compare_span *span, int count,
                                            void (*fill)(const compare_span *, uint16_t *, unsigned))
{
    uint16_t *row = compare_pixel(surface, 0, walk->y);
    const size_t pitch = surface->pitch / 2;
    int32_t x = walk->left.x;
    uint32_t pixels = 0;
    do {
        int32_t moved = walk->left.x - x, length = walk->right.x - walk->left.x;
        x = walk->left.x;
        compare_plane_row(&plane[0], &span->value[0], moved);
        compare_plane_row(&plane[1], &span->value[1], moved);
        if (count > 2) compare_plane_row(&plane[2], &span->value[2], moved);
        if (length > 0) {
            fill(span, row + x, (unsigned)length);
            pixels += (uint32_t)length;
        }
        row += pitch;
    } while (compare_walk_next(walk));
    return pixels;
}

/* A whole mesh whose pixels are made of count values, two or three, from room[].q; fill paints a span and is inlined. span
 * holds what fill wants beside value and step. */
static COMPARE_INLINE uint32_t compare_draw_planes(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_vertex *vertices,
                                                   const compare_room *room, compare_span *span, int count,
                                                   void (*fill)(const compare_span *, uint16_t *, unsigned))
{
    const LMB_FLASH uint16_t *index = mesh->indices, *end = index + (size_t)3 * mesh->triangles;
    uint32_t pixels = 0;
    for (; index != end; index += 3) {
        const lmb_vertex *a = &vertices[index[0]];
        const int32_t *qa = room[index[0]].q, *qb = room[index[1]].q, *qc = room[index[2]].q;
        compare_plane plane[3];
        compare_inverse by;
        compare_walk walk;
        int k;
        if (!compare_walk_begin(&walk, a, &vertices[index[1]], &vertices[index[2]])) continue;
        by = compare_invert(walk.area_2);
        for (k = 0; k < count; k++) {
            compare_plane_begin(&plane[k], &walk, &by, 16 * walk.left.x + 8 - a->x, 16 * walk.y + 8 - a->y, qa[k], qb[k], qc[k]);
            span->step[k] = lmb_signed(plane[k].dx);
        }
        pixels += compare_rows(surface, &walk, plane, span, count, fill);
    }
    return pixels;
}

#endif
