/* SPDX-License-Identifier: MIT */
/* The filler: spans and triangles into pixels, in loops that the compiler fuses with the library's inline steps.
 *
 * One light on RGB565 takes ramps (run.h), everything else three sums (levels.h). lit_run is written once; constant arguments make
 * eight of it: two formats, planes or arcs, highlight or not.
 */
#include "run.h"

/* From a term in Q2.30 to the lobe's entry, Q16.16. */
#define LOBE_ENTRY_SHIFT 14

/* Which of the two; a constant where only one is built in. */
static ALWAYS_INLINE bool is_rgb565(const lmb_surface *surface)
{
    return LMB_WITH_RGB565 && (!LMB_WITH_RGB888 || surface->format == LMB_RGB565);
}

/* -----------------------------------------------------------------------------------------------------------------------
 * pixels */

static ALWAYS_INLINE void store(int format, void *pixel, const uint32_t sum[3])
{
    int i;
    if (format == LMB_RGB565) {
        *(uint16_t *)pixel = STORE_ORDER(pixel_of_565(sum));
    } else {
        for (i = 0; i < 3; i++) ((uint8_t *)pixel)[i] = (uint8_t)level(sum[i], channel_of(LMB_RGB888, i));
    }
}

static ALWAYS_INLINE void add_light(uint32_t sum[3], const uint16_t coefficients[3], uint32_t intensity_q15)
{
    sum[0] += coefficients[0] * intensity_q15;
    sum[1] += coefficients[1] * intensity_q15;
    sum[2] += coefficients[2] * intensity_q15;
}

/* A term in Q2.30 as an intensity, UQ1.15. */
static ALWAYS_INLINE uint32_t intensity(int32_t f)
{
    int32_t q15 = f >> 15;
    return (uint32_t)(q15 < 0 ? 0 : q15 > 32768 ? 32768 : q15);
}

/* True where the pixel is nearer than what is there; then it takes the place. */
static ALWAYS_INLINE bool depth_pass(uint16_t *stored, lmb_term *depth)
{
    int32_t now = depth->f >> 14;
    lmb_plane_step(depth);
    if (now >= *stored) return false;
    *stored = (uint16_t)(now < 0 ? 0 : now);
    return true;
}

/* The argument of the lobe as a span carries it. */
static ALWAYS_INLINE int32_t argument_of(const lmb_term *specular, bool arc)
{
    return arc ? lmb_add_wrap(specular->f, specular->c) : specular->f;
}

/* The lobe at a highlight's argument, UQ1.15. */
static ALWAYS_INLINE uint32_t lobe_of(const lmb_look *look, unsigned i, int32_t argument, unsigned shift)
{
    if (argument <= 0) return 0;
    if (!LMB_WITH_LOBES) return (uint32_t)lmb_look_ramp_at(look, i, (uint32_t)argument << (LOBE_ENTRY_SHIFT - shift));
    return (uint32_t)lmb_lobe_at(&look->lobe, lmb_add(argument >> shift, look->light[i].dark_q16));
}

/* One light on RGB888: three sums. */
static ALWAYS_INLINE void pixel_888(const lmb_paint *paint, void *pixel, int32_t diffuse, uint32_t lobe_q15)
{
    uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
    add_light(sum, paint->light[0].diffuse, intensity(diffuse));
    if (lobe_q15) add_light(sum, paint->light[0].specular, lobe_q15);
    store(LMB_RGB888, pixel, sum);
}

/* One light; diffuse, with or without a highlight. */
static ALWAYS_INLINE void one_light(const lmb_paint *paint, const lmb_span *span, uint8_t *pixel, uint16_t *stored, int format,
                                    bool arc, bool highlight)
{
    const unsigned shift = (format == LMB_RGB565 ? GLEAM_SHIFT : LOBE_ENTRY_SHIFT) - (highlight ? span->exponent[0] : 0u);
    static const lmb_term none = {0, 0, 0};
    lmb_term diffuse = span->diffuse_on ? span->diffuse[0] : none, specular = span->specular[0], depth = span->depth;
    unsigned n;
    for (n = span->length; n > 0; n--, pixel += format == LMB_RGB565 ? 2 : 3) {
        if (!LMB_WITH_DEPTH || !stored || depth_pass(stored++, &depth)) {
            const int32_t argument = highlight ? argument_of(&specular, arc) : 0;
            if (format == LMB_RGB565) {
                *(uint16_t *)(void *)pixel = pixel_565(paint, diffuse.f, argument, shift);
            } else {
                pixel_888(paint, pixel, diffuse.f, highlight ? lobe_of(&paint->look, 0, argument, shift) : 0);
            }
        }
        if (arc) {
            lmb_arc_step(&span->arc, &diffuse);
            if (highlight) lmb_arc_step(&span->arc, &specular);
        } else {
            lmb_plane_step(&diffuse);
            if (highlight) lmb_plane_step(&specular);
        }
    }
}

