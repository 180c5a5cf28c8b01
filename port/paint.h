/* SPDX-License-Identifier: MIT */
/* Colours as pixels of RGB565, once for all. Inside the filler only. */
#ifndef LMB_PAINT_H
#define LMB_PAINT_H

#include "fill.h"

/* base, which may be NULL, plus q15 times the coefficients, all UQ1.15, saturated and rounded to nearest. */
uint16_t lmb_shade_565(const uint16_t base[3], const uint16_t coefficient[3], uint32_t q15);

#endif
