/* SPDX-License-Identifier: MIT */
/* Where the names of points go: beside them where there is room, else a little way off with a line to the point. */
#ifndef PAPERS_PANEL_NAMES_H
#define PAPERS_PANEL_NAMES_H

#include <stdbool.h>

#define PANEL_NAMES_MAX 200

typedef struct panel_name {
    double x, y;             /* of the point: pixels from the panel's upper left corner */
    const char *text;        /* NULL: a point without a name, to be kept clear of */
    bool is_small;           /* a dot that a name may touch if it must */
    double label_x, label_y; /* set: the middle of the name */
    bool has_leader;         /* set: there is a line, which ends at: */
    double leader_x, leader_y;
} panel_name;

void panel_names_place(panel_name *name, unsigned count, double width, double height);

#endif
