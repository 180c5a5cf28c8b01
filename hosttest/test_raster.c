/* SPDX-License-Identifier: MIT */
/* Triangles into spans: which pixels, in what order, and what the terms say at each, against exact integers and doubles.
 *
 * Coverage is taken from the definition, edge functions in 64 bits over every pixel of the window; unions are taken from a
 * crossing count over their outline at the pixel's centre moved by (e, e^2), e infinitely small, which is what the top-left rule
 * comes to. Neither shares anything with the edge walk. */
#include "test.h"

#include <string.h>

#include "../firmware/lambent.h"

#define SIDE 64 /* largest window of these tests */
#define PX 16   /* screen units in a pixel */

static const double pi = 3.14159265358979323846;

typedef struct shape {
    lmb_vertex v[3];
    lmb_window window;
} shape;

static int width_of(const lmb_window *w) { return w->right - w->left; }
static int height_of(const lmb_window *w) { return w->bottom - w->top; }
static double larger(double a, double b) { return a > b ? a : b; }

static lmb_vec unit(double x, double y, double z)
{
    double r = 16384 / sqrt(x * x + y * y + z * z);
    lmb_vec v = {(int16_t)lround(x * r), (int16_t)lround(y * r), (int16_t)lround(z * r)};
    return v;
}

static lmb_vec random_unit(test_random *random)
{
    double z = test_real(random, -1, 1), angle = test_real(random, 0, 2 * pi), r = sqrt(1 - z * z);
    return unit(r * cos(angle), r * sin(angle), z);
}

/* --------------------------------------------------------------------------------------------------------- windows and shapes */

static lmb_window random_window(test_random *random)
{
    int w = (int)test_integer(random, 1, SIDE), h = (int)test_integer(random, 1, SIDE), kind = (int)test_integer(random, 0, 9), x,
        y;
    lmb_window window;
    if (kind == 0) w = h = 1;
    if (kind == 1) w = SIDE, h = 1;
    if (kind == 2) w = 1, h = SIDE;
    x = (int)test_integer(random, -100, 1000);
    y = (int)test_integer(random, -100, 1000);
    if (kind == 3) x = (int)test_integer(random, -32767, 32767 - w), y = (int)test_integer(random, -32767, 32767 - h);
    if (kind == 4) x = y = 0;
    window.left = (int16_t)x;
    window.top = (int16_t)y;
    window.right = (int16_t)(x + w);
    window.bottom = (int16_t)(y + h);
    return window;
}

static int32_t held(int64_t at)
{
    return (int32_t)(at < -LMB_SCREEN_MAX ? -LMB_SCREEN_MAX : at > LMB_SCREEN_MAX ? LMB_SCREEN_MAX : at);
}

static int32_t near_window(test_random *random, int low, int high)
{
    int32_t margin = (high - low) * PX / 2;
    return held(test_integer(random, low * PX - margin, high * PX + margin));
}

static void place(lmb_vertex *v, int64_t x, int64_t y)
{
    v->x = held(x);
    v->y = held(y);
}

static void shape_ordinary(test_random *random, shape *s)
{
    int i;
    for (i = 0; i < 3; i++) {
        s->v[i].x = near_window(random, s->window.left, s->window.right);
        s->v[i].y = near_window(random, s->window.top, s->window.bottom);
    }
}

static void shape_tiny(test_random *random, shape *s)
{
    int i, reach = (int)test_integer(random, 1, 24);
    shape_ordinary(random, s);
    for (i = 1; i < 3; i++) {
        place(&s->v[i], s->v[0].x + test_integer(random, -reach, reach), s->v[0].y + test_integer(random, -reach, reach));
    }
}

/* Two corners up to 1000 pixels apart on a line through the window; the third within a few units of that line. */
static void shape_sliver(test_random *random, shape *s)
{
    double angle = test_real(random, 0, 2 * pi), length = test_real(random, 16, 1000 * PX), at = test_real(random, 0, 1);
    double dx = length * cos(angle), dy = length * sin(angle), along = test_real(random, 0, 1);
    shape_ordinary(random, s);
    if (test_integer(random, 0, 3) == 0) dx = 0;
    if (test_integer(random, 0, 3) == 0) dy = 0;
    place(&s->v[1], s->v[0].x - (int64_t)(dx * at), s->v[0].y - (int64_t)(dy * at));
    place(&s->v[2], s->v[1].x + (int64_t)dx, s->v[1].y + (int64_t)dy);
    place(&s->v[0], s->v[1].x + (int64_t)(dx * along) + test_integer(random, -2, 2),
          s->v[1].y + (int64_t)(dy * along) + test_integer(random, -2, 2));
}

