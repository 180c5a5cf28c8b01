/* SPDX-License-Identifier: MIT */
/* The depth test, by runs: pixels that are seen and stand side by side are shaded by the loops that know nothing of depth. Inside the
 * filler only.
 *
 * So any loop serves surfaces with depth, and nothing that is hidden is shaded; it takes 14 cycles a pixel on Cortex-M0+. Short rows
 * with a highlight have depth in their own loop (rows.c).
 */
#ifndef LMB_DEPTH_H
#define LMB_DEPTH_H

#include "levels.h"

/* Pixels of a row that are still to be tested. Depth is linear: triangles have no curve in it. */
typedef struct depth_row {
    uint16_t *stored, *end; /* of the next pixel, behind the last */
    uint16_t *seen;         /* of the run that was found: from here to stored */
    int32_t f, d;           /* of the next pixel, as a term has them */
} depth_row;

/* Finds the next run of pixels that are nearer than what is there, and stores their depth. The run is empty if all that is left is
 * hidden. A triangle's corners keep clear of both ends of 16 bits, but the plane of a thin one may pass below zero. */
static ALWAYS_INLINE void depth_run(depth_row *row)
{
    uint16_t *at = row->stored, *const end = row->end;
    const int32_t d = row->d;
    int32_t f = row->f;
    while (at != end && f >> 14 >= *at) {
        f = lmb_add_wrap(f, d);
        at++;
    }
    row->seen = at;
    while (at != end) {
        const int32_t now = f >> 14;
        if (now >= *at) break;
        *at++ = (uint16_t)(now & ~(now >> 31));
        f = lmb_add_wrap(f, d);
    }
    row->stored = at;
    row->f = f;
}

/* The same out of line. */
void lmb_depth_run(depth_row *row);

#endif
