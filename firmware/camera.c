/* SPDX-License-Identifier: MIT */
/* Cameras: points in space onto the screen, 1/w by table and multiplication. */
#include "lambent.h"

#define NEAR_MIN 256 /* 1/256 unit: keeps near / w to 16 bits */

/* What both kinds share; near and far must fit, and their distance too. */
static int camera_begin(lmb_camera *camera, int width, int height, int32_t focal_q16, int32_t near_q16, int32_t far_q16)
{
    if (width < 1 || height < 1 || width > 32767 || height > 32767 || focal_q16 < 1 || near_q16 >= far_q16)
        return LMB_ERROR_VALUE;
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
    camera->perspective = false;
    if (error || !LMB_WITH_DEPTH) return error;
    /* depth = (w - near) / (far - near): gain / 2^(30 + shift) */
    camera->depth_gain = lmb_reciprocal((uint32_t)lmb_sub(far_q16, near_q16), &shift) >> 1;
    camera->depth_shift = (uint8_t)shift;
    return LMB_OK;
}

int lmb_camera_perspective(lmb_camera *camera, int width, int height, int32_t focal_q16, int32_t near_q16, int32_t far_q16)
{
    unsigned shift;
    uint32_t reciprocal;
    int error = !LMB_WITH_PERSPECTIVE || near_q16 < NEAR_MIN ? LMB_ERROR_VALUE
                                                             : camera_begin(camera, width, height, focal_q16, near_q16, far_q16);
    if (error) return error;
    camera->perspective = true;
    /* depth = far / (far - near) * (1 - near / w): gain / 2^16, saturated where far hardly exceeds near */
    reciprocal = lmb_reciprocal((uint32_t)lmb_sub(far_q16, near_q16), &shift);
    camera->depth_gain = (uint32_t)lmb_mul_shr_sat(far_q16, (int32_t)(reciprocal >> 1), 14 + shift);
    camera->depth_shift = 16;
    return LMB_OK;
}

/* centre + value * focal / 2^shift in Q28.4, rounded; far off screen some value beyond LMB_SCREEN_MAX, as twice saturates. */
static int32_t to_screen(int32_t centre, int32_t value, int32_t focal, unsigned shift)
{
    int32_t twice = lmb_mul_shr_sat(value, focal, shift - 1);
    return lmb_add(centre, lmb_add(lmb_shr(twice, 1), twice & 1));
}
LMB_STATIC_ASSERT((1L << 30) - 32767 * 8L > LMB_SCREEN_MAX);

static bool on_screen(int32_t q4) { return (uint32_t)q4 + (uint32_t)LMB_SCREEN_MAX <= 2 * (uint32_t)LMB_SCREEN_MAX; }

#define RAISE_MAX 22 /* log2(w) + 12 more stay below 64 */

/* Depth of a distance in [near, far): what is farther than that has the greatest. */
static uint16_t depth_at(const lmb_camera *camera, int32_t w, int32_t near_w_q16)
{
    int32_t gain = (int32_t)camera->depth_gain, depth = 65535;
    if (w < camera->far_q16) {
        depth = LMB_WITH_PERSPECTIVE && camera->perspective
                    ? lmb_mul_shr_sat(65536 - near_w_q16, gain, 16)
                    : lmb_mul_shr_sat(lmb_sub(w, camera->near_q16), gain, 14u + camera->depth_shift);
    }
    return (uint16_t)lmb_max(0, lmb_min(depth, 65535));
}

bool lmb_project(const lmb_camera *camera, lmb_point p, lmb_vertex *vertex)
{
    int32_t x = p.x, y = p.y, w = lmb_sub(0, p.z), near_w_q16 = 0;
    unsigned shift = 28;
    if (w < camera->near_q16) return false;
    if (LMB_WITH_PERSPECTIVE && camera->perspective) {
        /* w * reciprocal = 2^(30 + shift), so x * reciprocal / 2^30 is x / w times 2^shift, and no larger than x, which is first
         * raised to the top of its word; near / w is at most one */
        int32_t reciprocal = (int32_t)(lmb_reciprocal((uint32_t)w, &shift) >> 1);
        unsigned raise = lmb_clz32((uint32_t)(x < 0 ? ~x : x) | (uint32_t)(y < 0 ? ~y : y)) - 1;
        if (raise > RAISE_MAX) raise = RAISE_MAX;
        near_w_q16 = lmb_min(65536, lmb_mul_shr_sat(camera->near_q16, reciprocal, 14 + shift));
        x = lmb_mul_shr_sat(lmb_mul(x, (int32_t)1 << raise), reciprocal, 30);
        y = lmb_mul_shr_sat(lmb_mul(y, (int32_t)1 << raise), reciprocal, 30);
        shift += raise + 12;
    }
    x = to_screen(camera->x, x, camera->focal_q16, shift);
    y = to_screen(camera->y, lmb_sub(0, y), camera->focal_q16, shift);
    if (!on_screen(x) || !on_screen(y)) return false;
    vertex->x = x;
    vertex->y = y;
    vertex->depth = LMB_WITH_DEPTH ? depth_at(camera, w, near_w_q16) : 0;
    return true;
}
