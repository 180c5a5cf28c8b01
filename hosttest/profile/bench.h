/* SPDX-License-Identifier: MIT */
/* What is shared by the parts of the profiled program. */
#ifndef LMB_PROFILE_BENCH_H
#define LMB_PROFILE_BENCH_H

#include "../../port/demo/scenes.h"
#include "../compare/compare.h"
#include "../compare/steps.h"

#ifndef LMB_PROFILE_SIZE
#define LMB_PROFILE_SIZE 240 /* pixels a side */
#endif
#define LMB_PROFILE_VERTICES 1200u /* most that a mesh here has */
#ifndef LMB_PROFILE_BYTES
#define LMB_PROFILE_BYTES                                                                                                        \
    (240u * 240u * 3u + LMB_PROFILE_VERTICES * sizeof(lmb_vertex)) /* of memory for projected vertices and pixels */
#define LMB_PROFILE_WHOLE 1                                        /* that is enough for whole frames */
#else
#define LMB_PROFILE_WHOLE 0
#endif

/* 0 where the tool chain has neither division nor floats: no comparisons. */
#ifndef LMB_PROFILE_COMPARED
#define LMB_PROFILE_COMPARED 1
#endif

/* 0 where flash does not hold the ways along a span beside everything else: no step_kernels.c. */
#ifndef LMB_PROFILE_STEPS
#define LMB_PROFILE_STEPS LMB_PROFILE_COMPARED
#endif

/* Whether the vertices of a scene have room there. */
#define PROFILE_FITS(mesh) ((mesh)->vertices <= LMB_PROFILE_BYTES / sizeof(lmb_vertex))

/* Names of the one scene and model to draw; empty: all. The scene "kernels" stands for all kernels, its models are their names.
 * From select.c. */
extern const char profile_scene[], profile_model[];

/* Whether a name is the one that is wanted, or all are. */
bool profile_chosen(const char *choice, const char *name);

/* Memory, in turns: of frames and kernels; of vertices with pixels behind them, and of comparisons. */
extern struct profile_work {
    scene scene;
    lmb_paint paint;
    lmb_walk walk;
    lmb_triangle triangle;
    lmb_span span;
} profile_work;
extern union profile_memory {
    lmb_vertex vertices[LMB_PROFILE_BYTES / sizeof(lmb_vertex)];
    uint16_t pixels[LMB_PROFILE_BYTES / 2];
    struct profile_compared {
        compare_look look;
        compare_span span;
        compare_lobe lobe;
        compare_argument arguments[COMPARE_ARGUMENTS];
        int32_t cosines[COMPARE_ARGUMENTS];
#if LMB_PROFILE_STEPS
        compare_step_state state;
        int32_t out[80];
#if COMPARE_WITH_MAP
        compare_step_map map;
#endif
#endif
    } compared;
} profile_memory;

/* Whether a scene is wanted and memory has room for it. */
bool profile_measures(const scene *s, enum lmb_format format);

/* Measures a frame of a scene with the paint of profile_work. */
void profile_frame(const scene *s, const char *name);

/* bench.c, kernels.c, lobe_kernels.c, step_kernels.c, sweep.c; true if anything was measured. */
bool profile_frames(void);
bool profile_kernels(void);
bool profile_lobe_kernels(void);
bool profile_step_kernels(void);
bool profile_sweep(void);

/* These five, NULL what this image does not hold. From select.c. */
#define PROFILE_FRAMES 0
#define PROFILE_SWEEP 4
#define PROFILE_PARTS 5
extern bool (*const profile_part[PROFILE_PARTS])(void);

#endif
