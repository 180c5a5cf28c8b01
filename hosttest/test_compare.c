/* SPDX-License-Identifier: MIT */
/* The comparisons draw the right picture: frames and spans of hosttest/compare/ against doubles. Lobes: test_papers_kernels.c.
 *
 *   test_compare [SEED]
 *
 * Each frame is held against its own definition, computed here in double from corners and normals (what its arithmetic costs),
 * and against per-pixel normalised Phong (reference (b): what its method costs). All in levels of RGB565, over both icospheres,
 * in many poses, under several materials and lights. Coverage must be that of the library to the pixel.
 *
 * The bounds would be worth nothing if they let a wrong renderer pass: definitions that are wrong on purpose (a normal that is
 * not normalised, another exponent) are held to them too, and must miss them.
 */
#include "compare/compare.h"
#include "reference.h"
#include "test.h"

#include <string.h>

#define SIZE 240
#define PIXELS (SIZE * SIZE)
#define POSES 24
#define VERTICES_MAX 642

extern const lmb_mesh mesh_icosphere_320, mesh_icosphere_1280;

static const lmb_mesh *const meshes[] = {&mesh_icosphere_320, &mesh_icosphere_1280};
static const char *const mesh_names[] = {"icosphere-320", "icosphere-1280"};

/* --------------------------------------------------------------------------------------------------------------- definitions */

enum definition { NORMALISED, UNNORMALISED, OTHER_POWER, LINEAR_SCHLICK, LINEAR_POWER, CORNERS, DEFINITIONS };

/* What a frame is held to: the share of pixels within a level, PSNR, and the largest error in levels. */
typedef struct bound {
    double share, psnr_db;
    int max;
} bound;

/* What each method is by definition, and its bounds against that and against reference (b) at 320 and at 1280 triangles: in any
 * pose, and in the scene that is measured. */
typedef struct method {
    const char *name;
    enum definition definition;
    bound own, phong[2], scene[2];
    const char *why;
} method;

/* Corners are rounded to 1/16 pixel, and at an outline normals turn through right angles within one. One pixel
 * in ten thousand or so is off by more than a level. */
#define PHONG                                                                                                                    \
    {1, 42, 1}, {{0.9998, 42, 12}, {0.9998, 42, 12}}, {{1, 43, 1}, {1, 43, 1}},                                                  \
        "at outlines, for corners are rounded to 1/16 pixel"

static const method methods[] = {
    {"float-phong", NORMALISED, PHONG},
    {"float-squarings", NORMALISED, PHONG},
    {"integer-phong-sqrt", NORMALISED, PHONG},
    {"integer-phong-textbook", NORMALISED, PHONG},
    {"schlick",
     LINEAR_SCHLICK,
     {1, 41.5, 1},
     {{0.1, 19, 12}, {0.1, 19, 12}},
     {{0.33, 26, 7}, {0.32, 25, 6}},
     "Schlick is 0.19 too wide; N.H linear is too dim"},
    {"power-table",
     LINEAR_POWER,
     {0.999, 41, 2},
     {{0.8, 28, 10}, {0.95, 35, 4}},
     {{0.84, 32.5, 8}, {0.97, 39, 3}},
     "256 entries, up to a level each; N.H linear is too dim"},
    {"ramp-table",
     LINEAR_POWER,
     {0.999, 43.5, 2},
     {{0.8, 28, 10}, {0.95, 35, 4}},
     {{0.85, 33.5, 8}, {0.98, 41, 3}},
     "256 entries, up to a level each; N.H linear is too dim"},
    {"integer-gouraud",
     CORNERS,
     {1, 42.5, 1},
     {{0.7, 28, 14}, {0.93, 34, 8}},
     {{0.89, 34, 8}, {0.99, 41, 2}},
     "light at corners alone"},
};
#define METHODS (sizeof methods / sizeof methods[0])

static double power_of(double cosine, double n) { return cosine > 0 ? pow(cosine, n) : 0; }
static double schlick_of(double t, double n) { return t > 0 ? t / (n - n * t + t) : 0; }

/* Intensities from N.L and the lobe's value, saturated. */
static void colour(const ref_shader *shader, double diffuse, double lobe, double rgb[3])
{
    ref_terms lit;
    lit.diffuse[0] = fmax(0, diffuse);
    lit.specular[0] = lobe;
    ref_terms_colour(shader, &lit, rgb);
}

/* One corner as a definition sees it: a normal and its light. */
typedef struct node {
    double x, y, normal[3], dot[2], rgb[3];
} node;

