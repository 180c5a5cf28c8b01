/* SPDX-License-Identifier: MIT */
/* Kernels: what one pixel, span, triangle, vertex or evaluation costs, measured where it is executed.
 *
 *   pixel-*                    a triangle's top 16 rows in a window of 80 and of 16 columns: the difference, over 16 x 64 pixels
 *   span-quadratic, span-arc   32 and 16 rows in windows of 80 and 16 columns: what 16 rows more cost at no width
 *   span-* of a comparison     its loop over 80 and over 16 pixels: the difference over 64
 *   span-arc-setup             both terms of a span between two normals, as a row begins them once its edges have given these: the
 *                              mean of 18 spans that turn by 2 to 40 degrees, of 7 to 64 pixels, first pixels anywhere in theirs.
 *                              Up to 13 degrees the library takes a curve (RGB888, the scene's exponent), then an arc
 *   span-arc-setup-565         the same of the eleven spans of up to 17 degrees as RGB565 takes them if n is up to 32: rough curves,
 *                              which end at 19 degrees
 *   triangle-gloss, -worst     lmb_triangle_begin of triangles that are drawn, and the beginning of their sides: the mean of
 *                              icosphere-320, the most of all scenes
 *   vertex                     lmb_mesh_project over the vertices of icosphere-320
 *   step-*                     step_kernels.c
 *
 * Rows are filled by what fills them in frames, so it is the same loop. Whether pixels are dark or lit is checked. What is said:
 * "kernel NAME UNIT DIVISOR WEIGHT..." before as many regions as weights, "mean NAME UNIT" or "most NAME UNIT" before any number
 * of regions.
 */
#include "bench.h"

#include "../../firmware/curve.h"
#include "../../firmware/shade.h"
#include "../../port/sides.h"
#include "mark.h"

#define NARROW 16
#define WIDE 80
#define FEW 16
#define MANY 32
#define MARGIN 2
#define FAR (LMB_PROFILE_SIZE - MARGIN)

/* ------------------------------------------------------------------------- the library's calls that are measured: all of them */

static struct {
    lmb_rays rays;
    lmb_surface surface;
    lmb_vertex corner[3];
} room;

static struct profile_work *const work = &profile_work;
static uint16_t row[LMB_PROFILE_SIZE], kept[WIDE];

static bool paint_prepare(const scene *s, enum lmb_model model, enum lmb_step_kind step)
{
    lmb_look look;
    if (lmb_look_prepare(&look, &s->object[0].material, s->light, 1, model, step)) return false;
    lmb_paint_prepare(&work->paint, &look, LMB_RGB565);
    return true;
}

static bool triangle_begin(const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c)
{
    return lmb_triangle_begin(&work->triangle, &work->paint.look, &room.rays, a, b, c, &room.surface.window);
}

static void triangle_fill(void) { lmb_fill_triangle(&room.surface, &work->paint, &work->triangle); }

/* --------------------------------------------------------------------------------------------------------------------- saying */

static bool any;

static void say_line(const char *what, const char *name, const char *unit)
{
    profile_say(what);
    profile_say(" ");
    profile_say(name);
    profile_say(" ");
    profile_say(unit);
    any = true;
}

/* The sum over regions of weight times cost, over divisor. weights end with 0. */
static void say_kernel(const char *name, const char *unit, uint32_t divisor, const int8_t *weights)
{
    say_line("kernel", name, unit);
    profile_say(" ");
    profile_say_number(divisor);
    for (; *weights; weights++) {
        profile_say(*weights < 0 ? " -" : " ");
        profile_say_number((uint32_t)(*weights < 0 ? -*weights : *weights));
    }
    profile_say_end();
}

static void say_series(const char *what, const char *name, const char *unit)
{
    say_line(what, name, unit);
    profile_say_end();
}

static void say_fault(const char *name, const char *what)
{
    profile_say("error: ");
    profile_say(name);
    profile_say(what);
    profile_say_end();
}

/* ----------------------------------------------------------------------------------------------------------- pixels and spans */

enum turn { SLIGHT, LARGE, AWAY, BESIDE, TOWARDS }; /* normals that turn by 2 degrees, by 40; and where: see corners_set */

typedef struct kernel {
    const char *name;
    enum lmb_model model;
    enum lmb_step_kind step;
    enum turn turn;
} kernel;