/* What one light adds at one pixel of any kind of span. */
static void light_pixel(uint32_t sum[3], const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                        const lmb_term *diffuse, const lmb_term *specular, unsigned i)
{
    if (lmb_bit(span->diffuse_on, i)) add_light(sum, paint->light[i].diffuse, intensity(diffuse->f));
    if (lmb_bit(span->specular_on, i)) {
        if (look->model != LMB_MODEL_GLOSS) {
            add_light(sum, paint->light[i].specular, intensity(specular->f));
        } else {
            const int32_t argument = argument_of(specular, span->kind == LMB_SPAN_ARC);
            add_light(sum, paint->light[i].specular,
                      lobe_of(look, i, argument, (unsigned)(LOBE_ENTRY_SHIFT - span->exponent[i])));
        }
    }
}

static void saturate(uint32_t sum[3], int format)
{
    int i;
    for (i = 0; i < 3; i++) {
        const channel c = channel_of(format, i);
        const uint32_t most = ((uint32_t)c.top << c.fraction) + ((uint32_t)1 << (c.fraction - 1));
        if (sum[i] > most) sum[i] = most;
    }
}

static void terms_step(const lmb_span *span, lmb_term *term)
{
    if (span->kind == LMB_SPAN_PLANE) {
        lmb_plane_step(term);
    } else if (span->kind == LMB_SPAN_ARC) {
        lmb_arc_step(&span->arc, term);
    }
}

/* What all lights add at one pixel, saturated. */
static void all_lights(uint32_t sum[3], int format, const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                       const lmb_term *diffuse, const lmb_term *specular)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(look); i++) {
        light_pixel(sum, look, paint, span, &diffuse[i], &specular[i], i);
        saturate(sum, format);
    }
}

/* A pixel whose format is known at run time only. */
static void store_as(const lmb_surface *surface, uint8_t *pixel, const uint32_t sum[3])
{
    if (is_rgb565(surface)) {
        store(LMB_RGB565, pixel, sum);
    } else {
        store(LMB_RGB888, pixel, sum);
    }
}

/* One colour: the triangle is flat, or no light reaches it. */
static void solid(const lmb_surface *surface, const lmb_look *look, const lmb_paint *paint, const lmb_span *span, uint8_t *pixel,
                  uint16_t *stored)
{
    lmb_term depth = span->depth;
    uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
    unsigned step = lmb_format_bytes((enum lmb_format)surface->format), n;
    if (LMB_WITH_CORNERS) all_lights(sum, surface->format, look, paint, span, span->diffuse, span->specular);
    for (n = span->length; n > 0; n--, pixel += step) {
        if (!LMB_WITH_DEPTH || !stored || depth_pass(stored++, &depth)) store_as(surface, pixel, sum);
    }
}

/* Any number of lights, any kind, any model. */
static void general_run(const lmb_surface *surface, const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                        uint8_t *pixel, uint16_t *stored)
{
    lmb_term diffuse[LMB_LIGHTS], specular[LMB_LIGHTS], depth = span->depth;
    unsigned step = lmb_format_bytes((enum lmb_format)surface->format), n, i;
    for (i = 0; i < lmb_look_lights(look); i++) {
        diffuse[i] = span->diffuse[i];
        specular[i] = span->specular[i];
    }
    for (n = span->length; n > 0; n--, pixel += step) {
        if (!LMB_WITH_DEPTH || !stored || depth_pass(stored++, &depth)) {
            uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
            all_lights(sum, surface->format, look, paint, span, diffuse, specular);
            store_as(surface, pixel, sum);
        }
        for (i = 0; i < lmb_look_lights(look); i++) {
            if (lmb_bit(span->diffuse_on, i)) terms_step(span, &diffuse[i]);
            if (lmb_bit(span->specular_on, i)) terms_step(span, &specular[i]);
        }
    }
}

static ALWAYS_INLINE void one_light_run(const lmb_paint *paint, const lmb_span *span, uint8_t *pixel, uint16_t *stored,
                                        int format)
{
    if (LMB_WITH_ARC && span->kind == LMB_SPAN_ARC) {
        if (span->specular_on) {
            one_light(paint, span, pixel, stored, format, true, true);
        } else {
            one_light(paint, span, pixel, stored, format, true, false);
        }
    } else if (span->specular_on) {
        one_light(paint, span, pixel, stored, format, false, true);
    } else {
        one_light(paint, span, pixel, stored, format, false, false);
    }
}

/* The pixel in column 0 of a row. */
static ALWAYS_INLINE uint8_t *row_of(const lmb_surface *surface, int32_t y)
{
    return (uint8_t *)surface->pixels + (size_t)lmb_sub(y, surface->window.top) * surface->pitch;
}

