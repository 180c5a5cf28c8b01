/* SPDX-License-Identifier: MIT */
/* What the methods of the comparison share beside walks, planes and colours. Inside hosttest/compare/ only. */
#ifndef COMPARE_METHODS_H
#define COMPARE_METHODS_H

#include "compare.h"

/* Where 0.5 cos^16 is a quarter of a level of 63: below this cosine the highlight is not seen. */
#define COMPARE_DARK 0.739

/* a.b, Q4.28 */
static inline int32_t compare_dot(const int32_t a[3], lmb_vec b) { return a[0] * b.x + a[1] * b.y + a[2] * b.z; }

/* The look and its rays, turned into the space of the mesh's normals; pose NULL: normals are given in space. */
void compare_span_look(compare_span *span, const compare_look *look, const lmb_pose *pose);

/* Value k of a span, with 16 fraction bits to come. */
void compare_span_value(compare_span *span, int k, int32_t from, int32_t to, unsigned length);

/* The begin and fill of each method, for the table of kernels. */
typedef void compare_begin(compare_span *span, const compare_look *look, lmb_vec from, lmb_vec to, unsigned length);
typedef void compare_fill(const compare_span *span, uint16_t *pixel, unsigned length);

compare_begin compare_begin_float, compare_begin_integer_phong, compare_begin_schlick, compare_begin_power_table;
compare_begin compare_begin_gouraud;
/* Called, not inlined: spans are drawn by the same code in frames and alone, and eight registers do not hold more. */
compare_fill compare_fill_float_phong, compare_fill_float_squarings, compare_fill_integer_phong, compare_fill_schlick;
compare_fill compare_fill_integer_phong_textbook, compare_fill_power_table, compare_fill_ramp_table, compare_fill_gouraud;

#endif