static void shape_degenerate(test_random *random, shape *s)
{
    int64_t dx = test_integer(random, -40, 40), dy = test_integer(random, -40, 40), m = test_integer(random, -30, 30);
    shape_ordinary(random, s);
    place(&s->v[1], s->v[0].x + dx, s->v[0].y + dy);
    place(&s->v[2], s->v[0].x + dx * m, s->v[0].y + dy * m);
    if (m == 1) s->v[1] = s->v[0];
}

/* Corners on pixel centres and on the corners between pixels. */
static void shape_aligned(test_random *random, shape *s)
{
    int i, step = test_integer(random, 0, 1) ? PX : PX / 2;
    for (i = 0; i < 3; i++) {
        place(&s->v[i], (s->window.left + test_integer(random, -4, 16)) * PX + test_integer(random, 0, 1) * step,
              (s->window.top + test_integer(random, -4, 16)) * PX + test_integer(random, 0, 1) * step);
    }
    if (step == PX) {
        for (i = 0; i < 3; i++) place(&s->v[i], s->v[i].x + PX / 2, s->v[i].y + PX / 2);
    }
}

static void shape_far(test_random *random, shape *s)
{
    int i;
    shape_ordinary(random, s);
    for (i = 0; i < 3; i++) {
        int what = (int)test_integer(random, 0, 4);
        if (what == 0) s->v[i].x = (int32_t)test_integer(random, -LMB_SCREEN_MAX, LMB_SCREEN_MAX);
        if (what <= 1) s->v[i].y = (int32_t)test_integer(random, -LMB_SCREEN_MAX, LMB_SCREEN_MAX);
        if (what == 2) s->v[i].x = test_integer(random, 0, 1) ? LMB_SCREEN_MAX : -LMB_SCREEN_MAX;
        if (what == 3) s->v[i].y = test_integer(random, 0, 1) ? LMB_SCREEN_MAX : -LMB_SCREEN_MAX;
    }
}

static void shape_beyond(test_random *random, shape *s)
{
    int32_t by = (int32_t)(test_integer(random, 0, 1) ? 1 : test_integer(random, 1, 1 << 30));
    int32_t out = test_integer(random, 0, 1) ? LMB_SCREEN_MAX + by : -LMB_SCREEN_MAX - by;
    lmb_vertex *v = &s->v[test_integer(random, 0, 2)];
    shape_ordinary(random, s);
    if (test_integer(random, 0, 1)) {
        v->x = out;
    } else {
        v->y = out;
    }
}

/* Around the whole window; corners from just outside it to the ends of the screen. */
static void shape_huge(test_random *random, shape *s)
{
    double turn = test_real(random, 0, 2 * pi), far = exp(test_real(random, log(100 * PX), log(20000 * PX)));
    int i;
    for (i = 0; i < 3; i++) {
        place(&s->v[i], s->window.left * PX + (int64_t)(far * cos(turn - i * 2 * pi / 3)),
              s->window.top * PX + (int64_t)(far * sin(turn - i * 2 * pi / 3)));
    }
}

typedef struct shape_class {
    const char *name;
    void (*make)(test_random *random, shape *s);
    int count;
} shape_class;

static const shape_class classes[] = {{"ordinary", shape_ordinary, 250000},
                                      {"tiny", shape_tiny, 250000},
                                      {"slivers", shape_sliver, 200000},
                                      {"degenerate", shape_degenerate, 50000},
                                      {"aligned", shape_aligned, 200000},
                                      {"far corners", shape_far, 50000},
                                      {"corners beyond the limit", shape_beyond, 20000},
                                      {"around the window", shape_huge, 20000}};
#define CLASSES ((int)(sizeof classes / sizeof *classes))

/* ------------------------------------------------------------------------------------------------------------------- coverage */

static int64_t side_of(const lmb_vertex *a, const lmb_vertex *b, int64_t px, int64_t py)
{
    return (int64_t)(b->x - a->x) * (py - a->y) - (int64_t)(b->y - a->y) * (px - a->x);
}

/* Clockwise as seen with y down: what lambent.h calls counter-clockwise, y up. */
static int is_front(const lmb_vertex v[3]) { return side_of(&v[0], &v[1], v[2].x, v[2].y) < 0; }

static int is_beyond(const lmb_vertex v[3])
{
    int i;
    for (i = 0; i < 3; i++) {
        if (labs((long)v[i].x) > LMB_SCREEN_MAX || labs((long)v[i].y) > LMB_SCREEN_MAX) return 1;
    }
    return 0;
}

/* The fill rule by its words, corners given clockwise with y down: inside, or on an edge that rises (a left one: the inside lies
 * to its right) or that runs right along a row (a top one). */
