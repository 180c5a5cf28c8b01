/* SPDX-License-Identifier: MIT */
/* Lobes that are functions of the angle x itself, in integers and without an arccos: the Gaussian of paper 000, the parabola of
 * 003.
 *
 * The argument is v = 1 - cos, Q2.30. g = x^2 = v (2 + v (1/3 + v (4/45 + v/35))), whose next term is 0.0051 v^4 of it; so half
 * of that, h, is v and a little more. The parabola needs x = g^1/2 as well: x = g times a reciprocal square root by
 * multiplications alone. All of it is done in w = n h, which is below 2 where a parabola is above zero and below 11.1 where e^-w
 * shows in 15 bits.
 */
#include "../../firmware/arith.h"
#include "lobe_parts.h"

/* h in Q2.30, rounded down: at most 2.2e-5 of it too small. */
static COMPARE_INLINE uint32_t half_square_q30(uint32_t v_q30)
{
    uint32_t v_q15 = v_q30 >> 15, more_q15;
    more_q15 = (v_q15 * 468 >> 15) + 1456;      /* 1/70, 2/45 */
    more_q15 = (v_q15 * more_q15 >> 15) + 5461; /* 1/6 */
    more_q15 = v_q15 * more_q15 >> 15;          /* at most 0.2254 */
    return v_q30 + v_q15 * more_q15;
}

/* ---------------------------------------------------------------------------------------------------------------------- gauss */

/* e^-w = 2^-(w / ln 2): the whole part is a shift, and 2^-f is a cubic that is exact at both ends and errs by 7.5e-5.
 *   h_q26   h times 2^shift, scale in [1, 2) times 2^shift is n / ln 2: below 16.1
 *   t_q16   w / ln 2, below 16.1 */
static COMPARE_INLINE uint32_t gauss(const compare_lobe *lobe, compare_argument argument)
{
    uint32_t h_q26 = half_square_q30((uint32_t)argument.q), t_q16, f_q16, p_q15;
    if (h_q26 >= lobe->gauss_end_q30) return 0;
    h_q26 = h_q26 >> 4 << lobe->gauss_shift;
    t_q16 = ((h_q26 >> 16) * lobe->gauss_scale_q15 + ((h_q26 & 65535) * lobe->gauss_scale_q15 >> 16)) >> 9;
    f_q16 = t_q16 & 65535;
    p_q15 = 7579 - (f_q16 * 1298 >> 16);
    p_q15 = 22665 - (f_q16 * p_q15 >> 16);
    p_q15 = 32768 - (f_q16 * p_q15 >> 16);
    return p_q15 >> (t_q16 >> 16);
}

COMPARE_LOBE_SUM(compare_sum_gauss, gauss)

static void gauss_prepare(compare_lobe *lobe, uint32_t n)
{
    uint32_t scale = n * 47274u, shift = 0; /* 2^15 / ln 2 */
    for (; scale >= 65536; scale >>= 1) shift++;
    lobe->gauss_scale_q15 = (uint16_t)scale;
    lobe->gauss_shift = (uint8_t)shift;
    lobe->gauss_end_q30 = n < 10 ? UINT32_MAX : 2979633561u / n << 2; /* 11.1 / n; h is below 1.24 */
}

/* ------------------------------------------------------------------------------------------------------------------- parabola */

/* C - a W - b W^1/2 with W = n g = 2 n h: A = -n a, B = -n^1/2 b. All parabolas end below W = 4.
 *   k_q29   W: n h_q30, below 2^31
 *   x_q30   W as [1/4, 1) times 2^(2 - 2 half)
 *   sum     above 2^30 - 0.44 * 2^32 - 0.18 * 2^31, so it fits int32_t */
