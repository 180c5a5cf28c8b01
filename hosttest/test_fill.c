/* SPDX-License-Identifier: MIT */
/* The filler and whole frames: bytes of a pixel, clearing, depth, strips of any height, saturation, closed meshes, looks.
 *
 * Frames are drawn into memory that is larger than the surface and holds a pattern: what is not the surface's must keep it. */
#include "test.h"

#include <string.h>

#include "../port/fill.h"

#define FRAME_W 96
#define FRAME_H 80

static uint16_t angle(test_random *random) { return (uint16_t)test_next(random); }

static lmb_vec vec(int64_t x, int64_t y, int64_t z)
{
    lmb_vec v = {(int16_t)x, (int16_t)y, (int16_t)z};
    return v;
}

static lmb_rgb rgb(int64_t r, int64_t g, int64_t b)
{
    lmb_rgb c = {(uint8_t)r, (uint8_t)g, (uint8_t)b};
    return c;
}

static lmb_rgb random_colour(test_random *random)
{
    return rgb(test_integer(random, 0, 255), test_integer(random, 0, 255), test_integer(random, 0, 255));
}

static const char *format_name(int format) { return format == LMB_RGB565 ? "RGB565" : "RGB888"; }

static lmb_window window_of(int left, int top, int right, int bottom)
{
    lmb_window w = {(int16_t)left, (int16_t)top, (int16_t)right, (int16_t)bottom};
    return w;
}

/* ------------------------------------------------------------------------------------------------- surfaces in guarded memory */

#define GUARD 0xa5
#define MEMORY 40000

/* Half words, so that RGB565 is aligned; looked at as bytes. */
typedef struct memory {
    uint16_t pixels[MEMORY / 2], depth[MEMORY / 2];
    lmb_surface surface;
    size_t pixels_at, depth_at; /* where the surface begins, in half words */
} memory;

static void memory_surface(memory *m, int format, lmb_window w, size_t spare, bool depth)
{
    size_t width = (size_t)(w.right - w.left);
    memset(m, 0, sizeof *m);
    memset(m->pixels, GUARD, sizeof m->pixels);
    memset(m->depth, GUARD, sizeof m->depth);
    m->pixels_at = m->depth_at = 64;
    m->surface.pixels = m->pixels + m->pixels_at;
    m->surface.depth = depth ? m->depth + m->depth_at : NULL;
    m->surface.pitch = width * lmb_format_bytes((enum lmb_format)format) + spare * 2;
    m->surface.format = (uint8_t)format;
    m->surface.window = w;
}

/* Bytes outside the surface that have changed. */
static int memory_spilt(const memory *m)
{
    const lmb_surface *s = &m->surface;
    const uint8_t *bytes = (const uint8_t *)m->pixels;
    size_t width = (size_t)(s->window.right - s->window.left), height = (size_t)(s->window.bottom - s->window.top), i;
    size_t row = width * lmb_format_bytes((enum lmb_format)s->format);
    int spilt = 0;
    for (i = 0; i < sizeof m->pixels; i++) {
        size_t at = i - 2 * m->pixels_at; /* wraps before the surface, and is then beyond its end */
        if (at >= s->pitch * height || at % s->pitch >= row) spilt += bytes[i] != GUARD;
    }
    for (i = 0; i < MEMORY / 2; i++) {
        size_t at = i - m->depth_at;
        if (!s->depth || at >= width * height) spilt += m->depth[i] != GUARD * 257;
    }
    return spilt;
}

static const uint8_t *pixel_of(const lmb_surface *s, int x, int y)
{
    return (const uint8_t *)s->pixels + (size_t)(y - s->window.top) * s->pitch +
           (size_t)(x - s->window.left) * lmb_format_bytes((enum lmb_format)s->format);
}

/* -------------------------------------------------------------------------------------------------------- layout and clearing */