static int covers(const lmb_vertex *const clockwise[3], int x, int y)
{
    int i;
    for (i = 0; i < 3; i++) {
        const lmb_vertex *a = clockwise[i], *b = clockwise[i == 2 ? 0 : i + 1];
        int64_t side = side_of(a, b, x * PX + PX / 2, y * PX + PX / 2);
        int owns = b->y < a->y || (b->y == a->y && b->x > a->x);
        if (side < 0 || (side == 0 && !owns)) return 0;
    }
    return 1;
}

typedef struct coverage {
    lmb_look look;
    lmb_rays rays;
    uint64_t pixels, spans;
} coverage;

static void coverage_begin(coverage *c)
{
    static const lmb_material material = {{10, 10, 10}, {200, 200, 200}, {0, 0, 0}, 10};
    static const lmb_light light = {{0, 0, 16384}, {255, 255, 255}};
    memset(c, 0, sizeof *c);
    if (lmb_look_prepare(&c->look, &material, &light, 1, LMB_MODEL_FLAT, LMB_STEP_LINEAR) != 0) abort();
    lmb_rays_prepare(&c->rays, &c->look, NULL);
}

/* Compares the spans of one shape with the rule, pixel by pixel; NULL if all is well. */
static const char *coverage_fault(coverage *c, const shape *s)
{
    const lmb_vertex *clockwise[3] = {&s->v[0], &s->v[2], &s->v[1]};
    const lmb_window *w = &s->window;
    lmb_triangle triangle;
    lmb_span span;
    int x, y, more, visible = is_front(s->v) && !is_beyond(s->v);
    int begun = lmb_triangle_begin(&triangle, &c->look, &c->rays, &s->v[0], &s->v[1], &s->v[2], w);
    if (begun && !visible) return "begun, though seen from behind, without area or beyond the limit";
    more = begun && lmb_triangle_next(&triangle, &span);
    for (y = w->top; y < w->bottom && visible; y++) {
        int first = w->right, end = w->right;
        if (more && span.y < y) return "rows do not come top to bottom, one span each";
        if (more && span.y == y) {
            first = span.x;
            end = first + span.length;
            if (span.length < 1) return "an empty span";
            if (first < w->left || end > w->right) return "a span leaves the window sideways";
            c->pixels += span.length;
            c->spans++;
            more = lmb_triangle_next(&triangle, &span);
        }
        for (x = w->left; x < w->right; x++) {
            int is = x >= first && x < end;
            if (covers(clockwise, x, y) != is) return is ? "a pixel too many" : "a pixel is missing";
        }
    }
    if (more) return "a span above or below the window";
    if (begun && lmb_triangle_next(&triangle, &span)) return "a span after the last";
    return NULL;
}

static void shape_print(const shape *s)
{
    int i;
    for (i = 0; i < 3; i++) printf("  (%" PRId32 ", %" PRId32 ")", s->v[i].x, s->v[i].y);
    printf("  window %d %d %d %d\n", s->window.left, s->window.top, s->window.right, s->window.bottom);
}

static void swap_corners(shape *s, int i, int j)
{
    lmb_vertex swap = s->v[i];
    s->v[i] = s->v[j];
    s->v[j] = swap;
}

static void test_coverage(test_random *random, const shape_class *class)
{
    coverage c;
    const char *fault = NULL;
    shape s;
    int i, front = 0;
    memset(&s, 0, sizeof s);
    coverage_begin(&c);
    for (i = 0; i < class->count && !fault; i++) {
        s.window = random_window(random);
        class->make(random, &s);
        if (test_integer(random, 0, 7) && !is_beyond(s.v) && !is_front(s.v))
            swap_corners(&s, 1, 2); /* one in eight stays as it is */
        front += !is_beyond(s.v) && is_front(s.v);
        fault = coverage_fault(&c, &s);
    }
    if (fault) shape_print(&s);
    test_verdict(!fault, "pixels of a triangle by the top-left rule",
                 "%s: %s, %d triangles (%d from the front), %" PRIu64 " spans, %" PRIu64 " pixels", class->name,
                 fault ? fault : "exact", i, front, c.spans, c.pixels);
}

/* --------------------------------------------------------------------------------------------------------------- shared edges */

#define OUTLINE_MAX 64

/* How often each pixel of a window has been painted. */
typedef struct tally {
    coverage c;
    lmb_window window;
    uint8_t count[SIDE * SIDE];
} tally;

static void tally_add(tally *t, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c, int order)
{
    const lmb_vertex *v[3];
    lmb_triangle triangle;
    lmb_span span;
    v[order] = a;
    v[(order + 1) % 3] = b;
    v[(order + 2) % 3] = c;
    if (!lmb_triangle_begin(&triangle, &t->c.look, &t->c.rays, v[0], v[1], v[2], &t->window)) return;
    while (lmb_triangle_next(&triangle, &span)) {
        uint8_t *row = t->count + (span.y - t->window.top) * SIDE + (span.x - t->window.left);
        unsigned i;
        for (i = 0; i < span.length; i++) row[i]++;
    }
}

