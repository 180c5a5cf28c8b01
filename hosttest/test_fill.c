/* SPDX-License-Identifier: MIT */
/* The filler and whole frames: strips of any height, levels and saturation, closed meshes, looks. */
#include "guarded.h"

#define FRAME_W 96
#define FRAME_H 80

static uint16_t angle(test_random *random) { return (uint16_t)test_next(random); }

static lmb_vec vec(int64_t x, int64_t y, int64_t z)
{
    lmb_vec v = {(int16_t)x, (int16_t)y, (int16_t)z};
    return v;
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

/* projected: with corners projected before. */
static void shot_draw(const shot *s, memory *m, int format, lmb_window w, size_t spare, bool depth, bool projected)
{
    static lmb_vertex vertices[3 * SPHERE_TRIANGLES];
    lmb_paint paint;
    memory_surface(m, format, w, spare, depth);
    lmb_clear(&m->surface, s->back);
    lmb_paint_prepare(&paint, &s->look, (enum lmb_format)format);
    if (projected) lmb_mesh_project(s->mesh, &s->pose, &s->camera, vertices);
    lmb_draw_mesh(&m->surface, s->mesh, &s->pose, &s->camera, &paint, projected ? vertices : NULL, NULL);
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
static const char *const step_names[] = {"linear", "quadratic", "arc", "planned"};

/* A frame whole and in strips of every height, and in windows of any size, one light and several, with depth and without, corners
 * projected before or not: the same bytes. */
static void test_strips(test_random *random, int model, int step, int format)
{
    static sphere ball;
    static memory whole, part;
    shot s;
    int i, height, top, differ = 0, spilt = 0, strips = 0;
    sphere_build(&ball);
    for (i = 0; i < 4; i++) {
        const bool depth = i >> 1;
        shot_set(random, &s, &ball, i == 0, i & 1 ? 3 : 2, i & 1 ? 9 : 4);
        random_look(random, &s.look, model, step, i & 1 ? (unsigned)test_integer(random, 2, LMB_LIGHTS) : 1);
        shot_draw(&s, &whole, format, window_of(0, 0, FRAME_W, FRAME_H), 0, depth, false);
        spilt += memory_spilt(&whole);
        for (height = 1; height < FRAME_H; height++) {
            for (top = 0; top < FRAME_H; top += height, strips++) {
                int bottom = top + height < FRAME_H ? top + height : FRAME_H;
                shot_draw(&s, &part, format, window_of(0, top, FRAME_W, bottom), 0, depth, strips & 1);
                differ += part_differs(&whole, &part);
            }
        }
        for (top = 0; top < 60; top++, strips++) {
            int left = (int)test_integer(random, 0, FRAME_W - 1), above = (int)test_integer(random, 0, FRAME_H - 1);
            int right = (int)test_integer(random, left + 1, FRAME_W), below = (int)test_integer(random, above + 1, FRAME_H);
            lmb_window w = window_of(left, above, right, below);
            shot_draw(&s, &part, format, w, (size_t)test_integer(random, 0, 20), depth, strips & 1);
            differ += part_differs(&whole, &part);
            spilt += memory_spilt(&part);
        }
    }
    test_verdict(!differ && !spilt, "strips: a frame in strips of every height gives the same bytes",
                 "%s, %s, %s: %d rows differ, %d bytes spilt, %d strips", model_names[model], step_names[step],
                 format_name(format), differ, spilt, strips);
}

/* ------------------------------------------------------------------------------------------------------------ levels by terms */

/* One light on RGB565 is looked up in ramps. */
static bool has_ramps(const lmb_paint *paint)
{
    return paint->format == LMB_RGB565 && paint->look.lights == 1 && paint->look.model >= LMB_MODEL_DIFFUSE;
}

/* The lobe at the argument that a span carries of light i: s less dark, or a ramp's, which falls from one to zero at quiet. */
static double lobe_at(const lmb_paint *paint, const lmb_span *span, unsigned i)
{
    const lmb_look *look = &paint->look;
    double argument = ldexp(span->specular[i].f, -30);
    if (span->kind == LMB_SPAN_ARC) argument += ldexp(span->specular[i].c, -30);
    argument = ldexp(argument, span->exponent[i]);
    if (argument <= 0) return 0;
    if (has_ramps(paint)) return pow(1 - ldexp(look->light[i].quiet_q30, -30) * (1 - fmin(1, argument)), look->lobe.shininess);
    return lmb_lobe_at(&look->lobe, (int32_t)floor(argument * 65536) + look->light[i].dark_q16) / 32768.0;
}

/* What a span's terms say, in doubles: the intensity of one channel at a pixel, saturated. */
static double intensity_of(const lmb_paint *paint, const lmb_span *span, int channel)
{
    const lmb_look *look = &paint->look;
    double sum = look->ambient_q15[channel] / 32768.0;
    unsigned i;
    for (i = 0; i < look->lights; i++) {
        if (span->diffuse_on >> i & 1) {
            sum += look->light[i].diffuse_q15[channel] / 32768.0 * fmin(1, fmax(0, ldexp(span->diffuse[i].f, -30)));
        }
        if (span->specular_on >> i & 1) {
            double lobe = look->model == LMB_MODEL_GLOSS ? lobe_at(paint, span, i) : ldexp(span->specular[i].f, -30);
            sum += look->light[i].specular_q15[channel] / 32768.0 * fmin(1, fmax(0, lobe));
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

/* Half a level for rounding; up to 2^-15 of the top for what each of nine parts loses to UQ1.15, and as much for coefficients.
 * Ramps round twice, N.L to the middle of a step of 1/64 and the highlight's argument to the middle of one of 1/256, over which
 * cos^n, 1 - quiet to 1, rises by up to n quiet / 512. */
static double level_bound(const lmb_paint *paint, int channel)
{
    const struct lmb_look_light *light = &paint->look.light[0];
    const double top = top_of(paint->format, channel), sums = 0.5 + (paint->format == LMB_RGB888 ? 255 : 63) * 17 / 32768.0;
    const double step = paint->look.lobe.shininess * ldexp(light->quiet_q30, -30) / (2 * LMB_GLEAM);
    double ramps = top * light->diffuse_q15[channel] / 32768.0 / (2 * LMB_RAMP);
    if (!has_ramps(paint)) return sums;
    if (paint->look.specular_on) ramps += 0.5 + top * light->specular_q15[channel] / 32768.0 * step;
    return sums + ramps;
}

/* The largest distance of a stored level from the intensity of its terms, in levels; and as a share of the bound. */
static void span_error(const memory *m, const lmb_paint *paint, lmb_span span, double *worst, double *share)
{
    int k, i, level[3];
    for (k = 0; k < span.length; k++) {
        levels_at(pixel_of(&m->surface, span.x + k, span.y), m->surface.format, level);
        for (i = 0; i < 3; i++) {
            double error = fabs(level[i] - top_of(m->surface.format, i) * intensity_of(paint, &span, i));
            *worst = fmax(*worst, error);
            *share = fmax(*share, error / level_bound(paint, i));
        }
        span_step(&span, paint->look.lights);
    }
}

static void test_levels(test_random *random, int model, int format, bool bright)
{
    static sphere ball;
    static memory m;
    double worst = 0, share = 0;
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
        random_look(random, &s.look, model, i % 3, i & 2 ? 1 : (unsigned)test_integer(random, 2, LMB_LIGHTS));
        for (k = 0; k < s.look.lights && bright; k++) { /* all at once, far beyond one */
            for (c = 0; c < 3; c++) s.look.light[k].diffuse_q15[c] = s.look.light[k].specular_q15[c] = 32768;
        }
        memory_surface(&m, format, w, 0, false);
        lmb_paint_prepare(&paint, &s.look, (enum lmb_format)format);
        lmb_mesh_begin(&walk, &ball.mesh, &s.pose, &s.camera, &paint.look, &w, NULL, NULL);
        while (lmb_mesh_next(&walk, &triangle)) {
            while (lmb_triangle_next(&triangle, &span)) {
                lmb_fill_span(&m.surface, &paint, &span);
                span_error(&m, &paint, span, &worst, &share);
            }
        }
    }
    test_verdict(share <= 1, "levels: what the terms say, rounded, saturated at one",
                 "%s, %s%s: worst %.4f levels, %.4f of the bound", model_names[model], format_name(format),
                 bright ? ", all colours full" : "", worst, share);
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
        if (lmb_look_prepare(&s.look, &material, light, n, LMB_MODEL_GLOSS, (enum lmb_step_kind)(i % 4)) != 0) abort();
        shot_draw(&s, &gloss, i / 3 & 1, w, 0, false, false);
        differ += s.look.specular_on != 0;
        if (lmb_look_prepare(&s.look, &material, light, n, LMB_MODEL_DIFFUSE, (enum lmb_step_kind)(i % 4)) != 0) abort();
        shot_draw(&s, &diffuse, i / 3 & 1, w, 0, false, false);
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

static void mesh_shot(const shot *s, memory *m, int format, const lmb_vertex *vertices, const uint16_t *order, bool depth)
{
    lmb_paint paint;
    memory_surface(m, format, window_of(0, 0, FRAME_W, FRAME_H), 0, depth);
    lmb_clear(&m->surface, s->back);
    lmb_paint_prepare(&paint, &s->look, (enum lmb_format)format);
    lmb_draw_mesh(&m->surface, s->mesh, &s->pose, &s->camera, &paint, vertices, order);
}

/* Corners projected before and corners projected on the way; painter's order and depth; a mesh in part too near or far aside. */
static void test_walks(test_random *random)
{
    static sphere ball;
    static lmb_vertex vertices[3 * SPHERE_TRIANGLES];
    static uint16_t order[SPHERE_TRIANGLES];
    static int16_t keys[SPHERE_TRIANGLES];
    static memory plain, projected, deep, painted, bent;
    int i, unlike = 0, painter = 0, clipped = 0, unbent = 0;
    sphere_build(&ball);
    for (i = 0; i < 600; i++) {
        shot s;
        const int format = i / 24 & 1;
        uint32_t k, hidden = 0;
        shot_set(random, &s, &ball, i % 3 > 0, i & 1 ? 0 : 3, i & 1 ? 2 : 9);
        random_look(random, &s.look, i % 4, i / 4 % 3, 1u + (i / 12 & 1));
        memset(vertices, 0x77, sizeof vertices);
        lmb_mesh_project(&ball.mesh, &s.pose, &s.camera, vertices);
        for (k = 0; k < ball.mesh.vertices; k++) hidden += vertices[k].x == INT32_MIN;
        clipped += hidden > 0 && hidden < ball.mesh.vertices;
        lmb_mesh_sort(&ball.mesh, &s.pose, order, keys);
        mesh_shot(&s, &plain, format, NULL, NULL, false);
        mesh_shot(&s, &projected, format, vertices, NULL, false);
        mesh_shot(&s, &painted, format, vertices, order, false);
        mesh_shot(&s, &deep, format, NULL, NULL, true);
        ball.mesh.bend = lmb_mesh_bend(&ball.mesh);
        mesh_shot(&s, &bent, format, vertices, NULL, false);
        ball.mesh.bend = 0;
        unlike += part_differs(&plain, &projected) != 0;
        unbent += part_differs(&plain, &bent) != 0;
        painter += part_differs(&painted, &deep) != 0;
    }
    test_verdict(!unlike, "walk: corners projected before give the same frame", "%d of %d frames differ, %d clipped", unlike, i,
                 clipped);
    test_verdict(!unbent, "walk: a mesh whose bend is known gives the same frame", "%d of %d frames differ", unbent, i);
    test_verdict(!painter, "walk: painter's order and depth give the same frame of a convex mesh", "%d of %d frames differ",
                 painter, i);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    int i;
    for (i = 0; i < 32; i++) test_strips(&random, i / 8, i / 2 % 4, i & 1);
    for (i = 0; i < 16; i++) test_levels(&random, i / 4, i & 1, i >> 1 & 1);
    test_no_specular(&random);
    for (i = 0; i < 2; i++) test_closed(&random, i);
    test_walks(&random);
    return test_end();
}