static void test_layout(void)
{
    static const struct {
        uint8_t r, g, b, low, high;
    } known[] = {{255, 0, 0, 0x00, 0xf8}, {0, 255, 0, 0xe0, 0x07}, {0, 0, 255, 0x1f, 0x00},   {255, 255, 255, 0xff, 0xff},
                 {0, 0, 0, 0x00, 0x00},   {8, 4, 8, 0x21, 0x08},   {132, 130, 16, 0x02, 0x84}};
    static memory m;
    int i, faults = 0;
    for (i = 0; i < (int)(sizeof known / sizeof *known); i++) {
        const uint8_t *bytes = (const uint8_t *)(m.pixels + 64);
        memory_surface(&m, LMB_RGB565, window_of(0, 0, 1, 1), 0, false);
        lmb_clear(&m.surface, rgb(known[i].r, known[i].g, known[i].b));
        faults += bytes[0] != known[i].low || bytes[1] != known[i].high;
        memory_surface(&m, LMB_RGB888, window_of(0, 0, 1, 1), 0, false);
        lmb_clear(&m.surface, rgb(known[i].r, known[i].g, known[i].b));
        faults += bytes[0] != known[i].r || bytes[1] != known[i].g || bytes[2] != known[i].b;
    }
    test_verdict(!faults, "layout: known colours as bytes", "%d faults in %d colours of two formats", faults, i);
}

/* Every value of every channel goes to the nearest level; no value of 255 is half way between two of 31 or 63. */
static void test_clear_levels(void)
{
    static memory m;
    int c, faults = 0;
    for (c = 0; c < 256; c++) {
        int32_t five = (int32_t)floor(c * 31 / 255.0 + 0.5), six = (int32_t)floor(c * 63 / 255.0 + 0.5), got;
        memory_surface(&m, LMB_RGB565, window_of(3, 4, 5, 6), 0, false);
        lmb_clear(&m.surface, rgb(c, 0, 0));
        got = pixel_of(&m.surface, 4, 5)[0] | pixel_of(&m.surface, 4, 5)[1] << 8;
        faults += got != five << 11;
        lmb_clear(&m.surface, rgb(0, c, 0));
        got = pixel_of(&m.surface, 4, 5)[0] | pixel_of(&m.surface, 4, 5)[1] << 8;
        faults += got != six << 5;
        lmb_clear(&m.surface, rgb(0, 0, c));
        got = pixel_of(&m.surface, 4, 5)[0] | pixel_of(&m.surface, 4, 5)[1] << 8;
        faults += got != five;
    }
    test_verdict(!faults, "clear: every value to its nearest level", "%d faults in 768", faults);
}

/* Any window, any pitch, either format: all of the surface and nothing else. */
static void test_clear_bounds(test_random *random)
{
    static memory m;
    int i, spilt = 0, missed = 0, x, y;
    for (i = 0; i < 400; i++) {
        int left = (int)test_integer(random, -50, 1000), top = (int)test_integer(random, -50, 1000);
        lmb_window w = window_of(left, top, left + (int)test_integer(random, 1, 70), top + (int)test_integer(random, 1, 70));
        memory_surface(&m, i & 1, w, i % 3 ? (size_t)test_integer(random, 0, 40) : 0, i & 2);
        lmb_clear(&m.surface, rgb(255, 255, 255));
        spilt += memory_spilt(&m);
        for (y = w.top; y < w.bottom; y++) {
            for (x = w.left; x < w.right; x++) {
                const uint8_t *p = pixel_of(&m.surface, x, y);
                missed += p[0] != 255 || p[1] != 255 || (i & 1 && p[2] != 255);
                if (i & 2) missed += m.surface.depth[(y - w.top) * (w.right - w.left) + (x - w.left)] != 65535;
            }
        }
    }
    test_verdict(!spilt && !missed, "clear: the whole surface, its depth, and nothing else",
                 "%d bytes spilt, %d pixels missed, %d surfaces", spilt, missed, i);
}

/* -------------------------------------------------------------------------------------------------------------- a convex mesh */

#define SPHERE_LEVEL 3
#define SPHERE_TRIANGLES 512 /* 8 * 4^3 */

/* An octahedron, each face cut into level^2 and pushed out to the sphere; corners are not shared between faces. */
typedef struct sphere {
    lmb_vec positions[3 * SPHERE_TRIANGLES], normals[3 * SPHERE_TRIANGLES];
    uint16_t indices[3 * SPHERE_TRIANGLES];
    lmb_mesh mesh;
} sphere;

