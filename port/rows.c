/* SPDX-License-Identifier: MIT */
/* The filler: triangles into pixels, row by row, without a span in between. What is not served here goes span by span (fill.c).
 *
 * fill_rows is written once; constant arguments make of it a loop for each kind of triangle, with nothing in it that the kind does
 * not need.
 */
#include "corner.h"
#include "depth.h"
#include "run.h"
#include "sides.h"

#if LMB_WITH_RGB565

/* Whether the surface has depth. */
enum depth_use { DEPTH_NEVER, DEPTH_ALWAYS, DEPTH_MAYBE = LMB_WITH_DEPTH ? 2 : DEPTH_NEVER };

/* What the rows of a triangle are filled with. */
typedef struct filling {
    bool diffuse, specular; /* neither: one colour */
    enum ramp_use ramp;     /* unless uneven no row is cut by the window, and the highlight's argument lies on its ramp */
    bool scaled;            /* the highlight's exponent is not 0 */
    bool straight;          /* N.L is linear */
    bool saturates;         /* some sum of diffuse and highlight may run over */
    bool summed;            /* linear terms, Gouraud's, and no ramps */
    enum depth_use depth;
} filling;

/* The term of a plane, straight: without a curve. */
static ALWAYS_INLINE lmb_term term_of(const lmb_plane *plane, int32_t columns, bool straight)
{
    lmb_term term = {lmb_add_wrap(plane->f, lmb_mul_wrap(columns, plane->dx)), plane->dx, 0};
    return straight ? term : lmb_plane_term(plane, columns);
}

/* A plane one row down. */
static ALWAYS_INLINE void plane_next(lmb_plane *plane, bool straight)
{
    plane->f = lmb_add_wrap(plane->f, plane->dy);
    if (straight) return;
    plane->dx = lmb_add_wrap(plane->dx, plane->dxy);
    plane->dy = lmb_add_wrap(plane->dy, plane->dyy);
}

static ALWAYS_INLINE bool has_strides(const filling how) { return STRIDES && how.ramp != RAMP_UNEVEN; }

/* How far a triangle's planes are from a column as its sides have it: strides count from there. */
static ALWAYS_INLINE int32_t columns_at(const lmb_triangle *t, int32_t x, const filling how)
{
    return has_strides(how) ? x : lmb_sub(x, t->column);
}

/* Pixels of a row of a triangle, columns x to end - 1, row being where column 0 is. */
static ALWAYS_INLINE void fill_run(const lmb_paint *paint, const lmb_triangle *t, uint16_t *row, int32_t x, int32_t end,
                                   const gleam_use gleam, uint16_t colour, const corner_steps *steps, const filling how)
{
#if LMB_WITH_RAMPS || GOURAUD_ROWS
    const lmb_plane *diffuse = &t->u.light[0].diffuse, *specular = &t->u.light[0].specular;
    const int32_t columns = columns_at(t, x, how);
    lmb_term n_l = {0, 0, 0}, n_h = {0, 0, 0};
    if (how.diffuse) n_l = term_of(diffuse, columns, how.straight);
    if (how.specular) n_h = term_of(specular, columns, how.summed);
#endif
    (void)paint, (void)gleam, (void)steps, (void)how; /* of all runs none may be built in */
#if GOURAUD_ROWS
    if (how.summed) {
        corner_pixels(paint, steps, row + x, (uint32_t)lmb_sub(end, x), n_l, n_h, how.specular);
        return;
    }
#endif
#if LMB_WITH_RAMPS
    if (how.specular) {
        lit_run(paint, row + x, row + end, &n_l, &n_h, how.ramp, gleam);
        return;
    }
    if (how.diffuse) {
        plain_run(paint->ramp, row + x, (uint32_t)lmb_sub(end, x), &n_l, how.ramp, how.straight);
        return;
    }
#endif
    (void)t;
    solid_run(row + x, row + end, colour);
}

/* The depth of a triangle at a row: the buffer's column 0, NULL for none, and the linear plane there. */
typedef struct depth_rows {
    uint16_t *stored;
    ptrdiff_t width;
    int32_t f, dx, dy;
} depth_rows;

