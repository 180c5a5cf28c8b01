/* SPDX-License-Identifier: MIT */
/* The lobe alone: max(0, cos)^n in each of the ways, in one and the same loop. Here what they share, division and table. */
#include "lobe_parts.h"
#include "powers.h"

int compare_lobe_prepare(compare_lobe *lobe, unsigned n)
{
    const enum lmb_lobe_kind kind[5] = {LMB_LOBE_TUNED, LMB_LOBE_W2, LMB_LOBE_W4, LMB_LOBE_W8, LMB_LOBE_W16};
    lmb_lobe *to[5];
    unsigned i;
    to[0] = &lobe->tuned;
    to[1] = &lobe->w2;
    to[2] = &lobe->w4;
    to[3] = &lobe->w8;
    to[4] = &lobe->w16;
    for (i = 0; i < 5; i++) {
        int status = lmb_lobe_prepare(to[i], kind[i], n, 0);
        if (status != LMB_OK) return status;
    }
    lobe->n = (int32_t)n;
    lobe->n_mirrored = n < 6 ? 1 : (int32_t)(n + 2) / 4;
    lobe->n_f = (float)n;
    lobe->ratio = (float)n / 16;
    compare_powers(lobe->power, n);
    compare_angles_prepare(lobe, n);
    return LMB_OK;
}

void compare_lobe_cosines(int32_t cosine_q30[COMPARE_ARGUMENTS], unsigned n)
{
    /* cos^n = e^(-n v) nearly, v = 1 - cos: it is 1/256 where n v is 5.5, and v is half the angle's square or a little less */
    int32_t last = 65536 * 11 / (int32_t)(2 * n);
    int32_t i;
    if (last > 65536) last = 65536;
    for (i = 0; i < COMPARE_ARGUMENTS; i++) {
        int32_t part = i * 65536 / (COMPARE_ARGUMENTS - 1);
        cosine_q30[i] = ((int32_t)1 << 30) - (int32_t)(((int64_t)part * part * last) >> 18);
    }
}

/* ------------------------------------------------------------------------------------------------------------------ nothing */

static void as_cosine(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    (void)lobe;
    while (count-- > 0) (argument++)->q = *cosine_q30++;
}

static COMPARE_INLINE uint32_t none(const compare_lobe *lobe, compare_argument argument)
{
    (void)lobe;
    return (uint32_t)argument.q;
}

COMPARE_LOBE_SUM(compare_sum_none, none)

/* ---------------------------------------------------------------------------------------------------------------- Schlick */

static void as_q15(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    (void)lobe;
    while (count-- > 0) (argument++)->q = (*cosine_q30++ + (1 << 14)) >> 15;
}

/* t / (n - n t + t) of t in UQ1.15: UQ1.15 again. */
static COMPARE_INLINE uint32_t schlick(const compare_lobe *lobe, compare_argument argument)
{
    uint32_t t = (uint32_t)argument.q;
    if (argument.q <= 0) return 0;
    return (t << 15) / ((uint32_t)lobe->n * (32768 - t) + t);
}

/* The same to 8 bits, which is what a display of 6 bits wants and fewer steps of a division. */
static COMPARE_INLINE uint32_t schlick_8(const compare_lobe *lobe, compare_argument argument)
{
    uint32_t t = (uint32_t)argument.q, below;
    if (argument.q <= 0) return 0;
    below = (uint32_t)lobe->n * (32768 - t) + t;
    return ((t << 8) + (below >> 1)) / below << 7;
}

COMPARE_LOBE_SUM(compare_sum_schlick, schlick)

COMPARE_LOBE_SUM(compare_sum_schlick_8, schlick_8)

/* ------------------------------------------------------------------------------------------------------------------ table */

/* 255 cos with half of one added, Q.22 */
static void as_index(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    (void)lobe;
    while (count-- > 0) {
        int32_t c = *cosine_q30++;
        (argument++)->q = c - (c >> 8) + ((int32_t)1 << 21);
    }
}

static COMPARE_INLINE uint32_t table(const compare_lobe *lobe, compare_argument argument)
{
    return argument.q > 0 ? lobe->power[argument.q >> 22] : 0;
}

COMPARE_LOBE_SUM(compare_sum_table, table)

/* -------------------------------------------------------------------------------------------------------------------- all */

/* clang-format off */
const compare_lobe_kernel compare_lobes[] = {
    {"lobe-none", false, as_cosine, compare_sum_none},
#if COMPARE_WITH_LIBM
    {"lobe-powf", true, compare_as_float, compare_sum_powf},
    {"lobe-float-squarings", true, compare_as_float, compare_sum_float_squarings},
#endif
    {"lobe-blinn", false, compare_as_versine, compare_sum_blinn},
    {"lobe-schlick", false, as_q15, compare_sum_schlick},
    {"lobe-schlick-8", false, as_q15, compare_sum_schlick_8},
    {"lobe-w16", false, compare_as_w16, compare_sum_w16},
    {"lobe-lambent", false, compare_as_tuned, compare_sum_lambent},
    {"lobe-table256", false, as_index, compare_sum_table},
    {"lobe-phong", false, compare_as_mirrored, compare_sum_phong},
    {"lobe-gauss", false, compare_as_versine, compare_sum_gauss},
    {"lobe-w2", false, compare_as_w2, compare_sum_w2},
    {"lobe-w4", false, compare_as_w4, compare_sum_w4},
    {"lobe-w8", false, compare_as_w8, compare_sum_w8},
    {"lobe-chebyshev_published", false, compare_as_versine, compare_sum_chebyshev_published},
    {"lobe-chebyshev_rootless", false, compare_as_versine, compare_sum_chebyshev_rootless},
    {"lobe-lyon", false, compare_as_difference, compare_sum_lyon},
#if COMPARE_WITH_LIBM
    {"lobe-float-schlick", true, compare_as_float, compare_sum_float_schlick},
    {"lobe-acosf", true, compare_as_float, compare_sum_acosf},
#endif
};
/* clang-format on */
const unsigned compare_lobe_count = sizeof compare_lobes / sizeof compare_lobes[0];
