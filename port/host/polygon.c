/* SPDX-License-Identifier: MIT */
/* One outline cut into triangles: a fan where it serves, otherwise ears.
 *
 * The outline is looked at along the axis nearest to its normal, so that everything happens in two dimensions. A fan from
 * corner 0 is right when every triangle of it winds like the outline (the outline is star-shaped from there, convex or not).
 * Otherwise ears are clipped (Meisters 1975): a corner that bulges outwards and whose triangle holds no other corner is cut off,
 * and so on until three are left. A corner on the triangle's rim blocks it too (otherwise what is left touches itself and ends in
 * flat triangles), unless it stands where one of the triangle's own corners stands, as along a bridge to a hole. Flat ears go
 * last: they are left for the caller to refuse or to drop.
 */
#include "polygon.h"

struct flat {
    double x, y;
};

struct outline {
    struct flat at[POLYGON_CONCAVE_MAX];
    uint32_t left[POLYGON_CONCAVE_MAX]; /* corners not yet clipped, in order */
    uint32_t count;
    double limit; /* doubled areas up to this are flat */
};

struct point3 point3_unit(struct point3 a)
{
    const double largest = point3_largest(a);
    if (!(largest > 0)) return a;
    struct point3 scaled = {a.x / largest, a.y / largest, a.z / largest};
    const double length = point3_length(scaled);
    struct point3 unit = {scaled.x / length, scaled.y / length, scaled.z / length};
    return unit;
}

/* Taken about corner 0, so that an outline far from the origin loses nothing. */
struct point3 polygon_area2(const struct point3 *corner, uint32_t corners)
{
    struct point3 sum = {0, 0, 0};
    for (uint32_t i = 1; i + 1 < corners; i++) {
        const struct point3 a = point3_minus(corner[i], corner[0]), b = point3_minus(corner[i + 1], corner[0]);
        sum = point3_plus_times(sum, point3_cross(a, b), 1);
    }
    return sum;
}

/* The point seen along the axis of the normal's largest component, mirrored where needed to run counter-clockwise. */
static struct flat flatten(struct point3 p, struct point3 origin, struct point3 normal)
{
    const struct point3 d = point3_minus(p, origin);
    const double largest = point3_largest(normal);
    struct flat xy = {d.x, d.y}, yz = {d.y, d.z}, zx = {d.z, d.x};
    struct flat f = largest == fabs(normal.z) ? xy : largest == fabs(normal.x) ? yz : zx;
    const double along = largest == fabs(normal.z) ? normal.z : largest == fabs(normal.x) ? normal.x : normal.y;
    if (along < 0) f.x = -f.x;
    return f;
}

/* Twice the area of abc, positive when it runs counter-clockwise. */
static double turn(struct flat a, struct flat b, struct flat c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

static int same(struct flat a, struct flat b) { return a.x == b.x && a.y == b.y; }

static int fan_serves(const struct point3 *corner, uint32_t corners, struct point3 normal, double limit)
{
    const struct flat zero = {0, 0};
    struct flat a = flatten(corner[1], corner[0], normal);
    for (uint32_t i = 2; i < corners; i++) {
        const struct flat b = flatten(corner[i], corner[0], normal);
        if (turn(zero, a, b) <= limit) return 0;
        a = b;
    }
    return 1;
}

/* Does any other corner lie in the triangle abc or on its rim? Corners in the same place as a, b or c do not count. */
static int is_blocked(const struct outline *o, struct flat a, struct flat b, struct flat c)
{
    for (uint32_t i = 0; i < o->count; i++) {
        const struct flat p = o->at[o->left[i]];
        if (same(p, a) || same(p, b) || same(p, c)) continue;
        if (turn(a, b, p) >= -o->limit && turn(b, c, p) >= -o->limit && turn(c, a, p) >= -o->limit) return 1;
    }
    return 0;
}

static int is_ear(const struct outline *o, uint32_t i, int flat)
{
    const struct flat a = o->at[o->left[(i + o->count - 1) % o->count]], b = o->at[o->left[i]];
    const struct flat c = o->at[o->left[(i + 1) % o->count]];
    const double area2 = turn(a, b, c);
    return flat ? fabs(area2) <= o->limit : area2 > o->limit && !is_blocked(o, a, b, c);
}

/* The place in left[] of an ear, searched from place first on; count when there is none. */
static uint32_t find_ear(const struct outline *o, uint32_t first)
{
    for (int flat = 0; flat < 2; flat++) {
        for (uint32_t step = 0; step < o->count; step++) {
            const uint32_t i = (first + step) % o->count;
            if (is_ear(o, i, flat)) return i;
        }
    }
    return o->count;
}

static enum polygon_verdict clip_ears(struct outline *o, uint32_t (*triangle)[3])
{
    uint32_t done = 0, first = 0;
    while (o->count > 3) {
        const uint32_t i = find_ear(o, first);
        if (i == o->count) return POLYGON_CROSSED;
        triangle[done][0] = o->left[(i + o->count - 1) % o->count];
        triangle[done][1] = o->left[i];
        triangle[done][2] = o->left[(i + 1) % o->count];
        done++;
        o->count--;
        for (uint32_t k = i; k < o->count; k++) o->left[k] = o->left[k + 1];
        first = i + 1; /* leave out the neighbour: one ear after the other from the same side makes slivers */
    }
    for (int k = 0; k < 3; k++) triangle[done][k] = o->left[k];
    return turn(o->at[o->left[0]], o->at[o->left[1]], o->at[o->left[2]]) < -o->limit ? POLYGON_CROSSED : POLYGON_CUT;
}

enum polygon_verdict polygon_cut(const struct point3 *corner, uint32_t corners, uint32_t (*triangle)[3])
{
    const struct point3 normal = polygon_area2(corner, corners);
    double magnitude = 0, size = 0;
    for (uint32_t i = 0; i < corners; i++) {
        magnitude = fmax(magnitude, point3_largest(corner[i]));
        size = fmax(size, 2 * point3_largest(point3_minus(corner[i], corner[0])));
    }
    const double limit = point3_flat_limit(magnitude, size);
    if (corners == 3 || fan_serves(corner, corners, normal, limit)) {
        for (uint32_t i = 0; i + 2 < corners; i++) {
            triangle[i][0] = 0;
            triangle[i][1] = i + 1;
            triangle[i][2] = i + 2;
        }
        return POLYGON_CUT;
    }
    if (point3_largest(normal) <= limit) return POLYGON_NO_AREA;
    if (corners > POLYGON_CONCAVE_MAX) return POLYGON_TOO_MANY;
    struct outline o = {.count = corners, .limit = limit};
    for (uint32_t i = 0; i < corners; i++) {
        o.at[i] = flatten(corner[i], corner[0], normal);
        o.left[i] = i;
    }
    return clip_ears(&o, triangle);
}