static ALWAYS_INLINE void depth_begin(depth_rows *rows, const lmb_surface *surface, const lmb_triangle *t, int32_t origin)
{
#if LMB_WITH_DEPTH
    const lmb_window *w = &surface->window;
    const ptrdiff_t width = (ptrdiff_t)lmb_sub(w->right, w->left);
    rows->width = width;
    rows->stored = surface->depth ? surface->depth + ((ptrdiff_t)lmb_sub(t->y, w->top) * width + origin - w->left) : NULL;
    rows->dx = t->depth.dx;
    rows->dy = t->depth.dy;
    rows->f = lmb_sub_wrap(t->depth.f, lmb_mul_wrap(lmb_sub(t->column, origin), rows->dx));
#else
    (void)surface, (void)t, (void)origin;
    rows->stored = NULL;
    rows->width = 0;
    rows->f = rows->dx = rows->dy = 0;
#endif
}

static ALWAYS_INLINE void depth_next(depth_rows *rows)
{
    rows->stored += rows->width;
    rows->f = lmb_add_wrap(rows->f, rows->dy);
}

static ALWAYS_INLINE bool has_depth(const depth_rows *rows, const filling how)
{
    return how.depth == DEPTH_ALWAYS || (how.depth == DEPTH_MAYBE && rows->stored);
}

#if LMB_WITH_RAMPS && LMB_WITH_DEPTH

/* Diffuse, highlight and depth in one loop, for highlights that stay on their ramp: where rows are a few pixels long, as those of
 * torus and teapot are, a run by itself takes longer to begin than the loop to spill (measured: 8 % on Cortex-M0+, 17 % on M4). */
static ALWAYS_INLINE void lit_run_seen(const lmb_paint *paint, uint16_t *pixel, const depth_row *row, lmb_term diffuse,
                                       lmb_term specular, const gleam_use gleam, const filling how)
{
    const uint16_t *const ramp = lit_ramp(paint, how.ramp);
    uint16_t *at = row->stored, *const end = row->end;
    const int32_t d = row->d;
    int32_t f = row->f;
    do {
        const int32_t now = f >> 14;
        if (now < *at) {
            *at = (uint16_t)(now & ~(now >> 31));
            *pixel = STORE_ORDER(lit_sum(ramp, diffuse.f, specular.f, how.ramp, gleam));
        }
        f = lmb_add_wrap(f, d);
        lmb_plane_step(&diffuse);
        lmb_plane_step(&specular);
        pixel++;
    } while (++at != end);
}

#endif

/* One row of a triangle, from column x on: all of it, or what is seen of it. */
static ALWAYS_INLINE void fill_row(const lmb_paint *paint, const lmb_triangle *t, const depth_rows *rows, uint16_t *row,
                                   int32_t x, int32_t end, const gleam_use gleam, uint16_t colour, const corner_steps *steps,
                                   const filling how)
{
    const bool deep = has_depth(rows, how);
    uint16_t *const stored = rows->stored;
    depth_row depth;
    if (how.depth == DEPTH_NEVER || (LMB_LOOPS && !deep)) {
        fill_run(paint, t, row, x, end, gleam, colour, steps, how);
        return;
    }
    depth.stored = depth.end = NULL;
    depth.f = depth.d = 0;
    if (deep) {
        depth.stored = stored + x;
        depth.end = stored + end;
        depth.d = rows->dx;
        depth.f = lmb_add_wrap(rows->f, lmb_mul_wrap(x, depth.d));
    }
#if LMB_WITH_RAMPS && LMB_WITH_DEPTH
    if (how.depth == DEPTH_ALWAYS && how.specular) {
        lit_run_seen(paint, row + x, &depth, term_of(&t->u.light[0].diffuse, columns_at(t, x, how), how.straight),
                     lmb_plane_term(&t->u.light[0].specular, columns_at(t, x, how)), gleam, how);
        return;
    }
#endif
    for (;;) {
        if (deep) {
            if (LMB_LOOPS) {
                depth_run(&depth);
            } else {
                lmb_depth_run(&depth);
            }
            if (depth.stored == depth.seen) return;
            x = (int32_t)(depth.seen - stored);
            end = (int32_t)(depth.stored - stored);
            FORGET();
        }
        fill_run(paint, t, row, x, end, gleam, colour, steps, how);
        if (depth.stored == depth.end) return;
        FORGET();
    }
}

/* Whether strides stay in registers from row to row: where pixels leave enough of them. */
static ALWAYS_INLINE bool keeps_strides(const filling how)
{
#if defined(__thumb__) && !defined(__thumb2__)
    return !how.diffuse && !how.specular;
#elif defined(__arm__)
    return !how.specular;
#else
    (void)how;
    return true;
#endif
}

