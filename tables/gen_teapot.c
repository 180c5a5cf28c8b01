/* SPDX-License-Identifier: MIT */
/* Generates the Utah teapot: gen_teapot SUBDIVISIONS NAME [FILE], SUBDIVISIONS x SUBDIVISIONS quads on each of its 32 patches.
 *
 * The shape is M. Newell's of 1975 ("The Utilization of Procedure Models in Digital Image Synthesis", University of Utah), with
 * the bottom that was added later: bicubic Bezier patches whose control points all follow one of two patterns, a quarter of a
 * turned body or half of a tube, given here by a few numbers a row and completed by mirroring.
 *
 * Control points are multiples of 1/4000 and parameters are fractions, so points and partial derivatives are exact integers
 * over a common denominator. Patches that meet give the same numbers along their seam, and welding leaves no crack.
 *
 * Newell's space (x to the spout, z up) becomes (x, z, -y): y up, spout at +x, handle at -x. Open by design: between lid and
 * rim, the spout's mouth, and where spout and handle end inside the body.
 */
#include "mesh_out.h"

#include <math.h>
#include <stdlib.h>

#define SUBDIVISIONS_MIN 4
#define SUBDIVISIONS_MAX 16 /* keeps sums exact, see vertex */
#define DENOMINATOR 4000
#define FINER 3 /* rows lie at multiples of 1 / (FINER * SUBDIVISIONS), columns at multiples of 1 / SUBDIVISIONS */

/* Mesh units for one of Newell's, and the middle of the box around the pot (x -3 to 3.434, z 0 to 3.15) in mesh units. The
 * spout's tip is 3.341 of Newell's units from there, so all fits into a sphere of radius 1, which is 2^15 mesh units. */
#define UNITS 9800
#define MIDDLE_X 2127
#define MIDDLE_Z 15435