static lmb_vec near_half(int x, int y)
{
    const lmb_vec h = work->paint.look.light[0].half;
    return lmb_normalise(h.x + x, h.y + y, h.z);
}

static void corner_set(unsigned i, int x, int y, lmb_vec normal)
{
    room.corner[i].x = x * 16;
    room.corner[i].y = y * 16;
    room.corner[i].normal = normal;
    room.corner[i].depth = 0;
}

/* A triangle whose top row is its widest, right angle at the top left. */
static void corners_set(enum turn turn)
{
    lmb_vec n[3];
    n[0] = lmb_normalise(-300, 100, 16384);
    n[1] = lmb_normalise(100, -300, 16384);
    n[2] = lmb_normalise(300, 100, 16384);
    if (turn == LARGE) {
        n[0] = lmb_normalise(-5000, 2000, 16384);
        n[1] = lmb_normalise(1000, -5000, 16384);
        n[2] = lmb_normalise(6000, 3000, 16384);
    }
    if (turn == AWAY) { /* dark on top, the middle of the highlight at the bottom */
        n[0] = lmb_normalise(-8500, 2000, 4800);
        n[1] = near_half(0, 0);
        n[2] = lmb_normalise(-8000, 1000, 5900);
    }
    if (turn == BESIDE) { /* where the highlight is a quarter of its most, and no channel saturates */
        n[0] = lmb_normalise(600, 1700, 16384);
        n[1] = lmb_normalise(900, 1300, 16384);
        n[2] = lmb_normalise(1100, 1700, 16384);
    }
    if (turn == TOWARDS) { /* in its middle, where blue saturates */
        n[0] = near_half(-900, 300);
        n[1] = near_half(300, -900);
        n[2] = near_half(900, 300);
    }
    corner_set(0, MARGIN, MARGIN, n[0]);
    corner_set(1, MARGIN, FAR, n[1]);
    corner_set(2, FAR, MARGIN, n[2]);
}

/* Cuts what has been begun at a column by an edge of its own, so that it is drawn as what no window cuts. */
static void upright(int32_t x, bool by_rows)
{
    lmb_triangle *t = &work->triangle;
    t->inside = true;
    if (STRIDES && by_rows && t->kind == LMB_SPAN_PLANE) {
        lmb_stride *right = &t->walk.stride[1];
        lmb_strides_begin(t);
        right->x = lmb_shl(lmb_sub(x, t->column), LMB_STRIDE_BITS);
        right->step = 0;
        t->y_turn = t->y_end;
    } else {
        lmb_edge *right = &t->walk.edge[1];
        lmb_triangle_walk(t);
        right->x = x;
        right->step = right->part = right->gap = 0;
    }
}

/* Begins the kernel's triangle in a window of so many columns and rows at its top left, where it fills all of it, to be filled by rows or
 * span by span. Every row of the surface lies on the first: that is memory enough. */
static bool begin(const scene *s, const kernel *k, int columns, int rows, bool by_rows)
{
    if (!paint_prepare(s, k->model, k->step)) return false;
    lmb_rays_prepare(&room.rays, &work->paint.look, NULL);
    room.rays.curve_q28 = -1; /* arcs are to be arcs, wide or narrow */
    room.rays.rough = false;
    lmb_surface_strip(&room.surface, LMB_RGB565, row, NULL, LMB_PROFILE_SIZE, 0, MARGIN + rows);
    room.surface.window.right = (int16_t)(MARGIN + columns);
    room.surface.pitch = 0;
    corners_set(k->turn);
    if (!triangle_begin(&room.corner[0], &room.corner[1], &room.corner[2])) return false;
    upright(MARGIN + columns, by_rows);
    return true;
}

static void filled(const scene *s, const kernel *k, int columns, int rows)
{
    uint32_t pixels = 0;
    if (!begin(s, k, columns, rows, false)) say_fault(k->name, " has no triangle");
    while (lmb_triangle_next(&work->triangle, &work->span)) pixels += work->span.length;
    begin(s, k, columns, rows, true);
    profile_begin();
    triangle_fill();
    profile_end();
    if (pixels != (uint32_t)columns * (uint32_t)rows) say_fault(k->name, " does not fill its window");
}

