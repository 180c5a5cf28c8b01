/* SPDX-License-Identifier: MIT */
/* Places names: each in turn takes the best of its places beside all others, until none moves. The same places on every run. */
#include "panel_names.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DIRECTIONS = 24, RINGS = 9, ROUNDS = 40 };

static const double tau = 6.28318530717958647693;
static const double ring[RINGS] = {7, 9, 14, 20, 28, 38, 50, 66, 86};

#define CHARACTER 6.5 /* pixels, on the safe side of DejaVu Sans at 9 points */
#define LINE 11.0
#define POINT 4.0 /* from the middle of a point that is to be kept clear */

typedef struct box {
    double left, top, right, bottom;
} box;

static box box_at(const panel_name *n, double x, double y)
{
    const double half = (CHARACTER * (double)strlen(n->text) + 3) / 2;
    box b;
    b.left = x - half;
    b.right = x + half;
    b.top = y - LINE / 2;
    b.bottom = y + LINE / 2;
    return b;
}

static double overlap(box a, box b)
{
    const double x = fmin(a.right, b.right) - fmax(a.left, b.left), y = fmin(a.bottom, b.bottom) - fmax(a.top, b.top);
    return x > 0 && y > 0 ? x * y : 0;
}

static box point_box(const panel_name *n)
{
    const double half = n->is_small ? 1.5 : POINT;
    box b;
    b.left = n->x - half;
    b.right = n->x + half;
    b.top = n->y - half;
    b.bottom = n->y + half;
    return b;
}

/* How much of a line lies in a box, of 24 pieces. */
static double crossing(double x0, double y0, double x1, double y1, box b)
{
    int i, in = 0;
    for (i = 1; i < 24; i++) {
        const double x = x0 + (x1 - x0) * i / 24, y = y0 + (y1 - y0) * i / 24;
        in += x > b.left && x < b.right && y > b.top && y < b.bottom;
    }
    return in;
}

static double side(double ax, double ay, double bx, double by, double px, double py)
{
    return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
}

static bool lines_cross(const panel_name *a, double ax, double ay, const panel_name *b)
{
    return side(a->x, a->y, ax, ay, b->x, b->y) * side(a->x, a->y, ax, ay, b->leader_x, b->leader_y) < 0 &&
           side(b->x, b->y, b->leader_x, b->leader_y, a->x, a->y) * side(b->x, b->y, b->leader_x, b->leader_y, ax, ay) < 0;
}

/* Where a line from the point meets the name's box. */
static void leader_end(const panel_name *n, box b, double *x, double *y)
{
    *x = fmin(fmax(n->x, b.left), b.right);
    *y = fmin(fmax(n->y, b.top), b.bottom);
}

static double cost_of(const panel_name *name, unsigned count, unsigned at, double x, double y, double distance, double width,
                      double height)
{
    const panel_name *n = &name[at];
    const box b = box_at(n, x, y);
    const bool leads = distance > 12;
    double cost = distance + (y > n->y + 4 ? 1 : 0) + (x < n->x ? 1.5 : 0) + (leads ? 12 : 0), ex, ey;
    unsigned i;
    if (b.left < 2 || b.top < 2 || b.right > width - 2 || b.bottom > height - 2) return 1e9;
    leader_end(n, b, &ex, &ey);
    for (i = 0; i < count; i++) {
        const panel_name *o = &name[i];
        const bool is_itself = i == at;
        cost += overlap(b, point_box(o)) * (o->is_small ? 3 : 12);
        if (leads && !is_itself) cost += crossing(n->x, n->y, ex, ey, point_box(o)) * (o->is_small ? 1 : 6);
        if (is_itself || !o->text || o->label_x < 0) continue;
        {
            const box other = box_at(o, o->label_x, o->label_y);
            cost += overlap(b, other) * 40;
            if (leads) cost += crossing(n->x, n->y, ex, ey, other) * 25;
            if (o->has_leader) cost += crossing(o->x, o->y, o->leader_x, o->leader_y, b) * 25;
            if (leads && o->has_leader && lines_cross(n, ex, ey, o)) cost += 60;
        }
    }
    return cost;
}

/* The best place of one name; whether it moved. */
static bool place(panel_name *name, unsigned count, unsigned at, double width, double height)
{
    panel_name *n = &name[at];
    const double half = (CHARACTER * (double)strlen(n->text) + 3) / 2, was_x = n->label_x, was_y = n->label_y;
    double best = 1e300;
    int d, r;
    for (r = 0; r < RINGS; r++) {
        for (d = 0; d < DIRECTIONS; d++) {
            const double c = cos(tau * d / DIRECTIONS), s = sin(tau * d / DIRECTIONS);
            const double x = n->x + c * (ring[r] + half), y = n->y - s * (ring[r] + LINE / 2);
            const double cost = cost_of(name, count, at, x, y, ring[r], width, height);
            if (cost >= best - 1e-6) continue;
            best = cost;
            n->label_x = x;
            n->label_y = y;
            n->has_leader = ring[r] > 12;
        }
    }
    leader_end(n, box_at(n, n->label_x, n->label_y), &n->leader_x, &n->leader_y);
    return fabs(n->label_x - was_x) + fabs(n->label_y - was_y) > 1e-6;
}

void panel_names_place(panel_name *name, unsigned count, double width, double height)
{
    unsigned i, round;
    bool moved = true;
    for (i = 0; i < count; i++) {
        name[i].label_x = name[i].label_y = -1;
        name[i].has_leader = false;
        name[i].leader_x = name[i].x;
        name[i].leader_y = name[i].y;
    }
    for (round = 0; round < ROUNDS && moved; round++) {
        moved = false;
        for (i = 0; i < count; i++)
            if (name[i].text) moved = place(name, count, i, width, height) || moved;
    }
}
