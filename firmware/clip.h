/* SPDX-License-Identifier: MIT */
/* Clipping in space against the near plane and the screen's guard band. Inside the library only. */
#ifndef LMB_CLIP_H
#define LMB_CLIP_H

#include "lambent.h"

/* A corner in space. */
typedef struct lmb_corner {
    lmb_point p;
    lmb_vec normal;
} lmb_corner;

/* Clips polygon[0..2], a triangle in space, and projects what is left into out. Returns its corners, 0 or 3 to LMB_CLIP_MAX. */
unsigned lmb_clip(const lmb_camera *camera, const lmb_corner triangle[3], lmb_vertex out[LMB_CLIP_MAX]);

#endif