static void sphere_face(sphere *s, lmb_vec a, lmb_vec b, lmb_vec c, int level)
{
    const lmb_vec corner[3] = {a, b, c};
    int i;
    if (level > 0) {
        lmb_vec ab = lmb_normalise(a.x + b.x, a.y + b.y, a.z + b.z), bc = lmb_normalise(b.x + c.x, b.y + c.y, b.z + c.z);
        lmb_vec ca = lmb_normalise(c.x + a.x, c.y + a.y, c.z + a.z);
        sphere_face(s, a, ab, ca, level - 1);
        sphere_face(s, ab, b, bc, level - 1);
        sphere_face(s, ca, bc, c, level - 1);
        sphere_face(s, ab, bc, ca, level - 1);
        return;
    }
    for (i = 0; i < 3; i++) {
        s->positions[s->mesh.vertices] = s->normals[s->mesh.vertices] = corner[i];
        s->indices[s->mesh.vertices] = s->mesh.vertices;
        s->mesh.vertices++;
    }
    s->mesh.triangles++;
}

static void sphere_build(sphere *s)
{
    int i;
    s->mesh.positions = s->positions;
    s->mesh.normals = s->normals;
    s->mesh.indices = s->indices;
    s->mesh.vertices = 0;
    s->mesh.triangles = 0;
    s->mesh.scale = -14;
    for (i = 0; i < 8; i++) {
        lmb_vec x = vec(i & 1 ? -16384 : 16384, 0, 0), y = vec(0, i & 2 ? -16384 : 16384, 0),
                z = vec(0, 0, i & 4 ? -16384 : 16384);
        int turned = (i & 1) ^ (i >> 1 & 1) ^ (i >> 2 & 1);
        sphere_face(s, x, turned ? z : y, turned ? y : z, SPHERE_LEVEL);
    }
}

static lmb_pose random_pose(test_random *random, double near, double far)
{
    lmb_pose pose;
    pose.rotation = lmb_rotation(angle(random), angle(random), angle(random));
    pose.x = (int32_t)(65536 * test_real(random, -1, 1));
    pose.y = (int32_t)(65536 * test_real(random, -1, 1));
    pose.z = (int32_t)(-65536 * test_real(random, near, far));
    return pose;
}

/* ---------------------------------------------------------------------------------------------------------------------- looks */

static lmb_light random_light(test_random *random)
{
    lmb_light light;
    light.direction = lmb_normalise((int32_t)test_integer(random, -99, 99), (int32_t)test_integer(random, -99, 99),
                                    (int32_t)test_integer(random, -40, 99));
    light.colour = random_colour(random);
    return light;
}

static void random_look(test_random *random, lmb_look *look, int model, int step, unsigned lights)
{
    lmb_material material;
    lmb_light light[LMB_LIGHTS];
    unsigned i;
    material.ambient = random_colour(random);
    material.diffuse = random_colour(random);
    material.specular = random_colour(random);
    material.shininess = (uint16_t)exp(test_real(random, 0, log(LMB_SHININESS_MAX)));
    if (test_integer(random, 0, 1)) material.ambient = rgb(20, 10, 5); /* leave something to see */
    for (i = 0; i < lights; i++) light[i] = random_light(random);
    if (lmb_look_prepare(look, &material, light, lights, (enum lmb_model)model, (enum lmb_step_kind)step) != 0) abort();
}

/* ---------------------------------------------------------------------------------------------------------------------- depth */

static void flat_span(lmb_span *span, int x, int y, int length, int depth)
{
    memset(span, 0, sizeof *span);
    span->x = (int16_t)x;
    span->y = (int16_t)y;
    span->length = (uint16_t)length;
    span->kind = LMB_SPAN_FLAT;
    span->depth.f = depth * 16384;
}