static void node_begin(node *c, const ref_shader *shader, const lmb_vertex *v)
{
    ref_vec n = ref_unit(ref_make(v->normal));
    c->x = (double)v->x / 16;
    c->y = (double)v->y / 16;
    c->normal[0] = n.x;
    c->normal[1] = n.y;
    c->normal[2] = n.z;
    c->dot[0] = ref_dot(n, shader->light[0].direction);
    c->dot[1] = ref_dot(n, shader->light[0].half);
    colour(shader, c->dot[0], power_of(c->dot[1], shader->shininess), c->rgb);
}

static double blend(const double weight[3], double a, double b, double c)
{
    return weight[0] * a + weight[1] * b + weight[2] * c;
}

static void define(enum definition definition, const ref_shader *shader, const node corner[3], const double weight[3],
                   double rgb[3])
{
    const node *a = &corner[0], *b = &corner[1], *c = &corner[2];
    double dot[2], n[3], shininess = shader->shininess, length;
    int k;
    for (k = 0; k < 2; k++) dot[k] = blend(weight, a->dot[k], b->dot[k], c->dot[k]);
    for (k = 0; k < 3; k++) n[k] = blend(weight, a->normal[k], b->normal[k], c->normal[k]);
    length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (definition == CORNERS) {
        for (k = 0; k < 3; k++) rgb[k] = blend(weight, a->rgb[k], b->rgb[k], c->rgb[k]);
    } else if (definition == LINEAR_SCHLICK) {
        colour(shader, dot[0], schlick_of(dot[1], shininess), rgb);
    } else if (definition == LINEAR_POWER || definition == UNNORMALISED) {
        colour(shader, dot[0], power_of(dot[1], shininess), rgb);
    } else {
        colour(shader, dot[0] / length, power_of(dot[1] / length, definition == OTHER_POWER ? 12 : shininess), rgb);
    }
}