void lmb_fill_span(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span)
{
    size_t row = (size_t)lmb_sub(span->y, surface->window.top), column = (size_t)lmb_sub(span->x, surface->window.left);
    size_t width = (size_t)lmb_sub(surface->window.right, surface->window.left);
    uint8_t *pixel = row_of(surface, span->y) + column * lmb_format_bytes((enum lmb_format)surface->format);
    uint16_t *stored = LMB_WITH_DEPTH && surface->depth ? surface->depth + row * width + column : NULL;
    if (lmb_paint_is_simple(paint)) {
        if (is_rgb565(surface)) {
            one_light_run(paint, span, pixel, stored, LMB_RGB565);
        } else {
            one_light_run(paint, span, pixel, stored, LMB_RGB888);
        }
    } else if ((LMB_WITH_CORNERS && span->kind == LMB_SPAN_FLAT) || !(span->diffuse_on | span->specular_on)) {
        solid(surface, &paint->look, paint, span, pixel, stored);
    } else {
        general_run(surface, &paint->look, paint, span, pixel, stored);
    }
}

/* ------------------------------------------------------------------------------------------------------ triangles, row by row */

#if LMB_WITH_RAMPS

/* What the rows of a triangle are filled with. */
typedef struct filling {
    bool diffuse, specular; /* neither: one colour */
    enum ramp_use ramp;     /* unless uneven no row is cut by the window, and the highlight's argument lies on its ramp */
    bool scaled;            /* the highlight's exponent is not 0 */
    bool straight;          /* N.L is linear */
    bool saturates;         /* some sum of diffuse and highlight may run over */
} filling;

/* The term of a plane, straight: without a curve. */
static ALWAYS_INLINE lmb_term term_of(const lmb_plane *plane, int32_t columns, bool straight)
{
    lmb_term term = {lmb_add_wrap(plane->f, lmb_mul_wrap(columns, plane->dx)), plane->dx, 0};
    return straight ? term : lmb_plane_term(plane, columns);
}

/* One row of a triangle: n pixels from the one that is columns right of where the planes stand. */
static ALWAYS_INLINE void fill_row(const lmb_paint *paint, const lmb_triangle *t, uint16_t *pixel, uint32_t n, int32_t columns,
                                   unsigned shift, const filling how)
{
    const lmb_plane *diffuse = &t->u.light[0].diffuse, *specular = &t->u.light[0].specular;
    if (how.specular) {
        lit_run(paint, pixel, n, term_of(diffuse, columns, how.straight), lmb_plane_term(specular, columns), shift, how.ramp,
                how.saturates);
    } else if (how.diffuse) {
        plain_run(paint->colour, pixel, n, term_of(diffuse, columns, how.straight), how.ramp, how.straight);
    } else {
        solid_run(pixel, n, STORE_ORDER(paint->colour[0]));
    }
}

/* All rows of a triangle of planes, one light, RGB565, no depth test: those above the middle corner, then those below. */
static ALWAYS_INLINE uint32_t fill_rows(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t, const filling how)
{
    uint8_t *row = row_of(surface, t->y) - 2 * (ptrdiff_t)surface->window.left;
    const size_t pitch = surface->pitch;
    const unsigned shift = how.scaled ? (unsigned)(GLEAM_SHIFT - t->exponent[0]) : GLEAM_SHIFT;
    uint32_t pixels = 0;
    int32_t rows = lmb_sub(lmb_min(t->y_switch, t->y_end), t->y), rest = lmb_sub(lmb_sub(t->y_end, t->y), rows);
    for (;;) {
        do {
            int32_t x = t->edge[0].x, end = t->edge[1].x;
            if (how.ramp == RAMP_UNEVEN) {
                x = lmb_max(x, t->window_left);
                end = lmb_min(end, t->window_right);
            }
            if (end > x) {
                pixels += (uint32_t)(end - x);
                fill_row(paint, t, (uint16_t *)(void *)row + x, (uint32_t)(end - x), lmb_sub(x, t->column), shift, how);
            }
            FORGET();
            row += pitch;
            lmb_edge_step(&t->edge[0]);
            lmb_edge_step(&t->edge[1]);
            if (how.diffuse) {
                lmb_plane *plane = &t->u.light[0].diffuse;
                plane->f = lmb_add_wrap(plane->f, plane->dy);
                if (!how.straight) {
                    plane->dx = lmb_add_wrap(plane->dx, plane->dxy);
                    plane->dy = lmb_add_wrap(plane->dy, plane->dyy);
                }
            }
            if (how.specular) lmb_plane_row(&t->u.light[0].specular);
            FORGET();
        } while (--rows > 0);
        if (rest == 0) return pixels;
        t->y = t->y_switch;
        lmb_triangle_turn(t);
        rows = rest;
        rest = 0;
    }
}

