/* SPDX-License-Identifier: MIT */
/* Curves: parabolas along spans, in the place of arcs whose normals turn little. */
#include "arc_parts.h"
#include "curve.h"

#if defined(__GNUC__)
/* Keeps a compiler from carrying in registers, of which small cores have too few, what lies ready in memory. */
#define FORGET() __asm__ volatile("" ::: "memory")
#if !defined(__OPTIMIZE_SIZE__)
#define INLINE inline __attribute__((always_inline))
#endif
#else
#define FORGET() ((void)0)
#endif
#ifndef INLINE
#define INLINE LMB_OUTLINE
#endif

/* so bulges are below 2^16 in Q0.20, tilt_q14 from -2 to 1, and their product fits */
LMB_STATIC_ASSERT(LMB_CURVE_U_MAX <= 0xe00000 && LMB_CURVE_LENGTH_MAX <= 1UL << 22);

/* A parabola errs by 1/303 psi^4 at the peak of a highlight, which counts n times, and by 1/125 psi^3 on its slopes. With u = psi^2 /
 * 2: n psi^4 / 303 <= 1/840 and psi^3 / 125 <= 1/8200, for the next power of two that is not below n. */
int32_t lmb_curve_limit_q28(unsigned n)
{
    unsigned bits = n > 1 ? 32u - lmb_clz32(n - 1u) : 0;
    return lmb_min(lmb_shr(bits & 1u ? 56943759 : 80530637, bits >> 1),
                   7999580); /* 0.3 over the root of 2^bits; 0.0298: 14 degrees */
}

/* What rough curves err by is below 1/500 then: n psi^4 / 303 */
LMB_STATIC_ASSERT(LMB_CURVE_ROUGH_SHININESS <= 32 && LMB_CURVE_U_MAX <= 0xe00000);

/* raise() from a pixel up to LMB_CURVE_LENGTH_MAX: three steps do. */
static inline unsigned raise_pixels(uint32_t *x)
{
#if LMB_CLZ_BY_STEPS
    uint32_t y = *x << 9;
    unsigned n = 9;
    if (y >> 28 == 0) y <<= 4, n = 13;
    if (y >> 30 == 0) y <<= 2, n += 2;
    if (y >> 31 == 0) y <<= 1, n += 1;
    *x = y;
    return n;
#else
    return raise(x);
#endif
}

/* With t from 0 to 1 over the span and B = 2 (1 / sqrt(1 - u/2) - 1) = u/2 (1 + 3/8 u + 5/32 u^2 ...), the parabola through both
 * ends and through the middle of the arc, (a + b)/2 / sqrt(1 - u/2), is
 *     f = a + rise t + (a + b) B t (1 - t)
 *     d = step (rise + (a + b) B (1 - 2t - step)),    c = -(a + b) 2B step^2
 * and what (a + b) is multiplied by is the same for all terms. 25/64 u for both powers of u is 2^-13 of B off. A pixel is step
 * 2^-down of the span. Where the span is shorter than a pixel there is no second one, and step does not count. */
static inline void prepare(lmb_curve *curve, int32_t u_q28, uint32_t length, uint32_t start)
{
    const uint32_t u_q15 = (uint32_t)u_q28 >> 13, bow_q20 = ((uint32_t)u_q28 >> 9) + (lmb_mulu(u_q15, u_q15) >> 10) * 3 / 16;
    uint32_t m_q31 = length, step_q16, first_q16, part_q16;
    const unsigned zeros = length >= LMB_ARC_PIXEL ? raise_pixels(&m_q31) : raise(&m_q31);
    const int32_t r_q9 = inverse_q9(m_q31);
    step_q16 = (uint32_t)lmb_add(lmb_shl(r_q9, 7), lmb_shr(lmb_mul(r_q9, lmb_shr(residue_q32(m_q31, r_q9), 16)), 9));
    if (zeros <= 15) {
        const unsigned down = 15 - zeros;
        first_q16 = lmb_mulu(start, step_q16) >> 16 >> down;
        part_q16 = step_q16 >> down;
        curve->down = 2 + down;
    } else {
        first_q16 = lmb_mulu((start < length ? start : length) << (zeros - 16), step_q16) >> 15;
        part_q16 = step_q16;
        curve->down = 2;
    }
    curve->first_q16 = (int32_t)first_q16;
    curve->step_q16 = (int32_t)step_q16;
    curve->slant_q19 = lmb_shr(lmb_mul((int32_t)bow_q20, lmb_shr(65538 - (int32_t)(2 * first_q16) - (int32_t)part_q16, 2)), 15);
    curve->above_q22 = (int32_t)(lmb_mulu(bow_q20, lmb_mulu(first_q16, 65536 - first_q16) >> 16) >> 14);
    curve->bow_q20 = -(int32_t)(lmb_mulu(bow_q20, lmb_mulu(step_q16, step_q16) >> 16) >> 15);
}

bool lmb_curve_prepare(lmb_curve *curve, int32_t u_q28, uint32_t length, uint32_t start)
{
    if (u_q28 > LMB_CURVE_U_MAX || length > LMB_CURVE_LENGTH_MAX) return false;
    prepare(curve, u_q28, length, start);
    return true;
}

