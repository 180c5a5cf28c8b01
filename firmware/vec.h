/* SPDX-License-Identifier: MIT */
/* Vectors by address: where they lie in memory, passing them by value would copy them twice. Inside the library only. */
#ifndef LMB_VEC_H
#define LMB_VEC_H

#include "lambent.h"

/* What the functions of lambent.h with the same names do. */
int32_t lmb_vec_dot_q28(const lmb_vec *a, const lmb_vec *b);
int32_t lmb_vec_half_distance_q28(const lmb_vec *a, const lmb_vec *b);
void lmb_vec_normalise(lmb_vec *unit, int32_t x, int32_t y, int32_t z);
void lmb_vec_rotate_wide(const lmb_matrix *m, const lmb_vec *v, int32_t out[3]);

/* Turns a vector back in its place. */
void lmb_vec_rotate_back(const lmb_matrix *m, lmb_vec *v);

/* Member by member: for six bytes compilers call memcpy. */
static inline void lmb_vec_copy(lmb_vec *to, const lmb_vec *from)
{
    to->x = from->x;
    to->y = from->y;
    to->z = from->z;
}

#endif
