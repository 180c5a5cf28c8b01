/* SPDX-License-Identifier: MIT */
/* Triangles into spans: which pixels, and in what order, against exact integers.
 *
 * Coverage is taken from the definition, edge functions in 64 bits over every pixel of the window; unions are taken from a
 * crossing count over their outline at the pixel's centre moved by (e, e^2), e infinitely small, which is what the top-left rule
 * comes to. Neither shares anything with the edge walk. */
#include <string.h>

#include "shapes.h"

static const double pi = 3.14159265358979323846;

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

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    int i;
    for (i = 0; i < SHAPE_CLASSES; i++) test_coverage(&random, &shape_classes[i]);
    test_quads(&random);
    test_fans(&random);
    test_grids(&random);
    return test_end();
}
