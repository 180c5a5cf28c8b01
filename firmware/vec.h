/* SPDX-License-Identifier: MIT */
/* Vectors by address: where they lie in memory, passing them by value would copy them twice. Inside the library only. */
#ifndef LMB_VEC_H
#define LMB_VEC_H

#include "lambent.h"

/* What the functions of lambent.h with the same names do. */
int32_t lmb_vec_dot_q28(const lmb_vec *a, const lmb_vec *b);
int32_t lmb_vec_half_distance_q28(const lmb_vec *a, const lmb_vec *b);
void lmb_vec_normalise(lmb_vec *unit, int32_t x, int32_t y, int32_t z);

/* Turns a vector back in its place: a unit vector, as nothing saturates. */
void lmb_vec_rotate_back(const lmb_matrix *m, lmb_vec *v);

/* By components, as for six bytes compilers call memcpy; unsigned ones, which every core loads in one instruction. */
static inline void lmb_vec_copy(lmb_vec *to, const lmb_vec *from)
{
    const uint16_t *f = (const uint16_t *)from;
    uint16_t *t = (uint16_t *)to;
    t[0] = f[0];
    t[1] = f[1];
    t[2] = f[2];
}
LMB_STATIC_ASSERT(sizeof(lmb_vec) == 6);

#endif
