/* SPDX-License-Identifier: MIT */
/* Generates a unit sphere from an icosahedron: gen_icosphere SUBDIVISIONS NAME [FILE], 20 * 4^SUBDIVISIONS triangles.
 *
 * Each subdivision cuts every triangle into four at the middles of its edges, pushed out onto the sphere. The radius is 2^14 mesh
 * units, one unit of space exactly: positions then are their normals in Q2.14, bit for bit, and one array serves as both. (A
 * radius of 32767 would also put vertices on rounding ties, at half the radius.)
 */
#include "mesh_out.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SUBDIVISIONS_MAX 6 /* 40962 vertices */

typedef struct point {
    double p[3];
} point;

/* Both neighbours of an edge must get the same bits: a sum does not mind the order of its two terms. */
static point middle(const point *a, const point *b)
{
    point m;
    double length;
    int i;
    for (i = 0; i < 3; i++) m.p[i] = a->p[i] + b->p[i];
    length = sqrt(m.p[0] * m.p[0] + m.p[1] * m.p[1] + m.p[2] * m.p[2]);
    for (i = 0; i < 3; i++) m.p[i] /= length;
    return m;
}

/* Four triangles for each of count, in place of them; a triangle is three points. */
static point *subdivide(point *from, size_t count)
{
    point *to = malloc(count * 12 * sizeof *to), *out = to, *t = from;
    if (!to) mesh_fail("out of memory");
    for (; count > 0; count--, t += 3, out += 12) {
        point ab = middle(&t[0], &t[1]), bc = middle(&t[1], &t[2]), ca = middle(&t[2], &t[0]);
        point four[12];
        four[0] = t[0], four[1] = ab, four[2] = ca;
        four[3] = ab, four[4] = t[1], four[5] = bc;
        four[6] = ca, four[7] = bc, four[8] = t[2];
        four[9] = ab, four[10] = bc, four[11] = ca;
        memcpy(out, four, sizeof four);
    }
    free(from);
    return to;
}

/* Twelve corners, (0, +-1, +-g) and its cyclic shifts, g the golden ratio: neighbours are 2 apart, all others 2 g or more. */
static void corners(point corner[12])
{
    double g = (1.0 + sqrt(5.0)) / 2.0, length = sqrt(1.0 + g * g);
    int i;
    for (i = 0; i < 12; i++) {
        int axis = i / 4;
        corner[i].p[axis] = 0.0;
        corner[i].p[(axis + 1) % 3] = (i & 1 ? -1.0 : 1.0) / length;
        corner[i].p[(axis + 2) % 3] = (i & 2 ? -g : g) / length;
    }
}

static bool neighbours(const point *a, const point *b)
{
    double x = a->p[0] - b->p[0], y = a->p[1] - b->p[1], z = a->p[2] - b->p[2];
    return x * x + y * y + z * z < 1.5; /* 4 / (1 + g^2) = 1.11 against 2.89 */
}

/* Above zero if the origin sees a, b, c clockwise, so that they run counter-clockwise from outside. */
static double orientation(const point *a, const point *b, const point *c)
{
    return a->p[0] * (b->p[1] * c->p[2] - b->p[2] * c->p[1]) + a->p[1] * (b->p[2] * c->p[0] - b->p[0] * c->p[2]) +
           a->p[2] * (b->p[0] * c->p[1] - b->p[1] * c->p[0]);
}

/* The twenty faces: every three corners that are neighbours of each other. */
static point *icosahedron(void)
{
    point corner[12], *faces = malloc(60 * sizeof *faces), *out = faces;
    int a, b, c;
    if (!faces) mesh_fail("out of memory");
    corners(corner);
    for (a = 0; a < 12; a++) {
        for (b = a + 1; b < 12; b++) {
            for (c = b + 1; c < 12; c++) {
                const point *p = &corner[a], *q = &corner[b], *r = &corner[c];
                bool outwards = orientation(p, q, r) > 0.0;
                if (!neighbours(p, q) || !neighbours(q, r) || !neighbours(r, p)) continue;
                *out++ = *p;
                *out++ = outwards ? *q : *r;
                *out++ = outwards ? *r : *q;
            }
        }
    }
    return faces;
}

int main(int argc, char **argv)
{
    mesh_out mesh;
    point *triangle;
    size_t count = 20, i;
    int level, levels;
    mesh_begin(&mesh, "gen_icosphere");
    if (argc < 3 || argc > 4) mesh_fail("usage: gen_icosphere SUBDIVISIONS NAME [FILE]");
    levels = mesh_argument(argv[1], 0, SUBDIVISIONS_MAX);
    triangle = icosahedron();
    for (level = 0; level < levels; level++, count *= 4) triangle = subdivide(triangle, count);
    for (i = 0; i < count; i++) {
        uint16_t corner[3];
        int k;
        for (k = 0; k < 3; k++) {
            const double *p = triangle[3 * i + (size_t)k].p;
            lmb_vec unit = mesh_unit(p[0], p[1], p[2]);
            corner[k] = mesh_vertex(&mesh, unit, unit);
        }
        mesh_triangle(&mesh, corner[0], corner[1], corner[2]);
    }
    free(triangle);
    mesh_write(&mesh, argv, 3, argc > 3 ? argv[3] : NULL, -14, "Unit sphere, an icosahedron subdivided.");
    return EXIT_SUCCESS;
}