/* Nearer wins, equal and farther keep what is there, pixel by pixel along a span whose depth runs. */
static void test_depth(test_random *random)
{
    static memory m;
    lmb_look look[2];
    lmb_paint paint[2];
    int i, k, faults = 0;
    for (i = 0; i < 20000; i++) {
        lmb_span span;
        int first = (int)test_integer(random, 0, 65534), second = (int)test_integer(random, 0, 65534);
        int rise = (int)test_integer(random, -99, 99);
        if (i % 3 == 0) second = first;
        if (i % 3 == 1) second = first + (int)test_integer(random, -40, 40);
        if (second + 20 * rise < 0 || second < 0 || second + 20 * rise > 65534 || second > 65534) continue;
        for (k = 0; k < 2; k++) {
            lmb_material material = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1};
            lmb_light light = {{0, 0, 16384}, {255, 255, 255}};
            material.ambient = k ? rgb(200, 200, 200) : rgb(100, 100, 100);
            if (lmb_look_prepare(&look[k], &material, &light, 1, LMB_MODEL_FLAT, LMB_STEP_LINEAR) != 0) abort();
            lmb_paint_prepare(&paint[k], &look[k], LMB_RGB888);
        }
        memory_surface(&m, LMB_RGB888, window_of(5, 7, 30, 9), 0, true);
        lmb_clear(&m.surface, rgb(1, 1, 1));
        flat_span(&span, 6, 8, 20, first);
        lmb_fill_span(&m.surface, &look[0], &paint[0], &span);
        flat_span(&span, 6, 8, 20, second);
        span.depth.d = rise * 16384;
        lmb_fill_span(&m.surface, &look[1], &paint[1], &span);
        for (k = 0; k < 20; k++) {
            int now = second + k * rise, wins = now < first;
            faults += pixel_of(&m.surface, 6 + k, 8)[0] != (wins ? 200 : 100);
            faults += m.surface.depth[25 + 1 + k] != (wins ? now : first);
        }
        faults += pixel_of(&m.surface, 5, 8)[0] != 1 || pixel_of(&m.surface, 26, 8)[0] != 1 || m.surface.depth[25] != 65535 ||
                  m.surface.depth[25 + 21] != 65535;
    }
    test_verdict(!faults, "depth: nearer wins, equal keeps the first, cleared is farthest", "%d faults, %d pairs of spans",
                 faults, i);
}

/* --------------------------------------------------------------------------------------------------------------------- frames */

typedef struct shot {
    lmb_camera camera;
    lmb_pose pose;
    lmb_look look;
    lmb_rgb back;
    const lmb_mesh *mesh;
} shot;

static void shot_set(test_random *random, shot *s, const sphere *ball, int perspective, double near, double far)
{
    int32_t focal = (int32_t)(65536 * (perspective ? test_real(random, 50, 300) : test_real(random, 5, 40)));
    int error = perspective ? lmb_camera_perspective(&s->camera, FRAME_W, FRAME_H, focal, 16384, 20 * 65536)
                            : lmb_camera_orthographic(&s->camera, FRAME_W, FRAME_H, focal, 16384, 20 * 65536);
    if (error) abort();
    s->pose = random_pose(random, near, far);
    s->back = random_colour(random);
    s->mesh = &ball->mesh;
}

static void shot_draw(const shot *s, memory *m, int format, lmb_window w, size_t spare, bool depth)
{
    memory_surface(m, format, w, spare, depth);
    lmb_clear(&m->surface, s->back);
    lmb_draw_mesh(&m->surface, s->mesh, &s->pose, &s->camera, &s->look, NULL, NULL);
}

/* Pixels of a part that are not those of the whole. */
static int part_differs(const memory *whole, const memory *part)
{
    const lmb_window *w = &part->surface.window;
    size_t row = (size_t)(w->right - w->left) * lmb_format_bytes((enum lmb_format)part->surface.format);
    int y, differ = 0;
    for (y = w->top; y < w->bottom; y++) {
        differ += memcmp(pixel_of(&whole->surface, w->left, y), pixel_of(&part->surface, w->left, y), row) != 0;
    }
    return differ;
}

static const char *const model_names[] = {"flat", "gouraud", "diffuse", "gloss"};
static const char *const step_names[] = {"linear", "quadratic", "arc"};

