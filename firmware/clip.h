/* SPDX-License-Identifier: MIT */
/* Clipping in space against the near plane and the screen's guard band. Inside the library only. */
#ifndef LMB_CLIP_H
#define LMB_CLIP_H

#include "lambent.h"

/* Triangles are cut at LMB_GUARD pixels from the axis; with the axis inside a frame of at most 16384 pixels what is left stays
 * within LMB_SCREEN_MAX. All that reach beyond LMB_GUARD_NEAR are cut, also where that changes nothing: neighbours along an
 * edge must do the same, and the distance to a plane of the guard is known less exactly than pixels are. */
#define LMB_GUARD 16000
#define LMB_GUARD_NEAR 15000

/* A corner in space, and on the screen, if it has been projected; x there is LMB_NOT_ON_SCREEN otherwise. */
typedef struct lmb_corner {
    lmb_point p;
    lmb_vertex screen;
} lmb_corner;

/* Clips polygon[0..2], a triangle in space, and projects what is left into out. Corners that are kept stay where they have been
 * projected, as neighbours that are not clipped have them. Normals are interpolated linearly and normalised at each cut.
 * Uses up polygon; returns the corners of out, 0 or 3 to LMB_CLIP_MAX. */
unsigned lmb_clip(const lmb_camera *camera, lmb_corner polygon[LMB_CLIP_MAX + 1], lmb_vertex out[LMB_CLIP_MAX]);

#endif