/* c rounded to nearest, as it counts half the square of the length times. */
static inline void start_curve(const lmb_curve *curve, lmb_term *term, int32_t a_q28, int32_t rise_q28)
{
    const int32_t sum_q14 = lmb_shr(lmb_add(lmb_shl(a_q28, 1), rise_q28), 14);
    int32_t x = lmb_add(a_q28, lmb_shr(lmb_mul(sum_q14, curve->above_q22), 8));
    term->f = lmb_shl(lmb_add(x, lmb_mul_q16(rise_q28, (uint32_t)curve->first_q16)), 2);
    x = lmb_add(rise_q28, lmb_shr(lmb_mul(sum_q14, curve->slant_q19), 5));
    term->d = lmb_shr(lmb_shl(lmb_mul_q16(x, (uint32_t)curve->step_q16), 4), curve->down);
    term->c = lmb_shr_round(lmb_mul(sum_q14, curve->bow_q20), 2 * curve->down);
}

void lmb_curve_start(const lmb_curve *curve, lmb_term *term, int32_t a_q30, int32_t rise_q30)
{
    start_curve(curve, term, lmb_shr(a_q30, 2), lmb_shr(rise_q30, 2));
}

void lmb_curve_beam(const lmb_curve *curve, lmb_term *term, const lmb_ends *ends, const lmb_beam *beam)
{
    int32_t a = corrected_q28(lmb_shr(lit_q30(&ends->from, beam), 2), ends->from.excess_q28);
    int32_t b = corrected_q28(lmb_shr(lit_q30(&ends->to, beam), 2), ends->to.excess_q28);
    start_curve(curve, term, a, lmb_sub(b, a));
}

/* Each product of two factors of 16 bits; the rise, which up to LMB_CURVE_U_MAX is at most 0.34, in Q0.16. Normals count as they
 * are: the length that they lack, 2^-14 of it, is what n may be LMB_CURVE_ROUGH_SHININESS times. */
static INLINE void start_rough(const lmb_curve *curve, lmb_term *term, const lmb_ends *ends, const lmb_beam *beam,
                               int32_t offset_q30)
{
    int32_t k = beam->x_q16, a = lmb_mul(ends->from.x, k), b = lmb_mul(ends->to.x, k), sum_q14, x;
    FORGET();
    k = beam->y_q16;
    a = lmb_add(a, lmb_mul(ends->from.y, k));
    b = lmb_add(b, lmb_mul(ends->to.y, k));
    FORGET();
    k = beam->z_q16;
    a = lmb_add(a, lmb_mul(ends->from.z, k));
    b = lmb_add(b, lmb_mul(ends->to.z, k));
    sum_q14 = lmb_add(lmb_shr(a, 16), lmb_shr(b, 16));
    b = lmb_sub(b, a);
    FORGET();
    x = lmb_mul(lmb_shr(b, 14), curve->first_q16);
    x = lmb_add(a, lmb_shr(x, 2));
    FORGET();
    x = lmb_add(x, lmb_shr(lmb_mul(sum_q14, curve->above_q22), 6));
    term->f = lmb_add_wrap(x, offset_q30);
    FORGET();
    x = lmb_shr(lmb_add(b, lmb_shr(lmb_mul(sum_q14, curve->slant_q19), 3)), 14);
    term->d = lmb_shr(lmb_mul(x, curve->step_q16), curve->down);
    FORGET();
    term->c = lmb_shr(lmb_shr(lmb_mul(sum_q14, curve->bow_q20), curve->down), curve->down);
    FORGET();
}

void lmb_curve_beam_rough(const lmb_curve *curve, lmb_term *term, const lmb_ends *ends, const lmb_beam *beam)
{
    start_rough(curve, term, ends, beam, 0);
}

/* ------------------------------------------------------------------------------------------------------------- spans of curves */

#if LMB_WITH_ARC

/* Half the squared distance of the ends: their lengths count by their part of it. */
static inline int32_t rough_u_q28(const lmb_ends *ends)
{
    const int32_t x = lmb_sub(ends->to.x, ends->from.x), y = lmb_sub(ends->to.y, ends->from.y),
                  z = lmb_sub(ends->to.z, ends->from.z);
    return (int32_t)(((uint32_t)x * (uint32_t)x + (uint32_t)y * (uint32_t)y + (uint32_t)z * (uint32_t)z) >> 1);
}

bool lmb_run_rough(const lmb_triangle *t, lmb_span *span, const lmb_run *run)
{
    const int32_t u_q28 = rough_u_q28(&run->ends);
    const struct lmb_ray *ray = t->rays->light;
    lmb_term *term = span->diffuse;
    uint8_t *exponent = span->exponent;
    lmb_curve curve;
    unsigned n;
    if (!lmb_curve_prepare(&curve, u_q28, run->length, run->start)) return false;
    FORGET();
    span->kind = LMB_SPAN_PLANE;
    n = lmb_look_lights(t->look);
    do {
        start_rough(&curve, term, &run->ends, &ray->diffuse, 0);
        if (ray->shines) start_rough(&curve, term + LMB_LIGHTS, &run->ends, &ray->specular, ray->offset_q30);
        term++;
        *exponent++ = ray->exponent;
        ray++;
        FORGET();
    } while (--n > 0);
    return true;
}

#endif
