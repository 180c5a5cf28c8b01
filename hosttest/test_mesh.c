/* SPDX-License-Identifier: MIT */
/* Meshes onto the screen: pose, projection, clipping, culling and order, against doubles and 64-bit integers.
 *
 * The reference for clipping does not clip: in homogeneous coordinates the sides of a triangle and the near plane are linear
 * functions of the pixel, whatever lies behind the viewer (Olano and Greer 1997): inside, all four are positive. */
#include "test.h"

#include <string.h>

#include "../firmware/lambent.h"

static const double pi = 3.14159265358979323846;

static double larger(double a, double b) { return a > b ? a : b; }

static lmb_vec vec(int64_t x, int64_t y, int64_t z)
{
    lmb_vec v;
    v.x = (int16_t)x;
    v.y = (int16_t)y;
    v.z = (int16_t)z;
    return v;
}

static uint16_t angle(test_random *random) { return (uint16_t)test_next(random); }

static double log_real(test_random *random, double low, double high) { return exp(test_real(random, log(low), log(high))); }

/* ----------------------------------------------------------------------------------------------------------------------- pose */

static void test_place(test_random *random)
{
    double worst = 0;
    int i, k;
    for (i = 0; i < 1000000; i++) {
        lmb_pose pose;
        lmb_vec v =
            vec(test_integer(random, -32768, 32767), test_integer(random, -32768, 32767), test_integer(random, -32768, 32767));
        lmb_mesh mesh = {&v, NULL, NULL, 1, 0, (int8_t)test_integer(random, LMB_SCALE_MIN, LMB_SCALE_MAX), 0};
        int32_t half = 16384 * 65536, to[3];
        lmb_point p;
        pose.rotation = lmb_rotation(angle(random), angle(random), angle(random));
        pose.x = (int32_t)test_integer(random, -half, half);
        pose.y = (int32_t)test_integer(random, -half, half);
        pose.z = (int32_t)test_integer(random, -half, half);
        p = lmb_mesh_place(&mesh, &pose, 0);
        to[0] = p.x - pose.x;
        to[1] = p.y - pose.y;
        to[2] = p.z - pose.z;
        for (k = 0; k < 3; k++) {
            lmb_vec r = pose.rotation.row[k];
            double turned = ((double)r.x * v.x + (double)r.y * v.y + (double)r.z * v.z) / 16384;
            worst = larger(worst, fabs(to[k] - ldexp(turned, mesh.scale + 16)));
        }
    }
    test_verdict(worst <= 0.5, "place: rounded to nearest", "worst %.6f / 65536 unit of %d points", worst, i);
}

/* ----------------------------------------------------------------------------------------------------------------- projection */

typedef struct view {
    lmb_camera camera;
    int width, height;
    double focal, near, far; /* as the camera has them; near and far in 1/65536 unit */
    int perspective;
} view;

static void view_set(view *v, int perspective, int width, int height, double focal, double near, double far)
{
    int32_t focal_q16 = (int32_t)(focal * 65536), near_q16 = (int32_t)near, far_q16 = (int32_t)far;
    int error = perspective ? lmb_camera_perspective(&v->camera, width, height, focal_q16, near_q16, far_q16)
                            : lmb_camera_orthographic(&v->camera, width, height, focal_q16, near_q16, far_q16);
    if (error) {
        printf("FAIL camera: refuses %d x %d, focal %g, near %g, far %g\n", width, height, focal, near, far);
        exit(EXIT_FAILURE);
    }
    v->perspective = perspective;
    v->width = width;
    v->height = height;
    v->focal = focal_q16 / 65536.0;
    v->near = near_q16;
    v->far = far_q16;
}

/* Any camera that set-up takes, with far at least twice as far as near and a field of view from 7 to 150 degrees. */
static void random_view(test_random *random, view *v, int perspective)
{
    int width = (int)test_integer(random, 1, 1024), height = (int)test_integer(random, 1, 1024);
    double near, far;
    if (perspective) {
        near = log_real(random, 256, 1 << 28);
        far = fmin(INT32_MAX, near * log_real(random, 2.01, 1e5));
        view_set(v, 1, width, height, width * log_real(random, 0.13, 8), near, far);
    } else {
        near = test_real(random, -16384 * 65536.0, 16384 * 65536.0);
        far = fmin(INT32_MAX, near + log_real(random, 256, INT32_MAX / 2));
        view_set(v, 0, width, height, log_real(random, 0.01, 4000), near, far);
    }
}

