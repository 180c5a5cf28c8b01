/* SPDX-License-Identifier: MIT */
/* Which scene and model to profile, and which parts are in the image: built anew for each choice. */
#include "bench.h"

#ifndef SELECT_SCENE
#define SELECT_SCENE ""
#endif
#ifndef SELECT_MODEL
#define SELECT_MODEL ""
#endif
/* 1: frames, 2: kernels, 4: lobes, 8: ways along a span, 16: frames of every fixed choice and tolerance. */
#ifndef SELECT_PARTS
#define SELECT_PARTS 15
#endif

bool (*const profile_part[PROFILE_PARTS])(void) = {
#if SELECT_PARTS & 1
    profile_frames,
#else
    NULL,
#endif
#if SELECT_PARTS & 2
    profile_kernels,
#else
    NULL,
#endif
#if SELECT_PARTS & 4 && LMB_PROFILE_COMPARED
    profile_lobe_kernels,
#else
    NULL,
#endif
#if SELECT_PARTS & 8 && LMB_PROFILE_STEPS
    profile_step_kernels,
#else
    NULL,
#endif
#if SELECT_PARTS & 16
    profile_sweep,
#else
    NULL,
#endif
};

const char profile_scene[] = SELECT_SCENE, profile_model[] = SELECT_MODEL;