#if LMB_LOOPS

static NOINLINE uint32_t fill_solid(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {false, false, RAMP_EVEN, false, true, false};
    return fill_rows(surface, paint, t, how);
}

static NOINLINE uint32_t fill_plain(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {true, false, RAMP_EVEN, false, false, false};
    return fill_rows(surface, paint, t, how);
}

static NOINLINE uint32_t fill_plain_straight(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {true, false, RAMP_EVEN, false, true, false};
    return fill_rows(surface, paint, t, how);
}

static NOINLINE uint32_t fill_plain_low(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {true, false, RAMP_LOW, false, false, false};
    return fill_rows(surface, paint, t, how);
}

static NOINLINE uint32_t fill_plain_uneven(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {true, false, RAMP_UNEVEN, false, false, false};
    return fill_rows(surface, paint, t, how);
}

static NOINLINE uint32_t fill_lit(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {true, true, RAMP_EVEN, false, false, false};
    return fill_rows(surface, paint, t, how);
}

static NOINLINE uint32_t fill_lit_straight(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {true, true, RAMP_EVEN, false, true, false};
    return fill_rows(surface, paint, t, how);
}

static NOINLINE uint32_t fill_lit_bright(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {true, true, RAMP_EVEN, false, false, true};
    return fill_rows(surface, paint, t, how);
}

static NOINLINE uint32_t fill_lit_scaled(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {true, true, RAMP_LOW, true, false, true};
    return fill_rows(surface, paint, t, how);
}

static NOINLINE uint32_t fill_lit_uneven(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {true, true, RAMP_UNEVEN, true, false, true};
    return fill_rows(surface, paint, t, how);
}

/* The loop with the least in it that serves a triangle. */
static uint32_t fill_simple(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    static const lmb_plane none = {0, 0, 0, 0, 0, 0};
    const int32_t ramp = t->high >> (RAMP_SHIFT - 2), ramp_low = t->low >> (RAMP_SHIFT - 2);
    const bool inside = t->inside && !t->rough && ramp < LMB_RAMP_TOP - 1; /* a step for what planes err */
    lmb_plane *diffuse = &t->u.light[0].diffuse;
    if (!t->diffuse_on && !t->specular_on && t->inside) return fill_solid(surface, paint, t);
    if (!t->diffuse_on) *diffuse = none;
    if (t->specular_on) {
        const int32_t gleam = t->gleam >> (GLEAM_SHIFT - 2 - t->exponent[0]);
        if (!inside || gleam >= LMB_GLEAM_TOP - 4) return fill_lit_uneven(surface, paint, t);
        if (ramp_low < 1 || t->exponent[0]) return fill_lit_scaled(surface, paint, t);
        if (carries_565(paint->colour[ramp + 1], paint->gleam[gleam + 4])) return fill_lit_bright(surface, paint, t);
        return diffuse->dxx | diffuse->dxy | diffuse->dyy ? fill_lit(surface, paint, t) : fill_lit_straight(surface, paint, t);
    }
    if (!inside) return fill_plain_uneven(surface, paint, t);
    if (ramp_low < 1) return fill_plain_low(surface, paint, t);
    return diffuse->dxx | diffuse->dxy | diffuse->dyy ? fill_plain(surface, paint, t) : fill_plain_straight(surface, paint, t);
}

#else

/* One loop for all: what a triangle lacks is drawn as nothing. */
static uint32_t fill_simple(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    static const lmb_plane none = {0, 0, 0, 0, 0, 0};
    const filling how = {true, true, RAMP_UNEVEN, true, false, true};
    if (!t->diffuse_on) t->u.light[0].diffuse = none;
    if (!t->specular_on) {
        t->u.light[0].specular = none;
        t->exponent[0] = 0;
    }
    return fill_rows(surface, paint, t, how);
}

#endif

/* What is always so where nothing else is built in. */
static bool is_ramped(const lmb_paint *paint)
{
    return paint->ramped || (LMB_WITH_RGB565 && !LMB_WITH_RGB888 && LMB_LIGHTS == 1 && !LMB_WITH_CORNERS);
}
static bool is_plane(const lmb_triangle *t) { return t->kind == LMB_SPAN_PLANE || (!LMB_WITH_ARC && !LMB_WITH_CORNERS); }

#endif

uint32_t lmb_fill_triangle(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    lmb_span span;
    uint32_t pixels = 0;
#if LMB_WITH_RAMPS
    if (is_ramped(paint) && is_plane(t) && !(LMB_WITH_DEPTH && surface->depth)) { return fill_simple(surface, paint, t); }
#endif
    while (lmb_triangle_next(t, &span)) {
        lmb_fill_span(surface, paint, &span);
        pixels += span.length;
    }
    return pixels;
}
