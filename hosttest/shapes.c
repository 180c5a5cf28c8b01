/* SPDX-License-Identifier: MIT */
/* Random triangles in random windows, by classes that rasters fail at. */
#include "shapes.h"

static const double pi = 3.14159265358979323846;

lmb_vec unit(double x, double y, double z)
{
    double r = 16384 / sqrt(x * x + y * y + z * z);
    lmb_vec v = {(int16_t)lround(x * r), (int16_t)lround(y * r), (int16_t)lround(z * r)};
    return v;
}

lmb_vec random_unit(test_random *random)
{
    double z = test_real(random, -1, 1), angle = test_real(random, 0, 2 * pi), r = sqrt(1 - z * z);
    return unit(r * cos(angle), r * sin(angle), z);
}

/* --------------------------------------------------------------------------------------------------------- windows and shapes */

lmb_window random_window(test_random *random)
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

int32_t near_window(test_random *random, int low, int high)
{
    int32_t margin = (high - low) * PX / 2;
    return held(test_integer(random, low * PX - margin, high * PX + margin));
}

void place(lmb_vertex *v, int64_t x, int64_t y)
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

const shape_class shape_classes[SHAPE_CLASSES] = {{"ordinary", shape_ordinary, 250000},
                                                  {"tiny", shape_tiny, 250000},
                                                  {"slivers", shape_sliver, 200000},
                                                  {"degenerate", shape_degenerate, 50000},
                                                  {"aligned", shape_aligned, 200000},
                                                  {"far corners", shape_far, 50000},
                                                  {"corners beyond the limit", shape_beyond, 20000},
                                                  {"around the window", shape_huge, 20000}};

int64_t side_of(const lmb_vertex *a, const lmb_vertex *b, int64_t px, int64_t py)
{
    return (int64_t)(b->x - a->x) * (py - a->y) - (int64_t)(b->y - a->y) * (px - a->x);
}

int is_front(const lmb_vertex v[3]) { return side_of(&v[0], &v[1], v[2].x, v[2].y) < 0; }

void shape_print(const shape *s)
{
    int i;
    for (i = 0; i < 3; i++) printf("  (%" PRId32 ", %" PRId32 ")", s->v[i].x, s->v[i].y);
    printf("  window %d %d %d %d\n", s->window.left, s->window.top, s->window.right, s->window.bottom);
}

void swap_corners(shape *s, int i, int j)
{
    lmb_vertex swap = s->v[i];
    s->v[i] = s->v[j];
    s->v[j] = swap;
}