/* Screen position in pixels and depth, by their definitions. */
static void project_reference(const view *v, lmb_point p, double *x, double *y, double *depth)
{
    double w = -(double)p.z, over = v->perspective ? w : 65536;
    *x = v->width / 2.0 + v->focal * p.x / over;
    *y = v->height / 2.0 - v->focal * p.y / over;
    *depth = 65536 * (v->perspective ? v->far / (v->far - v->near) * (1 - v->near / w) : (w - v->near) / (v->far - v->near));
    *depth = larger(0, fmin(*depth, 65535));
}

/* A point about the frame, near to somewhat beyond far. */
static lmb_point random_point(test_random *random, const view *v)
{
    double w = fmin(INT32_MAX, v->perspective ? v->near * log_real(random, 1, 1.5 * v->far / v->near)
                                              : v->near + (v->far - v->near) * test_real(random, 0, 1.5));
    double over = (v->perspective ? w : 65536) / v->focal;
    double x = v->width * test_real(random, -1, 1) * over, y = v->height * test_real(random, -1, 1) * over;
    lmb_point p;
    p.x = (int32_t)larger(-INT32_MAX, fmin(INT32_MAX, x));
    p.y = (int32_t)larger(-INT32_MAX, fmin(INT32_MAX, y));
    p.z = (int32_t)-larger(w, ceil(v->near));
    return p;
}

static void test_projection(test_random *random, int perspective)
{
    double worst = 0, worst_depth = 0, at_focal = 0;
    int i, refused = 0;
    int32_t at_w = 0, at_w_depth = 0;
    for (i = 0; i < 2000000; i++) {
        static view v;
        lmb_vertex vertex = {0, 0, {0, 0, 0}, 0};
        lmb_point p;
        double x, y, depth, error;
        if (i % 4 == 0) random_view(random, &v, perspective);
        p = random_point(random, &v);
        project_reference(&v, p, &x, &y, &depth);
        if (!lmb_project(&v.camera, p, &vertex)) {
            refused++;
            continue;
        }
        error = larger(fabs(vertex.x / 16.0 - x), fabs(vertex.y / 16.0 - y));
        if (error > worst) worst = error, at_w = -p.z, at_focal = v.focal;
        error = fabs(vertex.depth - depth);
        if (error > worst_depth) worst_depth = error, at_w_depth = -p.z;
    }
    test_verdict(worst <= LMB_PROJECT_MAX_ERROR && refused == 0, "project: place on the screen",
                 "%s, worst %.4f pixels (w 0x%08" PRIx32 ", focal length %.0f px), bound %.4f, %d of %d refused",
                 perspective ? "perspective" : "orthographic", worst, (uint32_t)at_w, at_focal, LMB_PROJECT_MAX_ERROR, refused,
                 i);
    test_verdict(worst_depth <= 2, "project: depth", "%s, worst %.3f / 65536 (w 0x%08" PRIx32 ")",
                 perspective ? "perspective" : "orthographic", worst_depth, (uint32_t)at_w_depth);
}

/* What is too near or too far aside is refused, and then nothing is written. */
static void test_refusals(test_random *random)
{
    int i, faults = 0, near = 0, aside = 0;
    for (i = 0; i < 400000; i++) {
        view v;
        lmb_vertex vertex, before;
        lmb_point p;
        double x, y, depth;
        bool drawn;
        random_view(random, &v, i & 1);
        p = random_point(random, &v);
        if (i % 3 == 0) p.z = (int32_t)-test_real(random, -INT32_MAX, v.near);
        if (i % 6 == 0) p.z = (int32_t)(test_integer(random, 1, 9) - (int64_t)v.near);
        if (i % 3 == 1) p.x = (int32_t)test_real(random, -INT32_MAX, INT32_MAX);
        if (i % 3 == 2) p.y = (int32_t)test_real(random, -INT32_MAX, INT32_MAX);
        memset(&vertex, 0x5a, sizeof vertex);
        before = vertex;
        project_reference(&v, p, &x, &y, &depth);
        x = larger(fabs(x), fabs(y));
        drawn = lmb_project(&v.camera, p, &vertex);
        if (-(double)p.z < v.near) {
            near++;
            faults += drawn;
        } else if (x > 32767 + LMB_PROJECT_MAX_ERROR) {
            aside++;
            faults += drawn;
        } else if (x < 32767 - LMB_PROJECT_MAX_ERROR) {
            faults += !drawn;
        }
        faults += !drawn && memcmp(&vertex, &before, sizeof vertex) != 0;
    }
    test_verdict(!faults, "project: refuses what is too near or beyond the screen, and writes nothing then",
                 "%d faults of %d, %d too near, %d beyond", faults, i, near, aside);
}

