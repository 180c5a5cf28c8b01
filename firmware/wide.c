/* SPDX-License-Identifier: MIT */
/* Leading zeros and 64-bit products, out of line: see arith.h. */
#include "lambent.h"

unsigned lmb_clz32_search(uint32_t x)
{
    unsigned n = 32, step;
    LMB_UNROLL
    for (step = 16; step > 0; step >>= 1) {
        if (x >> step == 0) continue;
        n -= step;
        x >>= step;
    }
    return n - (unsigned)x;
}

/* The whole product. Where 64 bits are a call, four products of halves take less room and time: with h 2^16 + l for a and b, each
 * of the two middle sums is at most 2^15 (2^16 - 1) + 2^16 - 1 < 2^31. */
int64_t lmb_mul_wide(int32_t a, int32_t b)
{
    if (LMB_LONG_PRODUCTS) return (int64_t)a * b;
    int32_t a_low = a & 0xffff, b_low = b & 0xffff, a_high = a >> 16, b_high = b >> 16;
    uint32_t low = (uint32_t)a_low * (uint32_t)b_low;
    int32_t middle = a_high * b_low + (int32_t)(low >> 16);
    int32_t other = a_low * b_high + (middle & 0xffff);
    int32_t high = a_high * b_high + (middle >> 16) + (other >> 16);
    return (int64_t)((uint64_t)(uint32_t)high << 32 | (uint32_t)other << 16 | (low & 0xffffu));
}

int32_t lmb_mul_shr_sat(int32_t a, int32_t b, unsigned s)
{
    int64_t r = lmb_mul_wide(a, b) >> s;
#ifdef LMB_CHECKED
    lmb_count.multiplications++;
    if (s > 63) lmb_check_failed(__FILE__, __LINE__, "mul_shr_sat: distance", a, b, (int64_t)s);
#endif
    if (r > INT32_MAX) return INT32_MAX;
    return r < INT32_MIN ? INT32_MIN : (int32_t)r;
}
