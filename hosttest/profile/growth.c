/* SPDX-License-Identifier: MIT */
/* How the cost of a frame grows: a sphere with more and more triangles, on more and more pixels, in lower and lower strips. Frames
 * as in bench.c: vertices projected once, triangles set up and filled in each strip; all in RGB565, without depth.
 *
 * Scenes are named by what grows and how far: triangles-5120, pixels-480, rows-8; rows-anew: without room for projected vertices,
 * which are then projected for each triangle and strip anew.
 */
#include "growth.h"

#include "mark.h"

#define SIZE_MAX_PX 480
#define VERTICES_MAX 10242

static lmb_vertex vertices[VERTICES_MAX];
static uint16_t pixels[SIZE_MAX_PX * SIZE_MAX_PX];
static lmb_paint paint;
static lmb_walk walk;
static lmb_triangle triangle;
static lmb_span span;

static void say_count(const char *name, uint32_t n)
{
    profile_say(" ");
    profile_say(name);
    profile_say(" ");
    profile_say_number(n);
}

static void say_frame(const growth_frame *f)
{
    profile_say("scene ");
    profile_say(f->axis);
    profile_say("-");
    profile_say_number(f->value);
    profile_say(f->model == LMB_MODEL_GLOSS ? " gloss" : " diffuse");
    profile_say(" rgb565 ");
    profile_say_number(f->mesh->triangles);
    say_count("size", (uint32_t)f->size);
    say_count("rows", (uint32_t)f->rows);
    profile_say_end();
}

static int strip(lmb_surface *surface, const growth_frame *f, int top)
{
    const int bottom = top + f->rows < f->size ? top + f->rows : f->size;
    lmb_surface_strip(surface, LMB_RGB565, pixels, NULL, f->size, top, bottom);
    return bottom;
}

/* The same walk again, uncounted, to say what there was. */
static void say_counts(const growth_frame *f, const scene *s)
{
    const lmb_pose *pose = &s->object[0].pose;
    uint32_t drawn = 0, spans = 0, painted = 0;
    lmb_surface surface;
    int top, bottom;
    for (top = 0; top < f->size; top = bottom) {
        bottom = strip(&surface, f, top);
        lmb_mesh_begin(&walk, f->mesh, pose, &s->camera, &paint.look, &surface.window, vertices, NULL);
        while (lmb_mesh_next(&walk, &triangle)) {
            drawn++;
            for (; lmb_triangle_next(&triangle, &span); spans++) painted += span.length;
        }
    }
    profile_say("counts");
    say_count("pixels", painted);
    say_count("spans", spans);
    say_count("triangles", drawn);
    say_count("vertices", f->mesh->vertices);
    profile_say_end();
}

static void measure(const growth_frame *f)
{
    static scene s;
    lmb_surface surface;
    int top, bottom;
    if (!growth_prepare(f, &s, &paint)) return;
    say_frame(f);
    profile_begin();
    if (!f->anew) lmb_mesh_project(f->mesh, &s.object[0].pose, &s.camera, vertices);
    for (top = 0; top < f->size; top = bottom) {
        bottom = strip(&surface, f, top);
        lmb_draw_mesh(&surface, f->mesh, &s.object[0].pose, &s.camera, &paint, f->anew ? NULL : vertices, NULL);
    }
    profile_end();
    say_counts(f, &s);
}

int main(void)
{
    growth_frames(measure);
    return 0;
}
