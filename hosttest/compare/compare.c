/* SPDX-License-Identifier: MIT */
/* The lists of frames and spans that are compared, and what spans share. */
#include "methods.h"

#include <stddef.h>

const compare_frame compare_frames[] = {
#if COMPARE_WITH_LIBM
    {"float-phong", compare_draw_float_phong},
    {"float-squarings", compare_draw_float_squarings},
#endif
    {"integer-phong-sqrt", compare_draw_integer_phong},
    {"integer-phong-textbook", compare_draw_integer_phong_textbook},
    {"schlick", compare_draw_schlick},
    {"power-table", compare_draw_power_table},
    {"ramp-table", compare_draw_ramp_table},
    {"integer-gouraud", compare_draw_gouraud},
};
const unsigned compare_frame_count = sizeof compare_frames / sizeof compare_frames[0];

const compare_span_kernel compare_spans[] = {
#if COMPARE_WITH_LIBM
    {"span-float-phong", compare_begin_float, compare_fill_float_phong},
    {"span-float-squarings", compare_begin_float, compare_fill_float_squarings},
#endif
    {"span-integer-phong-sqrt", compare_begin_integer_phong, compare_fill_integer_phong},
    {"span-integer-phong-textbook", compare_begin_integer_phong, compare_fill_integer_phong_textbook},
    {"span-schlick", compare_begin_schlick, compare_fill_schlick},
    {"span-power-table", compare_begin_power_table, compare_fill_power_table},
    {"span-ramp-table", compare_begin_power_table, compare_fill_ramp_table},
    {"span-integer-gouraud", compare_begin_gouraud, compare_fill_gouraud},
};
const unsigned compare_span_count = sizeof compare_spans / sizeof compare_spans[0];

static void ray(int32_t out[3], lmb_vec v, const lmb_pose *pose)
{
    if (pose) v = lmb_rotate_back(&pose->rotation, v);
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

void compare_span_look(compare_span *span, const compare_look *look, const lmb_pose *pose)
{
    span->look = look;
    ray(span->direction, look->direction, pose);
    ray(span->half, look->half, pose);
}

void compare_span_value(compare_span *span, int k, int32_t from, int32_t to, unsigned length)
{
    span->value[k] = lmb_signed((uint32_t)from << 16);
    span->step[k] = (int32_t)((int64_t)(to - from) * 65536 / (int32_t)length);
}
