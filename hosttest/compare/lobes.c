/* SPDX-License-Identifier: MIT */
/* The lobe alone: max(0, cos)^n in each of the ways, in one and the same loop. */
#include "powers.h"

#include "floats.h"
#include "walk.h"

int compare_lobe_prepare(compare_lobe *lobe, unsigned n)
{
    int status = lmb_lobe_prepare(&lobe->tuned, LMB_LOBE_TUNED, n, 0);
    if (status == LMB_OK) status = lmb_lobe_prepare(&lobe->w16, LMB_LOBE_W16, n, 0);
    if (status != LMB_OK) return status;
    lobe->n = (int32_t)n;
    lobe->n_f = (float)n;
    lobe->ratio = (float)n / 16;
    compare_powers(lobe->power, n);
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

typedef uint32_t lobe_value(const compare_lobe *lobe, compare_argument argument);

static COMPARE_INLINE uint32_t sum_of(const compare_lobe *lobe, const compare_argument *argument, unsigned count,
                                      lobe_value *value)
{
    const compare_argument *end = argument + count;
    uint32_t sum = 0;
    do {
        sum += value(lobe, *argument++);
    } while (argument != end);
    return sum;
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

static uint32_t sum_none(const compare_lobe *lobe, const compare_argument *argument, unsigned count)
{
    return sum_of(lobe, argument, count, none);
}

/* ------------------------------------------------------------------------------------------------------------------- floats */

#if COMPARE_WITH_LIBM

static void as_float(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    (void)lobe;
    while (count-- > 0) (argument++)->f = (float)*cosine_q30++ * (1.0f / 1073741824);
}

static COMPARE_INLINE uint32_t word(float x)
{
    compare_argument w;
    w.f = x;
    return (uint32_t)w.q;
}

static COMPARE_INLINE uint32_t power(const compare_lobe *lobe, compare_argument argument)
{
    return word(argument.f > 0 ? powf(argument.f, lobe->n_f) : 0.0f);
}

/* W_16 of paper 000, clamped at its zero: exact for n = 16. */
static COMPARE_INLINE uint32_t squarings(const compare_lobe *lobe, compare_argument argument)
{
    float w = 1.0f - lobe->ratio * (1.0f - argument.f);
    if (w <= 0) return 0;
    w *= w;
    w *= w;
    w *= w;
    return word(w * w);
}

static uint32_t sum_power(const compare_lobe *lobe, const compare_argument *argument, unsigned count)
{
    return sum_of(lobe, argument, count, power);
}

static uint32_t sum_squarings(const compare_lobe *lobe, const compare_argument *argument, unsigned count)
{
    return sum_of(lobe, argument, count, squarings);
}

#endif

/* ------------------------------------------------------------------------------------------------------------------ Schlick */

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

static uint32_t sum_schlick(const compare_lobe *lobe, const compare_argument *argument, unsigned count)
{
    return sum_of(lobe, argument, count, schlick);
}

static uint32_t sum_schlick_8(const compare_lobe *lobe, const compare_argument *argument, unsigned count)
{
    return sum_of(lobe, argument, count, schlick_8);
}

/* -------------------------------------------------------------------------------------------------------------------- table */

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

static uint32_t sum_table(const compare_lobe *lobe, const compare_argument *argument, unsigned count)
{
    return sum_of(lobe, argument, count, table);
}

/* -------------------------------------------------------------------------------------------------------- squarings, integer */

static void as_s(const lmb_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    while (count-- > 0) (argument++)->q = lmb_lobe_argument(lobe, ((int32_t)1 << 30) - *cosine_q30++);
}

static void as_tuned(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    as_s(&lobe->tuned, argument, cosine_q30, count);
}

static void as_w16(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
{
    as_s(&lobe->w16, argument, cosine_q30, count);
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

static uint32_t sum_w16(const compare_lobe *lobe, const compare_argument *argument, unsigned count)
{
    return sum_form(&lobe->w16, argument, count, 4, false);
}

static uint32_t sum_lambent(const compare_lobe *lobe, const compare_argument *argument, unsigned count)
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

const compare_lobe_kernel compare_lobes[] = {
    {"lobe-none", false, as_cosine, sum_none},
#if COMPARE_WITH_LIBM
    {"lobe-powf", true, as_float, sum_power},       {"lobe-float-squarings", true, as_float, sum_squarings},
#endif
    {"lobe-schlick", false, as_q15, sum_schlick},   {"lobe-schlick-8", false, as_q15, sum_schlick_8},
    {"lobe-table", false, as_index, sum_table},     {"lobe-w16", false, as_w16, sum_w16},
    {"lobe-lambent", false, as_tuned, sum_lambent},
};
const unsigned compare_lobe_count = sizeof compare_lobes / sizeof compare_lobes[0];