/* A frame whole and in strips of every height, and in windows of any size: the same bytes. */
static void test_strips(test_random *random, int model, int step, int format)
{
    static sphere ball;
    static memory whole, part;
    shot s;
    int i, height, top, differ = 0, spilt = 0, strips = 0;
    sphere_build(&ball);
    for (i = 0; i < 2; i++) {
        shot_set(random, &s, &ball, i == 0, i ? 3 : 2, i ? 9 : 4);
        random_look(random, &s.look, model, step, i ? (unsigned)test_integer(random, 2, LMB_LIGHTS) : 1);
        shot_draw(&s, &whole, format, window_of(0, 0, FRAME_W, FRAME_H), 0, true);
        spilt += memory_spilt(&whole);
        for (height = 1; height < FRAME_H; height++) {
            for (top = 0; top < FRAME_H; top += height, strips++) {
                int bottom = top + height < FRAME_H ? top + height : FRAME_H;
                shot_draw(&s, &part, format, window_of(0, top, FRAME_W, bottom), 0, true);
                differ += part_differs(&whole, &part);
            }
        }
        for (top = 0; top < 60; top++, strips++) {
            int left = (int)test_integer(random, 0, FRAME_W - 1), above = (int)test_integer(random, 0, FRAME_H - 1);
            int right = (int)test_integer(random, left + 1, FRAME_W), below = (int)test_integer(random, above + 1, FRAME_H);
            lmb_window w = window_of(left, above, right, below);
            shot_draw(&s, &part, format, w, (size_t)test_integer(random, 0, 20), top & 1);
            if (top & 1) differ += part_differs(&whole, &part);
            spilt += memory_spilt(&part);
        }
    }
    test_verdict(!differ && !spilt, "strips: a frame in strips of every height gives the same bytes",
                 "%s, %s, %s: %d rows differ, %d bytes spilt, %d strips", model_names[model], step_names[step],
                 format_name(format), differ, spilt, strips);
}

/* ------------------------------------------------------------------------------------------------------------ levels by terms */

/* What a span's terms say, in doubles: the intensity of one channel at a pixel, saturated. */
static double intensity_of(const lmb_look *look, const lmb_span *span, int channel)
{
    double sum = look->ambient_q15[channel] / 32768.0;
    unsigned i;
    for (i = 0; i < look->lights; i++) {
        if (span->diffuse_on >> i & 1) {
            sum += look->light[i].diffuse_q15[channel] / 32768.0 * fmin(1, fmax(0, ldexp(span->diffuse[i].f, -30)));
        }
        if (span->specular_on >> i & 1) {
            double s = ldexp(span->specular[i].f, -30);
            if (look->model == LMB_MODEL_GLOSS) {
                if (span->kind == LMB_SPAN_ARC) s += ldexp(span->specular[i].c, -30);
                s = ldexp(s, span->exponent[i]);
                s = s > 0 ? lmb_lobe_at(&look->lobe, (int32_t)floor(s * 65536)) / 32768.0 : 0;
            }
            sum += look->light[i].specular_q15[channel] / 32768.0 * fmin(1, fmax(0, s));
        }
    }
    return fmin(1, sum);
}

static void span_step(lmb_span *span, unsigned lights)
{
    unsigned i;
    for (i = 0; i < lights; i++) {
        if (span->kind == LMB_SPAN_PLANE && span->diffuse_on >> i & 1) lmb_plane_step(&span->diffuse[i]);
        if (span->kind == LMB_SPAN_PLANE && span->specular_on >> i & 1) lmb_plane_step(&span->specular[i]);
        if (span->kind == LMB_SPAN_ARC && span->diffuse_on >> i & 1) lmb_arc_step(&span->arc, &span->diffuse[i]);
        if (span->kind == LMB_SPAN_ARC && span->specular_on >> i & 1) lmb_arc_step(&span->arc, &span->specular[i]);
    }
}

static void levels_at(const uint8_t *p, int format, int level[3])
{
    if (format == LMB_RGB888) {
        level[0] = p[0], level[1] = p[1], level[2] = p[2];
    } else {
        int word = p[0] | p[1] << 8;
        level[0] = word >> 11, level[1] = word >> 5 & 63, level[2] = word & 31;
    }
}

/* The largest distance of a stored level from the intensity of its terms, in levels. */
static double span_error(const memory *m, const lmb_look *look, lmb_span span)
{
    double worst = 0;
    int k, i, level[3];
    for (k = 0; k < span.length; k++) {
        levels_at(pixel_of(&m->surface, span.x + k, span.y), m->surface.format, level);
        for (i = 0; i < 3; i++) {
            int top = m->surface.format == LMB_RGB888 ? 255 : i == 1 ? 63 : 31;
            worst = fmax(worst, fabs(level[i] - top * intensity_of(look, &span, i)));
        }
        span_step(&span, look->lights);
    }
    return worst;
}

