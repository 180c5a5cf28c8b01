/* SPDX-License-Identifier: MIT */
/* The filler: spans into pixels, in loops that the compiler fuses with the library's inline steps.
 *
 * One light on RGB565 takes ramps (run.h), everything else three sums (levels.h). one_light is written once; constant arguments
 * make four of it: planes or arcs, highlight or not.
 */
#include "depth.h"
#include "run.h"

/* From a term in Q2.30 to the lobe's entry, Q16.16. */
#define LOBE_ENTRY_SHIFT 14

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

/* The terms of a span, at the next pixel. */
typedef struct terms {
    lmb_term diffuse[LMB_LIGHTS], specular[LMB_LIGHTS];
} terms;

/* One light; diffuse, with or without a highlight. */
static ALWAYS_INLINE void one_light(const lmb_paint *paint, const lmb_span *span, uint8_t *pixel, uint32_t n, terms *now,
                                    int format, bool arc, bool highlight)
{
    const unsigned shift = (format == LMB_RGB565 ? GLEAM_SHIFT : LOBE_ENTRY_SHIFT) - (span->specular_on ? span->exponent[0] : 0u);
    lmb_term diffuse = now->diffuse[0], specular = now->specular[0];
    for (; n > 0; n--, pixel += format == LMB_RGB565 ? 2 : 3) {
        const int32_t argument = highlight ? argument_of(&specular, arc) : 0;
        if (format == LMB_RGB565) {
            *(uint16_t *)(void *)pixel = pixel_565(paint, diffuse.f, argument, shift);
        } else {
            pixel_888(paint, pixel, diffuse.f, highlight ? lobe_of(&paint->look, 0, argument, shift) : 0);
        }
        if (arc) {
            lmb_arc_step(&span->arc, &diffuse);
            if (highlight) lmb_arc_step(&span->arc, &specular);
        } else {
            lmb_plane_step(&diffuse);
            if (highlight) lmb_plane_step(&specular);
        }
    }
    now->diffuse[0] = diffuse;
    now->specular[0] = specular;
}

/* What one light adds at one pixel of any kind of span. */
static void light_pixel(uint32_t sum[3], const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                        const lmb_term *diffuse, const lmb_term *specular, unsigned i)
{
    if (lmb_bit(span->diffuse_on, i)) add_light(sum, paint->light[i].diffuse, intensity(diffuse->f));
    if (lmb_bit(span->specular_on, i)) {
        if (!LMB_WITH_GLOSS || look->model != LMB_MODEL_GLOSS) {
            add_light(sum, paint->light[i].specular, intensity(specular->f));
        } else {
            const int32_t argument = argument_of(specular, span->kind == LMB_SPAN_ARC);
            add_light(sum, paint->light[i].specular,
                      lobe_of(look, i, argument, (unsigned)(LOBE_ENTRY_SHIFT - span->exponent[i])));
        }
    }
}

static void term_step(const lmb_span *span, lmb_term *term)
{
    if (span->kind == LMB_SPAN_PLANE) {
        lmb_plane_step(term);
    } else if (span->kind == LMB_SPAN_ARC) {
        lmb_arc_step(&span->arc, term);
    }
}