/* Rows of a quarter of a turned body, from top to bottom along the outside: radius, its control handle, height. */
static const double turned[6][4][3] = {
    {{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}, /* rim */
    {{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2.0, 1.12, 1.35}, {2.0, 1.12, 0.9}},              /* upper body */
    {{2.0, 1.12, 0.9}, {2.0, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}},              /* lower body */
    {{1.5, 0.84, 0.15}, {1.5, 0.84, 0.075}, {1.425, 0.798, 0.0}, {0.0, 0.0, 0.0}},             /* bottom */
    {{0.0, 0.0, 3.15}, {0.8, 0.45, 3.15}, {0.0, 0.0, 2.85}, {0.2, 0.112, 2.7}},                /* knob */
    {{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}},            /* lid */
};

/* Rows of half a tube, from the body outwards: two points x, z in the plane of symmetry, and the half width. Seen from +y and
 * going along the tube, the first point is to the right. */
static const double tube[4][4][5] = {
    {{-1.6, 2.025, -1.5, 2.25, 0.3}, /* upper handle */
     {-2.3, 2.025, -2.5, 2.25, 0.3},
     {-2.7, 2.025, -3.0, 2.25, 0.3},
     {-2.7, 1.8, -3.0, 1.8, 0.3}},
    {{-2.7, 1.8, -3.0, 1.8, 0.3}, /* lower handle */
     {-2.7, 1.575, -3.0, 1.35, 0.3},
     {-2.5, 1.125, -2.65, 0.9375, 0.3},
     {-2.0, 0.9, -1.9, 0.6, 0.3}},
    {{1.7, 1.425, 1.7, 0.6, 0.66}, /* spout */
     {2.6, 1.425, 3.1, 0.825, 0.66},
     {2.3, 2.1, 2.4, 2.025, 0.25},
     {2.7, 2.4, 3.3, 2.4, 0.25}},
    {{2.7, 2.4, 3.3, 2.4, 0.25}, /* its lip */
     {2.8, 2.475, 3.525, 2.49375, 0.25},
     {2.9, 2.475, 3.45, 2.5125, 0.15},
     {2.8, 2.4, 3.2, 2.4, 0.15}},
};
#define TUBE_LIP 3

typedef struct vec64 {
    int64_t x, y, z;
} vec64;

typedef struct patch {
    vec64 p[4][4]; /* rows along u, columns along v; in 1 / DENOMINATOR */
    bool mirrored; /* an odd number of times: its outside is on the other side */
    bool lip;      /* rows of uneven spacing, see row_at */
} patch;

/* ------------------------------------------------------------------------------------------------------------ control points */

static vec64 control(double x, double y, double z)
{
    vec64 p;
    p.x = llround(DENOMINATOR * x);
    p.y = llround(DENOMINATOR * y);
    p.z = llround(DENOMINATOR * z);
    return p;
}

/* Quarter k of a turned body: sign bits of k mirror x and y. */
static patch turned_patch(int part, int k)
{
    patch q;
    double sx = k & 1 ? -1.0 : 1.0, sy = k & 2 ? -1.0 : 1.0;
    int i;
    for (i = 0; i < 4; i++) {
        double radius = turned[part][i][0], handle = turned[part][i][1], z = turned[part][i][2];
        q.p[i][0] = control(sx * radius, 0.0, z);
        q.p[i][1] = control(sx * radius, sy * handle, z);
        q.p[i][2] = control(sx * handle, sy * radius, z);
        q.p[i][3] = control(0.0, sy * radius, z);
    }
    q.mirrored = sx * sy < 0.0;
    q.lip = false;
    return q;
}

/* Half k of a part of a tube: 0 is at y > 0. */
static patch tube_patch(int part, int k)
{
    patch q;
    double sy = k ? -1.0 : 1.0;
    int i;
    for (i = 0; i < 4; i++) {
        const double *row = tube[part][i];
        q.p[i][0] = control(row[0], 0.0, row[1]);
        q.p[i][1] = control(row[0], sy * row[4], row[1]);
        q.p[i][2] = control(row[2], sy * row[4], row[3]);
        q.p[i][3] = control(row[2], 0.0, row[3]);
    }
    q.mirrored = k != 0;
    q.lip = part == TUBE_LIP;
    return q;
}

/* ------------------------------------------------------------------------------------------------------ points and normals */

/* Bernstein's weights at k / n, times n^3. */
static void weights(int64_t w[4], int64_t k, int64_t n)
{
    int64_t m = n - k;
    w[0] = m * m * m;
    w[1] = 3 * k * m * m;
    w[2] = 3 * k * k * m;
    w[3] = k * k * k;
}

/* Weights of a third of the derivative at k / n, times n^2. */
static void slope_weights(int64_t w[4], int64_t k, int64_t n)
{
    int64_t m = n - k;
    w[0] = -m * m;
    w[1] = m * m - 2 * k * m;
    w[2] = 2 * k * m - k * k;
    w[3] = k * k;
}

static vec64 blend(const patch *q, const int64_t u[4], const int64_t v[4])
{
    vec64 sum = {0, 0, 0};
    int i, j;
    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++) {
            sum.x += u[i] * v[j] * q->p[i][j].x;
            sum.y += u[i] * v[j] * q->p[i][j].y;
            sum.z += u[i] * v[j] * q->p[i][j].z;
        }
    }
    return sum;
}

/* Row i of n as a multiple of 1 / (FINER n): evenly, but for the lip of the spout. Its outline turns by half a circle between
 * u = 0.3 and 0.8, and few even rows would cut corners until triangles turn their backs to their normals. Its rows follow
 * t (87 - 127 t + 90 t^2) / 50, which runs from 0 through 0.46 to 1, found by search as the best of its kind for 4 to 12
 * subdivisions. It is slowest near the middle, 0.547 > 1 / FINER: no two rows fall together. */
static int64_t row_at(const patch *q, int64_t i, int64_t n)
{
    if (!q->lip) return FINER * i;
    return (2 * FINER * i * (87 * n * n - 127 * i * n + 90 * i * i) + 50 * n * n) / (100 * n * n);
}

/* The unit vector along a x b, from Newell's axes to ours. */
static lmb_vec cross_unit(vec64 a, vec64 b)
{
    double ax = (double)a.x, ay = (double)a.y, az = (double)a.z, bx = (double)b.x, by = (double)b.y, bz = (double)b.z;
    return mesh_unit(ay * bz - az * by, ax * by - ay * bx, ax * bz - az * bx);
}

/* The outward normal at row / (FINER n), column / n. Where a row of control points is one point, at the poles of knob and bottom,
 * dP/dv vanishes; its direction near by is that of +-d2P/dudv: + after the first row, - before the last. */
