/* SPDX-License-Identifier: MIT */
/* Triangles row by row for the comparisons: exact edges under the top-left rule, by Bresenham with two divisions an edge. */
#ifndef COMPARE_WALK_H
#define COMPARE_WALK_H

#include "compare.h"

#if defined(__GNUC__)
#define COMPARE_INLINE inline __attribute__((always_inline))
#define COMPARE_APART __attribute__((noinline))
#else
#define COMPARE_INLINE inline
#define COMPARE_APART
#endif

/* x is the first pixel of the row whose centre is not left of the edge; gap how far that centre lies behind it, in pixels times
 * modulus. A row down, the edge moves by step pixels and part / modulus of one. */
typedef struct compare_edge {
    int32_t x, step, gap, part, modulus;
} compare_edge;

typedef struct compare_walk {
    compare_edge left, right;
    int32_t y, y_switch, y_end; /* this row, first row below the middle corner, first row below the triangle */
    const lmb_vertex *middle, *bottom;
    bool middle_left;               /* the middle corner is on the left */
    int32_t bx, by, cx, cy, area_2; /* from corner a to b and to c, 1/16 pixel, and (b - a) x (c - a), above zero */
} compare_walk;

/* Sets a triangle up and stands on its first row. False if it is seen from behind or has no row. Corners within 32767 / 16 pixels
 * of one another. */
bool compare_walk_begin(compare_walk *walk, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c);

/* An edge from top down to bottom, on the first row at or below top. top->y < bottom->y. */
void compare_edge_begin(compare_edge *edge, const lmb_vertex *top, const lmb_vertex *bottom);

static COMPARE_INLINE void compare_edge_step(compare_edge *edge)
{
    edge->x += edge->step;
    edge->gap -= edge->part;
    if (edge->gap < 0) {
        edge->gap += edge->modulus;
        edge->x++;
    }
}

/* One row down; false past the last. */
static COMPARE_INLINE bool compare_walk_next(compare_walk *walk)
{
    if (++walk->y >= walk->y_end) return false;
    compare_edge_step(&walk->left);
    compare_edge_step(&walk->right);
    if (walk->y == walk->y_switch) compare_edge_begin(walk->middle_left ? &walk->left : &walk->right, walk->middle, walk->bottom);
    return true;
}

/* Whether all corners lie inside the window, so that no span needs clipping. */
bool compare_inside(const lmb_surface *surface, const lmb_vertex *vertices, unsigned count);

static COMPARE_INLINE uint16_t *compare_pixel(const lmb_surface *surface, int32_t x, int32_t y)
{
    return (uint16_t *)surface->pixels + (y - surface->window.top) * (int32_t)(surface->pitch / 2) + (x - surface->window.left);
}

#endif
