/* SPDX-License-Identifier: MIT */
/* N.L and N.H linear over the triangle, and the power of N.H a pixel by Schlick's approximation or by tables.
 *
 * schlick       t / (n - n t + t): one product and one division (Schlick, A fast alternative to Phong's specular model, Graphics
 *               Gems IV, 1994)
 * power-table   256 entries of a byte, the nearest taken
 * ramp-table    the colours themselves from two tables, of N.L and of N.H: 2 KB for a material under a light
 *
 * They are as fast as they come: nothing is normalised, so a highlight between corners is too dim.
 */
#include "methods.h"

#include "colour.h"
#include "planes.h"

/* N.L and N.H of a normal, Q2.14, at most just under one. */
static COMPARE_INLINE void dots(const compare_span *span, lmb_vec normal, int32_t term[2])
{
    term[0] = lmb_min(compare_dot(span->direction, normal) >> 14, 16383);
    term[1] = lmb_min(compare_dot(span->half, normal) >> 14, 16383);
}

/* N.H for the table: 255 of it are one, half of one is added, and the index is in the bits from 22 of its Q.30. */
static COMPARE_INLINE int32_t table_term(int32_t h_q14) { return (h_q14 * 255 >> 8) + 32; }

/* The nearest entry of the table; 0 where the highlight is not seen. */
#define TABLE_DARK ((int32_t)(COMPARE_DARK * (1l << 30)))

static COMPARE_INLINE uint32_t diffuse_256(int32_t d_q30) { return d_q30 > 0 ? (uint32_t)d_q30 >> 22 : 0; }

/* t / (16 - 15 t) of t = h in UQ1.15, in 1/256, rounded to nearest. */
static COMPARE_INLINE uint32_t schlick(int32_t h_q30)
{
    uint32_t t = (uint32_t)h_q30 >> 15;
    uint32_t below = COMPARE_SHININESS * (uint32_t)32768 - (COMPARE_SHININESS - 1) * t;
    return ((t << 8) + (below >> 1)) / below;
}

COMPARE_APART void compare_fill_schlick(const compare_span *span, uint16_t *pixel, unsigned length)
{
    int32_t d = span->value[0], h = span->value[1], d_step = span->step[0], h_step = span->step[1];
    const compare_look *look = span->look;
    uint16_t *end = pixel + length;
    do {
        uint32_t rb, g;
        compare_diffuse(look, diffuse_256(d), &rb, &g);
        if (h > 0) compare_specular(look, schlick(h), &rb, &g);
        *pixel++ = compare_pack(rb, g);
        d = lmb_add_wrap(d, d_step);
        h = lmb_add_wrap(h, h_step);
    } while (pixel != end);
}

COMPARE_APART void compare_fill_power_table(const compare_span *span, uint16_t *pixel, unsigned length)
{
    int32_t d = span->value[0], h = span->value[1], d_step = span->step[0], h_step = span->step[1];
    const compare_look *look = span->look;
    uint16_t *end = pixel + length;
    do {
        uint32_t rb, g;
        compare_diffuse(look, diffuse_256(d), &rb, &g);
        if (h > TABLE_DARK) compare_specular(look, look->power[(uint32_t)h >> 22], &rb, &g);
        *pixel++ = compare_pack(rb, g);
        d = lmb_add_wrap(d, d_step);
        h = lmb_add_wrap(h, h_step);
    } while (pixel != end);
}

COMPARE_APART void compare_fill_ramp_table(const compare_span *span, uint16_t *pixel, unsigned length)
{
    int32_t d = span->value[0], h = span->value[1], d_step = span->step[0], h_step = span->step[1];
    const uint32_t *diffuse = span->look->diffuse_ramp, *specular = span->look->specular_ramp, unlit = span->look->unlit;
    uint16_t *end = pixel + length;
    do {
        uint32_t c = d > 0 ? diffuse[(uint32_t)d >> 22] : unlit;
        if (h > TABLE_DARK) c = compare_ramp_sum(c, specular[(uint32_t)h >> 22]);
        *pixel++ = compare_ramp_pack(c);
        d = lmb_add_wrap(d, d_step);
        h = lmb_add_wrap(h, h_step);
    } while (pixel != end);
}

void compare_begin_schlick(compare_span *span, const compare_look *look, lmb_vec from, lmb_vec to, unsigned length)
{
    int32_t a[2], b[2];
    compare_span_look(span, look, NULL);
    dots(span, from, a);
    dots(span, to, b);
    compare_span_value(span, 0, a[0], b[0], length);
    compare_span_value(span, 1, a[1], b[1], length);
}

void compare_begin_power_table(compare_span *span, const compare_look *look, lmb_vec from, lmb_vec to, unsigned length)
{
    int32_t a[2], b[2];
    compare_span_look(span, look, NULL);
    dots(span, from, a);
    dots(span, to, b);
    compare_span_value(span, 0, a[0], b[0], length);
    compare_span_value(span, 1, table_term(a[1]), table_term(b[1]), length);
}

static COMPARE_INLINE uint32_t draw(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose,
                                    const compare_look *look, const lmb_vertex *vertices, compare_room *room, bool table,
                                    compare_fill *fill)
{
    compare_span span;
    unsigned i;
    if (!compare_inside(surface, vertices, mesh->vertices)) return 0;
    compare_span_look(&span, look, pose);
    for (i = 0; i < mesh->vertices; i++) {
        dots(&span, vertices[i].normal, room[i].q);
        if (table) room[i].q[1] = table_term(room[i].q[1]);
    }
    return compare_draw_planes(surface, mesh, vertices, room, &span, 2, fill);
}

uint32_t compare_draw_schlick(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose, const compare_look *look,
                              const lmb_vertex *vertices, compare_room *room)
{
    return draw(surface, mesh, pose, look, vertices, room, false, compare_fill_schlick);
}

uint32_t compare_draw_power_table(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose,
                                  const compare_look *look, const lmb_vertex *vertices, compare_room *room)
{
    return draw(surface, mesh, pose, look, vertices, room, true, compare_fill_power_table);
}

uint32_t compare_draw_ramp_table(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose, const compare_look *look,
                                 const lmb_vertex *vertices, compare_room *room)
{
    return draw(surface, mesh, pose, look, vertices, room, true, compare_fill_ramp_table);
}
