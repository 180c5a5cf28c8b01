/* SPDX-License-Identifier: MIT */
/* Points in double precision, and one outline cut into triangles. Host tools only.
 *
 * Outlines come from modellers: usually convex, sometimes concave, now and then with a corner in the middle of a straight edge,
 * with a bridge to a hole, or crossing themselves. A fan from the first corner serves nearly all; ears are clipped where it does
 * not.
 */
#ifndef LMB_HOST_POLYGON_H
#define LMB_HOST_POLYGON_H

#include <math.h>
#include <stdint.h>

struct point3 {
    double x, y, z;
};

static inline struct point3 point3_minus(struct point3 a, struct point3 b)
{
    struct point3 d = {a.x - b.x, a.y - b.y, a.z - b.z};
    return d;
}
static inline struct point3 point3_plus_times(struct point3 a, struct point3 b, double factor)
{
    struct point3 s = {a.x + b.x * factor, a.y + b.y * factor, a.z + b.z * factor};
    return s;
}
static inline double point3_dot(struct point3 a, struct point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline struct point3 point3_cross(struct point3 a, struct point3 b)
{
    struct point3 c = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return c;
}
static inline double point3_largest(struct point3 a) { return fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z))); }
static inline double point3_length(struct point3 a) { return sqrt(point3_dot(a, a)); }

/* a scaled to length one; the zero vector stays what it is. Divided by its largest component first, so that squares of tiny
 * components do not vanish. */
struct point3 point3_unit(struct point3 a);

/* Twice the area of a triangle below which it is taken as flat: what the rounding of its coordinates to double can make of
 * three corners in line. magnitude: largest |coordinate|; size: longest edge. */
static inline double point3_flat_limit(double magnitude, double size) { return 16 * 2.220446049250313e-16 * magnitude * size; }

/* Corners of a concave outline that ears are clipped from; the work grows with the square of it. A fan may have any number. */
#define POLYGON_CONCAVE_MAX 1024

enum polygon_verdict {
    POLYGON_CUT,     /* all well; flat triangles may be among the result when corners coincide or lie in line */
    POLYGON_NO_AREA, /* all corners in one line */
    POLYGON_CROSSED, /* the outline crosses itself */
    POLYGON_TOO_MANY /* concave with more than POLYGON_CONCAVE_MAX corners */
};

/* Twice the area of the outline times its unit normal, about which it runs counter-clockwise (Newell's sum). */
struct point3 polygon_area2(const struct point3 *corner, uint32_t corners);

/* Cuts an outline of three corners or more into corners - 2 triangles of the same winding; triangle[i] holds corner numbers. */
enum polygon_verdict polygon_cut(const struct point3 *corner, uint32_t corners, uint32_t (*triangle)[3]);

#endif