/* Whether (x + e, y + e^2) lies inside a closed outline: crossings to the right of it. */
static int outline_covers(const lmb_vertex *const *outline, int n, int x, int y)
{
    int64_t px = x * PX + PX / 2, py = y * PX + PX / 2;
    int i, inside = 0;
    for (i = 0; i < n; i++) {
        const lmb_vertex *a = outline[i], *b = outline[i + 1 == n ? 0 : i + 1];
        int64_t side;
        if ((a->y > py) == (b->y > py)) continue;
        side = side_of(a, b, px, py);
        if (b->y > a->y ? side > 0 : side < 0) inside = !inside;
    }
    return inside;
}

/* Pixels of the union painted not exactly once, or painted outside it. */
static int tally_faults(const tally *t, const lmb_vertex *const *outline, int n, uint64_t *pixels)
{
    int x, y, faults = 0;
    for (y = t->window.top; y < t->window.bottom; y++) {
        for (x = t->window.left; x < t->window.right; x++) {
            int want = outline_covers(outline, n, x, y);
            int got = t->count[(y - t->window.top) * SIDE + (x - t->window.left)];
            faults += got != want;
            *pixels += (uint64_t)want;
        }
    }
    return faults;
}

static void tally_clear(tally *t, test_random *random)
{
    memset(t->count, 0, sizeof t->count);
    t->window = random_window(random);
}

/* Corner k of n on a wavy ring, in order counter-clockwise with y up, reach in screen units. */
static void ring_place(test_random *random, lmb_vertex *v, int64_t cx, int64_t cy, int k, int n, double reach)
{
    double angle = 2 * pi * (k + test_real(random, -0.3, 0.3)) / n, r = reach * test_real(random, 0.3, 1);
    place(v, cx + (int64_t)(r * cos(angle)), cy - (int64_t)(r * sin(angle)));
}

/* Convex quadrilaterals, cut along either diagonal; every order of corners. */
static void test_quads(test_random *random)
{
    tally t;
    uint64_t pixels = 0;
    int i, k, faults = 0, n = 0;
    lmb_vertex v[4];
    const lmb_vertex *outline[4] = {&v[0], &v[1], &v[2], &v[3]};
    memset(v, 0, sizeof v);
    coverage_begin(&t.c);
    for (i = 0; i < 30000; i++) {
        double reach = exp(test_real(random, log(4), log(i % 10 ? 60 * PX : 15000 * PX)));
        int convex = 1, cut = i & 1;
        tally_clear(&t, random);
        int64_t cx = near_window(random, t.window.left, t.window.right), cy = near_window(random, t.window.top, t.window.bottom);
        for (k = 0; k < 4; k++) ring_place(random, &v[k], cx, cy, k, 4, reach);
        for (k = 0; k < 4; k++) convex &= side_of(&v[k], &v[(k + 1) % 4], v[(k + 2) % 4].x, v[(k + 2) % 4].y) < 0;
        if (!convex) continue;
        n++;
        tally_add(&t, &v[cut], &v[cut + 1], &v[cut + 2], (int)test_integer(random, 0, 2));
        tally_add(&t, &v[cut], &v[cut + 2], &v[(cut + 3) % 4], (int)test_integer(random, 0, 2));
        faults += tally_faults(&t, outline, 4, &pixels);
    }
    test_verdict(!faults, "quadrilaterals cut along either diagonal: each pixel once",
                 "%d faults, %d of them, %" PRIu64 " pixels", faults, n, pixels);
}

/* A closed fan about one corner, handed out in a random order of its triangles. */
static void test_fans(test_random *random)
{
    tally t;
    uint64_t pixels = 0;
    int i, k, faults = 0, n = 0;
    lmb_vertex v[OUTLINE_MAX], centre;
    const lmb_vertex *outline[OUTLINE_MAX];
    memset(v, 0, sizeof v);
    memset(&centre, 0, sizeof centre);
    coverage_begin(&t.c);
    for (k = 0; k < OUTLINE_MAX; k++) outline[k] = &v[k];
    for (i = 0; i < 20000; i++) {
        double reach = exp(test_real(random, log(PX), log(i % 10 ? 60 * PX : 15000 * PX)));
        int corners = (int)test_integer(random, 4, 24), start = (int)test_integer(random, 0, corners - 1), star = 1;
        tally_clear(&t, random);
        place(&centre, near_window(random, t.window.left, t.window.right), near_window(random, t.window.top, t.window.bottom));
        for (k = 0; k < corners; k++) ring_place(random, &v[k], centre.x, centre.y, k, corners, reach);
        for (k = 0; k < corners; k++) star &= side_of(&centre, &v[k], v[(k + 1) % corners].x, v[(k + 1) % corners].y) < 0;
        if (!star) continue;
        n++;
        for (k = 0; k < corners; k++) {
            int at = (start + k) % corners;
            tally_add(&t, &centre, &v[at], &v[(at + 1) % corners], (int)test_integer(random, 0, 2));
        }
        faults += tally_faults(&t, outline, corners, &pixels);
    }
    test_verdict(!faults, "closed fans: each pixel once", "%d faults, %d of them, %" PRIu64 " pixels", faults, n, pixels);
}

