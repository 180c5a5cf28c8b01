/* SPDX-License-Identifier: MIT */
/* The sides of triangles, row by row: strides where no window cuts, remainders elsewhere. Inside the filler only. */
#ifndef LMB_SIDES_H
#define LMB_SIDES_H

#include "levels.h"

#include "../firmware/stride.h"

/* Whether triangles that no window cuts take strides. On AVR a shift by their bits is a loop, and on cores without a multiplier so are
 * the products that set them up. */
#if LMB_LOOPS && !defined(__AVR__) && (!defined(__riscv) || defined(__riscv_mul))
#define STRIDES 1
#else
#define STRIDES 0
#endif

/* Whether strides serve a triangle inside of its window. */
static inline bool is_small(const lmb_triangle *t)
{
    return !STRIDES || (lmb_sub(t->window_right, t->window_left) < LMB_STRIDE_MAX / 16 &&
                        lmb_sub(t->corner[2]->y, t->corner[0]->y) < LMB_STRIDE_MAX);
}

/* Both sides of the next row, x to end - 1, cut by the window where it may cut; and one row down. */
static ALWAYS_INLINE void sides_next(lmb_triangle *t, lmb_stride stride[2], int32_t *x, int32_t *end, bool strides, bool cut)
{
    if (strides) {
        *x = lmb_stride_step(&stride[0]);
        *end = lmb_stride_step(&stride[1]);
        return;
    }
    *x = t->walk.edge[0].x;
    *end = t->walk.edge[1].x;
    if (cut) {
        *x = lmb_max(*x, t->window_left);
        *end = lmb_min(*end, t->window_right);
    }
    lmb_edge_step(&t->walk.edge[0]);
    lmb_edge_step(&t->walk.edge[1]);
}

/* The sides of the next rows: the row where these end. */
static ALWAYS_INLINE int32_t sides_begin(lmb_triangle *t, bool strides)
{
    if (strides) {
        if (t->walked != LMB_WALKED_STRIDES) lmb_strides_begin(t);
        return t->y_turn;
    }
    if (t->walked != LMB_WALKED_EDGES) lmb_triangle_walk(t);
    return t->y < t->y_switch ? lmb_min(t->y_switch, t->y_end) : t->y_end;
}

static ALWAYS_INLINE int32_t sides_turn(lmb_triangle *t, bool strides)
{
    if (strides) {
        lmb_strides_turn(t);
        return t->y_turn;
    }
    lmb_triangle_turn(t);
    return t->y_end;
}

#endif
