/* SPDX-License-Identifier: MIT */
/* Colours and highlights of looks. Inside the library and its filler only. */
#ifndef LMB_LOOK_H
#define LMB_LOOK_H

#include "power.h"

/* Material times light, or, without light, the material's colour as it is: UQ1.15, rounded to nearest. */
void lmb_colour_fold(uint16_t out[3], const lmb_rgb *material, const lmb_rgb *light);

/* What a ramp holds at v = 1 - N.H, UQ1.15: the power itself, or the lobe of paper 000 where that was asked for. */
static inline int32_t lmb_highlight_q15(const lmb_look *look, int32_t v_q30)
{
    if (LMB_WITH_LOBES && look->lobe.error_uq16 == 65535) return lmb_lobe_eval(&look->lobe, v_q30);
    return lmb_power_q15(look->lobe.shininess, v_q30);
}

#endif
