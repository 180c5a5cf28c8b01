/* SPDX-License-Identifier: MIT */
/* Lobes by squarings in the library's integers: W_m of paper 000, Lyon's, the library's own.
 *
 * Their argument s is carried from pixel to pixel, as the library's planes and arcs do. lyon carries the squared length of the
 * difference D = N - H instead and begins each evaluation with s = 1 - n/32 D.D: D.D runs along a row as a parabola whatever the
 * normals' lengths, and s would do as well, but then it were w16.
 */
#include "lobe_parts.h"

static void as_s(const lmb_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    while (count-- > 0) (argument++)->q = lmb_lobe_argument(lobe, ((int32_t)1 << 30) - *cosine_q30++);
}

/* As the library's own loops: the form is chosen once, outside. */
static COMPARE_INLINE uint32_t sum_form(const lmb_lobe *lobe, const compare_argument *argument, unsigned count, unsigned m,
                                        bool crossed)
{
    const compare_argument *end = argument + count;
    uint32_t sum = 0;
    do {
        sum += (uint32_t)lmb_lobe_at_form(lobe, (argument++)->q, m, crossed);
    } while (argument != end);
    return sum;
}

#define W_OF(M, SQUARINGS)                                                                                                       \
    void compare_as_w##M(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)        \
    {                                                                                                                            \
        as_s(&lobe->w##M, argument, cosine_q30, count);                                                                          \
    }                                                                                                                            \
    uint32_t compare_sum_w##M(const compare_lobe *lobe, const compare_argument *argument, unsigned count)                        \
    {                                                                                                                            \
        return sum_form(&lobe->w##M, argument, count, SQUARINGS, false);                                                         \
    }

W_OF(2, 1)
W_OF(4, 2)
W_OF(8, 3)
W_OF(16, 4)

void compare_as_tuned(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    as_s(&lobe->tuned, argument, cosine_q30, count);
}

uint32_t compare_sum_lambent(const compare_lobe *lobe, const compare_argument *argument, unsigned count)
{
    const lmb_lobe *l = &lobe->tuned;
    switch (l->multiplications + 8 * l->crossed) {
    case 2:
        return sum_form(l, argument, count, 2, false);
    case 3:
        return sum_form(l, argument, count, 3, false);
    case 4:
        return sum_form(l, argument, count, 4, false);
    case 8 + 2:
        return sum_form(l, argument, count, 2, true);
    case 8 + 3:
        return sum_form(l, argument, count, 3, true);
    case 8 + 4:
        return sum_form(l, argument, count, 4, true);
    default:
        return sum_form(l, argument, count, l->multiplications, l->crossed);
    }
}

/* D.D in Q3.29, below 4: the same bits as half of it, 1 - c, in Q2.30. */
void compare_as_difference(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    (void)lobe;
    for (; count-- > 0; cosine_q30++) {
        const uint32_t v_q30 = ((uint32_t)1 << 30) - (uint32_t)*cosine_q30;
        (argument++)->q = v_q30 <= INT32_MAX ? (int32_t)v_q30 : INT32_MAX;
    }
}

static COMPARE_INLINE uint32_t lyon(const compare_lobe *lobe, compare_argument argument)
{
    return (uint32_t)lmb_lobe_at_form(&lobe->w16, lmb_lobe_argument(&lobe->w16, argument.q), 4, false);
}

COMPARE_LOBE_SUM(compare_sum_lyon, lyon)