/* Pixels of the last row that differ from those without a highlight. */
static unsigned pixels_lit(const scene *s, const kernel *k)
{
    kernel plain = *k;
    unsigned i, lit = 0;
    plain.model = LMB_MODEL_DIFFUSE;
    if (begin(s, k, WIDE, FEW, true)) triangle_fill();
    for (i = 0; i < WIDE; i++) kept[i] = row[MARGIN + i];
    if (begin(s, &plain, WIDE, FEW, true)) triangle_fill();
    for (i = 0; i < WIDE; i++) lit += kept[i] != row[MARGIN + i];
    return lit;
}

static void pixel_kernel(const scene *s, const kernel *k)
{
    static const int8_t weights[] = {1, -1, 0};
    if (!profile_chosen(profile_model, k->name)) return;
    say_kernel(k->name, "pixel", (WIDE - NARROW) * FEW, weights);
    filled(s, k, WIDE, FEW);
    filled(s, k, NARROW, FEW);
    if (k->model == LMB_MODEL_GLOSS) {
        unsigned lit = pixels_lit(s, k);
        if (k->turn == AWAY && lit != 0) say_fault(k->name, " has lit pixels");
        if (k->turn >= BESIDE && lit != WIDE) say_fault(k->name, " has dark pixels");
    }
}

/* Rows of no width: WIDE times those of NARROW columns less NARROW times those of WIDE, over WIDE - NARROW. */
static void span_kernel(const scene *s, const kernel *k)
{
    static const int8_t weights[] = {WIDE, -NARROW, -WIDE, NARROW, 0};
    if (!profile_chosen(profile_model, k->name)) return;
    say_kernel(k->name, "span", (WIDE - NARROW) * (MANY - FEW), weights);
    filled(s, k, NARROW, MANY);
    filled(s, k, WIDE, MANY);
    filled(s, k, NARROW, FEW);
    filled(s, k, WIDE, FEW);
}

/* Normals up to 45 degrees off the viewer, turned by an angle towards any side. Lengths are not whole pixels, and first pixels'
 * centres lie anywhere within a pixel. */
static void arc_kernel(const scene *s, const char *name, bool exact)
{
    static const uint8_t degrees[] = {2, 3, 4, 5, 6, 8, 9, 11, 13, 15, 17, 19, 22, 25, 29, 32, 36, 40};
    static const uint8_t pixels[] = {13, 40, 8, 27, 64, 19, 51};
    lmb_span span;
    lmb_run run;
    unsigned i, length = 0;
    if (!profile_chosen(profile_model, name) || !paint_prepare(s, LMB_MODEL_GLOSS, LMB_STEP_ARC)) return;
    if (exact) lmb_look_tolerance(&work->paint.look, LMB_TOLERANCE_RGB888);
    lmb_rays_prepare(&room.rays, &work->paint.look, NULL);
    work->triangle.look = &work->paint.look;
    work->triangle.rays = &room.rays;
    work->triangle.specular_on = 1;
    say_series("mean", name, "span");
    for (i = 0; i < sizeof degrees && (exact || degrees[i] <= 18); i++) {
        const uint16_t lean = (uint16_t)(i * 1100u), turn = (uint16_t)(degrees[i] * 46603ul >> 8), about = (uint16_t)(i * 9973u);
        const lmb_matrix leant = lmb_rotation(lean & 8191u, 0, about), turned = lmb_rotation(0, turn, (uint16_t)(3u * about));
        const lmb_vec towards = {0, 0, 16384}, from = lmb_rotate(&leant, towards);
        const lmb_vec to = lmb_rotate(&leant, lmb_rotate(&turned, towards));
        run.start = (i * 40503u) & 65535u;
        run.length = pixels[length] * LMB_ARC_PIXEL - (i * 30011u & 65535u);
        if (++length == sizeof pixels) length = 0;
        span.kind = LMB_SPAN_ARC;
        lmb_end_place(&run.ends.from, from.x, from.y, from.z);
        lmb_end_place(&run.ends.to, to.x, to.y, to.z);
        profile_begin();
        lmb_run_terms(&work->triangle, &span, &run);
        profile_end();
    }
}

/* ----------------------------------------------------------------------------------------------------- triangles and vertices */

