/* SPDX-License-Identifier: MIT */
/* The exponents for which lobes are charted, and the library's own lobe with so many multiplications: for the profiled image and
 * the host. */
#ifndef PARETO_EXPONENTS_H
#define PARETO_EXPONENTS_H

#include "../compare/lobe_parts.h"

#define PARETO_EXPONENTS 5u
static const uint16_t pareto_exponents[PARETO_EXPONENTS] = {8, 20, 60, 200, 800};

#define PARETO_MULTIPLICATIONS 4u

/* The most accurate tuned lobe of at most so many multiplications, or the one with fewest if none has so few: by the tolerance
 * that it is found under, bit by bit. */
static inline void pareto_tuned(lmb_lobe *lobe, unsigned n, unsigned multiplications)
{
    unsigned tolerance = 0, bit;
    for (bit = 0x8000; bit; bit >>= 1) {
        lmb_lobe_prepare(lobe, LMB_LOBE_TUNED, n, (uint16_t)(tolerance + bit - 1));
        if (lobe->multiplications > multiplications) tolerance += bit;
    }
    lmb_lobe_prepare(lobe, LMB_LOBE_TUNED, n, (uint16_t)tolerance);
}

/* The kernel that evaluates it, in a lobe that is prepared for n: where the form is plain that of W_m itself, since W_m is the
 * same form with other numbers, so that both are the same code. */
static inline const compare_lobe_kernel *pareto_tuned_kernel(compare_lobe *lobe, unsigned n, unsigned multiplications)
{
    static uint32_t (*const sums[PARETO_MULTIPLICATIONS])(const compare_lobe *, const compare_argument *, unsigned) = {
        compare_sum_w2, compare_sum_w4, compare_sum_w8, compare_sum_w16};
    lmb_lobe *const to[PARETO_MULTIPLICATIONS] = {&lobe->w2, &lobe->w4, &lobe->w8, &lobe->w16};
    uint32_t (*sum)(const compare_lobe *, const compare_argument *, unsigned) = compare_sum_lambent;
    unsigned i, m;
    pareto_tuned(&lobe->tuned, n, multiplications);
    m = lobe->tuned.multiplications;
    if (!lobe->tuned.crossed && m > 0) {
        *to[m - 1] = lobe->tuned;
        sum = sums[m - 1];
    }
    for (i = 0; i + 1 < compare_lobe_count && compare_lobes[i].sum != sum; i++) {}
    return &compare_lobes[i];
}

#endif
