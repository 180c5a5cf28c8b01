/* SPDX-License-Identifier: MIT */
/* Phong shading in integers: the normal runs linearly, and each pixel takes a square root, a division, two dot products and four
 * squarings.
 *
 * What is not lit at all (a third of a lit sphere's pixels, beyond the terminator) is told by the dot products before the root,
 * and where the highlight is under a quarter of a level no power is taken: what an author does who has looked at the picture.
 */
#include "methods.h"

#include "colour.h"
#include "planes.h"

/* One bit of a root: x is what is left of the argument, r the root so far, shifted. */
static COMPARE_INLINE uint32_t root_bit(uint32_t *x, uint32_t r, unsigned shift)
{
    uint32_t t = r + ((uint32_t)1 << shift);
    r >>= 1;
    if (*x < t) return r;
    *x -= t;
    return r + ((uint32_t)1 << shift);
}

/* floor(sqrt(x)) of x in [2^22, 2^24): the usual method, a bit a time, unrolled; the first bit is known. */
static COMPARE_INLINE uint32_t root(uint32_t x)
{
    uint32_t r = (uint32_t)1 << 22;
    x -= r;
    r = root_bit(&x, r, 20);
    r = root_bit(&x, r, 18);
    r = root_bit(&x, r, 16);
    r = root_bit(&x, r, 14);
    r = root_bit(&x, r, 12);
    r = root_bit(&x, r, 10);
    r = root_bit(&x, r, 8);
    r = root_bit(&x, r, 6);
    r = root_bit(&x, r, 4);
    r = root_bit(&x, r, 2);
    return root_bit(&x, r, 0);
}

/* cos^16 of UQ1.15, in 1/256 */
static COMPARE_INLINE uint32_t power_16(uint32_t c)
{
    c = c * c >> 15;
    c = c * c >> 15;
    c = c * c >> 15;
    c = c * c >> 15;
    return (c + 64) >> 7;
}

/* The pixel of a normal (Q2.14) that is at least half as long as a unit one. 12 bits of its length will do: that is an eighth of
 * a level of the highlight. */
static COMPARE_INLINE uint16_t shade(const compare_span *span, int32_t nx, int32_t ny, int32_t nz)
{
    const int32_t *direction = span->direction, *half = span->half;
    int32_t d = (nx * direction[0] + ny * direction[1] + nz * direction[2]) >> 14;
    int32_t h = (nx * half[0] + ny * half[1] + nz * half[2]) >> 14;
    uint32_t inverse, cosine, rb = span->look->ambient_rb, g = span->look->ambient_g;
    if (d > 0 || h > (int32_t)(COMPARE_DARK * 8192)) {
        uint32_t square_q24 = (uint32_t)(nx * nx + ny * ny + nz * nz) >> 4;
        if (square_q24 > 0xffffff) square_q24 = 0xffffff;
        inverse = ((uint32_t)1 << 24) / root(square_q24); /* UQ.12: 1 to 2 */
        if (d > 0) compare_diffuse(span->look, ((uint32_t)d * inverse + ((uint32_t)1 << 17)) >> 18, &rb, &g);
        if (h > (int32_t)(COMPARE_DARK * 8192)) {
            cosine = (uint32_t)h * inverse >> 11;
            if (cosine > (uint32_t)(COMPARE_DARK * 32768)) compare_specular(span->look, power_16(cosine), &rb, &g);
        }
    }
    return compare_pack(rb, g);
}

COMPARE_APART void compare_fill_integer_phong(const compare_span *span, uint16_t *pixel, unsigned length)
{
    int32_t x = span->value[0], y = span->value[1], z = span->value[2];
    uint16_t *end = pixel + length;
    do {
        *pixel++ = shade(span, x >> 16, y >> 16, z >> 16);
        x = lmb_add_wrap(x, span->step[0]);
        y = lmb_add_wrap(y, span->step[1]);
        z = lmb_add_wrap(z, span->step[2]);
    } while (pixel != end);
}

/* As textbooks have it: the vector is normalised by a root of 32 bits and three divisions, then multiplied; no short cuts. */
static uint32_t whole_root(uint32_t x)
{
    uint32_t r = 0, bit = (uint32_t)1 << 30;
    do {
        uint32_t t = r + bit;
        r >>= 1;
        if (x >= t) {
            x -= t;
            r += bit;
        }
        bit >>= 2;
    } while (bit != 0);
    return r;
}

static COMPARE_INLINE uint16_t textbook(const compare_span *span, int32_t nx, int32_t ny, int32_t nz)
{
    const int32_t *direction = span->direction, *half = span->half;
    int32_t length = (int32_t)whole_root((uint32_t)(nx * nx + ny * ny + nz * nz)), d, h;
    uint32_t rb, g;
    nx = nx * 16384 / length;
    ny = ny * 16384 / length;
    nz = nz * 16384 / length;
    d = (nx * direction[0] + ny * direction[1] + nz * direction[2]) >> 14;
    h = (nx * half[0] + ny * half[1] + nz * half[2]) >> 13;
    compare_diffuse(span->look, d > 0 ? (uint32_t)d >> 6 : 0, &rb, &g);
    if (h > 0) compare_specular(span->look, power_16((uint32_t)h), &rb, &g);
    return compare_pack(rb, g);
}

COMPARE_APART void compare_fill_integer_phong_textbook(const compare_span *span, uint16_t *pixel, unsigned length)
{
    int32_t x = span->value[0], y = span->value[1], z = span->value[2];
    uint16_t *end = pixel + length;
    do {
        *pixel++ = textbook(span, x >> 16, y >> 16, z >> 16);
        x = lmb_add_wrap(x, span->step[0]);
        y = lmb_add_wrap(y, span->step[1]);
        z = lmb_add_wrap(z, span->step[2]);
    } while (pixel != end);
}

void compare_begin_integer_phong(compare_span *span, const compare_look *look, lmb_vec from, lmb_vec to, unsigned length)
{
    compare_span_look(span, look, NULL);
    compare_span_value(span, 0, from.x, to.x, length);
    compare_span_value(span, 1, from.y, to.y, length);
    compare_span_value(span, 2, from.z, to.z, length);
}

static COMPARE_INLINE uint32_t draw(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose,
                                    const compare_look *look, const lmb_vertex *vertices, compare_room *room, compare_fill *fill)
{
    compare_span span;
    unsigned i;
    if (!compare_inside(surface, vertices, mesh->vertices)) return 0;
    compare_span_look(&span, look, pose);
    for (i = 0; i < mesh->vertices; i++) {
        room[i].q[0] = vertices[i].normal.x;
        room[i].q[1] = vertices[i].normal.y;
        room[i].q[2] = vertices[i].normal.z;
    }
    return compare_draw_planes(surface, mesh, vertices, room, &span, 3, fill);
}

uint32_t compare_draw_integer_phong(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose,
                                    const compare_look *look, const lmb_vertex *vertices, compare_room *room)
{
    return draw(surface, mesh, pose, look, vertices, room, compare_fill_integer_phong);
}

uint32_t compare_draw_integer_phong_textbook(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose,
                                             const compare_look *look, const lmb_vertex *vertices, compare_room *room)
{
    return draw(surface, mesh, pose, look, vertices, room, compare_fill_integer_phong_textbook);
}
