/* SPDX-License-Identifier: MIT */
/* cos^n by squarings over the bits of n. Inside the library only. */
#ifndef LMB_POWER_H
#define LMB_POWER_H

#include "lambent.h"

/* max(0, 1 - v)^n.
 *   n       1 to LMB_SHININESS_MAX
 *   v_q30   1 - cos, Q2.30, not below zero
 *   return  UQ1.15, to nearest; error beyond that under 3e-6 */
int32_t lmb_power_q15(unsigned n, int32_t v_q30);

#endif
