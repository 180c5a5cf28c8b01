/* SPDX-License-Identifier: MIT */
/* Random triangles in random windows, by classes that rasters fail at; shared by the tests of coverage and of terms. */
#ifndef LMB_TEST_SHAPES_H
#define LMB_TEST_SHAPES_H

#include "../firmware/lambent.h"
#include "test.h"

#define SIDE 64 /* largest window of these tests */
#define PX 16   /* screen units in a pixel */

typedef struct shape {
    lmb_vertex v[3];
    lmb_window window;
} shape;

typedef struct shape_class {
    const char *name;
    void (*make)(test_random *random, shape *s);
    int count; /* triangles that the coverage test takes */
} shape_class;

enum {
    SHAPE_ORDINARY,
    SHAPE_TINY,
    SHAPE_SLIVER,
    SHAPE_DEGENERATE,
    SHAPE_ALIGNED,
    SHAPE_FAR,
    SHAPE_BEYOND,
    SHAPE_HUGE,
    SHAPE_CLASSES
};
extern const shape_class shape_classes[SHAPE_CLASSES];

static inline int width_of(const lmb_window *w) { return w->right - w->left; }
static inline int height_of(const lmb_window *w) { return w->bottom - w->top; }
static inline double larger(double a, double b) { return a > b ? a : b; }

/* A unit vector in a direction, and in a random one. */
lmb_vec unit(double x, double y, double z);
lmb_vec random_unit(test_random *random);

/* A window of 1 to SIDE pixels each way, most of them in the frame. */
lmb_window random_window(test_random *random);

/* A coordinate in or around a window; and a corner at a position, held on the screen. */
int32_t near_window(test_random *random, int low, int high);
void place(lmb_vertex *v, int64_t x, int64_t y);

/* Above zero if (px, py) lies to the right of the way from a to b, y down; twice an area. */
int64_t side_of(const lmb_vertex *a, const lmb_vertex *b, int64_t px, int64_t py);

/* Clockwise as seen with y down: what lambent.h calls counter-clockwise, y up. */
int is_front(const lmb_vertex v[3]);

void shape_print(const shape *s);
void swap_corners(shape *s, int i, int j);

#endif