#define GRID 8 /* cells each way */

/* The outline of the grid: 4 GRID corners, counter-clockwise with y up: down the left side first. */
static void grid_outline(lmb_vertex v[GRID + 1][GRID + 1], const lmb_vertex *outline[4 * GRID])
{
    int k;
    for (k = 0; k < GRID; k++) {
        outline[k] = &v[k][0];
        outline[GRID + k] = &v[GRID][k];
        outline[2 * GRID + k] = &v[GRID - k][GRID];
        outline[3 * GRID + k] = &v[0][GRID - k];
    }
}

/* A grid with jittered corners, small enough a jitter that every cell stays convex. */
static void test_grids(test_random *random)
{
    tally t;
    uint64_t pixels = 0;
    int i, x, y, faults = 0, n = 0;
    lmb_vertex v[GRID + 1][GRID + 1];
    const lmb_vertex *outline[4 * GRID];
    memset(v, 0, sizeof v);
    grid_outline(v, outline);
    coverage_begin(&t.c);
    for (i = 0; i < 4000; i++) {
        double cell = test_real(random, 10, 8 * PX), turned = test_real(random, 0, 2 * pi), jitter = i % 4 ? 0.2 : 0;
        int64_t cx, cy;
        tally_clear(&t, random);
        cx = near_window(random, t.window.left, t.window.right);
        cy = near_window(random, t.window.top, t.window.bottom);
        if (i % 8 == 0) turned = 0, cell = PX / 2 * (1 + i % 7), cx &= ~7, cy &= ~7; /* edges through pixel centres */
        for (y = 0; y <= GRID; y++) {
            for (x = 0; x <= GRID; x++) {
                double dx = (x - GRID / 2 + test_real(random, -jitter, jitter)) * cell;
                double dy = (y - GRID / 2 + test_real(random, -jitter, jitter)) * cell;
                place(&v[y][x], cx + lround(dx * cos(turned) - dy * sin(turned)),
                      cy + lround(dx * sin(turned) + dy * cos(turned)));
            }
        }
        n++;
        for (y = 0; y < GRID; y++) {
            for (x = 0; x < GRID; x++) {
                const lmb_vertex *q[4] = {&v[y][x], &v[y + 1][x], &v[y + 1][x + 1], &v[y][x + 1]};
                int cut = (int)test_integer(random, 0, 1);
                tally_add(&t, q[cut], q[cut + 1], q[cut + 2], (int)test_integer(random, 0, 2));
                tally_add(&t, q[cut], q[cut + 2], q[(cut + 3) % 4], (int)test_integer(random, 0, 2));
            }
        }
        faults += tally_faults(&t, outline, 4 * GRID, &pixels);
    }
    test_verdict(!faults, "grids of jittered corners: each pixel once", "%d faults, %d of them, %" PRIu64 " pixels", faults, n,
                 pixels);
}

/* -------------------------------------------------------------------------------------------------------- looks for the terms */

static lmb_rgb random_colour(test_random *random)
{
    lmb_rgb c = {(uint8_t)test_integer(random, 0, 255), (uint8_t)test_integer(random, 0, 255),
                 (uint8_t)test_integer(random, 1, 255)};
    return c;
}

static void random_look(test_random *random, lmb_look *look, lmb_rays *rays, enum lmb_model model, enum lmb_step_kind step)
{
    lmb_material material;
    lmb_light lights[LMB_LIGHTS];
    unsigned i, n = (unsigned)test_integer(random, 1, LMB_LIGHTS);
    material.ambient = random_colour(random);
    material.diffuse = random_colour(random);
    material.specular = random_colour(random);
    material.shininess = (uint16_t)exp(test_real(random, 0, log(1000.9)));
    for (i = 0; i < n; i++) {
        lights[i].direction = random_unit(random);
        lights[i].colour = random_colour(random);
    }
    if (lmb_look_prepare(look, &material, lights, n, model, step) != 0) abort();
    lmb_rays_prepare(rays, look, NULL);
}

