/* SPDX-License-Identifier: MIT */
/* Colours of the comparisons in packed integers: ambient + diffuse d + specular s with d and s in 1/256, red and blue by one
 * product. Each field has a guard bit above it, since the three together may exceed one.
 *
 *   rb   red in bits 31-16, blue in bits 15-0: guard, level (5 bits), fraction (10 bits)
 *   g    guard, level (6 bits), fraction (25 bits)
 * Half a level is in ambient, so that levels are rounded to nearest. A coefficient is its level times 1/256 in the same scale:
 * 124 or 63 * 2^17 for full intensity, so red and blue err by up to 1/8 level a part, green by none.
 */
#ifndef COMPARE_COLOUR_H
#define COMPARE_COLOUR_H

#include "walk.h"

#define COMPARE_RB_ONE 124          /* full intensity as a coefficient of red and blue: 31 * 1024 / 256 */
#define COMPARE_G_ONE (63ul << 17)  /* of green: 63 * 2^25 / 256 */
#define COMPARE_RB_HALF 0x02000200u /* half a level */
#define COMPARE_G_HALF 0x01000000u

/* Who wants to know what a frame is before it is rounded (hosttest/pareto) is told each pixel as it is packed, in levels of 31,
 * 63 and 31. */
#ifdef COMPARE_TAPPED
void compare_tap(double red, double green, double blue);
#define COMPARE_TAP(red, green, blue) compare_tap((red)-0.5, (green)-0.5, (blue)-0.5)
#else
#define COMPARE_TAP(red, green, blue) ((void)0)
#endif

/* Ambient and diffuse light, diffuse in 1/256 from 0 to 256: the guards stay clear (compare_look_prepare). */
static COMPARE_INLINE void compare_diffuse(const compare_look *look, uint32_t diffuse, uint32_t *rb, uint32_t *g)
{
    *rb = look->ambient_rb + look->diffuse_rb * diffuse;
    *g = look->ambient_g + look->diffuse_g * diffuse;
}

/* A highlight on top, saturated: a guard less itself shifted down fills the level below it. */
static COMPARE_INLINE void compare_specular(const compare_look *look, uint32_t specular, uint32_t *rb, uint32_t *g)
{
    uint32_t r_b = *rb + look->specular_rb * specular, green = *g + look->specular_g * specular;
    if (((r_b | (green & 0x80000000u)) & 0x80008000u) != 0) {
        const uint32_t over = r_b & 0x80008000u, over_g = green & 0x80000000u;
        r_b |= over - (over >> 5);
        green |= over_g - (over_g >> 6);
    }
    *rb = r_b;
    *g = green;
}

/* What the guards hold does not matter. */
static COMPARE_INLINE uint16_t compare_pack(uint32_t rb, uint32_t g)
{
    COMPARE_TAP((rb >> 16) / 1024.0, g / 33554432.0, (rb & 0xffffu) / 1024.0);
    return (uint16_t)((rb >> 15 & 0xf800u) | (g >> 20 & 0x7e0u) | (rb >> 10 & 31u));
}

/* Colours of ramps, all three in a word: guard, level and fraction (4 bits; green 5). Green from bit 20, red from 10, blue
 * from 0. The sum of two, saturated. */
static COMPARE_INLINE uint32_t compare_ramp_sum(uint32_t a, uint32_t b)
{
    uint32_t sum = a + b, over = sum & 0x80080200u;
    return over ? sum | (over - (over >> 6)) : sum;
}

static COMPARE_INLINE uint16_t compare_ramp_pack(uint32_t c)
{
    COMPARE_TAP((c >> 10 & 0x3ffu) / 16.0, (c >> 20) / 32.0, (c & 0x3ffu) / 16.0);
    return (uint16_t)((c >> 3 & 0xf800u) | (c >> 20 & 0x7e0u) | (c >> 4 & 31u));
}

#endif
