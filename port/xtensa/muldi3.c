/* SPDX-License-Identifier: MIT */
/* The product of two 64-bit integers that compilers call for on a core with 32-bit products: some builds of libgcc for the LX106,
 * Debian 12's among them, lack it. From products of halves, modulo 2^64. */
#include <stdint.h>

int64_t __muldi3(int64_t a, int64_t b);

int64_t __muldi3(int64_t a, int64_t b)
{
    uint32_t a_high = (uint32_t)((uint64_t)a >> 32), b_high = (uint32_t)((uint64_t)b >> 32);
    uint32_t a_low = (uint32_t)a, b_low = (uint32_t)b;
    uint32_t a0 = a_low & 0xffff, a1 = a_low >> 16, b0 = b_low & 0xffff, b1 = b_low >> 16;
    uint32_t low = a0 * b0, middle = a1 * b0 + (low >> 16), other = a0 * b1 + (middle & 0xffff);
    uint32_t high = a1 * b1 + (middle >> 16) + (other >> 16) + a_low * b_high + a_high * b_low;
    return (int64_t)((uint64_t)high << 32 | other << 16 | (low & 0xffff));
}
