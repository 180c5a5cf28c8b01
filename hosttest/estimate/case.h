/* SPDX-License-Identifier: MIT */
/* A frame to measure on a target, in numbers alone: what estimate_cases writes and draw.c draws. */
#ifndef ESTIMATE_CASE_H
#define ESTIMATE_CASE_H

#include "../../port/fill.h"

typedef struct estimate_case {
    const lmb_mesh *mesh;
    int32_t focal_q16, near_q16, far_q16, z_q16;
    uint16_t turn[3];
    int16_t width, height, rows;
    uint8_t perspective, format, model, step, lobe, depth, painter, anew, lights;
    lmb_material material;
    lmb_light light[LMB_LIGHTS];
} estimate_case;

#endif