/* Every triangle of a scene that is drawn, by itself. */
static void triangles(const scene *s)
{
    const scene_object *o = &s->object[0];
    uint32_t i;
    if (s->objects != 1 || !PROFILE_FITS(o->mesh) || !paint_prepare(s, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC)) return;
    lmb_rays_prepare(&room.rays, &work->paint.look, &o->pose.rotation);
    lmb_shade_bend(&room.rays, &work->paint.look, o->mesh->bend);
    lmb_surface_strip(&room.surface, LMB_RGB565, row, NULL, s->width, 0, s->height);
    lmb_mesh_project(o->mesh, &o->pose, &s->camera, profile_memory.vertices);
    for (i = 0; i < o->mesh->triangles; i++) {
        const LMB_FLASH uint16_t *index = o->mesh->indices + 3 * i;
        const lmb_vertex *a = &profile_memory.vertices[index[0]], *b = &profile_memory.vertices[index[1]],
                         *c = &profile_memory.vertices[index[2]];
        if (!triangle_begin(a, b, c)) continue;
        profile_begin();
        triangle_begin(a, b, c);
        sides_begin(&work->triangle, STRIDES);
        profile_end();
    }
}

static void triangle_kernels(scene *s)
{
    unsigned i;
    if (profile_chosen(profile_model, "triangle-gloss")) {
        say_series("mean", "triangle-gloss", "triangle");
        triangles(s);
    }
    if (profile_chosen(profile_model, "triangle-gloss-worst")) {
        say_series("most", "triangle-gloss-worst", "triangle");
        for (i = 0; i < scene_count(); i++) {
            scene_make(s, i);
            triangles(s);
        }
        scene_make(s, 0);
    }
}

static void vertex_kernel(const scene *s)
{
    static const int8_t once[] = {1, 0};
    const scene_object *o = &s->object[0];
    if (!profile_chosen(profile_model, "vertex")) return;
    say_kernel("vertex", "vertex", o->mesh->vertices, once);
    profile_begin();
    lmb_mesh_project(o->mesh, &o->pose, &s->camera, profile_memory.vertices);
    profile_end();
}

/* --------------------------------------------------------------------------------------------------------------- comparisons */

#if LMB_PROFILE_COMPARED

static void compared_spans(const scene *s)
{
    static const int8_t weights[] = {1, -1, 0};
    struct profile_compared *c = &profile_memory.compared;
    unsigned i, n;
    if (compare_look_prepare(&c->look, &s->object[0].material, s->light)) return;
    for (i = 0; i < compare_span_count; i++) {
        const compare_span_kernel *k = &compare_spans[i];
        if (!profile_chosen(profile_model, k->name)) continue;
        k->begin(&c->span, &c->look, near_half(-900, 300), near_half(900, 300), WIDE);
        say_kernel(k->name, "pixel", WIDE - NARROW, weights);
        for (n = WIDE; n != 0; n = n == WIDE ? NARROW : 0) {
            profile_begin();
            k->fill(&c->span, row, n);
            profile_end();
        }
    }
}

#endif

static const kernel pixel_kernels[] = {
    {"pixel-plain-linear", LMB_MODEL_DIFFUSE, LMB_STEP_QUADRATIC, SLIGHT},
    {"pixel-plain-quadratic", LMB_MODEL_DIFFUSE, LMB_STEP_QUADRATIC, LARGE},
    {"pixel-diffuse-arc", LMB_MODEL_DIFFUSE, LMB_STEP_ARC, LARGE},
    {"pixel-dark", LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, AWAY},
    {"pixel-lit", LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, BESIDE},
    {"pixel-lit-bright", LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, TOWARDS},
    {"pixel-lit-arc", LMB_MODEL_GLOSS, LMB_STEP_ARC, BESIDE},
};
static const kernel span_kernels[] = {
    {"span-quadratic", LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, LARGE},
    {"span-arc", LMB_MODEL_GLOSS, LMB_STEP_ARC, LARGE},
};

bool profile_kernels(void)
{
    scene *s = &work->scene;
    unsigned i;
    scene_make(s, 0);
    for (i = 0; i < sizeof pixel_kernels / sizeof pixel_kernels[0]; i++) pixel_kernel(s, &pixel_kernels[i]);
    for (i = 0; i < sizeof span_kernels / sizeof span_kernels[0]; i++) span_kernel(s, &span_kernels[i]);
    arc_kernel(s, "span-arc-setup", true);
    arc_kernel(s, "span-arc-setup-565", false);
    triangle_kernels(s);
    vertex_kernel(s);
#if LMB_PROFILE_COMPARED
    paint_prepare(s, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC);
    compared_spans(s);
#endif
    return any;
}