/* Barycentric weights of the pixel's centre; the definitions do not ask who owns an edge. */
static bool inside(const node c[3], double x, double y, double weight[3])
{
    double area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
    if (area >= 0) return false;
    weight[1] = ((x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (y - c[0].y)) / area;
    weight[2] = ((c[1].x - c[0].x) * (y - c[0].y) - (x - c[0].x) * (c[1].y - c[0].y)) / area;
    weight[0] = 1 - weight[1] - weight[2];
    return weight[0] >= -1e-9 && weight[1] >= -1e-9 && weight[2] >= -1e-9;
}

static int whole(double x) { return x < 0 ? 0 : x > SIZE ? SIZE : (int)x; }

/* A frame by definition. */
static void define_frame(ref_frame *frame, const scene *s, enum definition definition)
{
    const scene_object *o = &s->object[0];
    static lmb_vertex vertices[VERTICES_MAX];
    ref_shader shader;
    uint32_t t;
    ref_frame_begin(frame, s, 0);
    ref_shader_begin(&shader, s, o, true);
    lmb_mesh_project(o->mesh, &o->pose, &s->camera, vertices);
    for (t = 0; t < o->mesh->triangles; t++) {
        node c[3];
        double weight[3], rgb[3];
        int k, x, y;
        for (k = 0; k < 3; k++) node_begin(&c[k], &shader, &vertices[o->mesh->indices[3 * t + (uint32_t)k]]);
        for (y = whole(fmin(fmin(c[0].y, c[1].y), c[2].y)); y < whole(fmax(fmax(c[0].y, c[1].y), c[2].y) + 1); y++) {
            for (x = whole(fmin(fmin(c[0].x, c[1].x), c[2].x)); x < whole(fmax(fmax(c[0].x, c[1].x), c[2].x) + 1); x++) {
                if (!inside(c, x + 0.5, y + 0.5, weight)) continue;
                define(definition, &shader, c, weight, rgb);
                ref_frame_add(frame, x, y, 0, rgb, t);
            }
        }
    }
}

/* -------------------------------------------------------------------------------------------------------------------- frames */

/* Draws over two backgrounds: what shows neither was painted. */
static void draw(ref_drawn *drawn, const scene *s, compare_draw *renderer)
{
    static uint16_t frame[2][PIXELS];
    static lmb_vertex vertices[VERTICES_MAX];
    static compare_room room[VERTICES_MAX];
    const scene_object *o = &s->object[0];
    lmb_surface surface;
    compare_look look;
    int pass, i;
    drawn->shaded = 0;
    if (compare_look_prepare(&look, &o->material, &s->light[0]) != LMB_OK) return;
    lmb_mesh_project(o->mesh, &o->pose, &s->camera, vertices);
    for (pass = 0; pass < 2; pass++) {
        memset(frame[pass], pass ? 0xff : 0, sizeof frame[pass]);
        lmb_surface_strip(&surface, LMB_RGB565, frame[pass], NULL, SIZE, 0, SIZE);
        drawn->shaded = renderer(&surface, o->mesh, &o->pose, &look, vertices, room);
    }
    for (i = 0; i < PIXELS; i++) {
        uint16_t word = frame[0][i];
        drawn->painted[i] = word == frame[1][i];
        drawn->levels[3 * i] = (uint8_t)(word >> 11);
        drawn->levels[3 * i + 1] = (uint8_t)(word >> 5 & 63u);
        drawn->levels[3 * i + 2] = (uint8_t)(word & 31u);
    }
}

/* Pose i of a mesh: the demo's first, then random ones, with materials and lights of all kinds. */
static void pose(scene *s, const lmb_mesh *mesh, int i, test_random *r)
{
    scene_make(s, 0);
    s->object[0].mesh = mesh;
    if (i == 0) return;
    s->object[0].pose.rotation = lmb_rotation((uint16_t)test_next(r), (uint16_t)test_next(r), (uint16_t)test_next(r));
    s->object[0].pose.x = (int32_t)test_integer(r, -4000, 4000);
    s->object[0].pose.y = (int32_t)test_integer(r, -4000, 4000);
    s->light[0].direction =
        lmb_normalise((int32_t)test_integer(r, -99, 99), (int32_t)test_integer(r, -99, 99), (int32_t)test_integer(r, 0, 99));
    if (i % 3 == 1) {
        lmb_material m = {{0, 40, 90}, {255, 200, 0}, {90, 255, 140}, COMPARE_SHININESS};
        s->object[0].material = m;
    } else if (i % 3 == 2) {
        lmb_rgb warm = {255, 180, 90};
        s->light[0].colour = warm;
    }
}

/* What frames of one kind come to. */
typedef struct tally {
    int max_error, pose;
    double share, psnr_db; /* the least of all frames */
    ref_score worst;
} tally;

static void tally_add(tally *t, const ref_frame *frame, const ref_drawn *drawn, int i)
{
    ref_score score;
    ref_judge(&score, frame, drawn, NULL);
    t->share = fmin(t->share, score.share_within_1);
    t->psnr_db = fmin(t->psnr_db, score.psnr_db);
    if (score.max_error <= t->max_error && t->worst.pixels) return;
    t->max_error = score.max_error;
    t->pose = i;
    t->worst = score;
}

/* A frame's own memory. */
static uint8_t levels[3 * PIXELS];
static bool painted[PIXELS];
static ref_drawn drawn_into = {SIZE, SIZE, LMB_RGB565, levels, painted, 0};

static uint64_t coverage_difference(const ref_drawn *a, const ref_drawn *b)
{
    uint64_t differ = 0;
    int i;
    for (i = 0; i < PIXELS; i++) differ += a->painted[i] != b->painted[i];
    return differ + (a->shaded > b->shaded ? a->shaded - b->shaded : b->shaded - a->shaded);
}

static compare_draw *renderer_of(const char *name)
{
    unsigned i;
    for (i = 0; i < compare_frame_count; i++) {
        if (!strcmp(compare_frames[i].name, name)) return compare_frames[i].draw;
    }
    return NULL;
}

/* All poses of a mesh by all methods. */
enum { OWN, PHONG_ANY, PHONG_SCENE, WRONG, KINDS = WRONG + 2 };
static const enum definition wrong_definition[2] = {UNNORMALISED, OTHER_POWER};

typedef struct results {
    tally of[METHODS][KINDS];
    uint64_t coverage[METHODS], pixels;
} results;

static void results_begin(results *out)
{
    unsigned k, d;
    memset(out, 0, sizeof *out);
    for (k = 0; k < METHODS; k++) {
        for (d = 0; d < KINDS; d++) {
            out->of[k][d].share = 1;
            out->of[k][d].psnr_db = 99;
        }
    }
}

static void one_pose(results *out, const scene *s, int i)
{
    ref_frame by[DEFINITIONS], phong;
    ref_drawn library;
    unsigned k, d;
    for (d = 0; d < DEFINITIONS; d++) define_frame(&by[d], s, (enum definition)d);
    ref_normalised_phong(&phong, s, true);
    ref_draw(&library, s, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, LMB_RGB565);
    out->pixels += library.shaded;
    for (k = 0; k < METHODS; k++) {
        tally *of = out->of[k];
        draw(&drawn_into, s, renderer_of(methods[k].name));
        out->coverage[k] += coverage_difference(&drawn_into, &library);
        tally_add(&of[OWN], &by[methods[k].definition], &drawn_into, i);
        tally_add(&of[PHONG_ANY], &phong, &drawn_into, i);
        if (i == 0) tally_add(&of[PHONG_SCENE], &phong, &drawn_into, i);
        for (d = 0; d < 2; d++) tally_add(&of[WRONG + d], &by[wrong_definition[d]], &drawn_into, i);
    }
    for (d = 0; d < DEFINITIONS; d++) ref_frame_end(&by[d]);
    ref_frame_end(&phong);
    ref_drawn_end(&library);
}

static void tally_verdict(const tally *t, const char *name, const char *mesh, const char *against, const bound *b,
                          const char *why)
{
    char property[96];
    const ref_score *w = &t->worst;
    snprintf(property, sizeof property, "%s %s", name, mesh);
    test_verdict(w->pixels > 0 && t->share >= b->share && t->psnr_db >= b->psnr_db && t->max_error <= b->max, property,
                 "%s: %d levels of %d, %.6f within one, %.1f dB of %.1f; pose %d at (%d, %d): got %d %d %d, want %d %d %d (%s)",
                 against, t->max_error, b->max, t->share, t->psnr_db, b->psnr_db, t->pose, w->x, w->y, w->drawn[0], w->drawn[1],
                 w->drawn[2], w->wanted[0], w->wanted[1], w->wanted[2], why);
}

static void verdicts(const method *m, const results *out, const tally *of, int mesh)
{
    const char *on = mesh_names[mesh];
    char name[96];
    unsigned d;
    snprintf(name, sizeof name, "coverage %s %s", m->name, on);
    test_verdict(out->coverage[m - methods] == 0, name, "%llu of %llu pixels differ from lmb_draw_mesh, %d poses",
                 (unsigned long long)out->coverage[m - methods], (unsigned long long)out->pixels, POSES);
    tally_verdict(&of[OWN], m->name, on, "own definition", &m->own, "its arithmetic");
    tally_verdict(&of[PHONG_ANY], m->name, on, "per-pixel Phong", &m->phong[mesh], m->why);
    tally_verdict(&of[PHONG_SCENE], m->name, on, "per-pixel Phong, measured scene", &m->scene[mesh], m->why);
    for (d = 0; d < 2 && m->definition == NORMALISED; d++) {
        snprintf(name, sizeof name, "%s %s", m->name, on);
        test_verdict(of[WRONG + d].max_error > m->own.max, name, "%s misses the bound, as it must: %d levels",
                     d ? "exponent 12 in place of 16" : "a normal that is not normalised", of[WRONG + d].max_error);
    }
}

static void test_frames(test_random *r, int mesh)
{
    static results out;
    unsigned k;
    int i;
    results_begin(&out);
    for (i = 0; i < POSES; i++) {
        scene s;
        pose(&s, meshes[mesh], i, r);
        one_pose(&out, &s, i);
    }
    for (k = 0; k < METHODS; k++) verdicts(&methods[k], &out, out.of[k], mesh);
}

/* A look that cannot be drawn and a mesh that is not wholly inside are refused, and nothing is written. */
static void test_refusals(void)
{
    static uint16_t frame[PIXELS];
    static lmb_vertex vertices[VERTICES_MAX];
    static compare_room room[VERTICES_MAX];
    lmb_material bright = {{1, 0, 0}, {255, 0, 0}, {0, 0, 0}, COMPARE_SHININESS}, other = bright;
    unsigned k, written = 0, i;
    lmb_surface surface;
    compare_look look;
    uint32_t drawn = 0;
    int refused;
    scene s;
    scene_make(&s, 0);
    refused = compare_look_prepare(&look, &bright, &s.light[0]) == LMB_ERROR_VALUE;
    other.ambient.r = 0;
    other.shininess = COMPARE_SHININESS + 1;
    refused += compare_look_prepare(&look, &other, &s.light[0]) == LMB_ERROR_VALUE;
    other.shininess = COMPARE_SHININESS;
    refused += compare_look_prepare(&look, &other, &s.light[0]) == LMB_OK;
    s.object[0].pose.x = 65536 / 10; /* 11 pixels of 10 */
    lmb_mesh_project(s.object[0].mesh, &s.object[0].pose, &s.camera, vertices);
    lmb_surface_strip(&surface, LMB_RGB565, frame, NULL, SIZE, 0, SIZE);
    for (k = 0; k < compare_frame_count; k++) {
        drawn += compare_frames[k].draw(&surface, s.object[0].mesh, &s.object[0].pose, &look, vertices, room);
    }
    for (i = 0; i < PIXELS; i++) written += frame[i] != 0;
    test_verdict(
        refused == 3 && drawn == 0 && written == 0, "refusals",
        "light above one, another exponent, a mesh beyond the window: %d of 3 looks judged right, %u pixels drawn, %u written",
        refused, (unsigned)drawn, written);
}

/* --------------------------------------------------------------------------------------------------------------------- spans */

#define LENGTH_MAX 240
#define TURN_MAX 0.35 /* about 20 degrees, as between the corners of the coarser mesh */

static lmb_vec random_normal(test_random *r)
{
    return lmb_normalise((int32_t)test_integer(r, -99, 99), (int32_t)test_integer(r, -99, 99), (int32_t)test_integer(r, 0, 99));
}

static lmb_vec turned(lmb_vec n, test_random *r)
{
    double by = test_real(r, 0, TURN_MAX) * 16384 / 99;
    lmb_vec to = random_normal(r);
    return lmb_normalise((int32_t)(n.x + by * to.x / 166), (int32_t)(n.y + by * to.y / 166), (int32_t)(n.z + by * to.z / 166));
}

/* The largest error of a kernel over a span, in levels; -1 if it wrote beside it. */
static int span_error(const compare_span_kernel *kernel, enum definition definition, const scene *s, lmb_vec from, lmb_vec to,
                      int length)
{
    static const lmb_matrix straight = {{{16384, 0, 0}, {0, 16384, 0}, {0, 0, 16384}}};
    uint16_t pixel[LENGTH_MAX + 2];
    lmb_vertex v[2] = {{0, 0, from, 0}, {0, 0, to, 0}};
    scene_object object = s->object[0];
    compare_look look;
    compare_span span;
    ref_shader shader;
    node corner[3];
    int i, c, largest = 0;
    object.pose.rotation = straight;
    ref_shader_begin(&shader, s, &object, true);
    for (i = 0; i < 3; i++) node_begin(&corner[i], &shader, &v[i > 0]);
    if (compare_look_prepare(&look, &object.material, &s->light[0]) != LMB_OK) return -1;
    memset(pixel, 0x5a, sizeof pixel);
    kernel->begin(&span, &look, from, to, (unsigned)length);
    kernel->fill(&span, pixel + 1, (unsigned)length);
    if (pixel[0] != 0x5a5a || pixel[length + 1] != 0x5a5a) return -1;
    for (i = 0; i < length; i++) {
        const double weight[3] = {1 - (double)i / length, (double)i / length, 0};
        const int got[3] = {pixel[1 + i] >> 11, pixel[1 + i] >> 5 & 63, pixel[1 + i] & 31};
        double rgb[3];
        define(definition, &shader, corner, weight, rgb);
        for (c = 0; c < 3; c++) {
            int error = abs(got[c] - (int)floor(rgb[c] * ref_top(LMB_RGB565, c) + 0.5));
            if (error > largest) largest = error;
        }
    }
    return largest;
}

static void test_spans(test_random *r)
{
    static const int lengths[] = {1, 2, 7, 32, 100, LENGTH_MAX};
    unsigned k, l;
    int i;
    for (k = 0; k < METHODS; k++) {
        const compare_span_kernel *kernel = &compare_spans[k];
        const method *m = &methods[k];
        int largest = 0, beside = 0, missed = 0;
        for (i = 0; i < 500; i++) {
            scene s;
            lmb_vec from, to;
            pose(&s, meshes[0], i, r);
            from = random_normal(r);
            to = turned(from, r);
            for (l = 0; l < sizeof lengths / sizeof lengths[0]; l++) {
                int error = span_error(kernel, m->definition, &s, from, to, lengths[l]);
                int wrong = span_error(kernel, OTHER_POWER, &s, from, to, lengths[l]);
                if (error < 0) beside++;
                if (error > largest) largest = error;
                if (wrong > missed) missed = wrong;
            }
        }
        test_verdict(!strcmp(kernel->name + 5, m->name) && beside == 0 && largest <= m->own.max && missed > m->own.max,
                     kernel->name, "3000 spans of 1 to %d pixels, at most %d levels, got %d, %d wrote beside it; exponent 12: %d",
                     LENGTH_MAX, m->own.max, largest, beside, missed);
    }
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    test_frames(&r, 0);
    test_frames(&r, 1);
    test_refusals();
    test_spans(&r);
    return test_end();
}
