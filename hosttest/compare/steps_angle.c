/* SPDX-License-Identifier: MIT */
/* Kuijk and Blake's spans: the angle between the normal and the ray's shadow runs linearly, and each pixel takes its cosine.
 *
 * Per line, as in the paper: with k = (b - a cos psi) / sin psi the shadow lies atan2(k, a) past the first normal and is
 * sqrt(a^2 + k^2) long. Both, and psi itself, are what CORDIC's vectoring gives in one go. */
#include "steps_parts.h"

enum { TURNS = 18 };

/* atan(2^-i), 2^32 to a turn */
static const uint32_t turn_by[TURNS] = {536870912, 316933406, 167458907, 85004756, 42667331, 21354465, 10679838, 5340245, 2670163,
                                        1335087,   667544,    333772,    166886,   83443,    41722,    20861,    10430,   5215};

/* Turns (x, y), up to 1.2 long in Q28, onto the x axis: returns the angle, and in *x its length times 1.64676. */
static uint32_t vectoring(int32_t *x, int32_t y)
{
    uint32_t angle = 0;
    unsigned i;
    if (*x < 0) {
        *x = -*x;
        y = -y;
        angle = 0x80000000;
    }
    for (i = 0; i < TURNS; i++) {
        const int32_t across = *x >> i, along = y >> i;
        const bool up = y < 0;
        *x += up ? -along : along;
        y += up ? across : -across;
        angle += up ? 0u - turn_by[i] : turn_by[i];
    }
    return angle;
}

/* rise / sin(psi), where it is at most 1.06 but for rounding, by the library's reciprocal: a 64-bit division is a long call. */
static int32_t over_sine(int32_t rise_q28, uint32_t sine_q28)
{
    unsigned shift;
    const uint32_t inverse = lmb_reciprocal(sine_q28, &shift); /* 2^(31 + shift) / sine */
    const int64_t k_q28 = ((int64_t)rise_q28 * (int32_t)inverse) >> (3 + shift);
    return k_q28 > 0x11000000 ? 0x11000000 : k_q28 < -0x11000000 ? -0x11000000 : (int32_t)k_q28;
}

void compare_begin_kuijk_blake(compare_step_state *state, lmb_vec from, lmb_vec to, lmb_vec ray, unsigned pixels)
{
    const int32_t u_q28 = lmb_vec_half_distance_q28(&from, &to), a = compare_dot_q28(from, ray), b = compare_dot_q28(to, ray);
    /* sin^2 psi = u (2 - u): two roots of 16 bits keep small angles where one of the product would not */
    const uint32_t room_q28 = u_q28 < 0x20000000 ? 0x20000000u - (uint32_t)u_q28 : 0;
    const uint32_t sine_q28 = compare_root((uint32_t)u_q28 << 2) * compare_root(room_q28 << 1) / 23170 << 13;
    int32_t cosine_q28 = 0x10000000 - u_q28, k_q28 = 0, x = cosine_q28;
    uint32_t psi;
    if (sine_q28 > 0) k_q28 = over_sine(b - a + lmb_mul_shr(u_q28, a, 28), sine_q28);
    psi = vectoring(&x, (int32_t)sine_q28);
    x = a;
    state->as.angle.angle = 0u - vectoring(&x, k_q28);
    state->as.angle.step = (psi < 0xf0000000 ? psi : 0) / pixels;
    state->as.angle.amplitude = (int32_t)(((int64_t)x * 9949) >> 28); /* over 1.64676 */
}

COMPARE_APART void compare_run_kuijk_blake(compare_step_state *state, int32_t *out, unsigned count)
{
    const uint32_t step = state->as.angle.step;
    const int32_t amplitude = state->as.angle.amplitude, *end = out + count;
    uint32_t angle = state->as.angle.angle + 0x8000; /* half a unit of the sine's */
    do {
        *out++ = lmb_cos_q14((uint16_t)(angle >> 16)) * amplitude;
        angle += step;
    } while (out != end);
}
