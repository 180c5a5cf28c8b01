/* SPDX-License-Identifier: MIT */
/* How the cost of a frame grows: a sphere with more and more triangles, on more and more pixels, in lower and lower strips. Frames
 * as in bench.c: vertices projected once, triangles set up and filled in each strip; all in RGB565, without depth.
 *
 * Scenes are named by what grows and how far: triangles-5120, pixels-480, rows-8; rows-anew: without room for projected vertices,
 * which are then projected for each triangle and strip anew.
 */
#include "../../port/demo/scenes.h"
#include "mark.h"

#define SIZE_MAX_PX 480
#define VERTICES_MAX 10242

extern const lmb_mesh mesh_icosphere_20, mesh_icosphere_80, mesh_icosphere_5120, mesh_icosphere_20480;
extern const lmb_mesh mesh_icosphere_320, mesh_icosphere_1280;

static lmb_vertex vertices[VERTICES_MAX];
static uint16_t pixels[SIZE_MAX_PX * SIZE_MAX_PX];
static lmb_paint paint;
static lmb_walk walk;
static lmb_triangle triangle;
static lmb_span span;

/* A frame to measure. */
typedef struct frame {
    const char *axis;
    uint32_t value; /* along that axis */
    const lmb_mesh *mesh;
    enum lmb_model model;
    int size, rows;
    bool anew; /* corners are projected for each triangle anew */
} frame;

static void say_count(const char *name, uint32_t n)
{
    profile_say(" ");
    profile_say(name);
    profile_say(" ");
    profile_say_number(n);
}

static void say_frame(const frame *f)
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

static int strip(lmb_surface *surface, const frame *f, int top)
{
    const int bottom = top + f->rows < f->size ? top + f->rows : f->size;
    lmb_surface_strip(surface, LMB_RGB565, pixels, NULL, f->size, top, bottom);
    return bottom;
}

/* The same walk again, uncounted, to say what there was. */
static void say_counts(const frame *f, const scene *s)
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

static void measure(const frame *f)
{
    static scene s;
    lmb_look look;
    lmb_surface surface;
    int top, bottom;
    scene_make(&s, 0);
    lmb_camera_orthographic(&s.camera, f->size, f->size, f->size * 30037L, 65536, 8 * 65536L); /* 110 of 240 pixels */
    if (lmb_look_prepare(&look, &s.object[0].material, s.light, 1, f->model, LMB_STEP_QUADRATIC)) return;
    lmb_paint_prepare(&paint, &look, LMB_RGB565);
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
    static const lmb_mesh *const meshes[] = {&mesh_icosphere_20,   &mesh_icosphere_80,   &mesh_icosphere_320,
                                             &mesh_icosphere_1280, &mesh_icosphere_5120, &mesh_icosphere_20480};
    static const uint16_t sizes[] = {32, 48, 64, 96, 128, 160, 240, 320, 400, 480}, rows[] = {120, 60, 30, 16, 8, 4, 2};
    frame f;
    unsigned i, model;
    f.anew = false;
    for (model = 0; model < 2; model++) {
        f.model = model ? LMB_MODEL_DIFFUSE : LMB_MODEL_GLOSS;
        f.axis = "triangles";
        f.size = f.rows = 240;
        for (i = 0; i < sizeof meshes / sizeof meshes[0]; i++) {
            f.mesh = meshes[i];
            f.value = f.mesh->triangles;
            measure(&f);
        }
        f.axis = "pixels";
        f.mesh = &mesh_icosphere_320;
        for (i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
            f.value = sizes[i];
            f.size = f.rows = sizes[i];
            measure(&f);
        }
    }
    f.model = LMB_MODEL_GLOSS;
    f.axis = "rows";
    f.mesh = &mesh_icosphere_1280;
    f.size = 240;
    for (i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        f.value = rows[i];
        f.rows = rows[i];
        measure(&f);
    }
    f.axis = "rows-anew";
    f.anew = true;
    for (i = 0; i < 4; i++) {
        f.value = i ? rows[i - 1] : 240;
        f.rows = (int)f.value;
        measure(&f);
    }
    return 0;
}
