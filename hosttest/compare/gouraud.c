/* SPDX-License-Identifier: MIT */
/* Gouraud shading in integers: diffuse and specular light at each vertex once, saturated there, and three channels linear over
 * the triangle. A pixel is three additions and a store. */
#include "methods.h"

#include "colour.h"
#include "planes.h"

static COMPARE_INLINE uint32_t saturate(uint32_t x, uint32_t most) { return x < most ? x : most; }

/* Red, green and blue: the level in the upper 5, 6 and 5 of 16 bits, half a level added, below 32 and 64. */
static COMPARE_INLINE void light(const compare_span *span, lmb_vec normal, int32_t rgb[3])
{
    const compare_look *look = span->look;
    int32_t d = compare_dot(span->direction, normal) >> 14, h = compare_dot(span->half, normal) >> 14;
    uint32_t diffuse = d > 0 ? (uint32_t)(d + 32) >> 6 : 0, specular = 0, rb, g;
    if (h > (int32_t)(COMPARE_DARK * 16384)) {
        specular = (uint32_t)h * (uint32_t)h >> 14;
        specular = specular * specular >> 14;
        specular = specular * specular >> 14;
        specular = (specular * specular + ((uint32_t)1 << 19)) >> 20;
    }
    rb = look->ambient_rb + look->diffuse_rb * diffuse + look->specular_rb * specular;
    g = look->ambient_g + look->diffuse_g * diffuse + look->specular_g * specular;
    rgb[0] = (int32_t)saturate(rb >> 16, 63 * 512) * 2;
    rgb[1] = (int32_t)saturate(g >> 16, 127 * 256) * 2;
    rgb[2] = (int32_t)saturate(rb & 0xffffu, 63 * 512) * 2;
}

COMPARE_APART void compare_fill_gouraud(const compare_span *span, uint16_t *pixel, unsigned length)
{
    uint32_t r = (uint32_t)span->value[0], g = (uint32_t)span->value[1], b = (uint32_t)span->value[2];
    const uint32_t r_step = (uint32_t)span->step[0], g_step = (uint32_t)span->step[1], b_step = (uint32_t)span->step[2];
    uint16_t *end = pixel + length;
    do {
        COMPARE_TAP(r / 134217728.0, g / 67108864.0, b / 134217728.0);
        *pixel++ = (uint16_t)((r >> 16 & 0xf800u) | (g >> 21 & 0x7e0u) | b >> 27);
        r += r_step;
        g += g_step;
        b += b_step;
    } while (pixel != end);
}

void compare_begin_gouraud(compare_span *span, const compare_look *look, lmb_vec from, lmb_vec to, unsigned length)
{
    int32_t a[3], b[3];
    int k;
    compare_span_look(span, look, NULL);
    light(span, from, a);
    light(span, to, b);
    for (k = 0; k < 3; k++) compare_span_value(span, k, a[k], b[k], length);
}

uint32_t compare_draw_gouraud(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose, const compare_look *look,
                              const lmb_vertex *vertices, compare_room *room)
{
    compare_span span;
    unsigned i;
    if (!compare_inside(surface, vertices, mesh->vertices)) return 0;
    compare_span_look(&span, look, pose);
    for (i = 0; i < mesh->vertices; i++) light(&span, vertices[i].normal, room[i].q);
    return compare_draw_planes(surface, mesh, vertices, room, &span, 3, compare_fill_gouraud);
}
