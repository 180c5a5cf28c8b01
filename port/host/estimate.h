/* SPDX-License-Identifier: MIT */
/* Views as lmb-estimate takes them: with what firmware does beside drawing, and counted. */
#ifndef LMB_HOST_ESTIMATE_H
#define LMB_HOST_ESTIMATE_H

#include "costs.h"
#include "view.h"

typedef struct estimate_view {
    view view;
    int vertices; /* 0: projected once and kept; 1: projected anew for each triangle and strip */
} estimate_view;

/* --vertices and --depth; returns as view_program's option does. */
int estimate_option(void *own, const char *option, const char *value);
#define ESTIMATE_HELP                                                                                                            \
    "  --vertices V          kept: projected once a frame into 16 bytes of RAM each (default), or anew for each strip\n"

/* Counts the frame of a view at a pose. Returns 0, or -1 after one line on the standard error. */
int estimate_count(const estimate_view *e, const lmb_mesh *mesh, cost_counts *counts);

#endif
