/* SPDX-License-Identifier: MIT */
/* What the kernels of lobes share: one and the same loop, and their own symbols. Inside hosttest/compare/ only. */
#ifndef COMPARE_LOBE_PARTS_H
#define COMPARE_LOBE_PARTS_H

#include "compare.h"
#include "walk.h"

typedef uint32_t lobe_value(const compare_lobe *lobe, compare_argument argument);
typedef void lobe_arguments(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count);
typedef uint32_t lobe_sum(const compare_lobe *lobe, const compare_argument *argument, unsigned count);

static COMPARE_INLINE uint32_t compare_sum_of(const compare_lobe *lobe, const compare_argument *argument, unsigned count,
                                              lobe_value *value)
{
    const compare_argument *end = argument + count;
    uint32_t sum = 0;
    do {
        sum += value(lobe, *argument++);
    } while (argument != end);
    return sum;
}

/* The sum of a value over its arguments, a symbol of its own. */
#define COMPARE_LOBE_SUM(NAME, VALUE)                                                                                            \
    uint32_t NAME(const compare_lobe *lobe, const compare_argument *argument, unsigned count)                                    \
    {                                                                                                                            \
        return compare_sum_of(lobe, argument, count, VALUE);                                                                     \
    }

/* lobes.c */
lobe_sum compare_sum_none, compare_sum_schlick, compare_sum_schlick_8, compare_sum_table;

/* lobes_float.c; COMPARE_WITH_LIBM */
lobe_arguments compare_as_float;
lobe_sum compare_sum_powf, compare_sum_float_squarings, compare_sum_float_schlick, compare_sum_acosf;

/* lobes_power.c */
lobe_arguments compare_as_versine, compare_as_mirrored;
lobe_sum compare_sum_phong, compare_sum_blinn;

/* lobes_angle.c */
void compare_angles_prepare(compare_lobe *lobe, unsigned n);
lobe_sum compare_sum_gauss, compare_sum_chebyshev_published, compare_sum_chebyshev_rootless;

/* lobes_squarings.c */
lobe_arguments compare_as_w2, compare_as_w4, compare_as_w8, compare_as_w16, compare_as_tuned, compare_as_difference;
lobe_sum compare_sum_w2, compare_sum_w4, compare_sum_w8, compare_sum_w16, compare_sum_lambent, compare_sum_lyon;

#endif