/* All terms one pixel on. */
static void terms_step(const lmb_look *look, const lmb_span *span, terms *now)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(look); i++) {
        if (lmb_bit(span->diffuse_on, i)) term_step(span, &now->diffuse[i]);
        if (lmb_bit(span->specular_on, i)) term_step(span, &now->specular[i]);
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

/* One colour: the triangle is flat, its terms are constant, or no light reaches it. */
static void solid(const lmb_surface *surface, const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                  const terms *now, uint8_t *pixel, uint32_t n)
{
    uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
    const unsigned step = lmb_format_bytes((enum lmb_format)surface->format);
    all_lights(sum, surface->format, look, paint, span, now->diffuse, now->specular);
    for (; n > 0; n--, pixel += step) store_as(surface, pixel, sum);
}

/* Any number of lights, any kind, any model. */
static void general_run(const lmb_surface *surface, const lmb_look *look, const lmb_paint *paint, const lmb_span *span,
                        uint8_t *pixel, uint32_t n, terms *now)
{
    const unsigned step = lmb_format_bytes((enum lmb_format)surface->format);
    for (; n > 0; n--, pixel += step) {
        uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
        all_lights(sum, surface->format, look, paint, span, now->diffuse, now->specular);
        store_as(surface, pixel, sum);
        terms_step(look, span, now);
    }
}

/* A term that is not on is zero, so that the loops with a highlight serve all. */
static ALWAYS_INLINE void one_light_run(const lmb_paint *paint, const lmb_span *span, uint8_t *pixel, uint32_t n, terms *now,
                                        int format)
{
    const bool arc = LMB_WITH_ARC && span->kind == LMB_SPAN_ARC, lit = LMB_WITH_GLOSS && (!LMB_LOOPS || span->specular_on);
    if (arc && lit) {
        one_light(paint, span, pixel, n, now, format, true, true);
    } else if (arc) {
        one_light(paint, span, pixel, n, now, format, true, false);
    } else if (lit) {
        one_light(paint, span, pixel, n, now, format, false, true);
    } else {
        one_light(paint, span, pixel, n, now, format, false, false);
    }
}

#if LMB_WITH_RAMPS

/* Out of line, where each has the registers to itself. */
static NOINLINE void arc_diffuse(const lmb_paint *paint, const lmb_arc *arc, uint16_t *pixel, uint32_t n, lmb_term *diffuse)
{
    arc_run(paint->ramp, pixel, n, arc, diffuse);
}

static NOINLINE void arc_gleam(const lmb_paint *paint, const lmb_arc *arc, uint16_t *pixel, uint32_t n, lmb_term *specular,
                               unsigned shift)
{
    arc_gleam_run(paint->ramp + LMB_RAMP_TOP, pixel, n, arc, specular, shift);
}

static NOINLINE void plane_lit(const lmb_paint *paint, uint16_t *pixel, uint32_t n, lmb_term *diffuse, lmb_term *specular,
                               unsigned shift)
{
    const gleam_use how = {shift, false, true, false, 0};
    lit_run(paint, pixel, pixel + n, diffuse, specular, RAMP_UNEVEN, how);
}

/* One light on RGB565, looked up. A term that is not on is zero. */
static void ramp_run(const lmb_paint *paint, const lmb_span *span, uint16_t *pixel, uint32_t n, terms *now)
{
    const unsigned shift = (unsigned)(GLEAM_SHIFT - (span->specular_on ? span->exponent[0] : 0));
    if (LMB_WITH_ARC && span->kind == LMB_SPAN_ARC) {
        arc_diffuse(paint, &span->arc, pixel, n, &now->diffuse[0]);
        if (!LMB_WITH_GLOSS || !span->specular_on || (n == span->length && arc_stays_dark(&span->arc, &now->specular[0], n)))
            return;
        arc_gleam(paint, &span->arc, pixel, n, &now->specular[0], shift);
    } else if (LMB_WITH_GLOSS && (!LMB_LOOPS || span->specular_on)) {
        plane_lit(paint, pixel, n, &now->diffuse[0], &now->specular[0], shift);
    } else {
        plain_run(paint->ramp, pixel, n, &now->diffuse[0], RAMP_UNEVEN, false);
    }
}

#else

static void ramp_run(const lmb_paint *paint, const lmb_span *span, uint16_t *pixel, uint32_t n, terms *now)
{
    one_light_run(paint, span, (uint8_t *)pixel, n, now, LMB_RGB565);
}

#endif

/* Whether no term changes along a span. One that is not on is zero. */
static bool is_level(const lmb_look *look, const lmb_span *span, const terms *now)
{
    int32_t any = 0;
    unsigned i;
    if (span->kind != LMB_SPAN_PLANE) return span->kind == LMB_SPAN_FLAT;
    for (i = 0; i < lmb_look_lights(look); i++)
        any |= now->diffuse[i].d | now->diffuse[i].c | now->specular[i].d | now->specular[i].c;
    return any == 0;
}

/* A run of pixels that are seen. */
static void run(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span, uint8_t *pixel, uint32_t n, terms *now)
{
    if (is_rgb565(surface) && lmb_paint_is_simple(paint)) {
        ramp_run(paint, span, (uint16_t *)(void *)pixel, n, now);
    } else if (is_level(&paint->look, span, now)) {
        solid(surface, &paint->look, paint, span, now, pixel, n);
    } else if (lmb_paint_is_simple(paint)) {
        one_light_run(paint, span, pixel, n, now, LMB_RGB888);
    } else if (LMB_WITH_PIXELS || LMB_WITH_GOURAUD) {
        general_run(surface, &paint->look, paint, span, pixel, n, now);
    }
}

/* The runs of a span that are seen. */
static void runs(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span, uint8_t *pixel, depth_row *row,
                 terms *now)
{
    const unsigned step = lmb_format_bytes((enum lmb_format)surface->format);
    do {
        uint16_t *const from = row->stored;
        size_t hidden, seen;
        lmb_depth_run(row);
        seen = (size_t)(row->stored - row->seen);
        if (seen == 0) return;
        for (hidden = (size_t)(row->seen - from); hidden > 0; hidden--, pixel += step) terms_step(&paint->look, span, now);
        run(surface, paint, span, pixel, (uint32_t)seen, now);
        pixel += seen * step;
    } while (row->stored != row->end);
}

/* A term that is not on is zero. */
static ALWAYS_INLINE void term_set(lmb_term *now, bool on, const lmb_term *term)
{
    now->f = on ? term->f : 0;
    now->d = on ? term->d : 0;
    now->c = on ? term->c : 0;
}

static void terms_set(terms *now, const lmb_look *look, const lmb_span *span)
{
    unsigned i;
    for (i = 0; i < lmb_look_lights(look); i++) {
        term_set(&now->diffuse[i], lmb_bit(span->diffuse_on, i), &span->diffuse[i]);
        term_set(&now->specular[i], lmb_bit(span->specular_on, i), &span->specular[i]);
    }
}

void lmb_fill_span(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span)
{
    const size_t row = (size_t)lmb_sub(span->y, surface->window.top), column = (size_t)lmb_sub(span->x, surface->window.left);
    uint8_t *const pixel = row_of(surface, span->y) + column * lmb_format_bytes((enum lmb_format)surface->format);
    terms now;
    if (LMB_LOOPS && lmb_paint_is_simple(paint) && is_rgb565(surface) && !(LMB_WITH_DEPTH && surface->depth)) {
        term_set(&now.diffuse[0], span->diffuse_on, &span->diffuse[0]); /* the same as below, with less in between */
        term_set(&now.specular[0], span->specular_on, &span->specular[0]);
        ramp_run(paint, span, (uint16_t *)(void *)pixel, span->length, &now);
        return;
    }
    terms_set(&now, &paint->look, span);
    if (LMB_WITH_DEPTH && surface->depth) {
        const size_t width = (size_t)lmb_sub(surface->window.right, surface->window.left);
        depth_row depth;
        depth.stored = surface->depth + row * width + column;
        depth.end = depth.stored + span->length;
        depth.f = span->depth.f;
        depth.d = span->depth.d;
        runs(surface, paint, span, pixel, &depth, &now);
    } else {
        run(surface, paint, span, pixel, span->length, &now);
    }
}
