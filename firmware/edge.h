/* SPDX-License-Identifier: MIT */
/* Triangle edges, walked row by row without error. Inside the library only. */
#ifndef LMB_EDGE_H
#define LMB_EDGE_H

#include "lambent.h"

/* The first row whose pixel centres lie at y or below, y in Q28.4. */
static inline int32_t lmb_row_at(int32_t y) { return lmb_shr(lmb_add(y, 7), 4); }

/* Sets an edge from top down to bottom, top->y < bottom->y, and places it on row, lmb_row_at(top->y) <= row <
 * lmb_row_at(bottom->y). */
void lmb_edge_begin(lmb_edge *edge, const lmb_vertex *top, const lmb_vertex *bottom, int32_t row);

#endif