/* Normals within an angle of a common direction, most of them facing the viewer; depths at random. */
static void random_normals(test_random *random, lmb_vertex v[3], double spread)
{
    lmb_vec axis = random_unit(random);
    int i;
    if (test_integer(random, 0, 3)) axis.z = (int16_t)labs(axis.z);
    for (i = 0; i < 3; i++) {
        const lmb_vec off = random_unit(random);
        double r = tan(spread * test_real(random, 0, 0.999));
        v[i].normal = unit(axis.x + r * off.x, axis.y + r * off.y, axis.z + r * off.z);
        if (spread > 1.5) v[i].normal = off;
        v[i].depth = (uint16_t)test_next(random);
    }
}

/* ------------------------------------------------------------------------------------------- the same bits through any window */

typedef struct pixel_terms {
    int32_t diffuse[LMB_LIGHTS], specular[LMB_LIGHTS], depth;
    uint8_t painted, diffuse_on, specular_on, exponent[LMB_LIGHTS];
} pixel_terms;

static void term_walk(const lmb_span *span, lmb_term *term)
{
    if (span->kind == LMB_SPAN_PLANE) lmb_plane_step(term);
    if (span->kind == LMB_SPAN_ARC) lmb_arc_step(&span->arc, term);
}

static void span_terms(lmb_span span, unsigned lights, pixel_terms *out)
{
    unsigned n, i;
    for (n = 0; n < span.length; n++, out++) {
        out->painted = 1;
        out->diffuse_on = span.diffuse_on;
        out->specular_on = span.specular_on;
        out->depth = span.depth.f;
        lmb_plane_step(&span.depth);
        for (i = 0; i < lights; i++) {
            if (span.diffuse_on >> i & 1) {
                out->diffuse[i] = span.diffuse[i].f;
                term_walk(&span, &span.diffuse[i]);
            }
            if (span.specular_on >> i & 1) {
                out->exponent[i] = span.exponent[i];
                out->specular[i] = lmb_add_wrap(span.specular[i].f, span.kind == LMB_SPAN_ARC ? span.specular[i].c : 0);
                term_walk(&span, &span.specular[i]);
            }
        }
    }
}

/* The terms at every pixel of a window, SIDE to the row. */
static void window_terms(const lmb_look *look, const lmb_rays *rays, const lmb_vertex v[3], const lmb_window *w, pixel_terms *out)
{
    lmb_triangle triangle;
    lmb_span span;
    int y;
    for (y = 0; y < height_of(w); y++) memset(out + y * SIDE, 0, (size_t)width_of(w) * sizeof *out);
    if (!lmb_triangle_begin(&triangle, look, rays, &v[0], &v[1], &v[2], w)) return;
    while (lmb_triangle_next(&triangle, &span)) {
        span_terms(span, look->lights, out + (span.y - w->top) * SIDE + (span.x - w->left));
    }
}

static lmb_window part_of(test_random *random, const lmb_window *w, int kind)
{
    lmb_window part = *w;
    part.top = (int16_t)test_integer(random, w->top, w->bottom - 1);
    part.bottom = (int16_t)(kind ? test_integer(random, part.top + 1, w->bottom) : part.top + 1);
    if (kind == 1) return part;
    part.left = (int16_t)test_integer(random, w->left, w->right - 1);
    part.right = (int16_t)test_integer(random, part.left + 1, w->right);
    return part;
}

static int parts_differ(const pixel_terms *whole, const lmb_window *w, const pixel_terms *part, const lmb_window *p)
{
    int y, differ = 0;
    for (y = p->top; y < p->bottom; y++) {
        const pixel_terms *a = whole + (y - w->top) * SIDE + (p->left - w->left), *b = part + (y - p->top) * SIDE;
        differ |= memcmp(a, b, (size_t)width_of(p) * sizeof *a) != 0;
    }
    return differ;
}

static const char *const model_names[] = {"flat", "gouraud", "diffuse", "gloss"};
static const char *const step_names[] = {"linear", "quadratic", "arc"};

static void test_windows(test_random *random, enum lmb_model model, enum lmb_step_kind step)
{
    static pixel_terms whole[SIDE * SIDE], part[SIDE * SIDE];
    static const int shapes[] = {0, 0, 0, 0, 1, 2, 4, 5, 7};
    lmb_look look;
    lmb_rays rays;
    shape s;
    int i, k, faults = 0, windows = 0;
    memset(&s, 0, sizeof s);
    for (i = 0; i < 6000; i++) {
        s.window = random_window(random);
        classes[shapes[i % 9]].make(random, &s);
        if (!is_front(s.v)) swap_corners(&s, 1, 2);
        random_look(random, &look, &rays, model, step);
        random_normals(random, s.v, i % 5 ? 0.5 : 2);
        window_terms(&look, &rays, s.v, &s.window, whole);
        for (k = 0; k < 3; k++, windows++) {
            lmb_window p = part_of(random, &s.window, k);
            window_terms(&look, &rays, s.v, &p, part);
            if (parts_differ(whole, &s.window, part, &p) && !faults++) shape_print(&s);
        }
    }
    test_verdict(!faults, "terms of a pixel are the same bits through any window",
                 "%s, %s: %d faults in %d windows of %d triangles", model_names[model], step_names[step], faults, windows, i);
}

