/* SPDX-License-Identifier: MIT */
/* Cameras: points in space onto the screen, 1/w by table and multiplication. */
#include "lambent.h"

#define NEAR_MIN 256 /* 1/256 unit: keeps near / w to 16 bits */

/* What both kinds share; near and far must fit, and their distance too. */
static int camera_begin(lmb_camera *camera, int width, int height, int32_t focal_q16, int32_t near_q16, int32_t far_q16)
{
    if (width < 1 || height < 1 || width > 32767 || height > 32767 || focal_q16 < 1 || near_q16 >= far_q16) return LMB_ERROR_VALUE;
    if (near_q16 < 0 && far_q16 > INT32_MAX + near_q16) return LMB_ERROR_VALUE;
    camera->focal_q16 = focal_q16;
    camera->near_q16 = near_q16;
    camera->far_q16 = far_q16;
    camera->x = lmb_mul(width, 8);
    camera->y = lmb_mul(height, 8);
    return LMB_OK;
}

int lmb_camera_orthographic(lmb_camera *camera, int width, int height, int32_t focal_q16, int32_t near_q16, int32_t far_q16)
{
    unsigned shift;
    int error = camera_begin(camera, width, height, focal_q16, near_q16, far_q16);
    if (error) return error;
    camera->perspective = false;
    /* depth = (w - near) / (far - near): gain / 2^(30 + shift) */
    camera->depth_gain = lmb_reciprocal((uint32_t)lmb_sub(far_q16, near_q16), &shift) >> 1;
    camera->depth_shift = (uint8_t)shift;
    return LMB_OK;
}

int lmb_camera_perspective(lmb_camera *camera, int width, int height, int32_t focal_q16, int32_t near_q16, int32_t far_q16)
{
    unsigned shift;
    uint32_t reciprocal;
    int error = !LMB_WITH_PERSPECTIVE || near_q16 < NEAR_MIN ? LMB_ERROR_VALUE : camera_begin(camera, width, height, focal_q16, near_q16, far_q16);
    if (error) return error;
    camera->perspective = true;
    /* depth = far / (far - near) * (1 - near / w): gain / 2^16, saturated where far hardly exceeds near */
    reciprocal = lmb_reciprocal((uint32_t)lmb_sub(far_q16, near_q16), &shift);
    camera->depth_gain = (uint32_t)lmb_mul_shr_sat(far_q16, (int32_t)(reciprocal >> 1), 14 + shift);
    camera->depth_shift = 16;
    return LMB_OK;
}

static uint16_t saturate_depth(int32_t depth) { return (uint16_t)lmb_max(0, lmb_min(depth, 65535)); }

/* center + value * focal, both Q16.16, to Q28.4, rounded; saturates. */
static int32_t to_screen(int32_t center, int32_t value, int32_t focal, unsigned shift)
{
    int32_t twice = lmb_mul_shr_sat(value, focal, shift - 1);
    return lmb_add(center, lmb_shr(lmb_add(lmb_max(lmb_min(twice, 1 << 24), -(1 << 24)), 1), 1));
}

bool lmb_project(const lmb_camera *camera, lmb_point p, lmb_vertex *vertex)
{
    int32_t x, y, w = lmb_sub(0, p.z);
    if (w < camera->near_q16) return false;
    if (LMB_WITH_PERSPECTIVE && camera->perspective) {
        /* w * reciprocal = 2^(31 + shift): x / w = x * reciprocal / 2^31 in 1 / 2^shift; near / w <= 1 alike */
        unsigned shift;
        int32_t reciprocal = (int32_t)(lmb_reciprocal((uint32_t)w, &shift) >> 1);
        int32_t over_x = lmb_mul_shr_sat(p.x, reciprocal, 30), over_y = lmb_mul_shr_sat(p.y, reciprocal, 30);
        int32_t near_w_q16 = lmb_min(65536, lmb_mul_shr(camera->near_q16, reciprocal, 14 + shift));
        x = to_screen(camera->x, over_x, camera->focal_q16, shift + 12);
        y = to_screen(camera->y, lmb_sub(0, over_y), camera->focal_q16, shift + 12);
        vertex->depth = saturate_depth(lmb_mul_shr_sat(65536 - near_w_q16, (int32_t)camera->depth_gain, 16));
    } else {
        x = to_screen(camera->x, p.x, camera->focal_q16, 28);
        y = to_screen(camera->y, lmb_sub(0, p.y), camera->focal_q16, 28);
        vertex->depth = saturate_depth(
            lmb_mul_shr_sat(lmb_sub(w, camera->near_q16), (int32_t)camera->depth_gain, 14u + camera->depth_shift));
    }
    if (x < -LMB_SCREEN_MAX || x > LMB_SCREEN_MAX || y < -LMB_SCREEN_MAX || y > LMB_SCREEN_MAX) return false;
    vertex->x = x;
    vertex->y = y;
    return true;
}
