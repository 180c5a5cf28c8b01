/* SPDX-License-Identifier: MIT */
/* Vertices of meshes onto the screen, by one product a coordinate or through space: places and depths against doubles, the near
 * plane, and that a corner is the same whichever way a walk comes by it. */
#include "test.h"

#include <string.h>

#include "../firmware/screen.h"

#define VERTICES 24
#define TRIANGLES 40
#define DEPTH_ERROR (65536 * LMB_PROJECT_MAX_DEPTH_ERROR)

typedef struct model {
    lmb_camera camera;
    lmb_pose pose;
    lmb_mesh mesh;
    lmb_screen screen;
    double half, focal, near, far; /* half a side of the cube that positions can fill, units; pixels; units */
    int width, height;
    lmb_vec position[VERTICES], normal[VERTICES];
    uint16_t index[3 * TRIANGLES];
    lmb_vertex vertex[VERTICES];
} model;

static double larger(double a, double b) { return a > b ? a : b; }
static double log_real(test_random *random, double low, double high) { return exp(test_real(random, log(low), log(high))); }
static uint16_t angle(test_random *random) { return (uint16_t)test_next(random); }

/* One component of a position: any, or as far out as it goes. */
static int16_t component(test_random *random)
{
    int kind = (int)test_integer(random, 0, 5);
    return (int16_t)(kind == 0 ? 32767 : kind == 1 ? -32768 : test_integer(random, -32768, 32767));
}

static void random_mesh(test_random *random, model *m)
{
    int i;
    for (i = 0; i < VERTICES; i++) {
        m->position[i].x = component(random);
        m->position[i].y = component(random);
        m->position[i].z = component(random);
        m->normal[i] = lmb_normalise(component(random), component(random), component(random));
    }
    for (i = 0; i < 3 * TRIANGLES; i++) m->index[i] = (uint16_t)test_integer(random, 0, VERTICES - 1);
    m->mesh.positions = m->position;
    m->mesh.normals = m->normal;
    m->mesh.indices = m->index;
    m->mesh.vertices = VERTICES;
    m->mesh.triangles = TRIANGLES;
}

static int32_t fixed(double units) { return (int32_t)larger(-INT32_MAX, fmin(INT32_MAX, units * 65536)); }

/* Meshes of a pixel to two thousand, on the frame or aside, in any depth; the near plane may go through them. */
static void random_orthographic(test_random *random, model *m)
{
    double most;
    do {
        m->mesh.scale = (int8_t)test_integer(random, LMB_SCALE_MIN, LMB_SCALE_MAX);
        m->half = ldexp(1, m->mesh.scale + 15);
        m->focal = log_real(random, 1, 2000) / m->half;
    } while (m->focal > 32000 || m->focal < 1.0 / 16384);
    m->near = test_real(random, -100, 100);
    m->far = m->near + fmin(32000, m->half * log_real(random, 0.5, 1000));
    m->far = larger(m->far, m->near + log_real(random, 1e-4, 10));
    most = fmin(16000, 1.2 * larger(m->width, m->height) / m->focal);
    m->pose.x = fixed(test_real(random, -1, 1) * most);
    m->pose.y = fixed(test_real(random, -1, 1) * most);
    m->pose.z = fixed(-larger(-8000, fmin(16000, m->near + test_real(random, -1, 3) * m->half)));
    if (lmb_camera_orthographic(&m->camera, m->width, m->height, fixed(m->focal), fixed(m->near), fixed(m->far))) abort();
}

/* Meshes of a unit to sixty, a unit or more before the camera, where 1/65536 unit does not show. */
static void random_perspective(test_random *random, model *m)
{
    double w;
    m->mesh.scale = (int8_t)test_integer(random, -15, -9);
    m->half = ldexp(1, m->mesh.scale + 15);
    m->focal = larger(m->width, m->height) * log_real(random, 0.5, 2);
    m->near = log_real(random, 1, 10);
    m->far = m->near * log_real(random, 2.01, 1000);
    w = m->near + m->half * test_real(random, -1, 4);
    m->pose.x = fixed(test_real(random, -1, 1) * w * m->width / m->focal);
    m->pose.y = fixed(test_real(random, -1, 1) * w * m->height / m->focal);
    m->pose.z = fixed(-w);
    if (lmb_camera_perspective(&m->camera, m->width, m->height, fixed(m->focal), fixed(m->near), fixed(m->far))) abort();
}