/* All rows of a triangle of planes, RGB565: those above the middle corner, then those below. */
static ALWAYS_INLINE void fill_rows(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t, uint16_t colour,
                                    const corner_steps *steps, const filling how)
{
    int32_t stop = sides_begin(t, has_strides(how));
    const int32_t origin = has_strides(how) ? t->column : 0;
    uint8_t *row = row_of(surface, t->y) + 2 * (ptrdiff_t)lmb_sub(origin, surface->window.left);
    size_t pitch = surface->pitch;
    const unsigned shift = how.scaled ? (unsigned)(GLEAM_SHIFT - t->exponent[0]) : GLEAM_SHIFT;
    const bool glares = how.ramp == RAMP_EVEN && how.saturates && how.depth == DEPTH_NEVER;
    const gleam_use gleam = {shift, how.ramp != RAMP_UNEVEN, how.saturates, glares, glares ? t->glare : 0};
    depth_rows depth;
    if (how.depth != DEPTH_NEVER) depth_begin(&depth, surface, t, origin);
    if (how.specular && how.ramp == RAMP_EVEN) t->u.light[0].diffuse.f = lmb_sub_wrap(t->u.light[0].diffuse.f, LIT_BELOW);
    for (;;) {
        int32_t rows = lmb_sub(stop, t->y);
        lmb_stride side[2];
        t->y = stop;
        if (has_strides(how) && keeps_strides(how)) {
            side[0] = t->walk.stride[0];
            side[1] = t->walk.stride[1];
        }
        do {
            int32_t x, end;
            PUT_BY(row);
            PUT_BY(rows);
            PUT_BY(pitch);
            sides_next(t, keeps_strides(how) ? side : t->walk.stride, &x, &end, has_strides(how), how.ramp == RAMP_UNEVEN);
            if (end > x) fill_row(paint, t, &depth, (uint16_t *)(void *)row, x, end, gleam, colour, steps, how);
            FORGET();
            PUT_BY(row);
            PUT_BY(pitch);
            row += pitch;
            if (has_depth(&depth, how)) depth_next(&depth);
            if (how.diffuse) plane_next(&t->u.light[0].diffuse, how.straight);
            if (how.specular) plane_next(&t->u.light[0].specular, how.summed);
            FORGET();
        } while (--rows != 0);
        if (t->y == t->y_end) return; /* that is stop, which has no register */
        if (has_strides(how) && keeps_strides(how)) {
            t->walk.stride[0].x = side[0].x;
            t->walk.stride[1].x = side[1].x;
        }
        stop = sides_turn(t, has_strides(how));
    }
}

/* -------------------------------------------------------------------------------------------------------------- one colour */

#define SOLIDS (LMB_WITH_CORNERS || LMB_WITH_PLANS)
#if SOLIDS || (LMB_LOOPS && LMB_WITH_RAMPS)

static NOINLINE void fill_solid_any(const lmb_surface *surface, lmb_triangle *t, uint16_t colour)
{
    const filling how = {.ramp = RAMP_UNEVEN, .straight = true, .depth = DEPTH_MAYBE};
    fill_rows(surface, NULL, t, colour, NULL, how);
}

#if LMB_LOOPS
static NOINLINE void fill_solid_even(const lmb_surface *surface, lmb_triangle *t, uint16_t colour)
{
    const filling how = {.straight = true};
    fill_rows(surface, NULL, t, colour, NULL, how);
}
#endif

static void fill_solid(const lmb_surface *surface, lmb_triangle *t, uint16_t colour)
{
#if LMB_LOOPS
    if (t->inside && !surface->depth && is_small(t)) {
        fill_solid_even(surface, t, colour);
        return;
    }
#endif
    fill_solid_any(surface, t, colour);
}

#endif

#if SOLIDS

/* The colour of a flat triangle, whose terms are lit. */
static uint16_t flat_colour(const lmb_paint *paint, const lmb_triangle *t)
{
    uint32_t sum[3] = {paint->ambient[0], paint->ambient[1], paint->ambient[2]};
    unsigned i;
    for (i = 0; i < lmb_look_lights(&paint->look); i++) {
        if (lmb_bit(t->diffuse_on, i)) add_light(sum, paint->light[i].diffuse, intensity(t->u.light[i].diffuse.f));
        if (lmb_bit(t->specular_on, i)) add_light(sum, paint->light[i].specular, intensity(t->u.light[i].specular.f));
        saturate(sum, LMB_RGB565);
    }
    return STORE_ORDER(pixel_of_565(sum));
}

/* The colour of a triangle whose terms are constant, of one light that is reckoned for each pixel. */
static uint16_t level_colour(const lmb_paint *paint, const lmb_triangle *t)
{
    const int32_t diffuse = t->diffuse_on ? t->u.light[0].diffuse.f : 0;
    if (!t->specular_on) return pixel_565(paint, diffuse, 0, 0);
    return pixel_565(paint, diffuse, t->u.light[0].specular.f, (unsigned)(GLEAM_SHIFT - t->exponent[0]));
}

