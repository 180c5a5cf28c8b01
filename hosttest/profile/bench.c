/* SPDX-License-Identifier: MIT */
/* What is profiled: whole frames of the demo scenes, drawn into memory with each model and each method of comparison, and the
 * kernels (kernels.c).
 *
 * Counted in a frame: vertices projected once, triangles set up, spans filled. Not counted: preparing a paint, clearing. Where
 * memory holds a whole frame it is one surface; where not it is drawn strip by strip. Pixels, spans and triangles are counted by
 * walking the mesh a second time, uncounted.
 */
#include "bench.h"

#include "mark.h"

#define COMPARED (LMB_PROFILE_COMPARED && LMB_PROFILE_WHOLE) /* methods of comparison paint whole frames, without depth */

struct profile_work profile_work;
union profile_memory profile_memory;

#if LMB_PROFILE_WHOLE
static uint16_t depth[LMB_PROFILE_SIZE * LMB_PROFILE_SIZE];
#endif
#if COMPARED
static compare_room room[LMB_PROFILE_VERTICES];
#endif

static const struct {
    const char *name;
    enum lmb_model model;
    enum lmb_step_kind step;
} models[] = {{"flat", LMB_MODEL_FLAT, LMB_STEP_QUADRATIC},       {"gouraud", LMB_MODEL_GOURAUD, LMB_STEP_QUADRATIC},
              {"diffuse", LMB_MODEL_DIFFUSE, LMB_STEP_QUADRATIC}, {"gloss", LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC},
              {"gloss-arc", LMB_MODEL_GLOSS, LMB_STEP_ARC},       {"gloss-planned", LMB_MODEL_GLOSS, LMB_STEP_PLANNED}};
#define MODELS (sizeof models / sizeof models[0])

typedef struct counts {
    uint32_t pixels, spans, triangles;
} counts;

static bool same(const char *a, const char *b)
{
    while (*a && *a == *b) {
        a++;
        b++;
    }
    return *a == *b;
}

bool profile_chosen(const char *choice, const char *name) { return !*choice || same(choice, name); }

/* Rows of a scene that memory holds behind its vertices. */
static int rows_of(const scene *s, enum lmb_format format)
{
    uint32_t row = (uint32_t)s->width * lmb_format_bytes(format),
             used = row + s->object[0].mesh->vertices * (uint32_t)sizeof(lmb_vertex);
    int rows = 0;
    for (; used <= LMB_PROFILE_BYTES && rows < s->height; used += row) rows++;
    return rows;
}

/* A surface of the strip that begins at row top. Returns the row behind it. */
static int strip(lmb_surface *surface, const scene *s, enum lmb_format format, int rows, int top)
{
    int bottom = top + rows < s->height ? top + rows : s->height;
    uint16_t *pixels = profile_memory.pixels + s->object[0].mesh->vertices * sizeof(lmb_vertex) / 2;
#if LMB_PROFILE_WHOLE
    lmb_surface_strip(surface, format, pixels, s->depth ? depth : NULL, s->width, top, bottom);
#else
    lmb_surface_strip(surface, format, pixels, NULL, s->width, top, bottom);
#endif
    return bottom;
}

/* The same walk as lmb_draw_mesh's, to count what it does. */
static void count(counts *c, const scene *s, const lmb_paint *paint)
{
    const scene_object *o = &s->object[0];
    struct profile_work *w = &profile_work;
    lmb_surface surface;
    const enum lmb_format format = (enum lmb_format)paint->format;
    int rows = rows_of(s, format), top, bottom;
    c->pixels = c->spans = c->triangles = 0;
    for (top = 0; top < s->height; top = bottom) {
        bottom = strip(&surface, s, format, rows, top);
        lmb_mesh_begin(&w->walk, o->mesh, &o->pose, &s->camera, &paint->look, &surface.window, profile_memory.vertices, NULL);
        while (lmb_mesh_next(&w->walk, &w->triangle)) {
            c->triangles++;
            while (lmb_triangle_next(&w->triangle, &w->span)) {
                c->spans++;
                c->pixels += w->span.length;
            }
        }
    }
}

static void say_count(const char *name, uint32_t n)
{
    profile_say(" ");
    profile_say(name);
    profile_say(" ");
    profile_say_number(n);
}

static void say_scene(const scene *s, enum lmb_format format, const char *model)
{
    profile_say("scene ");
    profile_say(s->name);
    profile_say(" ");
    profile_say(model);
    profile_say(format == LMB_RGB565 ? " rgb565 " : " rgb888 ");
    profile_say_number(s->object[0].mesh->triangles);
    say_count("size", (uint32_t)s->width);
    say_count("rows", (uint32_t)rows_of(s, format));
    profile_say_end();
}

/* After a frame. drawn: triangles, or pixels, as the renderer counts them, which must be those of the walk. */
static void say_counts(const scene *s, uint32_t drawn, bool triangles)
{
    counts c;
    count(&c, s, &profile_work.paint);
    if (drawn != (triangles ? c.triangles : c.pixels)) {
        profile_say("error: the walk counts ");
        profile_say_number(triangles ? c.triangles : c.pixels);
        profile_say(triangles ? " triangles, but drawn were " : " pixels, but drawn were ");
        profile_say_number(drawn);
        profile_say_end();
    }
    profile_say("counts");
    say_count("pixels", c.pixels);
    say_count("spans", c.spans);
    say_count("triangles", c.triangles);
    say_count("vertices", s->object[0].mesh->vertices);
    profile_say_end();
}

