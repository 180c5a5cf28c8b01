/* SPDX-License-Identifier: MIT */
/* Phong shading in floats: the normal runs linearly, and each pixel takes a square root, a division, two dot products and a
 * power: powf, or four squarings. Colours are integers, since the display wants integers: N.L and the power are converted.
 *
 * As in integer_phong.c, pixels without light are told before the root, and no power is taken where it is not seen.
 */
#include "methods.h"

#include "colour.h"
#include "floats.h"

#if COMPARE_WITH_LIBM

#define DARK ((float)COMPARE_DARK)
#define UNIT (1.0f / 16384)
#define FINE 4096.0f /* N.L is counted in units of 1/4096 */

static COMPARE_INLINE float dot(const float a[3], float x, float y, float z) { return a[0] * x + a[1] * y + a[2] * z; }

/* x, in units of 1/4096, in units of 1/256, rounded to nearest */
static COMPARE_INLINE uint32_t to_256(float x) { return (uint32_t)((int32_t)x + 8) >> 4; }

static COMPARE_INLINE float power_16(float c)
{
    c *= c;
    c *= c;
    c *= c;
    return c * c;
}

static COMPARE_INLINE uint16_t shade(const compare_span *span, float x, float y, float z, bool squarings)
{
    float d = dot(span->direction_f, x, y, z), h = dot(span->half_f, x, y, z), inverse;
    uint32_t rb = span->look->ambient_rb, g = span->look->ambient_g;
    if (d > 0 || h > DARK / 2) {
        inverse = 1.0f / COMPARE_ROOT(x * x + y * y + z * z);
        if (d > 0) compare_diffuse(span->look, to_256(d * inverse), &rb, &g);
        h *= inverse;
        if (h > DARK) {
            h = squarings ? power_16(h) : powf(h, (float)COMPARE_SHININESS);
            compare_specular(span->look, to_256(h * FINE), &rb, &g);
        }
    }
    return compare_pack(rb, g);
}

static COMPARE_INLINE void paint(const compare_span *span, uint16_t *pixel, unsigned length, bool squarings)
{
    float x = span->value_f[0], y = span->value_f[1], z = span->value_f[2];
    uint16_t *end = pixel + length;
    do {
        *pixel++ = shade(span, x, y, z, squarings);
        x += span->step_f[0];
        y += span->step_f[1];
        z += span->step_f[2];
    } while (pixel != end);
}

COMPARE_APART void compare_fill_float_phong(const compare_span *span, uint16_t *pixel, unsigned length)
{
    paint(span, pixel, length, false);
}
COMPARE_APART void compare_fill_float_squarings(const compare_span *span, uint16_t *pixel, unsigned length)
{
    paint(span, pixel, length, true);
}

static void rays(compare_span *span)
{
    int k;
    for (k = 0; k < 3; k++) {
        span->direction_f[k] = (float)span->direction[k] * (UNIT * FINE);
        span->half_f[k] = (float)span->half[k] * UNIT;
    }
}

static COMPARE_INLINE void to_float(float out[3], lmb_vec v)
{
    out[0] = (float)v.x * UNIT;
    out[1] = (float)v.y * UNIT;
    out[2] = (float)v.z * UNIT;
}

/* ---------------------------------------------------------------------------------------------------------------- triangles */

typedef struct slope {
    float value, dx, dy;
} slope;

/* The normal's three components over a triangle: at the centre that lies (px, py) pixels from corner a, and their steps. */
static void planes_begin(slope normal[3], const compare_walk *walk, float px, float py, const float *a, const float *b,
                         const float *c)
{
    float by_area = 16.0f / (float)walk->area_2;
    float ab_x = (float)walk->bx * by_area, ab_y = (float)walk->by * by_area;
    float ac_x = (float)walk->cx * by_area, ac_y = (float)walk->cy * by_area;
    int k;
    for (k = 0; k < 3; k++) {
        float ab = b[k] - a[k], ac = c[k] - a[k];
        normal[k].dx = ac * ab_y - ab * ac_y;
        normal[k].dy = ab * ac_x - ac * ab_x;
        normal[k].value = a[k] + normal[k].dx * px + normal[k].dy * py;
    }
}

static COMPARE_INLINE uint32_t triangle(const lmb_surface *surface, compare_span *span, compare_walk *walk, slope normal[3],
                                        compare_fill *fill)
{
    uint16_t *row = compare_pixel(surface, 0, walk->y);
    int32_t x = walk->left.x;
    uint32_t pixels = 0;
    int k;
    for (k = 0; k < 3; k++) span->step_f[k] = normal[k].dx;
    do {
        int32_t moved = walk->left.x - x, length = walk->right.x - walk->left.x;
        float by = (float)moved;
        x = walk->left.x;
        for (k = 0; k < 3; k++) {
            if (moved) normal[k].value += normal[k].dx * by;
            span->value_f[k] = normal[k].value;
            normal[k].value += normal[k].dy;
        }
        if (length > 0) {
            fill(span, row + x, (unsigned)length);
            pixels += (uint32_t)length;
        }
        row += surface->pitch / 2;
    } while (compare_walk_next(walk));
    return pixels;
}

static COMPARE_INLINE uint32_t draw(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose,
                                    const compare_look *look, const lmb_vertex *vertices, compare_room *room, compare_fill *fill)
{
    const LMB_FLASH uint16_t *index = mesh->indices, *end = index + (size_t)3 * mesh->triangles;
    uint32_t pixels = 0;
    compare_span span;
    unsigned i;
    if (!compare_inside(surface, vertices, mesh->vertices)) return 0;
    compare_span_look(&span, look, pose);
    rays(&span);
    for (i = 0; i < mesh->vertices; i++) to_float(room[i].f, vertices[i].normal);
    for (; index != end; index += 3) {
        const lmb_vertex *a = &vertices[index[0]];
        compare_walk walk;
        slope normal[3];
        if (!compare_walk_begin(&walk, a, &vertices[index[1]], &vertices[index[2]])) continue;
        planes_begin(normal, &walk, (float)(16 * walk.left.x + 8 - a->x) * 0.0625f, (float)(16 * walk.y + 8 - a->y) * 0.0625f,
                     room[index[0]].f, room[index[1]].f, room[index[2]].f);
        pixels += triangle(surface, &span, &walk, normal, fill);
    }
    return pixels;
}

uint32_t compare_draw_float_phong(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose,
                                  const compare_look *look, const lmb_vertex *vertices, compare_room *room)
{
    return draw(surface, mesh, pose, look, vertices, room, compare_fill_float_phong);
}

uint32_t compare_draw_float_squarings(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose,
                                      const compare_look *look, const lmb_vertex *vertices, compare_room *room)
{
    return draw(surface, mesh, pose, look, vertices, room, compare_fill_float_squarings);
}

/* -------------------------------------------------------------------------------------------------------------------- spans */

void compare_begin_float(compare_span *span, const compare_look *look, lmb_vec from, lmb_vec to, unsigned length)
{
    float end[3];
    int k;
    compare_span_look(span, look, NULL);
    rays(span);
    to_float(span->value_f, from);
    to_float(end, to);
    for (k = 0; k < 3; k++) span->step_f[k] = (end[k] - span->value_f[k]) / (float)length;
}

#endif
