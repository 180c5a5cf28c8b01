/* SPDX-License-Identifier: MIT */
/* The power table of the comparisons. Inside hosttest/compare/ only. */
#ifndef COMPARE_POWERS_H
#define COMPARE_POWERS_H

#include "compare.h"

/* (i / 255)^n, UQ1.15, rounded to nearest. */
void compare_powers(uint16_t power_q15[COMPARE_POWERS], unsigned n);

#endif