static bool prepare(const scene *s, unsigned model)
{
    lmb_look look;
    if (lmb_look_prepare(&look, &s->object[0].material, s->light, s->lights, models[model].model, models[model].step))
        return false;
    lmb_paint_prepare(&profile_work.paint, &look, LMB_RGB565);
    return true;
}

void profile_frame(const scene *s, const char *name)
{
    const scene_object *o = &s->object[0];
    const enum lmb_format format = (enum lmb_format)profile_work.paint.format;
    lmb_surface surface;
    uint32_t drawn = 0;
    int rows = rows_of(s, format), top, bottom;
    say_scene(s, format, name);
    strip(&surface, s, format, rows, 0);
    lmb_clear(&surface, s->background);
    profile_begin();
    lmb_mesh_project(o->mesh, &o->pose, &s->camera, profile_memory.vertices);
    for (top = 0; top < s->height; top = bottom) {
        bottom = strip(&surface, s, format, rows, top);
        drawn += lmb_draw_mesh(&surface, o->mesh, &o->pose, &s->camera, &profile_work.paint, profile_memory.vertices, NULL);
    }
    profile_end();
    say_counts(s, drawn, true);
}

#if COMPARED
static void draw_compared(const scene *s, const compare_frame *frame)
{
    const scene_object *o = &s->object[0];
    static compare_look compared;
    lmb_surface surface;
    uint32_t drawn;
    if (!prepare(s, MODELS - 1) || compare_look_prepare(&compared, &o->material, s->light)) return;
    say_scene(s, LMB_RGB565, frame->name);
    strip(&surface, s, LMB_RGB565, s->height, 0);
    lmb_clear(&surface, s->background);
    profile_begin();
    lmb_mesh_project(o->mesh, &o->pose, &s->camera, profile_memory.vertices);
    drawn = frame->draw(&surface, o->mesh, &o->pose, &compared, profile_memory.vertices, room);
    profile_end();
    say_counts(s, drawn, false);
}
#endif

/* Strips of fewer rows would measure the setting up of triangles over and over. */
static bool fits(const scene *s, enum lmb_format format)
{
    const int rows = PROFILE_FITS(s->object[0].mesh) ? rows_of(s, format) : 0;
    return s->objects == 1 && (rows == s->height || rows >= 16) && (LMB_PROFILE_WHOLE || !s->depth);
}

static bool figured(const char *name)
{
    return same(name, "icosphere-320") || same(name, "icosphere-1280") || same(name, "icosphere-128") || same(name, "teapot") ||
           same(name, "torus");
}

bool profile_measures(const scene *s, enum lmb_format format)
{
    return figured(s->name) && profile_chosen(profile_scene, s->name) && fits(s, format);
}

static bool scene_measured(const scene *s)
{
    bool any = false;
    unsigned k;
    for (k = 0; k < MODELS; k++) {
        if (profile_chosen(profile_model, models[k].name) && prepare(s, k)) {
            profile_frame(s, models[k].name);
            any = true;
        }
    }
#if COMPARED
    for (k = 0; k < compare_frame_count && !s->depth; k++) {
        if (profile_chosen(profile_model, compare_frames[k].name)) {
            draw_compared(s, &compare_frames[k]);
            any = true;
        }
    }
#endif
    return any;
}

static void say_choice(void)
{
    unsigned k;
    profile_say("error: no such scene and model. Scenes here: kernels");
    for (k = 0; k < scene_count(); k++) {
        scene *s = &profile_work.scene;
        scene_make(s, k);
        if (!figured(s->name) || !fits(s, LMB_RGB565)) continue;
        profile_say(" ");
        profile_say(s->name);
    }
    profile_say("; models:");
    for (k = 0; k < MODELS; k++) {
        profile_say(" ");
        profile_say(models[k].name);
    }
#if COMPARED
    profile_say("; and of icosphere scenes:");
    for (k = 0; k < compare_frame_count; k++) {
        profile_say(" ");
        profile_say(compare_frames[k].name);
    }
#endif
    profile_say_end();
}

bool profile_frames(void)
{
    scene *s = &profile_work.scene;
    bool any = false;
    unsigned i;
    for (i = 0; i < scene_count(); i++) {
        scene_make(s, i);
        if (profile_measures(s, LMB_RGB565)) any = scene_measured(s) || any;
    }
    return any;
}

int main(void)
{
    bool any = false;
    unsigned i;
    for (i = 0; i < PROFILE_PARTS; i++) {
        const bool frames = i == PROFILE_FRAMES || i == PROFILE_SWEEP;
        if (profile_part[i] && (frames || profile_chosen(profile_scene, "kernels"))) any = profile_part[i]() || any;
    }
    if (!any) say_choice();
    return 0;
}