static lmb_vec outward(const patch *q, int64_t row, int64_t column, int64_t n)
{
    int64_t u[4], v[4], du[4], dv[4];
    vec64 along, across;
    bool flip = q->mirrored;
    weights(u, row, FINER * n);
    weights(v, column, n);
    slope_weights(du, row, FINER * n);
    slope_weights(dv, column, n);
    along = blend(q, du, v);
    across = blend(q, u, dv);
    if (!across.x && !across.y && !across.z) {
        across = blend(q, du, dv);
        if (row > 0) flip = !flip;
    }
    return flip ? cross_unit(across, along) : cross_unit(along, across);
}

/* numerator / denominator to the nearest integer, halves away from zero: mirrored points stay mirrored. */
static int64_t divide_round(int64_t numerator, int64_t denominator)
{
    int64_t magnitude = (2 * (numerator < 0 ? -numerator : numerator) + denominator) / (2 * denominator);
    return numerator < 0 ? -magnitude : magnitude;
}

/* Vertex (i, j) of (n + 1) x (n + 1). Bounds for n = 16: what blend sums stays below 4 * DENOMINATOR * (FINER n^2)^3 < 2^43, so
 * double holds it exactly; times 2 * UNITS < 2^58. */
static uint16_t vertex(mesh_out *mesh, const patch *q, int i, int j, int n)
{
    int64_t u[4], v[4], row = row_at(q, i, n), cube = (int64_t)n * n * n;
    int64_t denominator = DENOMINATOR * FINER * FINER * FINER * cube * cube;
    vec64 point;
    lmb_vec position;
    weights(u, row, FINER * n);
    weights(v, j, n);
    point = blend(q, u, v);
    position.x = mesh_round((double)(divide_round(UNITS * point.x, denominator) - MIDDLE_X));
    position.y = mesh_round((double)(divide_round(UNITS * point.z, denominator) - MIDDLE_Z));
    position.z = mesh_round((double)-divide_round(UNITS * point.y, denominator));
    return mesh_vertex(mesh, position, outward(q, row, j, n));
}

/* ------------------------------------------------------------------------------------------------------------ tessellation */

static int64_t distance_squared(lmb_vec a, lmb_vec b)
{
    int64_t x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z;
}

/* Cuts a quad along the shorter diagonal, which bends less. */
static void quad(mesh_out *mesh, uint16_t a, uint16_t b, uint16_t c, uint16_t d)
{
    const lmb_vec *p = mesh->positions;
    if (distance_squared(p[a], p[c]) <= distance_squared(p[b], p[d])) {
        mesh_triangle(mesh, a, b, c);
        mesh_triangle(mesh, a, c, d);
    } else {
        mesh_triangle(mesh, a, b, d);
        mesh_triangle(mesh, b, c, d);
    }
}

static void tessellate(mesh_out *mesh, const patch *q, int n)
{
    int i, j;
    for (i = 0; i < n; i++) {
        for (j = 0; j < n; j++) {
            uint16_t a = vertex(mesh, q, i, j, n), b = vertex(mesh, q, i + 1, j, n);
            uint16_t c = vertex(mesh, q, i + 1, j + 1, n), d = vertex(mesh, q, i, j + 1, n);
            if (q->mirrored) {
                quad(mesh, a, d, c, b);
            } else {
                quad(mesh, a, b, c, d);
            }
        }
    }
}

int main(int argc, char **argv)
{
    mesh_out mesh;
    int part, k, n;
    mesh_begin(&mesh, "gen_teapot");
    if (argc < 3 || argc > 4) mesh_fail("usage: gen_teapot SUBDIVISIONS NAME [FILE]");
    n = mesh_argument(argv[1], SUBDIVISIONS_MIN, SUBDIVISIONS_MAX);
    for (part = 0; part < 6; part++) {
        for (k = 0; k < 4; k++) {
            patch q = turned_patch(part, k);
            tessellate(&mesh, &q, n);
        }
    }
    for (part = 0; part < 4; part++) {
        for (k = 0; k < 2; k++) {
            patch q = tube_patch(part, k);
            tessellate(&mesh, &q, n);
        }
    }
    mesh_write(&mesh, argv, 3, argc > 3 ? argv[3] : NULL, -15,
               "Utah teapot after M. Newell, 1975; y up, spout at +x; fits the unit sphere about the middle of its box.");
    return EXIT_SUCCESS;
}
