/* SPDX-License-Identifier: MIT */
/* What a frame costs: classes of work, how often each occurs in a frame, and what a core takes for each.
 *
 * The library itself draws the frame on the host; what it does is counted on the way (count.c, count_calls.c) and multiplied by what each
 * costs on a core (costs_table.h, fitted to the profiler's frames by hosttest/estimate/fit.c). Cores draw the same bits by the
 * same decisions, so counts are exact, and all that a cost stands for is a mean over one class.
 *
 * Work is in six stages, which the profiler tells apart by the functions that they begin with; each stage has classes of its own.
 */
#ifndef LMB_HOST_COSTS_H
#define LMB_HOST_COSTS_H

#include "../fill.h"

enum cost_stage {
    COST_PROJECT, /* lmb_mesh_project */
    COST_SORT,    /* lmb_mesh_sort */
    COST_BEGIN,   /* lmb_mesh_begin, and what the caller does for each strip */
    COST_WALK,    /* lmb_draw_mesh but for the others: triangles told apart, corners sorted, planes of depth */
    COST_SHADE,   /* lmb_shade_begin: planes of light */
    COST_FILL,    /* lmb_fill_triangle: edges, rows, spans, pixels */
    COST_STAGES
};

/* What users know of a scene; shares are given by these. */
enum cost_part { PART_FRAME, PART_VERTEX, PART_TRIANGLE, PART_SPAN, PART_PIXEL, COST_PARTS };

/* Loops over rows or spans, and what is counted of each: see costs.def. */
enum cost_loop {
#define COST(name, stage, part, text)
#define COST_LOOP(name, text) LOOP_##name,
#include "costs.def"
#undef COST
#undef COST_LOOP
    COST_LOOPS
};
enum cost_of_loop { LOOP_triangle, LOOP_row, LOOP_run, LOOP_pixel, LOOP_gleam, LOOP_more, LOOP_hidden, COST_OF_LOOP };

enum cost_class {
#define COST(name, stage, part, text) COST_##name,
#define COST_LOOP(name, text)
#include "costs.def"
#undef COST
#undef COST_LOOP
    COST_OTHERS, /* from here on loops */
    COST_CLASSES = COST_OTHERS + COST_LOOPS * COST_OF_LOOP
};
#define COST_OF(loop, what) (COST_OTHERS + LOOP_##loop * COST_OF_LOOP + LOOP_##what)
static inline int cost_of(enum cost_loop loop, enum cost_of_loop what)
{
    return COST_OTHERS + (int)loop * COST_OF_LOOP + (int)what;
}

/* What a class is: name and unit are words of at most 40 characters. */
typedef struct cost_kind {
    char name[40];
    const char *text;
    enum cost_stage stage;
    enum cost_part part;
} cost_kind;
cost_kind cost_kind_of(int class);
extern const char *const cost_stage_names[COST_STAGES], *const cost_part_names[COST_PARTS];

/* How often each class occurs in a frame, and what users ask about. */
typedef struct cost_counts {
    double of[COST_CLASSES];
    uint32_t drawn; /* triangles that lmb_draw_mesh returns, strips added up */
    uint32_t spans, pixels;
    lmb_statistics chosen; /* for terms of triangles, each triangle once */
} cost_counts;

/* A frame to draw: as firmware does it. */
typedef struct cost_frame {
    const lmb_mesh *mesh;
    const lmb_pose *pose;
    const lmb_camera *camera;
    const lmb_paint *paint;
    int width, height, rows; /* rows of a strip */
    bool anew;               /* vertices have no room: projected for each triangle anew */
    bool depth, painter;
} cost_frame;

/* Draws a frame into memory of its own and counts. Returns 0, or -1 without memory or with too many triangles to sort. */
int cost_count(cost_counts *counts, const cost_frame *frame);

/* A core's costs, cycles (or instructions, where no manual gives cycles) for each class. */
typedef struct cost_core {
    const char *name, *title, *unit;
    int column;         /* of the table of costs */
    double clear[2][2]; /* lmb_clear: a pixel of RGB565, RGB888; without and with depth */
} cost_core;
extern const cost_core cost_cores[];
extern const unsigned cost_core_count;

/* What one of a class takes on a core. */
double cost_each(const cost_core *core, int class);

/* Adds up a frame: cycles of each part, and all of it. */
double cost_sum(const cost_core *core, const cost_counts *counts, double parts[COST_PARTS]);

#endif
