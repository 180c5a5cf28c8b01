/* SPDX-License-Identifier: MIT */
/* Material, light and power tables of the comparisons. */
#include "powers.h"

#include "colour.h"

/* A material's channel under a light, times one, rounded to nearest. */
static uint32_t coefficient(uint32_t material, uint32_t light, uint64_t one)
{
    return (uint32_t)((material * light * one + 255ul * 255 / 2) / (255ul * 255));
}

/* A channel whose ambient and diffuse light exceed one: then a highlight could reach past the guard bits. */
static bool too_bright(uint32_t ambient, uint32_t diffuse, uint32_t light)
{
    return ambient * 255 + diffuse * light > 255ul * 255;
}

/* A colour of the ramps: see colour.h. Each channel in its fraction's units; diffuse and specular times part / whole. */
static uint32_t ramp_colour(const uint32_t ambient[3], const uint32_t light[3], uint32_t part, uint32_t whole)
{
    uint32_t c[3];
    int k;
    for (k = 0; k < 3; k++) c[k] = (uint32_t)((ambient[k] + (uint64_t)light[k] * part / whole + (1ul << 15)) >> 16);
    return c[1] << 20 | c[0] << 10 | c[2];
}

/* The full intensity of a channel in a ramp, with 16 more fraction bits: 31 or 63 levels of 16 or 32. */
static void ramp_channels(uint32_t out[3], const lmb_rgb *material, const lmb_rgb *light)
{
    out[0] = coefficient(material->r, light->r, 31ull << 20);
    out[1] = coefficient(material->g, light->g, 63ull << 21);
    out[2] = coefficient(material->b, light->b, 31ull << 20);
}

static void ramps(compare_look *look, const lmb_material *material, const lmb_rgb *light,
                  const uint16_t power_q15[COMPARE_POWERS])
{
    static const lmb_rgb white = {255, 255, 255};
    static const uint32_t none[3] = {0, 0, 0};
    uint32_t ambient[3], diffuse[3], specular[3];
    uint32_t i;
    ramp_channels(ambient, &material->ambient, &white);
    ramp_channels(diffuse, &material->diffuse, light);
    ramp_channels(specular, &material->specular, light);
    ambient[0] += 1ul << 19; /* half a level */
    ambient[1] += 1ul << 20;
    ambient[2] += 1ul << 19;
    look->unlit = ramp_colour(ambient, none, 0, 1);
    for (i = 0; i < COMPARE_POWERS; i++) {
        look->diffuse_ramp[i] = ramp_colour(ambient, diffuse, 2 * i + 1, 2 * COMPARE_POWERS);
        look->specular_ramp[i] = ramp_colour(none, specular, power_q15[i], 32768);
    }
}

int compare_look_prepare(compare_look *look, const lmb_material *material, const lmb_light *light)
{
    const lmb_rgb *a = &material->ambient, *d = &material->diffuse, *s = &material->specular, *l = &light->colour;
    uint16_t power[COMPARE_POWERS];
    int i;
    if (material->shininess != COMPARE_SHININESS || too_bright(a->r, d->r, l->r) || too_bright(a->g, d->g, l->g) ||
        too_bright(a->b, d->b, l->b)) {
        return LMB_ERROR_VALUE;
    }
    look->direction = light->direction;
    look->half = lmb_normalise(light->direction.x, light->direction.y, light->direction.z + 16384l);
    look->ambient_rb = coefficient(a->r, 255, 31 * 1024) << 16 | coefficient(a->b, 255, 31 * 1024);
    look->ambient_rb += COMPARE_RB_HALF;
    look->ambient_g = coefficient(a->g, 255, 63ull << 25) + COMPARE_G_HALF;
    look->diffuse_rb = coefficient(d->r, l->r, COMPARE_RB_ONE) << 16 | coefficient(d->b, l->b, COMPARE_RB_ONE);
    look->diffuse_g = coefficient(d->g, l->g, COMPARE_G_ONE);
    look->specular_rb = coefficient(s->r, l->r, COMPARE_RB_ONE) << 16 | coefficient(s->b, l->b, COMPARE_RB_ONE);
    look->specular_g = coefficient(s->g, l->g, COMPARE_G_ONE);
    compare_powers(power, COMPARE_SHININESS);
    for (i = 0; i < COMPARE_POWERS; i++) look->power[i] = (uint8_t)((power[i] * 255ul + 16384) >> 15);
    ramps(look, material, l, power);
    return LMB_OK;
}

void compare_powers(uint16_t power_q15[COMPARE_POWERS], unsigned n)
{
    unsigned i, k;
    for (i = 0; i < COMPARE_POWERS; i++) {
        uint64_t p = 1ull << 40; /* products are truncated at 2^-40: 1000 of them lose less than 2^-30 */
        for (k = 0; k < n; k++) p = p * i / (COMPARE_POWERS - 1);
        power_q15[i] = (uint16_t)((p + (1ul << 24)) >> 25);
    }
}
