/* SPDX-License-Identifier: MIT */
/* Unit vectors and rotations in Q2.14, and the reciprocal square root, in 32-bit products alone. */
#include "flash.h"

#include "vec.h"

#include "../tables/rsqrt_table.h"

/* Vectors up to 1.41 long pass here and below: each partial sum is at most |a| |b| < 2^29 by Cauchy. */
int32_t lmb_vec_dot_q28(const lmb_vec *a, const lmb_vec *b)
{
    return lmb_add(lmb_add(lmb_mul16(a->x, b->x), lmb_mul16(a->y, b->y)), lmb_mul16(a->z, b->z));
}

int32_t lmb_dot_q28(lmb_vec a, lmb_vec b) { return lmb_vec_dot_q28(&a, &b); }

/* |a - b|^2 is at most (2 * 1.41)^2 < 8 in Q28. A component of the difference can be 32768, one too many for lmb_mul16. */
int32_t lmb_vec_half_distance_q28(const lmb_vec *a, const lmb_vec *b)
{
    int32_t x = lmb_sub(a->x, b->x), y = lmb_sub(a->y, b->y), z = lmb_sub(a->z, b->z);
    return lmb_shr(lmb_add(lmb_add(lmb_mul(x, x), lmb_mul(y, y)), lmb_mul(z, z)), 1);
}

int32_t lmb_half_distance_q28(lmb_vec a, lmb_vec b) { return lmb_vec_half_distance_q28(&a, &b); }

/* Two steps of Newton's method, y <- y (1 + h/2) with h = 1 - x y^2. A product that is known to be nearly one needs its low
 * word alone to give h, where a 64-bit product is a call on cores like M0+.
 *   y0    table, 9 bits; |h0| < 2^-5.9 (tables/gen_rsqrt.c), below 2^30.1 in Q36: the low word holds it
 *   h0    has 2^-13 added: Newton's step falls short by 3/8 h0^2, 0 to 2^-13.2, and so by half of that, either way
 *   y1    Q14 in (2^14, 2^15); with its rounding |h1| < 2^-12.7, below 2^29.3 in Q42
 *   t     x y1, Q28
 *   h1    1 - t y1, Q42; from bit 15 on times y1: below 2^14.3 * 2^15; outside the domain 2^16 * 2^14.1
 * What remains is 3/8 h1^2 and the roundings of t and h1. */
LMB_STATIC_ASSERT(sizeof rsqrt_table == 128 - 32);
uint32_t lmb_rsqrt_q30(uint32_t x)
{
    uint32_t place = (x >> 23) - 32, y0_q8 = 256u + rsqrt_table[place < 96 ? place : 95];
    int32_t h0_q36 = lmb_signed(((uint32_t)1 << 23) - (x >> 10) * lmb_mulu(y0_q8, y0_q8));
    int32_t y1_q14 = (int32_t)(y0_q8 << 6) + lmb_shr(lmb_mul(lmb_shr(h0_q36, 9), (int32_t)y0_q8), 22);
    int32_t t_q28 = lmb_mul_q16(lmb_signed(x), (uint32_t)y1_q14);
    int32_t h1_q42 = lmb_mul_wrap(lmb_sub(0, t_q28), y1_q14); /* wraps: 2^42, one, is 0 in the low word */
    return ((uint32_t)y1_q14 << 16) + (uint32_t)lmb_shr(lmb_mul(lmb_shr(h1_q42, 15), y1_q14), 12);
}

/* a^2 / 2^32, too small by less than 1.5; |a| <= 2^30. With a = high 2^15 + low, low^2 is left out. */
static int32_t square_q28(int32_t a_q30)
{
    int32_t high = lmb_shr(a_q30, 15), low = a_q30 & 0x7fff;
    return lmb_shr(lmb_add(lmb_mul(high, high), lmb_shr(lmb_mul(high, low), 14)), 2);
}

/* a r / 2^(31 + down), rounded to nearest; r < 2^31. The product before its rounding is too small by less than 2, and at
 * most 2^30 (1 + 2^-24), since it is a component over the length. */