/* Half a level for rounding; up to 2^-15 of the top for what each of nine parts loses to UQ1.15, and as much for coefficients. */
static double level_bound(int format) { return 0.5 + (format == LMB_RGB888 ? 255 : 63) * 17 / 32768.0; }

static void test_levels(test_random *random, int model, int format, bool bright)
{
    static sphere ball;
    static memory m;
    double worst = 0;
    int i;
    sphere_build(&ball);
    for (i = 0; i < 120; i++) {
        shot s;
        lmb_walk walk;
        lmb_triangle triangle;
        lmb_span span;
        lmb_paint paint;
        lmb_window w = window_of(0, 0, FRAME_W, FRAME_H);
        unsigned k, c;
        shot_set(random, &s, &ball, i & 1, 3, 6);
        random_look(random, &s.look, model, i % 3, (unsigned)test_integer(random, 1, LMB_LIGHTS));
        for (k = 0; k < s.look.lights && bright; k++) { /* all at once, far beyond one */
            for (c = 0; c < 3; c++) s.look.light[k].diffuse_q15[c] = s.look.light[k].specular_q15[c] = 32768;
        }
        memory_surface(&m, format, w, 0, false);
        lmb_paint_prepare(&paint, &s.look, (enum lmb_format)format);
        lmb_mesh_begin(&walk, &ball.mesh, &s.pose, &s.camera, &s.look, &w, NULL, NULL);
        while (lmb_mesh_next(&walk, &triangle)) {
            while (lmb_triangle_next(&triangle, &span)) {
                lmb_fill_span(&m.surface, &s.look, &paint, &span);
                worst = fmax(worst, span_error(&m, &s.look, span));
            }
        }
    }
    test_verdict(worst <= level_bound(format), "levels: what the terms say, rounded, saturated at one",
                 "%s, %s%s: worst %.4f levels, bound %.4f", model_names[model], format_name(format),
                 bright ? ", all colours full" : "", worst, level_bound(format));
}

/* Without specular colour gloss is diffuse, byte by byte. */
static void test_no_specular(test_random *random)
{
    static sphere ball;
    static memory gloss, diffuse;
    int i, differ = 0;
    sphere_build(&ball);
    for (i = 0; i < 60; i++) {
        lmb_material material = {{20, 30, 40}, {200, 180, 160}, {0, 0, 0}, 20};
        lmb_light light[LMB_LIGHTS];
        shot s;
        unsigned k, n = (unsigned)test_integer(random, 1, LMB_LIGHTS);
        lmb_window w = window_of(0, 0, FRAME_W, FRAME_H);
        for (k = 0; k < n; k++) light[k] = random_light(random);
        shot_set(random, &s, &ball, i & 1, 3, 6);
        if (lmb_look_prepare(&s.look, &material, light, n, LMB_MODEL_GLOSS, (enum lmb_step_kind)(i % 3)) != 0) abort();
        shot_draw(&s, &gloss, i / 3 & 1, w, 0, false);
        differ += s.look.specular_on != 0;
        if (lmb_look_prepare(&s.look, &material, light, n, LMB_MODEL_DIFFUSE, (enum lmb_step_kind)(i % 3)) != 0) abort();
        shot_draw(&s, &diffuse, i / 3 & 1, w, 0, false);
        differ += part_differs(&gloss, &diffuse);
    }
    test_verdict(!differ, "look: without specular colour gloss is diffuse", "%d rows differ in %d frames", differ, i);
}

/* ----------------------------------------------------------------------------------------------------------- a closed surface */

/* Culling: of a closed convex surface the front covers each pixel of its shadow once, the back gives nothing; but for a sliver at
 * the rim here and there that rounding to 1/16 pixel has turned over. */
