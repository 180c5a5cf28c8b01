/* SPDX-License-Identifier: MIT */
/* Sine, cosine and rotation matrices from angles in 1/65536 of a turn. */
#include "flash.h"

#include "../tables/sine_table.h"

/* The sine before its last rounding: an odd polynomial over the quarter turn x in [0, 1), unfolded by symmetry. At x = 1 it
 * is one by decree, so that u stays within the 16 bits of lmb_mul_q16 and quarter turns are exact.
 *   u       x^2 in Q16, rounded, at most 65528; that moves the result by up to 0.57 * 2^-17, 0.07 units of Q14
 *   p       c[0] - u (c[1] - u (c[2] - u c[3])), Q30; every step lies in (0, 1.58), so that it fits
 *   return  x p in Q29, |.| <= 2^29 (1 + 2^-17)
 * A table with interpolation takes as long and more flash. */
static int32_t sine_wide_q29(uint16_t angle)
{
    int32_t x_q14 = angle & 0x3fff, p_q30 = sine_q30[3], s_q29 = 0x20000000;
    if (angle & 0x4000) x_q14 = lmb_sub(16384, x_q14);
    if (x_q14 < 16384) {
        uint32_t u_q16 = (uint32_t)lmb_shr_round(lmb_mul(x_q14, x_q14), 12);
        unsigned i;
        for (i = 3; i-- > 0;) p_q30 = lmb_sub(sine_q30[i], lmb_mul_q16(p_q30, u_q16));
        s_q29 = lmb_mul_q16(p_q30, (uint32_t)lmb_shl(x_q14, 1));
    }
    return angle & 0x8000 ? lmb_sub(0, s_q29) : s_q29;
}

/* Rounded to nearest, halves away from zero, so that an odd function stays exactly odd. */
static int16_t q14_of(int32_t a_q29)
{
    return (int16_t)(a_q29 < 0 ? lmb_sub(0, lmb_shr_round(lmb_sub(0, a_q29), 15)) : lmb_shr_round(a_q29, 15));
}

int32_t lmb_sin_q14(uint16_t angle) { return q14_of(sine_wide_q29(angle)); }

int32_t lmb_cos_q14(uint16_t angle) { return lmb_sin_q14((uint16_t)(angle + 0x4000u)); }

/* Turns the plane of two rows from the first towards the second. A matrix is built once for a picture, so that 64-bit
 * products may stay, and loops, where the nine elements written out take three times the code. Each sum is at most one, up to
 * 2^-16 or so, by Cauchy, since columns are unit and c^2 + s^2 is one. */
static void turn(int32_t *from_q29, int32_t *to_q29, uint16_t angle)
{
    int32_t s_q29 = sine_wide_q29(angle), c_q29 = sine_wide_q29((uint16_t)(angle + 0x4000u));
    unsigned i;
    for (i = 0; i < 3; i++) {
        int32_t a = from_q29[i], b = to_q29[i];
        from_q29[i] = lmb_sub(lmb_mul_shr(a, c_q29, 29), lmb_mul_shr(b, s_q29, 29));
        to_q29[i] = lmb_add(lmb_mul_shr(a, s_q29, 29), lmb_mul_shr(b, c_q29, 29));
    }
}

/* Rz Ry Rx; sines of 15 fraction bits would do with 32-bit products, and err 1.5 units of Q14. */
lmb_matrix lmb_rotation(uint16_t x, uint16_t y, uint16_t z)
{
    int32_t r_q29[3][3];
    lmb_matrix m;
    unsigned i, k;
    for (i = 0; i < 3; i++) /* not an initialiser: that would be copied from flash */
        for (k = 0; k < 3; k++) r_q29[i][k] = i == k ? 0x20000000 : 0;
    turn(r_q29[1], r_q29[2], x);
    turn(r_q29[2], r_q29[0], y);
    turn(r_q29[0], r_q29[1], z);
    for (i = 0; i < 3; i++) {
        m.row[i].x = q14_of(r_q29[i][0]);
        m.row[i].y = q14_of(r_q29[i][1]);
        m.row[i].z = q14_of(r_q29[i][2]);
    }
    return m;
}
