/* SPDX-License-Identifier: MIT */
/* Triangles whose corners are known to lie on the screen. Inside the library only. */
#ifndef LMB_TRIANGLE_H
#define LMB_TRIANGLE_H

#include "lambent.h"

/* lmb_triangle_begin for a triangle whose look and rays are set, and corners within LMB_SCREEN_MAX. */
bool lmb_triangle_seen(lmb_triangle *triangle, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c,
                       const lmb_window *window);

/* The same for one that is known to be seen from the front; triangle->inside says whether it is known to lie in the window, too. */
bool lmb_triangle_front(lmb_triangle *triangle, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c,
                        const lmb_window *window);

#endif