static void test_closed(test_random *random, int perspective)
{
    static sphere ball;
    static uint8_t count[FRAME_W * FRAME_H];
    int i, x, twice = 0, holes = 0, begun = 0;
    uint64_t pixels = 0;
    sphere_build(&ball);
    for (i = 0; i < 500; i++) {
        shot s;
        lmb_walk walk;
        lmb_triangle triangle;
        lmb_span span;
        lmb_window w = window_of(0, 0, FRAME_W, FRAME_H);
        shot_set(random, &s, &ball, perspective, 3, 9);
        random_look(random, &s.look, LMB_MODEL_DIFFUSE, LMB_STEP_LINEAR, 1);
        memset(count, 0, sizeof count);
        lmb_mesh_begin(&walk, &ball.mesh, &s.pose, &s.camera, &s.look, &w, NULL, NULL);
        for (; lmb_mesh_next(&walk, &triangle); begun++) {
            while (lmb_triangle_next(&triangle, &span)) {
                for (x = 0; x < span.length; x++) count[span.y * FRAME_W + span.x + x]++;
            }
        }
        for (x = 0; x < FRAME_W * FRAME_H; x++) {
            pixels += count[x] > 0;
            twice += count[x] > 1;
            /* convex: between painted pixels of a row there is no gap */
            if (x % FRAME_W > 0 && x % FRAME_W < FRAME_W - 1) holes += !count[x] && count[x - 1] && count[x + 1];
        }
    }
    test_verdict(twice < 10 && !holes && begun < i * SPHERE_TRIANGLES * 6 / 10,
                 "cull: a closed convex mesh covers each pixel once",
                 "%s, %d poses, %" PRIu64 " pixels, %d twice, %d holes, %d of %d triangles begun",
                 perspective ? "perspective" : "orthographic", i, pixels, twice, holes, begun, i * SPHERE_TRIANGLES);
}

static void mesh_shot(const shot *s, memory *m, const lmb_vertex *vertices, const uint16_t *order, bool depth)
{
    memory_surface(m, LMB_RGB888, window_of(0, 0, FRAME_W, FRAME_H), 0, depth);
    lmb_clear(&m->surface, s->back);
    lmb_draw_mesh(&m->surface, s->mesh, &s->pose, &s->camera, &s->look, vertices, order);
}

/* Corners projected before and corners projected on the way; painter's order and depth; a mesh in part too near or far aside. */
static void test_walks(test_random *random)
{
    static sphere ball;
    static lmb_vertex vertices[3 * SPHERE_TRIANGLES];
    static uint16_t order[SPHERE_TRIANGLES];
    static int16_t keys[SPHERE_TRIANGLES];
    static memory plain, projected, deep, painted;
    int i, unlike = 0, painter = 0, clipped = 0;
    sphere_build(&ball);
    for (i = 0; i < 600; i++) {
        shot s;
        uint32_t k, hidden = 0;
        shot_set(random, &s, &ball, i % 3 > 0, i & 1 ? 0 : 3, i & 1 ? 2 : 9);
        random_look(random, &s.look, i % 4, i / 4 % 3, 2);
        memset(vertices, 0x77, sizeof vertices);
        lmb_mesh_project(&ball.mesh, &s.pose, &s.camera, vertices);
        for (k = 0; k < ball.mesh.vertices; k++) hidden += vertices[k].x == INT32_MIN;
        clipped += hidden > 0 && hidden < ball.mesh.vertices;
        lmb_mesh_sort(&ball.mesh, &s.pose, order, keys);
        mesh_shot(&s, &plain, NULL, NULL, false);
        mesh_shot(&s, &projected, vertices, NULL, false);
        mesh_shot(&s, &painted, vertices, order, false);
        mesh_shot(&s, &deep, NULL, NULL, true);
        unlike += part_differs(&plain, &projected) != 0;
        painter += part_differs(&painted, &deep) != 0;
    }
    test_verdict(!unlike, "walk: corners projected before give the same frame", "%d of %d frames differ, %d clipped", unlike, i,
                 clipped);
    test_verdict(!painter, "walk: painter's order and depth give the same frame of a convex mesh", "%d of %d frames differ",
                 painter, i);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    int i;
    test_layout();
    test_clear_levels();
    test_clear_bounds(&random);
    test_depth(&random);
    for (i = 0; i < 24; i++) test_strips(&random, i / 6, i / 2 % 3, i & 1);
    for (i = 0; i < 16; i++) test_levels(&random, i / 4, i & 1, i >> 1 & 1);
    test_no_specular(&random);
    for (i = 0; i < 2; i++) test_closed(&random, i);
    test_walks(&random);
    return test_end();
}
