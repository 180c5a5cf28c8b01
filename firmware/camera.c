/* SPDX-License-Identifier: MIT */
/* Cameras: points in space onto the screen, 1/w by multiplication. */
#include "lambent.h"

#define NEAR_MIN 256 /* 1/256 unit: keeps near / w to 16 bits */

/* What both kinds share; near and far must fit, and their distance too. */
static int camera_begin(lmb_camera *camera, int width, int height, int32_t focal_q16, int32_t near_q16, int32_t far_q16)
{
    const bool frame = width != 0 && height != 0 && (width | height) >> 15 == 0; /* 1 to 32767 */
    if (!frame || focal_q16 < 1 || near_q16 >= far_q16 || lmb_sub_wrap(far_q16, near_q16) < 0) return LMB_ERROR_VALUE;
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
    if (error || !LMB_SCREEN_EXACT) return error;
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
    camera->focal_up = (uint8_t)(lmb_clz32((uint32_t)focal_q16) - 1);
    camera->near_up = (uint8_t)(lmb_clz32((uint32_t)near_q16) - 1);
    /* depth = far / (far - near) * (1 - near / w): gain / 2^16, saturated where far hardly exceeds near */
    reciprocal = lmb_reciprocal((uint32_t)lmb_sub(far_q16, near_q16), &shift);
    camera->depth_gain = (uint32_t)lmb_mul_shr_sat(far_q16, (int32_t)(reciprocal >> 1), 14 + shift);
    camera->depth_shift = 16;
    return LMB_OK;
}

/* a * b / 2^30 with b in [0, 2^30), from halves: short by less than two. Grows with b if a is not negative. */
static int32_t product_q30(int32_t a, int32_t b)
{
    return lmb_add(lmb_mul_q16(a, (uint32_t)b >> 14), lmb_shr(lmb_mul(lmb_shr(a, 16), b & 0x3fff), 14));
}

/* value * focal / 2^28, rounded: a length on the screen in Q28.4; far off some value beyond LMB_SCREEN_MAX. */
static int32_t flat_length(int32_t value, int32_t focal)
{
    int32_t twice = lmb_mul_shr_sat(value, focal, 27);
    return lmb_add(lmb_shr(twice, 1), twice & 1);
}
LMB_STATIC_ASSERT((1L << 30) - 32767 * 8L > LMB_SCREEN_MAX);

/* The same under perspective, value * focal / (w 2^12). focal is raised by up, and half the reciprocal of w is 2^(30 + shift) / w, so
 * k is focal / w times 2^(up + shift - 1). Values are raised or lowered so that with k they come to 9 fraction bits: those of 2^30
 * and more, as k is about 2^28 or more, to a length beyond LMB_SCREEN_MAX. False then. */
#define FRACTION 9
static bool deep_lengths(const lmb_camera *camera, int32_t reciprocal, unsigned shift, int32_t *x, int32_t *y)
{
    int32_t k = lmb_shr(product_q30(lmb_shl(camera->focal_q16, camera->focal_up), reciprocal), 1);
    int32_t raise = 19 + FRACTION - camera->focal_up - (int32_t)shift;
    if (raise >= 0) {
        if (((*x ^ lmb_shr(*x, 31)) | (*y ^ lmb_shr(*y, 31))) >> (30 - raise)) return false;
        *x = lmb_mul(*x, (int32_t)1 << raise);
        *y = lmb_mul(*y, (int32_t)1 << raise);
    } else {
        *x = lmb_shr(*x, (unsigned)lmb_min(-raise, 31));
        *y = lmb_shr(*y, (unsigned)lmb_min(-raise, 31));
    }
    *x = lmb_shr_round(product_q30(*x, k), FRACTION);
    *y = lmb_shr_round(product_q30(*y, k), FRACTION);
    return true;
}
LMB_STATIC_ASSERT((1L << (28 - FRACTION)) > LMB_SCREEN_MAX);

static bool on_screen(int32_t q4) { return (uint32_t)q4 + (uint32_t)LMB_SCREEN_MAX <= 2 * (uint32_t)LMB_SCREEN_MAX; }

/* Depth of a distance w from near on; what is farther than far has the greatest. */
static uint16_t flat_depth(const lmb_camera *camera, int32_t w)
{
    int32_t depth = 65535;
    if (w < camera->far_q16) {
        depth = lmb_mul_shr_sat(lmb_sub(w, camera->near_q16), (int32_t)camera->depth_gain, 14u + camera->depth_shift);
    }
    return (uint16_t)lmb_min(depth, 65535);
}

/* Under perspective, by near / w in Q16, rounded down, from half the reciprocal of w. */
static uint16_t deep_depth(const lmb_camera *camera, int32_t reciprocal, unsigned shift)
{
    int32_t share = product_q30(lmb_shl(camera->near_q16, camera->near_up), reciprocal);
    share = lmb_max(1, lmb_shr(share, (unsigned)lmb_min(31, (int32_t)(shift + camera->near_up) - 16)));
    return (uint16_t)lmb_min(lmb_mul_q16((int32_t)camera->depth_gain, (uint32_t)lmb_max(0, 65536 - share)), 65535);
}

bool lmb_project(const lmb_camera *camera, lmb_point p, lmb_vertex *vertex)
{
    int32_t x = p.x, y = lmb_sub(0, p.y), w = lmb_sub(0, p.z);
    uint16_t depth;
    if (w < camera->near_q16) return false;
    if (LMB_WITH_PERSPECTIVE && camera->perspective) {
        unsigned shift;
        int32_t reciprocal = (int32_t)(lmb_reciprocal((uint32_t)w, &shift) >> 1);
        if (!deep_lengths(camera, reciprocal, shift, &x, &y)) return false;
        depth = LMB_WITH_DEPTH ? (w < camera->far_q16 ? deep_depth(camera, reciprocal, shift) : 65535) : 0;
    } else {
        x = flat_length(x, camera->focal_q16);
        y = flat_length(y, camera->focal_q16);
        depth = LMB_WITH_DEPTH ? flat_depth(camera, w) : 0;
    }
    x = lmb_add(x, camera->x);
    y = lmb_add(y, camera->y);
    if (!on_screen(x) || !on_screen(y)) return false;
    vertex->x = x;
    vertex->y = y;
    vertex->depth = depth;
    return true;
}