static COMPARE_INLINE uint32_t parabola(const compare_lobe *lobe, const compare_parabola *p, compare_argument argument)
{
    uint32_t h_q30 = half_square_q30((uint32_t)argument.q), k_q29, x_q30, root_q15;
    unsigned half;
    int32_t sum_q30 = p->c_q30;
    if (h_q30 >= lobe->parabola_end_q30) return 0;
    k_q29 = (uint32_t)lobe->n * h_q30;
    if (k_q29 != 0) {
        half = (lmb_clz32(k_q29) - 1) >> 1;
        x_q30 = k_q29 << (2 * half) >> 1;
        root_q15 = (x_q30 >> 15) * (lmb_rsqrt_q30(x_q30) >> 15) >> 15;
        sum_q30 -= (int32_t)((k_q29 >> 14) * p->a_q15);
        sum_q30 -= (int32_t)((root_q15 * 2 >> half) * p->b_q15);
    }
    if (sum_q30 <= 0) return 0;
    return sum_q30 < (int32_t)1 << 30 ? (uint32_t)sum_q30 >> 15 : 32768;
}

static COMPARE_INLINE uint32_t rootless(const compare_lobe *lobe, compare_argument argument)
{
    return parabola(lobe, &lobe->refit, argument);
}

COMPARE_LOBE_SUM(compare_sum_chebyshev_rootless, rootless)

static COMPARE_INLINE uint32_t published(const compare_lobe *lobe, compare_argument argument)
{
    return parabola(lobe, &lobe->published, argument);
}

COMPARE_LOBE_SUM(compare_sum_chebyshev_published, published)

/* A = -(0.272 n + 0.16), B by four pieces, C = 1, as printed; in thousandths. */
static void published_prepare(compare_lobe *lobe, uint32_t n)
{
    uint32_t b, x_q30 = n << 20, half = 5;
    if (n <= 31)
        b = 18 * n + 158;
    else if (n <= 63)
        b = 10 * n + 380;
    else if (n <= 255)
        b = 5 * n + 700;
    else
        b = 3 * n + 1200;
    while (x_q30 < (uint32_t)1 << 28) x_q30 <<= 2, half--;            /* n = 4^half x */
    lobe->published.a_q15 = (uint16_t)((4563403 + 2684355 / n) >> 9); /* 0.272 and 0.16, Q24 */
    lobe->published.b_q15 = (uint16_t)(b * (lmb_rsqrt_q30(x_q30) >> 14) / 1000 >> (1 + half));
    lobe->published.c_q30 = (int32_t)1 << 30;
#if COMPARE_WITH_LIBM
    lobe->published_f[0] = (float)(272 * n + 160) * -0.001f;
    lobe->published_f[1] = (float)b * -0.001f;
#endif
}

/* c0 + c1 t + c2 t^2 + c3 t^3 in millionths, t = 1 / n; within 3e-6. */
static int32_t law_q30(const int32_t c[4], int32_t n)
{
    int32_t sum = 0, i;
    for (i = 3; i >= 0; i--) sum = sum / n + c[i] * 1073 + c[i] / 1000 * 742; /* 2^30 / 10^6 = 1073.742 */
    return sum;
}

/* The refits as laws: hosttest/papers/chebyshev.h; the test compares these numbers with what is fitted there. */
static void refit_prepare(compare_lobe *lobe, int32_t n)
{
    const int32_t a[4] = COMPARE_LAW_A, b[4] = COMPARE_LAW_B, c[4] = COMPARE_LAW_C;
    lobe->refit.a_q15 = (uint16_t)(law_q30(a, n) >> 15);
    lobe->refit.b_q15 = (uint16_t)(law_q30(b, n) >> 15);
    lobe->refit.c_q30 = law_q30(c, n);
}

void compare_angles_prepare(compare_lobe *lobe, unsigned n)
{
    gauss_prepare(lobe, n);
    published_prepare(lobe, n);
    refit_prepare(lobe, (int32_t)n);
    lobe->parabola_end_q30 = ((uint32_t)1 << 31) / n;
}