/* --------------------------------------------------------------------------------------------------------- terms by the model */

/* A quadratic over a triangle from its values at corners 0, 1, 2 and at the middles of edges 01, 12, 20. */
typedef struct quadratic {
    double corner[3], middle[3];
} quadratic;

static double quadratic_at(const quadratic *q, const double l[3])
{
    double sum = 0;
    int i, j;
    for (i = 0; i < 3; i++) {
        j = i == 2 ? 0 : i + 1;
        sum += q->corner[i] * l[i] * (2 * l[i] - 1) + 4 * q->middle[i] * l[i] * l[j];
    }
    return sum;
}

static double dot_of(lmb_vec a, lmb_vec b) { return ((double)a.x * b.x + (double)a.y * b.y + (double)a.z * b.z) / 268435456.0; }

static double distance_of(lmb_vec a, lmb_vec b)
{
    double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return (x * x + y * y + z * z) / 536870912.0;
}

/* N.L or 1 - N.H by the model: at the corners as they are, linear between or through the normalised mean normals at mid-edge. */
static quadratic model_terms(const lmb_vertex v[3], lmb_vec ray, int highlight, int curved)
{
    quadratic q;
    int i, j;
    for (i = 0; i < 3; i++) q.corner[i] = highlight ? distance_of(v[i].normal, ray) : dot_of(v[i].normal, ray);
    for (i = 0; i < 3; i++) {
        double mean, u, p;
        j = i == 2 ? 0 : i + 1;
        mean = (q.corner[i] + q.corner[j]) / 2;
        u = distance_of(v[i].normal, v[j].normal);
        p = curved ? 1 / sqrt(1 - fmin(u, LMB_ARC_U_MAX / 268435456.0) / 2) : 1;
        q.middle[i] = highlight ? 1 + p * (mean - 1) : p * mean;
    }
    return q;
}

/* Barycentric coordinates of a pixel centre. */
static void weights_at(const lmb_vertex v[3], int x, int y, double l[3])
{
    double area = (double)side_of(&v[0], &v[1], v[2].x, v[2].y);
    int i;
    for (i = 0; i < 3; i++) l[i] = (double)side_of(&v[(i + 1) % 3], &v[(i + 2) % 3], x * PX + PX / 2, y * PX + PX / 2) / area;
}

/* The extent in screen units. */
static double extent(const lmb_vertex v[3])
{
    double size = 0;
    int i;
    for (i = 1; i < 3; i++) size = larger(size, larger(fabs((double)v[i].x - v[0].x), fabs((double)v[i].y - v[0].y)));
    return size;
}

/* What plane.c says of corners up to 512 pixels apart, whatever the shape: a linear part within 2^-16 of rises up to two, a
 * quadratic one within 2^-13 of its coefficients, four times the bulges, floored to 14 bits; numerators at the anchor are
 * floored by less than four, so barycentric coordinates may be off by that over the area; and second differences are rounded.
 * Beyond, and where a triangle is so thin that plane.c leaves its curve out, a term must be no worse than it would be without
 * its curve, but for 1/256. */
#define LINEAR_ERROR ldexp(1, -15)
#define CURVED_ERROR ldexp(1, -13)

typedef struct term_errors {
    double diffuse, specular; /* worst error, s where it is above zero or said to be */
    double share, excess;     /* of the bound for triangles up to 512 pixels; beyond what leaving out the curve costs */
    double range, dark;       /* largest true value; largest where the bit says that there is none */
    uint64_t pixels;
} term_errors;

static double bulge_of(const quadratic *q)
{
    double bulge = 0;
    int i;
    for (i = 0; i < 3; i++) bulge += fabs(q->middle[i] - (q->corner[i] + q->corner[(i + 1) % 3]) / 2);
    return bulge;
}

/* Whether a triangle may be drawn without its curve: at least 1024 times longer than high. */
static int is_thin(double size, double area) { return area < size * size / 1024; }

static void errors_take(term_errors *e, const quadratic *q, double factor, double error, double size, double area)
{
    double bulge = bulge_of(q), bound = LINEAR_ERROR * (1 + 64 / area) + 4 * bulge * (CURVED_ERROR + 8 / area);
    if (bulge > 0) bound += ldexp(size / PX * (size / PX), -30); /* second differences, half a unit of 2^-30 each */
    if (size < 512 * PX && !is_thin(size, area)) e->share = larger(e->share, error / factor / bound);
    e->excess = larger(e->excess, error / factor - bulge);
}

