/* SPDX-License-Identifier: MIT */
/* From a mesh's own space straight to the screen: pose and camera in one matrix. Inside the library only. */
#ifndef LMB_SCREEN_H
#define LMB_SCREEN_H

#include "lambent.h"

/* x of a corner that is nearer than the near plane, or far off the screen: it has no place there, but a normal. */
#define LMB_NOT_ON_SCREEN INT32_MIN

/* Prepares the way of screen->mesh to the screen; mesh, pose and camera are set and stay valid. */
void lmb_screen_begin(lmb_screen *screen);

/* Corners of the vertices index[0 .. count - 1] of the mesh, or, without index, of its first count. What a vertex comes to depends on
 * nothing else. */
void lmb_screen_project(const lmb_screen *screen, const LMB_FLASH uint16_t *index, uint32_t count, lmb_vertex *corners);

/* Whether lmb_screen_y knows a corner's row without the rest of it. */
static inline bool lmb_screen_direct(const lmb_screen *screen)
{
#if LMB_SCREEN_EXACT
    return screen->direct;
#else
    return screen->mesh != NULL;
#endif
}

/* Then: y of the corner of vertex i. */
int32_t lmb_screen_y(const lmb_screen *screen, uint32_t i);

#endif
