/* SPDX-License-Identifier: MIT */
/* Set-ups of the recurrences as paper 001 gives them, for comparison with lmb_arc: see arc.h. */
#include "lambent.h"

/* cos(phi) and the term one pixel before its start, f(-1) = a cos(phi) - (rise + u a) sin(phi) / sin(psi), both Q2.30.
 * The amplitude is at most 1.06, so each product and sum is under two; beyond LMB_ARC_U_MAX the term is linear, and
 * f(-1) is held inside two. */
static int32_t begin(int32_t u_q28, uint32_t length, int32_t a_q30, int32_t rise_q30, int32_t *before_q30)
{
    const int32_t turn_q28 = u_q28 <= LMB_ARC_U_MAX ? u_q28 : 0;
    const lmb_turn turn = lmb_arc_turn(u_q28, length);
    int32_t cosine_q30 = lmb_signed(0x40000000u - (turn.kappa_q30 >> 1));
    int32_t across = lmb_add(lmb_shr(rise_q30, 1), lmb_mul_shr(turn_q28, a_q30, 29)); /* these are halves, to leave room */
    int32_t before = lmb_sub(lmb_mul_shr(a_q30, cosine_q30, 31), lmb_mul_shr(across, (int32_t)turn.sine_q30, 30));
    *before_q30 = lmb_mul(lmb_max(lmb_min(before, 0x3fffffff), -0x3fffffff), 2);
    return cosine_q30;
}

/* Q2.30 to Q2.14, rounded to nearest; just under two at most. */
static int32_t to_q14(int32_t x_q30) { return lmb_min(lmb_shr_round(lmb_shr(x_q30, 1), 15), 32767); }

void lmb_plain16_prepare(lmb_plain16 *term, int32_t u_q28, uint32_t length, int32_t a_q30, int32_t rise_q30)
{
    int32_t before_q30, cosine_q30 = begin(u_q28, length, a_q30, rise_q30, &before_q30);
    term->f = to_q14(a_q30);
    term->before = to_q14(before_q30);
    term->twice_cos = lmb_shr_round(cosine_q30, 15); /* up to 32768, two */
}

void lmb_plain32_prepare(lmb_plain32 *term, int32_t u_q28, uint32_t length, int32_t a_q30, int32_t rise_q30)
{
    term->cosine = begin(u_q28, length, a_q30, rise_q30, &term->before);
    term->f = a_q30;
}

void lmb_block4_prepare(lmb_block4 *term, int32_t u_q28, uint32_t length, int32_t a_q30, int32_t rise_q30)
{
    int32_t before_q30, c_q30 = begin(u_q28, length, a_q30, rise_q30, &before_q30);
    int32_t c2_q29 = lmb_sub(lmb_mul_shr(c_q30, c_q30, 30), 0x20000000); /* cos(2 phi) = 2 cos^2(phi) - 1 */
    term->f = to_q14(a_q30);
    term->before = to_q14(before_q30);
    term->twice_cos = lmb_shr_round(c_q30, 15);
    term->twice_cos2 = lmb_shr_round(c2_q29, 14);
}
