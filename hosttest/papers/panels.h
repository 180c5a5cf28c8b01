/* SPDX-License-Identifier: MIT */
/* Panels of points with names: error over cost, both by their logarithms. Where a name goes is searched for, so that names
 * overlap neither each other nor points. */
#ifndef PAPERS_PANELS_H
#define PAPERS_PANELS_H

#include <stdbool.h>
#include <stdio.h>

/* What a point is: something of others, a fixed choice of ours, the same at another tolerance (a small dot on a line of its
 * choice), or what the library takes by itself. */
enum panel_class { PANEL_OTHERS, PANEL_FIXED, PANEL_SWEPT, PANEL_OURS, PANEL_CLASSES };

typedef struct panel_point {
    double x, y;
    enum panel_class kind;
    bool on_front;
    bool in_curve;     /* of ours: lies on the planner's curve */
    const char *label; /* NULL: none */
    unsigned line;     /* swept: points of one line have one number, from 1 on */
} panel_point;

typedef struct panel {
    const char *title, *x_label;     /* x_label: NULL for none */
    double left, top, width, height; /* pixels, from the chart's upper left corner, of which 800 are across */
    bool first, last;                /* in its row: y is named to the left of the first, levels to the right of the last */
    double y_low, y_high;
    panel_point *point;
    unsigned points;
} panel;

/* Writes what gnuplot draws a panel by, in a multiplot; number: of the panel. The chart's script sets height. */
void panel_write(FILE *file, panel *p, unsigned number);

#endif