static void random_model(test_random *random, model *m, int perspective)
{
    random_mesh(random, m);
    m->width = (int)test_integer(random, 1, 800);
    m->height = (int)test_integer(random, 1, 480);
    m->pose.rotation = lmb_rotation(angle(random), angle(random), angle(random));
    if (perspective) {
        random_perspective(random, m);
    } else {
        random_orthographic(random, m);
    }
    m->focal = m->camera.focal_q16 / 65536.0;
    m->near = m->camera.near_q16 / 65536.0;
    m->far = m->camera.far_q16 / 65536.0;
    m->screen.mesh = &m->mesh;
    m->screen.pose = &m->pose;
    m->screen.camera = &m->camera;
    lmb_screen_begin(&m->screen);
    lmb_mesh_project(&m->mesh, &m->pose, &m->camera, m->vertex);
}

/* Where vertex i stands in space, by definition, units. */
static void place(const model *m, int i, double p[3])
{
    const int32_t at[3] = {m->pose.x, m->pose.y, m->pose.z};
    int k;
    for (k = 0; k < 3; k++) {
        lmb_vec r = m->pose.rotation.row[k], v = m->position[i];
        p[k] = at[k] / 65536.0 + ldexp(((double)r.x * v.x + (double)r.y * v.y + (double)r.z * v.z) / 16384, m->mesh.scale);
    }
}

typedef struct result {
    double place, depth;        /* worst errors: pixels, 1/65536 */
    int meshes, judged;         /* vertices that have a place */
    int lost, nearer;           /* without a place though well seen; with one though too near */
    double place_left, place_w; /* of the worst: where it should be, and how far away */
} result;

static void judge(const model *m, int i, result *r)
{
    const lmb_vertex *v = &m->vertex[i];
    bool perspective = m->camera.perspective, direct = m->screen.direct;
    double p[3], x, y, w, depth, error, slack, range = m->far - m->near, step = range / 65536;
    place(m, i, p);
    w = -p[2];
    x = m->width / 2.0 + m->focal * p[0] / (perspective ? w : 1);
    y = m->height / 2.0 - m->focal * p[1] / (perspective ? w : 1);
    depth = 65536 * (perspective ? m->far / range * (1 - m->near / w) : (w - m->near) / range);
    depth = larger(0, fmin(65535, depth));
    if (v->x == LMB_NOT_ON_SCREEN) { /* some depths, and what a place in space may be off, are left to clipping */
        r->lost += w > m->near + 7 * step + 1.0 / 65536 && fabs(x) < 14000 && fabs(y) < 14000;
        return;
    }
    r->judged++;
    r->nearer += -lmb_mesh_place(&m->mesh, &m->pose, (uint32_t)i).z < m->camera.near_q16;
    /* half of 1/65536 unit each way, where places in space are rounded; under perspective seen from a unit or more */
    slack = direct ? 0 : m->focal / 131072 * (perspective ? 1 + hypot(x - m->width / 2.0, y - m->height / 2.0) / m->focal : 1);
    error = larger(fabs(v->x / 16.0 - x), fabs(v->y / 16.0 - y)) - slack;
    if (error > r->place) r->place = error, r->place_left = x, r->place_w = w;
    r->depth = larger(r->depth, fabs(v->depth - depth) - (direct ? 0 : 0.5 / 65536 / step));
}

