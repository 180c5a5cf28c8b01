/* SPDX-License-Identifier: MIT */
/* Lobes in floats, as software with a libm has them: a value is the bit pattern of a float. */
#include "lobe_parts.h"

#if COMPARE_WITH_LIBM

#include "floats.h"

void compare_as_float(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count)
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

COMPARE_LOBE_SUM(compare_sum_powf, power)
COMPARE_LOBE_SUM(compare_sum_float_squarings, squarings)

static COMPARE_INLINE uint32_t schlick(const compare_lobe *lobe, compare_argument argument)
{
    float c = argument.f;
    return c > 0 ? word(c / (lobe->n_f - (lobe->n_f - 1.0f) * c)) : 0;
}

/* Paper 003 as printed: the angle by arccos, then the parabola, cut off at zero. */
static COMPARE_INLINE uint32_t parabola(const compare_lobe *lobe, compare_argument argument)
{
    float x, p;
    if (argument.f <= 0) return 0;
    x = acosf(argument.f < 1.0f ? argument.f : 1.0f);
    p = (lobe->published_f[0] * x + lobe->published_f[1]) * x + 1.0f;
    return p > 0 ? word(p) : 0;
}

COMPARE_LOBE_SUM(compare_sum_float_schlick, schlick)
COMPARE_LOBE_SUM(compare_sum_acosf, parabola)

#else

extern char compare_lobes_float_is_empty;

#endif