/* Wherever two points lie, the farther is not the nearer one by depth. */
static void test_depth_order(test_random *random)
{
    int i, faults = 0;
    for (i = 0; i < 400000; i++) {
        view v;
        lmb_vertex a, b;
        lmb_point p = {0, 0, 0}, q = {0, 0, 0};
        random_view(random, &v, i & 1);
        p.z = (int32_t)-test_real(random, ceil(v.near), INT32_MAX);
        q.z = (int32_t)-test_real(random, ceil(v.near), INT32_MAX);
        if (i % 3 == 0) q.z = p.z < 0 ? p.z + 1 : p.z - 1;
        if (!lmb_project(&v.camera, p, &a) || !lmb_project(&v.camera, q, &b)) continue;
        if (p.z <= q.z ? a.depth < b.depth : a.depth > b.depth) faults++;
    }
    test_verdict(!faults, "project: depth never falls with distance", "%d faults of %d pairs", faults, i);
}

static void test_camera_arguments(void)
{
    static const struct {
        int width, height;
        int32_t focal, near, far;
        int orthographic, perspective;
    } cases[] = {
        {240, 240, 65536, 65536, 655360, LMB_OK, LMB_OK},
        {1, 1, 1, 256, 257, LMB_OK, LMB_OK},
        {240, 240, 65536, 255, 655360, LMB_OK, LMB_ERROR_VALUE},
        {240, 240, 65536, 0, 655360, LMB_OK, LMB_ERROR_VALUE},
        {240, 240, 65536, -655360, 655360, LMB_OK, LMB_ERROR_VALUE},
        {240, 240, INT32_MAX, 256, INT32_MAX, LMB_OK, LMB_OK},
        {240, 240, 65536, -1, INT32_MAX - 1, LMB_OK, LMB_ERROR_VALUE},
        {240, 240, 65536, -1, INT32_MAX, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
        {240, 240, 65536, -INT32_MAX, INT32_MAX, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
        {240, 240, 65536, 65536, 65536, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
        {240, 240, 65536, 65537, 65536, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
        {240, 240, 0, 65536, 655360, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
        {240, 240, -65536, 65536, 655360, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
        {0, 240, 65536, 65536, 655360, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
        {240, 0, 65536, 65536, 655360, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
        {-1, 240, 65536, 65536, 655360, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
        {240, 32768, 65536, 65536, 655360, LMB_ERROR_VALUE, LMB_ERROR_VALUE},
    };
    int i, n = (int)(sizeof cases / sizeof *cases), faults = 0, at = -1;
    lmb_camera camera;
    for (i = 0; i < n; i++) {
        int o = lmb_camera_orthographic(&camera, cases[i].width, cases[i].height, cases[i].focal, cases[i].near, cases[i].far);
        int p = lmb_camera_perspective(&camera, cases[i].width, cases[i].height, cases[i].focal, cases[i].near, cases[i].far);
        if (o != cases[i].orthographic || p != cases[i].perspective) faults++, at = i;
    }
    test_verdict(!faults, "camera: good arguments are taken, bad ones refused", "%d faults in %d cases, last at case %d", faults,
                 n, at);
}

/* ------------------------------------------------------------------------------------------------------------------- clipping */

#define FRAME_W 96
#define FRAME_H 72
#define EDGE 0.125  /* pixels this near an edge may go either way */
#define NEAR_STEP 8 /* and those whose distance is this near the near plane, 1/65536 unit: on a steep plane many pixels */

/* Four linear functions of the pixel, positive inside: value = x v[0] + y v[1] + v[2], in pixels from the edge. */
typedef struct region {
    double side[5][3], diagonal[3];
    int sides;
    int front;
} region;

static void cross_product(double out[3], const double a[3], const double b[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static void side_set(double to[3], const double f[3])
{
    double length = sqrt(f[0] * f[0] + f[1] * f[1]);
    int i;
    if (length == 0) length = fabs(f[2]) * 1e-9 + 1e-300; /* all of the screen on one side */
    for (i = 0; i < 3; i++) to[i] = -f[i] / length;
}

/* A point in homogeneous screen coordinates; w[0] its distance from the near plane. */
static void homogeneous(const view *v, double near, lmb_point p, double h[3], double *before)
{
    double w = -(double)p.z, over = v->perspective ? w : 65536;
    h[0] = v->focal * p.x + v->width / 2.0 * over;
    h[1] = -v->focal * p.y + v->height / 2.0 * over;
    h[2] = over;
    *before = w - near;
}

/* The region of a triangle, or of the parallelogram whose fourth corner faces the second: sides 01, 12, 23, 30. */
static void region_set(region *r, const view *v, double near_plane, const lmb_point *corner, int corners)
{
    double h[4][3], before[4], f[3][3], near[3] = {0, 0, 0}, volume;
    int i, k;
    for (i = 0; i < corners; i++) homogeneous(v, near_plane, corner[i], h[i], &before[i]);
    for (i = 0; i < 3; i++) cross_product(f[i], h[(i + 1) % 3], h[(i + 2) % 3]);
    volume = f[0][0] * h[0][0] + f[0][1] * h[0][1] + f[0][2] * h[0][2];
    r->front = volume < 0;
    r->sides = 0;
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 3; k++) near[k] += f[i][k] * before[i];
    }
    side_set(r->side[r->sides++], near);
    side_set(r->diagonal, f[1]);
    for (i = 0; i < corners; i++) {
        double e[3];
        cross_product(e, h[i], h[(i + 1) % corners]);
        side_set(r->side[r->sides++], e);
    }
}

static double side_at(const double f[3], int x, int y) { return f[0] * (x + 0.5) + f[1] * (y + 0.5) + f[2]; }

/* How deep inside, front or back, the centre of a pixel lies, in pixels; negative outside. */
static double region_depth(const region *r, int x, int y)
{
    double least = INFINITY, sign = r->front ? 1 : -1;
    int i;
    for (i = 0; i < r->sides; i++) least = fmin(least, sign * side_at(r->side[i], x, y));
    return least;
}

typedef struct scene {
    view v;
    lmb_look look;
    lmb_window window;
    lmb_vec position[4], normal[4];
    lmb_mesh mesh;
    lmb_pose pose;
    uint8_t count[FRAME_W * FRAME_H];
    uint64_t triangles;
    int outside; /* spans that left the window */
} scene;

static const uint16_t scene_indices[6] = {0, 1, 2, 0, 2, 3};

static void scene_begin(scene *s)
{
    static const lmb_material material = {{10, 10, 10}, {200, 200, 200}, {0, 0, 0}, 10};
    static const lmb_light light = {{0, 0, 16384}, {255, 255, 255}};
    static const lmb_matrix straight = {{{16384, 0, 0}, {0, 16384, 0}, {0, 0, 16384}}};
    int i;
    memset(s, 0, sizeof *s);
    if (lmb_look_prepare(&s->look, &material, &light, 1, LMB_MODEL_DIFFUSE, LMB_STEP_LINEAR) != 0) abort();
    for (i = 0; i < 4; i++) s->normal[i] = vec(0, 0, 16384);
    s->mesh.positions = s->position;
    s->mesh.normals = s->normal;
    s->mesh.indices = scene_indices;
    s->mesh.vertices = 4;
    s->pose.rotation = straight;
}

/* What scenes there are: far-reaching ones under either camera, and close ones. */
enum { SCENE_ORTHOGRAPHIC, SCENE_PERSPECTIVE, SCENE_CLOSE };

/* A corner that is seen, aside, far aside (about the guard band), or behind the near plane. */
static lmb_vec random_corner(test_random *random, const scene *s)
{
    double unit_q16 = ldexp(65536, s->mesh.scale), most = 8000 * unit_q16, w, x, y, over, reach;
    int kind = (int)test_integer(random, 0, 7);
    w = s->v.near * log_real(random, 1, 30);
    if (kind >= 6) w = test_real(random, -10, 1) * s->v.near;
    over = (s->v.perspective ? (fabs(w) > 1 ? fabs(w) : 1) : 65536) / s->v.focal;
    reach = kind <= 2 ? FRAME_W : kind == 3 ? 1000 : kind == 4 ? log_real(random, 14000, 40000) : log_real(random, 100, 1e6);
    x = larger(-most, fmin(most, over * test_real(random, -reach, reach)));
    y = larger(-most, fmin(most, over * test_real(random, -reach, reach)));
    w = larger(-most, fmin(most, w));
    return vec(lround(x / unit_q16), lround(y / unit_q16), lround(-w / unit_q16));
}

/* Corners 0 and 2 on either side of the frame, so that their edge crosses it; one of them, as a rule, about the guard band. */
static void edge_across(test_random *random, scene *s)
{
    double unit_q16 = ldexp(65536, s->mesh.scale), turn = test_real(random, 0, 2 * pi), most = 8000 * unit_q16;
    int i;
    for (i = 0; i < 3; i += 2, turn += pi) {
        double w = s->v.near * log_real(random, 1, 3), over = (s->v.perspective ? w : 65536) / s->v.focal;
        double reach = over * log_real(random, i ? 100 : 15000, 33000);
        double x = larger(-most, fmin(most, reach * cos(turn))), y = larger(-most, fmin(most, reach * sin(turn)));
        s->position[i] = vec(lround(x / unit_q16), lround(y / unit_q16), lround(-larger(-most, fmin(most, w)) / unit_q16));
    }
}

/* A mesh that goes to the screen by one product a coordinate (screen.c), the near plane through it as a rule. */
static void random_close(test_random *random, scene *s)
{
    double half, focal, near;
    int i;
    s->mesh.scale = (int8_t)test_integer(random, -17, -12);
    half = ldexp(65536, s->mesh.scale + 15);
    focal = log_real(random, 10, 370) / half * 65536;
    near = test_real(random, -8, 8) * 65536;
    view_set(&s->v, 0, FRAME_W, FRAME_H, focal, near, near + log_real(random, 65536, 64 * half + 65536 * 2));
    for (i = 0; i < 3; i++) {
        s->position[i] =
            vec(test_integer(random, -10900, 10900), test_integer(random, -10900, 10900), test_integer(random, -10900, 10900));
    }
    s->pose.x = (int32_t)(test_real(random, -0.5, 0.5) * half);
    s->pose.y = (int32_t)(test_real(random, -0.5, 0.5) * half);
    s->pose.z = (int32_t) - (s->v.near + test_real(random, -0.2, 0.6) * half);
}

static void random_scene(test_random *random, scene *s, int kind)
{
    double near = log_real(random, 65536 * 4, 65536 * 32);
    int i;
    if (kind == SCENE_CLOSE) {
        random_close(random, s);
    } else {
        view_set(&s->v, kind, FRAME_W, FRAME_H, log_real(random, 30, 300), near, near * log_real(random, 4, 1000));
        s->mesh.scale = (int8_t)test_integer(random, -8, -2);
        for (i = 0; i < 3; i++) s->position[i] = random_corner(random, s);
        if (test_integer(random, 0, 2) == 0) edge_across(random, s);
    }
    i = s->position[0].x + s->position[2].x - s->position[1].x; /* the fourth of a parallelogram: differences of 15 bits fit */
    s->position[3].x = (int16_t)i;
    s->position[3].y = (int16_t)(s->position[0].y + s->position[2].y - s->position[1].y);
    s->position[3].z = (int16_t)(s->position[0].z + s->position[2].z - s->position[1].z);
    s->window.left = (int16_t)test_integer(random, 0, FRAME_W - 1);
    s->window.top = (int16_t)test_integer(random, 0, FRAME_H - 1);
    s->window.right = (int16_t)test_integer(random, s->window.left + 1, FRAME_W);
    s->window.bottom = (int16_t)test_integer(random, s->window.top + 1, FRAME_H);
    if (test_integer(random, 0, 1)) s->window.left = s->window.top = 0, s->window.right = FRAME_W, s->window.bottom = FRAME_H;
}

static void scene_draw(scene *s)
{
    lmb_walk walk;
    lmb_triangle triangle;
    lmb_span span;
    unsigned i;
    memset(s->count, 0, sizeof s->count);
    lmb_mesh_begin(&walk, &s->mesh, &s->pose, &s->v.camera, &s->look, &s->window, NULL, NULL);
    while (lmb_mesh_next(&walk, &triangle)) {
        s->triangles++;
        while (lmb_triangle_next(&triangle, &span)) {
            if (span.x < s->window.left || span.x + span.length > s->window.right || span.y < s->window.top ||
                span.y >= s->window.bottom) {
                s->outside++;
                continue;
            }
            for (i = 0; i < span.length; i++) s->count[span.y * FRAME_W + span.x + (int)i]++;
        }
    }
}

static void scene_print(const scene *s)
{
    int i;
    printf("  %s near %.0f far %.0f focal_q16 %" PRId32 " scale %d", s->v.perspective ? "perspective" : "orthographic", s->v.near,
           s->v.far, s->v.camera.focal_q16, s->mesh.scale);
    for (i = 0; i < 4; i++) printf(" (%d, %d, %d)", s->position[i].x, s->position[i].y, s->position[i].z);
    printf("\n");
}

/* slivers: pixels within EDGE of the diagonal that a fan's sliver, turned over as its corners were rounded, has painted again or
 * from behind. That costs a repaint; a pixel missing would be a hole. */
typedef struct clip_result {
    int gaps, twice, strays, drawn, slivers;
    double deepest, farthest; /* of a gap, of a stray, pixels from the edge */
} clip_result;

/* inner and outer: the region with the near plane a step farther and a step nearer. */
static void scene_compare(const scene *s, const region *inner, const region *outer, clip_result *c)
{
    int x, y;
    for (y = s->window.top; y < s->window.bottom; y++) {
        for (x = s->window.left; x < s->window.right; x++) {
            int got = s->count[y * FRAME_W + x];
            double deep = region_depth(inner, x, y), wide = region_depth(outer, x, y), stray = outer->front ? -wide : fabs(wide);
            int sliver = outer->sides > 4 && fabs(side_at(outer->diagonal, x, y)) <= EDGE && (outer->front ? got > 1 : got > 0);
            c->drawn += got > 0;
            if (got == 0 && outer->front) c->deepest = larger(c->deepest, deep);
            c->gaps += got == 0 && outer->front && deep > EDGE;
            c->slivers += sliver;
            if (sliver) continue;
            if (got > 0) c->farthest = larger(c->farthest, stray);
            c->strays += got > 0 && stray > EDGE;
            c->twice += got > 1 && deep > EDGE;
        }
    }
}

/* quads: two triangles that share a diagonal; inside them each pixel comes once, along the diagonal too. */
static void test_clipping(test_random *random, int kind, int quads)
{
    static const char *const name[] = {"orthographic", "perspective", "orthographic, close"};
    static scene s;
    clip_result c = {0, 0, 0, 0, 0, 0, 0};
    int i, faults = 0;
    scene_begin(&s);
    s.mesh.triangles = quads ? 2 : 1;
    for (i = 0; i < 30000; i++) {
        region inner, outer;
        lmb_point p[4];
        int k, before = c.gaps + c.twice + c.strays;
        random_scene(random, &s, kind);
        for (k = 0; k < 4; k++) p[k] = lmb_mesh_place(&s.mesh, &s.pose, (uint32_t)k);
        region_set(&inner, &s.v, s.v.near + NEAR_STEP, p, quads ? 4 : 3);
        region_set(&outer, &s.v, s.v.near - NEAR_STEP, p, quads ? 4 : 3);
        scene_draw(&s);
        scene_compare(&s, &inner, &outer, &c);
        if (c.gaps + c.twice + c.strays > before && faults++ < 3) { scene_print(&s); }
    }
    test_verdict(!c.gaps && !c.strays && !s.outside && !c.twice && c.slivers < c.drawn / 100000,
                 quads ? "clip: two triangles that share an edge" : "clip: a triangle",
                 "%s, %d scenes, %d pixels: %d missing (deepest %.4f px inside), %d outside (farthest %.4f px), %d twice, %d by "
                 "slivers, %d beyond the window",
                 name[kind], i, c.drawn, c.gaps, c.deepest, c.strays, c.farthest, c.twice, c.slivers, s.outside);
}

/* ---------------------------------------------------------------------------------------------------------------------- order */

#define SORT_MAX 65537

/* Where each triangle stands, exact: three times the depth of its middle in Q2.14 mesh units. */
static int64_t triangle_depth(const lmb_mesh *mesh, const lmb_pose *pose, uint32_t triangle)
{
    int64_t sum = 0;
    int i;
    for (i = 0; i < 3; i++) {
        lmb_vec p = mesh->positions[mesh->indices[3 * triangle + (uint32_t)i]], r = pose->rotation.row[2];
        sum += (int64_t)r.x * p.x + (int64_t)r.y * p.y + (int64_t)r.z * p.z;
    }
    return sum;
}

static void test_sort(test_random *random)
{
    static lmb_vec positions[1000];
    static uint16_t indices[3 * SORT_MAX], order[SORT_MAX + 1];
    static int16_t keys[SORT_MAX + 1];
    static uint8_t seen[SORT_MAX];
    static const uint32_t sizes[] = {0, 1, 2, 3, 4, 5, 13, 14, 40, 41, 1000, 65535, 65536};
    int faults = 0, upset = 0, i;
    uint32_t n, k;
    lmb_mesh mesh = {positions, positions, indices, 1000, 0, -14, 0};
    lmb_pose pose = {{{{16384, 0, 0}, {0, 16384, 0}, {0, 0, 16384}}}, 0, 0, -300000};
    int64_t back = 0;
    for (i = 0; i < 1000; i++) {
        positions[i] =
            vec(test_integer(random, -32768, 32767), test_integer(random, -32768, 32767), test_integer(random, -32768, 32767));
    }
    for (i = 0; i < 3 * SORT_MAX; i++) indices[i] = (uint16_t)test_integer(random, 0, 999);
    for (i = 0; i < 13 * 4; i++) {
        mesh.triangles = n = sizes[i % 13];
        pose.rotation = lmb_rotation(angle(random), angle(random), angle(random));
        memset(seen, 0, sizeof seen);
        order[n] = 0x5a5a;
        keys[n] = 0x5a5a;
        if (lmb_mesh_sort(&mesh, &pose, order, keys) != LMB_OK) faults++;
        faults += order[n] != 0x5a5a || keys[n] != 0x5a5a;
        for (k = 0; k < n; k++) faults += order[k] >= n || seen[order[k]]++;
        for (k = 1; k < n; k++) {
            int64_t fall = triangle_depth(&mesh, &pose, order[k - 1]) - triangle_depth(&mesh, &pose, order[k]);
            upset += keys[order[k - 1]] > keys[order[k]];
            if (fall > back) back = fall;
        }
    }
    mesh.triangles = SORT_MAX;
    test_verdict(lmb_mesh_sort(&mesh, &pose, order, keys) == LMB_ERROR_VALUE, "sort: 65537 triangles are refused",
                 "as they must be");
    test_verdict(!faults && !upset, "sort: a permutation in order of its keys", "%d faults, %d pairs upset, 0 to 65536 triangles",
                 faults, upset);
    /* a key is in units of 2^17, and three roundings by less than 4 go before */
    test_verdict(back <= (1 << 17) + 12, "sort: farthest first",
                 "a triangle comes before one at most %.2f mesh units farther, bound 2.67", (double)back / 3 / 16384);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    int i;
    test_place(&random);
    for (i = 0; i < 2; i++) test_projection(&random, i);
    test_refusals(&random);
    test_depth_order(&random);
    test_camera_arguments();
    for (i = 0; i < 6; i++) test_clipping(&random, i % 3, i / 3);
    test_sort(&random);
    return test_end();
}
