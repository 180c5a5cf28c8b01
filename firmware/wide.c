/* SPDX-License-Identifier: MIT */
/* Saturating 64-bit products, out of line: see arith.h. */
#include "lambent.h"

int32_t lmb_mul_shr_sat(int32_t a, int32_t b, unsigned s)
{
    int64_t r = ((int64_t)a * b) >> s;
#ifdef LMB_CHECKED
    lmb_count.multiplications++;
    if (s > 63) lmb_check_failed(__FILE__, __LINE__, "mul_shr_sat: distance", a, b, (int64_t)s);
#endif
    if (r > INT32_MAX) return INT32_MAX;
    return r < INT32_MIN ? INT32_MIN : (int32_t)r;
}
