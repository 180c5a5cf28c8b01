/* SPDX-License-Identifier: MIT */
/* Which scene and model to profile: built anew for each choice. */
#include "bench.h"

#ifndef SELECT_SCENE
#define SELECT_SCENE ""
#endif
#ifndef SELECT_MODEL
#define SELECT_MODEL ""
#endif

const char profile_scene[] = SELECT_SCENE, profile_model[] = SELECT_MODEL;
