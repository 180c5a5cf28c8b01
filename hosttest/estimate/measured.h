/* SPDX-License-Identifier: MIT */
/* What the profiler has measured of a list of frames, as report stages prints it. */
#ifndef ESTIMATE_MEASURED_H
#define ESTIMATE_MEASURED_H

#include "list.h"

typedef struct measured {
    double drawn, instructions, all, stages[COST_STAGES]; /* all: cycles, or instructions where these are not known */
} measured;

typedef struct measurements {
    char core[32];
    bool cycles;      /* known */
    measured *frames; /* one for each case of the list */
    double clear[2][2];
} measurements;

/* Reads build/estimate/LIST-CORE.csv. Ends the program with one line if it is not that of the list. */
void measured_read(measurements *m, const char *path, unsigned cases);

/* Counts each case of a list, with progress on the standard error. Ends the program on errors. */
cost_counts *list_count(const list *l);

/* Ends the program unless each frame drew as many triangles on the core as on the host. */
void measured_check(const measurements *m, const list *l, const cost_counts *counts);

#endif
