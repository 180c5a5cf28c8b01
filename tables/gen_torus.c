/* SPDX-License-Identifier: MIT */
/* Generates a torus about z: gen_torus MAJOR_SEGMENTS MINOR_SEGMENTS NAME [FILE]; radii 0.7 and 0.3, so outer radius 1.
 *
 * The surface is (sqrt(x^2 + y^2) - 0.7)^2 + z^2 = 0.09. One unit of space is 2^14 mesh units: the outer radius is exact, and no
 * vertex at a simple fraction of a turn lies on a rounding tie, as it would with 32767 units at 60 degrees.
 */
#include "mesh_out.h"

#include <math.h>
#include <stdlib.h>

#define MAJOR 0.7
#define MINOR 0.3
#define UNIT 16384.0
#define SEGMENTS_MAX 1024

static const double turn = 6.28318530717958647692;

/* Vertex at i of major and j of minor; both angles count from +x, outside. */
static uint16_t vertex(mesh_out *mesh, int i, int major, int j, int minor)
{
    double a = turn * (i % major) / major, b = turn * (j % minor) / minor, radius = MAJOR + MINOR * cos(b);
    lmb_vec position;
    position.x = mesh_round(UNIT * radius * cos(a));
    position.y = mesh_round(UNIT * radius * sin(a));
    position.z = mesh_round(UNIT * MINOR * sin(b));
    return mesh_vertex(mesh, position, mesh_unit(cos(b) * cos(a), cos(b) * sin(a), sin(b)));
}

int main(int argc, char **argv)
{
    mesh_out mesh;
    int i, j, major, minor;
    mesh_begin(&mesh, "gen_torus");
    if (argc < 4 || argc > 5) mesh_fail("usage: gen_torus MAJOR_SEGMENTS MINOR_SEGMENTS NAME [FILE]");
    major = mesh_argument(argv[1], 3, SEGMENTS_MAX);
    minor = mesh_argument(argv[2], 3, SEGMENTS_MAX);
    for (i = 0; i < major; i++) {
        for (j = 0; j < minor; j++) {
            uint16_t a = vertex(&mesh, i, major, j, minor), b = vertex(&mesh, i + 1, major, j, minor);
            uint16_t c = vertex(&mesh, i + 1, major, j + 1, minor), d = vertex(&mesh, i, major, j + 1, minor);
            mesh_triangle(&mesh, a, b, c);
            mesh_triangle(&mesh, a, c, d);
        }
    }
    mesh_write(&mesh, argv, 4, argc > 4 ? argv[4] : NULL, -14, "Torus about z, major radius 0.7, minor radius 0.3.");
    return EXIT_SUCCESS;
}