static int16_t scale(int32_t a_q30, uint32_t r_q30, unsigned down)
{
    int32_t rest = lmb_shr(lmb_mul(lmb_shr(a_q30, 15), (int32_t)(r_q30 & 0x7fff)), 16);
    return (int16_t)lmb_shr_round(lmb_add(lmb_mul_q16(a_q30, r_q30 >> 15), rest), down);
}

/* All components are shifted up by one distance, so that the largest lies in [2^29, 2^30] and nothing is lost; the one's
 * complement stands for the magnitude of a negative one, which lets -2^30 through as well.
 *   s     |a|^2 / 2^32 + 4 - less than 4.5, so never under 2^26; at most 3 * 2^28 + 4
 *   r     from s or 4 s, whichever lies in [2^28, 2^30)
 * s is off by at most 4 in 2^26, which moves r by 2^-25, and r by LMB_RSQRT_MAX_ERROR: together under 2^-24.4, or 2^-10.4
 * units of the result beyond its rounding. */
void lmb_vec_normalise(lmb_vec *unit, int32_t x, int32_t y, int32_t z)
{
    unsigned up, down = 16;
    int32_t s_q28;
    uint32_t r_q30;
    if ((x | y | z) == 0) z = 1;
    up = lmb_clz32((uint32_t)((x ^ lmb_shr(x, 31)) | (y ^ lmb_shr(y, 31)) | (z ^ lmb_shr(z, 31)))) - 2;
    x = lmb_shl(x, up);
    y = lmb_shl(y, up);
    z = lmb_shl(z, up);
    s_q28 = lmb_add(lmb_add(lmb_add(square_q28(x), square_q28(y)), square_q28(z)), 4);
    if (s_q28 < 0x10000000) {
        s_q28 = lmb_shl(s_q28, 2);
        down = 15;
    }
    r_q30 = lmb_rsqrt_q30((uint32_t)s_q28);
    unit->x = scale(x, r_q30, down);
    unit->y = scale(y, r_q30, down);
    unit->z = scale(z, r_q30, down);
}

lmb_vec lmb_normalise(int32_t x, int32_t y, int32_t z)
{
    lmb_vec unit;
    lmb_vec_normalise(&unit, x, y, z);
    return unit;
}

/* |row| <= 1.01 * 2^14 and |v| <= 2^15 sqrt(3): every partial sum is under 1.01 * 2^29 sqrt(3) < 2^30 by Cauchy. */
void lmb_rotate_wide(const lmb_matrix *m, lmb_vec v, int32_t out[3])
{
    unsigned i;
    for (i = 0; i < 3; i++) out[i] = lmb_vec_dot_q28(&m->row[i], &v);
}

/* Turns v by a matrix whose elements follow one another at `across` in a row and at `down` in a column: 1 and 3 as it is, 3 and 1
 * transposed. */
static void rotate(const lmb_matrix *m, unsigned across, unsigned down, lmb_vec *v)
{
    const int16_t *e = (const int16_t *)m;
    int16_t *to = (int16_t *)v;
    int32_t x = v->x, y = v->y, z = v->z;
    unsigned i;
    for (i = 0; i < 3; i++, e += down) {
        int32_t wide = lmb_add(lmb_add(lmb_mul16(e[0], x), lmb_mul16(e[across], y)), lmb_mul16(e[2 * across], z));
        to[i] = (int16_t)lmb_max(lmb_min(lmb_shr_round(wide, 14), INT16_MAX), INT16_MIN);
    }
}
LMB_STATIC_ASSERT(sizeof(lmb_matrix) == 9 * sizeof(int16_t));

lmb_vec lmb_rotate(const lmb_matrix *m, lmb_vec v)
{
    rotate(m, 1, 3, &v);
    return v;
}

lmb_vec lmb_rotate_back(const lmb_matrix *m, lmb_vec v)
{
    rotate(m, 3, 1, &v);
    return v;
}

void lmb_vec_rotate_back(const lmb_matrix *m, lmb_vec *v)
{
    const int16_t *e = (const int16_t *)m;
    int16_t *to = (int16_t *)v;
    int32_t x = v->x, y = v->y, z = v->z;
    unsigned i;
    for (i = 0; i < 3; i++, e++) {
        *to++ = (int16_t)lmb_shr_round(lmb_add(lmb_add(lmb_mul16(e[0], x), lmb_mul16(e[3], y)), lmb_mul16(e[6], z)), 14);
    }
}