/* Whether all of a triangle has one colour that is told at once. */
static bool is_solid(const lmb_paint *paint, const lmb_triangle *t)
{
    if (lmb_paint_is_simple(paint)) return t->kind == LMB_SPAN_FLAT;
    return !(t->diffuse_on | t->specular_on) || (LMB_WITH_CORNERS && paint->look.model == LMB_MODEL_FLAT);
}

#endif

/* ---------------------------------------------------------------------------------------------------------------- Gouraud */

#if GOURAUD_ROWS

static NOINLINE void fill_corners(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t, const corner_steps *steps)
{
    const filling how = {
        .diffuse = true, .specular = true, .ramp = RAMP_UNEVEN, .straight = true, .summed = true, .depth = DEPTH_MAYBE};
    fill_rows(surface, paint, t, 0, steps, how);
}

static NOINLINE void fill_corners_dull(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t,
                                       const corner_steps *steps)
{
    const filling how = {.diffuse = true, .ramp = RAMP_UNEVEN, .straight = true, .summed = true, .depth = DEPTH_MAYBE};
    fill_rows(surface, paint, t, 0, steps, how);
}

/* One light; dull: without a highlight. */
static void fill_gouraud(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    static const lmb_plane none = {0, 0, 0, 0, 0, 0};
    corner_steps steps;
    if (!t->diffuse_on) t->u.light[0].diffuse = none;
    if (!t->specular_on) t->u.light[0].specular = none;
    corner_steps_set(&steps, paint, t->u.light[0].diffuse.dx, t->u.light[0].specular.dx);
    if (t->specular_on) {
        fill_corners(surface, paint, t, &steps);
    } else {
        fill_corners_dull(surface, paint, t, &steps);
    }
}

#endif

/* -------------------------------------------------------------------------------------------------------- one light, ramps */

#if LMB_WITH_RAMPS

#if LMB_LOOPS