/* The terms of light k at all pixels of a window. */
static void errors_of_light(term_errors *e, const shape *s, const lmb_look *look, const lmb_rays *rays, unsigned k,
                            const pixel_terms *p)
{
    const int curved = look->step == LMB_STEP_QUADRATIC;
    const quadratic f = model_terms(s->v, rays->light[k].direction, 0, curved),
                    v = model_terms(s->v, rays->light[k].half, 1, curved);
    const double slope = ldexp(look->lobe.slope, look->lobe.slope_shift - 15), alpha = ldexp(look->lobe.alpha_q30, -30);
    const double zero = look->lobe.floor_q15 / 32768.0; /* where the lobe ends */
    double size = extent(s->v), area = fabs((double)side_of(&s->v[0], &s->v[1], s->v[2].x, s->v[2].y)), l[3], want, got;
    const double doubt_f = is_thin(size, area) ? bulge_of(&f) : 0, doubt_v = is_thin(size, area) ? slope * bulge_of(&v) : 0;
    int x, y;
    for (y = s->window.top; y < s->window.bottom; y++, p += SIDE - width_of(&s->window)) {
        for (x = s->window.left; x < s->window.right; x++, p++) {
            if (!p->painted) continue;
            e->pixels++;
            weights_at(s->v, x, y, l);
            want = quadratic_at(&f, l);
            e->range = larger(e->range, fabs(want));
            got = p->diffuse_on >> k & 1 ? ldexp(p->diffuse[k], -30) : fmin(0, want);
            e->dark = larger(e->dark, p->diffuse_on >> k & 1 ? 0 : want - doubt_f);
            e->diffuse = larger(e->diffuse, fabs(got - want));
            errors_take(e, &f, 1, fabs(got - want), size, area);
            want = alpha - slope * quadratic_at(&v, l);
            if (!(look->specular_on >> k & 1)) continue;
            got = p->specular_on >> k & 1 ? ldexp(p->specular[k], p->exponent[k] - 30) : fmin(zero, want);
            e->dark = larger(e->dark, p->specular_on >> k & 1 ? 0 : want - zero - doubt_v);
            if (want <= zero && got <= zero) continue;
            e->specular = larger(e->specular, fabs(got - want));
            errors_take(e, &v, larger(slope, 1), fabs(got - want), size, area);
        }
    }
}

static void test_terms(test_random *random, const shape_class *class, enum lmb_step_kind step, double spread, int frame)
{
    static pixel_terms pixels[SIDE * SIDE];
    term_errors e = {0, 0, 0, 0, 0, 0, 0};
    lmb_look look;
    lmb_rays rays;
    shape s;
    int i;
    memset(&s, 0, sizeof s);
    for (i = 0; e.pixels < 400000 && i < 200000; i++) {
        unsigned k;
        s.window = random_window(random);
        if (s.window.left < 0 || s.window.top < 0 || s.window.right > frame || s.window.bottom > frame) continue;
        class->make(random, &s);
        if (!is_front(s.v)) swap_corners(&s, 1, 2);
        if (!is_front(s.v)) continue;
        random_look(random, &look, &rays, LMB_MODEL_GLOSS, step);
        random_normals(random, s.v, spread);
        window_terms(&look, &rays, s.v, &s.window, pixels);
        for (k = 0; k < look.lights; k++) errors_of_light(&e, &s, &look, &rays, k, pixels);
    }
    test_verdict(e.share <= 1 && e.excess <= 1.0 / 256 && e.range < 2 && e.dark < 1e-4, "terms against the model in doubles",
                 "%s, %s, normals within %.1f, frame of %d: N.L errs %.2g, s %.2g, %.2f of the bound, %.2g worse than without "
                 "the curve; |N.L| up to %.4f, unlit up to %.2g",
                 class->name, step_names[step], spread, frame, e.diffuse, e.specular, e.share, larger(0, e.excess), e.range,
                 e.dark);
}

int main(int argc, char **argv)
{
    static const int fat_to_slim[] = {0, 1, 4, 2, 5, 7};
    test_random random = test_seed(argc, argv);
    int i, k;
    for (i = 0; i < CLASSES; i++) test_coverage(&random, &classes[i]);
    test_quads(&random);
    test_fans(&random);
    test_grids(&random);
    for (i = 0; i < 12; i++) test_windows(&random, (enum lmb_model)(i / 3), (enum lmb_step_kind)(i % 3));
    for (i = 0; i < 6; i++) {
        for (k = 0; k < 4; k++) test_terms(&random, &classes[fat_to_slim[i]], (enum lmb_step_kind)(k & 1), k < 2 ? 0.5 : 2, 1024);
    }
    for (k = 0; k < 2; k++) test_terms(&random, &classes[0], (enum lmb_step_kind)k, 0.5, 32767);
    return test_end();
}
