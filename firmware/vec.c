/* SPDX-License-Identifier: MIT */
/* Unit vectors and rotations in Q2.14, in 32-bit products alone. */
#include "vec.h"

/* Vectors up to 1.41 long pass here and below: each partial sum is at most |a| |b| < 2^29 by Cauchy. */
int32_t lmb_vec_dot_q28(const lmb_vec *a, const lmb_vec *b)
{
    const int16_t *p = (const int16_t *)a, *q = (const int16_t *)b;
    int32_t sum = 0;
    unsigned i;
    LMB_UNROLL
    for (i = 0; i < 3; i++) sum = lmb_add(sum, lmb_mul16(p[i], q[i]));
    return sum;
}

int32_t lmb_dot_q28(lmb_vec a, lmb_vec b) { return lmb_vec_dot_q28(&a, &b); }

/* |a - b|^2 is at most (2 * 1.41)^2 < 8 in Q28. A component of the difference can be 32768, one too many for lmb_mul16. */
int32_t lmb_vec_half_distance_q28(const lmb_vec *a, const lmb_vec *b)
{
    int32_t x = lmb_sub(a->x, b->x), y = lmb_sub(a->y, b->y), z = lmb_sub(a->z, b->z);
    return lmb_shr(lmb_add(lmb_add(lmb_mul(x, x), lmb_mul(y, y)), lmb_mul(z, z)), 1);
}

int32_t lmb_half_distance_q28(lmb_vec a, lmb_vec b) { return lmb_vec_half_distance_q28(&a, &b); }

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