static NOINLINE void fill_plain(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_plain_straight(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true, .straight = true};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_plain_low(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true, .ramp = RAMP_LOW};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_plain_uneven(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true, .ramp = RAMP_UNEVEN, .depth = DEPTH_MAYBE};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_lit(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true, .specular = true};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_lit_straight(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true, .specular = true, .straight = true};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_lit_bright(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true, .specular = true, .saturates = true};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_lit_scaled(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true, .specular = true, .ramp = RAMP_LOW, .scaled = true, .saturates = true};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_lit_uneven(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {
        .diffuse = true, .specular = true, .ramp = RAMP_UNEVEN, .scaled = true, .saturates = true, .depth = DEPTH_MAYBE};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_plain_deep(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true, .ramp = RAMP_LOW, .depth = DEPTH_ALWAYS};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_lit_deep(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {.diffuse = true, .specular = true, .depth = DEPTH_ALWAYS};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static NOINLINE void fill_lit_deep_bright(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    const filling how = {
        .diffuse = true, .specular = true, .ramp = RAMP_LOW, .scaled = true, .saturates = true, .depth = DEPTH_ALWAYS};
    fill_rows(surface, paint, t, 0, NULL, how);
}

static bool is_curved(const lmb_plane *plane) { return (plane->bow | plane->dxy | plane->dyy) != 0; }

/* The steps of highlights, up to one that does, that with a step of diffuse light do not run over. Neither ramp ever falls. */
static uint32_t steps_below(const lmb_paint *paint, uint32_t diffuse, uint32_t running_over)
{
    uint32_t low = 0;
    while (low < running_over) {
        const uint32_t middle = (low + running_over) >> 1;
        if (carries_565(paint->ramp[diffuse], paint->ramp[LMB_RAMP_TOP + middle])) {
            running_over = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

/* The loops with the least in them that serve a triangle; even: N.L stays on its ramp, or low: falls below it, and no column lies
 * outside of the window. */
static void fill_highlight(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t, bool even, bool low, int32_t ramp)
{
    const int32_t gleam = t->gleam >> (GLEAM_SHIFT - 2 - t->exponent[0]);
    const bool scaled = low || t->exponent[0];
    if (!even || gleam >= LMB_GLEAM_TOP - 4) {
        fill_lit_uneven(surface, paint, t);
    } else if (LMB_WITH_DEPTH && surface->depth) {
        if (scaled || carries_565(paint->ramp[ramp + 1], paint->ramp[LMB_RAMP_TOP + gleam + 4])) {
            fill_lit_deep_bright(surface, paint, t);
        } else {
            fill_lit_deep(surface, paint, t);
        }
    } else if (scaled) {
        fill_lit_scaled(surface, paint, t);
    } else if (carries_565(paint->ramp[ramp + 1], paint->ramp[LMB_RAMP_TOP + gleam + 4])) {
        t->glare = (int32_t)(steps_below(paint, (uint32_t)ramp + 1, (uint32_t)gleam + 4) << GLEAM_SHIFT);
        fill_lit_bright(surface, paint, t);
    } else if (is_curved(&t->u.light[0].diffuse)) {
        fill_lit(surface, paint, t);
    } else {
        fill_lit_straight(surface, paint, t);
    }
}

static void fill_diffuse(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t, bool even, bool low)
{
    if (!even) {
        fill_plain_uneven(surface, paint, t);
    } else if (LMB_WITH_DEPTH && surface->depth) {
        fill_plain_deep(surface, paint, t);
    } else if (low) {
        fill_plain_low(surface, paint, t);
    } else if (is_curved(&t->u.light[0].diffuse)) {
        fill_plain(surface, paint, t);
    } else {
        fill_plain_straight(surface, paint, t);
    }
}

static void fill_simple(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    static const lmb_plane none = {0, 0, 0, 0, 0, 0};
    const int32_t ramp = t->high >> (RAMP_SHIFT - 2);
    const bool even = t->inside && !t->rough && ramp < LMB_RAMP_TOP - 1 && /* a step for what planes err */
                      (LMB_WITH_LARGE || is_small(t));                     /* those that are not count as rough */
    const bool low = t->low >> (RAMP_SHIFT - 2) < 1;
    if (!t->diffuse_on && !t->specular_on) {
        fill_solid(surface, t, STORE_ORDER(paint->ramp[0]));
    } else if (LMB_WITH_GLOSS && t->specular_on) {
        if (!t->diffuse_on) t->u.light[0].diffuse = none;
        fill_highlight(surface, paint, t, even, low, ramp);
    } else {
        fill_diffuse(surface, paint, t, even, low);
    }
}

#else

/* One loop for all: what a triangle lacks is drawn as nothing. */
static void fill_simple(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    static const lmb_plane none = {0, 0, 0, 0, 0, 0};
    const filling how = {.diffuse = true,
                         .specular = LMB_WITH_GLOSS,
                         .ramp = RAMP_UNEVEN,
                         .scaled = true,
                         .saturates = true,
                         .depth = DEPTH_MAYBE};
    if (!t->diffuse_on) t->u.light[0].diffuse = none;
    if (LMB_WITH_GLOSS && !t->specular_on) {
        t->u.light[0].specular = none;
        t->exponent[0] = 0;
    }
    fill_rows(surface, paint, t, 0, NULL, how);
}

#endif

/* What is always so where nothing else is built in. */
static bool is_ramped(const lmb_paint *paint)
{
    return paint->ramped || (LMB_WITH_RGB565 && !LMB_WITH_RGB888 && LMB_LIGHTS == 1 && !LMB_WITH_CORNERS);
}
static bool is_plane(const lmb_triangle *t) { return t->kind == LMB_SPAN_PLANE || (!LMB_WITH_ARC && !SOLIDS); }

#endif

#endif

/* What is not served row by row. */
static void fill_spans(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    lmb_span span;
    while (lmb_triangle_next(t, &span)) lmb_fill_span(surface, paint, &span);
}

/* All but ramps; out of line, as it takes more stack than these. */
static NOINLINE void fill_others(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
#if LMB_WITH_RGB565 && SOLIDS
    if (is_rgb565(surface)) {
        if (is_solid(paint, t)) {
            fill_solid(surface, t, lmb_paint_is_simple(paint) ? level_colour(paint, t) : flat_colour(paint, t));
            return;
        }
#if GOURAUD_ROWS
        if (paint->look.model == LMB_MODEL_GOURAUD && lmb_look_lights(&paint->look) == 1) {
            fill_gouraud(surface, paint, t);
            return;
        }
#endif
    }
#endif
    fill_spans(surface, paint, t);
}

void lmb_fill_triangle(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *t)
{
    if (t->y >= t->y_end) return; /* drawn before */
#if LMB_WITH_RGB565 && LMB_WITH_RAMPS
    if (is_ramped(paint) && is_plane(t)) {
        fill_simple(surface, paint, t);
        return;
    }
#endif
    fill_others(surface, paint, t);
}