static void test_places(test_random *random, int perspective)
{
    static model m;
    static result r[2];
    int n, i, k;
    memset(r, 0, sizeof r);
    for (n = 0; n < 60000; n++) {
        random_model(random, &m, perspective);
        r[m.screen.direct].meshes++;
        for (i = 0; i < VERTICES; i++) judge(&m, i, &r[m.screen.direct]);
    }
    for (k = 0; k < 2 - perspective; k++) {
        const char *how = perspective ? "perspective" : k ? "orthographic, one product" : "orthographic, through space";
        test_verdict(r[k].place <= LMB_PROJECT_MAX_ERROR && r[k].judged > 100000, "vertex: place on the screen",
                     "%s, worst %.4f pixels (x %.1f, w %.4g) of %d vertices, %d meshes, bound %.4f", how, r[k].place,
                     r[k].place_left, r[k].place_w, r[k].judged, r[k].meshes, LMB_PROJECT_MAX_ERROR);
        test_verdict(r[k].depth <= DEPTH_ERROR, "vertex: depth", "%s, worst %.3f / 65536, bound %.1f", how, r[k].depth,
                     DEPTH_ERROR);
        test_verdict(!r[k].nearer && !r[k].lost, "vertex: nearer than the near plane has no place, what is seen has one",
                     "%s, %d have one, %d have none", how, r[k].nearer, r[k].lost);
    }
    test_verdict(perspective ? r[1].meshes == 0 : r[1].meshes > n / 4, "vertex: which way", "%s, %d of %d meshes by one product",
                 perspective ? "perspective" : "orthographic", r[1].meshes, n);
}

#define PIECES (6 * TRIANGLES)

/* What a walk comes by: the corners of its triangles, top to bottom. */
typedef struct path {
    lmb_vertex corner[3 * PIECES];
    int triangles;
} path;

static void walk_mesh(path *p, const model *m, const lmb_look *look, bool before, const uint16_t *order)
{
    const lmb_window window = {0, 0, (int16_t)m->width, (int16_t)m->height, true};
    lmb_walk walk;
    lmb_triangle triangle;
    int k;
    memset(p, 0, sizeof *p);
    lmb_mesh_begin(&walk, &m->mesh, &m->pose, &m->camera, look, &window, before ? m->vertex : NULL, order);
    for (; lmb_mesh_next(&walk, &triangle); p->triangles++) {
        for (k = 0; k < 3; k++) p->corner[3 * p->triangles + k] = *triangle.corner[k];
    }
}

static bool same_path(const path *p, const path *q)
{
    int i;
    bool same = p->triangles == q->triangles;
    for (i = 0; same && i < 3 * p->triangles; i++) {
        const lmb_vertex *a = &p->corner[i], *b = &q->corner[i];
        same = a->x == b->x && a->y == b->y && a->depth == b->depth && a->normal.x == b->normal.x && a->normal.y == b->normal.y &&
               a->normal.z == b->normal.z;
    }
    return same;
}

/* Walks with corners projected before and on the way come by the same triangles, bit for bit, clipped ones among them; in
 * painter's order, too, and flat. */
static void test_walks(test_random *random, enum lmb_model kind)
{
    static model m;
    static path p, q;
    static const lmb_material material = {{10, 10, 10}, {200, 200, 200}, {0, 0, 0}, 10};
    static const lmb_light light = {{0, 0, 16384}, {255, 255, 255}};
    static uint16_t order[TRIANGLES];
    static int16_t keys[TRIANGLES];
    lmb_look look;
    int n, i, faults = 0, clipped = 0, more = 0, triangles = 0;
    if (lmb_look_prepare(&look, &material, &light, 1, kind, LMB_STEP_LINEAR) != 0) abort();
    for (n = 0; n < 20000; n++) {
        random_model(random, &m, n % 3 == 0);
        for (i = 0; i < VERTICES; i++) clipped += m.vertex[i].x == LMB_NOT_ON_SCREEN;
        if (lmb_mesh_sort(&m.mesh, &m.pose, order, keys) != 0) abort();
        for (i = 0; i < 2; i++) {
            walk_mesh(&p, &m, &look, false, i ? order : NULL);
            walk_mesh(&q, &m, &look, true, i ? order : NULL);
            faults += !same_path(&p, &q);
            more += i ? p.triangles : -p.triangles;
            triangles += p.triangles;
        }
    }
    test_verdict(!faults && !more && triangles > 100000 && clipped > 10000,
                 "walk: the same corners projected before or on the way",
                 "%s, %d of %d walks differ, %d triangles, %d more in painter's order; %d vertices to clip",
                 kind == LMB_MODEL_FLAT ? "flat" : "diffuse", faults, 4 * n, triangles, more, clipped);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    int i;
    for (i = 0; i < 2; i++) test_places(&random, i);
    test_walks(&random, LMB_MODEL_DIFFUSE);
    test_walks(&random, LMB_MODEL_FLAT);
    return test_end();
}
