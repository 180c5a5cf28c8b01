/* SPDX-License-Identifier: MIT */
/* Models to fit costs on and to judge them by, as Wavefront OBJ files: shapes of many kinds of triangles.
 * usage: estimate_models NAME OUT.obj */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TAU 6.283185307179586

typedef struct spot {
    double x, y, z;
} spot;

static FILE *out;
static int vertices;

static int put(spot p)
{
    fprintf(out, "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
    return ++vertices;
}

static spot at(double x, double y, double z)
{
    spot p = {x, y, z};
    return p;
}

/* A grid of n x m quads over a surface of u and v from 0 to 1; closed: its last column is its first. */
static void grid(int n, int m, int closed_u, int closed_v, spot (*of)(double u, double v))
{
    const int columns = closed_u ? n : n + 1, rows = closed_v ? m : m + 1, first = vertices + 1;
    int i, j;
    for (i = 0; i < columns; i++)
        for (j = 0; j < rows; j++) put(of((double)i / n, (double)j / m));
    for (i = 0; i < n; i++) {
        for (j = 0; j < m; j++) {
            const int a = i * rows, b = (i + 1) % columns * rows, k = (j + 1) % rows;
            fprintf(out, "f %d %d %d\nf %d %d %d\n", first + a + j, first + b + j, first + b + k, first + a + j, first + b + k,
                    first + a + k);
        }
    }
}

/* A box with flat sides: normals of their own. */
static void box(spot low, spot high)
{
    static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    static const char *const normal[6] = {"0 0 -1", "0 0 1", "0 -1 0", "0 1 0", "-1 0 0", "1 0 0"};
    static int normals;
    const int first = vertices + 1;
    int i, k;
    for (i = 0; i < 8; i++) put(at(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z));
    for (i = 0; i < 6; i++) {
        fprintf(out, "vn %s\nf", normal[i]);
        normals++;
        for (k = 0; k < 4; k++) fprintf(out, " %d//%d", first + side[i][k], normals);
        fprintf(out, "\n");
    }
}

/* ------------------------------------------------------------------------------------------------------------------ surfaces */

static spot on_globe(double u, double v)
{
    const double a = TAU * u, b = TAU / 2 * (v * 0.98 + 0.01);
    return at(sin(b) * cos(a), -cos(b), -sin(b) * sin(a));
}
static spot on_ring(double u, double v)
{
    const double r = 0.8 + 0.2 * cos(TAU * v);
    return at(r * cos(TAU * u), r * sin(TAU * u), 0.2 * sin(TAU * v));
}
static spot on_waves(double u, double v)
{
    return at(2 * u - 1, 2 * v - 1, 0.15 * sin(9 * u + 1) * cos(7 * v) + 0.05 * sin(23 * u * v));
}
static spot on_coil(double u, double v)
{
    const double a = TAU * 4 * u, r = 0.7 + 0.1 * cos(TAU * v);
    return at(r * cos(a), 1.6 * u - 0.8 + 0.1 * sin(TAU * v), -r * sin(a));
}
static spot on_cups(double u, double v)
{
    const double r = 0.25 + 0.6 * v + 0.1 * sin(12 * v), a = TAU * u;
    return at(r * cos(a), 0.9 - 1.4 * v * v + 0.2 * sin(9 * v), -r * sin(a));
}
static spot on_hills(double u, double v)
{
    const double x = 2 * u - 1, y = 2 * v - 1;
    return at(x, y, 0.3 * exp(-6 * (x * x + y * y)) + 0.12 * cos(13 * x) * sin(11 * y + 2 * x));
}
static spot on_rod(double u, double v) { return at(0.12 * cos(TAU * u), 2 * v - 1, -0.12 * sin(TAU * u)); }
static spot on_reed(double u, double v)
{
    const double r = 0.05 + 0.03 * sin(5 * v);
    return at(r * cos(TAU * u) + 0.2 * v * v, 2 * v - 1, -r * sin(TAU * u));
}
static spot on_vase(double u, double v)
{
    const double r = 0.35 + 0.2 * sin(5.5 * v + 0.6) * (1.1 - 0.4 * v), b = 2 * v - 1;
    return at(r * cos(TAU * u), b, -r * sin(TAU * u));
}
static spot on_crystal(double u, double v)
{
    spot p = on_globe(u, v);
    const double r = 0.75 + 0.25 * sin(40 * u + 3 * v) * cos(33 * v - 5 * u);
    return at(p.x * r, p.y * r, p.z * r);
}
static spot on_knot(double u, double v)
{
    const double a = TAU * u, r = 0.6 + 0.25 * cos(3 * a), s = 0.13;
    const spot c = at(r * cos(2 * a), r * sin(2 * a), 0.25 * sin(3 * a));
    return at(c.x + s * cos(TAU * v) * cos(2 * a), c.y + s * cos(TAU * v) * sin(2 * a), c.z + s * sin(TAU * v));
}
static spot on_cone(double u, double v)
{
    const double r = 0.02 + 0.7 * v;
    return at(r * cos(TAU * u), 0.9 - 1.6 * v, -r * sin(TAU * u));
}
static spot on_shell(double u, double v)
{
    const double a = TAU * 2.5 * u, r = 0.1 + 0.65 * u, s = 0.05 + 0.3 * u;
    return at(r * cos(a) + s * cos(TAU * v) * cos(a), r * sin(a) + s * cos(TAU * v) * sin(a), s * sin(TAU * v) - 0.3 * u);
}

static void blocks(int n)
{
    int i, j;
    for (i = 0; i < n; i++) {
        for (j = 0; j < n; j++) {
            const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1, h = 0.2 + 0.15 * ((i * 7 + j * 5) % 6);
            box(at(x, y, -h), at(x + 1.6 / n, y + 1.4 / n, h));
        }
    }
}

static void slats(int n)
{
    int i;
    for (i = 0; i < n; i++) box(at(-1, 2.0 * i / n - 1, -0.02), at(1, 2.0 * i / n - 1 + 0.7 / n, 0.3 * (i % 3)));
}

/* Bars that cross, as long as the display and a few pixels wide. */
static void fence(int n)
{
    int i;
    for (i = 0; i < n; i++) {
        const double middle = 2.0 * i / n - 0.95;
        box(at(-1, middle, -0.1), at(1, middle + 0.15 / n, -0.05));
        box(at(middle, -1, 0.05), at(middle + 0.4 / n, 1, 0.1));
    }
}

static const struct model {
    const char *name;
    int n, m, closed_u, closed_v;
    spot (*of)(double u, double v);
    void (*make)(int n);
} models[] = {
    {"globe", 40, 20, 1, 0, on_globe, NULL},     {"bead", 12, 8, 1, 0, on_globe, NULL},
    {"gem", 6, 4, 1, 0, on_globe, NULL},         {"ring", 36, 14, 1, 1, on_ring, NULL},
    {"hoop", 90, 20, 1, 1, on_ring, NULL},       {"waves", 24, 24, 0, 0, on_waves, NULL},
    {"hills", 40, 40, 0, 0, on_hills, NULL},     {"rod", 24, 1, 1, 0, on_rod, NULL},
    {"reed", 10, 6, 1, 0, on_reed, NULL},        {"vase", 32, 24, 1, 0, on_vase, NULL},
    {"crystal", 18, 12, 1, 0, on_crystal, NULL}, {"burr", 40, 26, 1, 0, on_crystal, NULL},
    {"knot", 96, 12, 1, 1, on_knot, NULL},       {"cone", 28, 3, 1, 0, on_cone, NULL},
    {"shell", 70, 14, 0, 1, on_shell, NULL},     {"box", 1, 0, 0, 0, NULL, blocks},
    {"blocks", 4, 0, 0, 0, NULL, blocks},        {"town", 9, 0, 0, 0, NULL, blocks},
    {"slats", 12, 0, 0, 0, NULL, slats},         {"sheet", 2, 2, 0, 0, on_waves, NULL},
    {"coil", 100, 10, 0, 1, on_coil, NULL},      {"cups", 36, 20, 1, 0, on_cups, NULL},
    {"fence", 7, 0, 0, 0, NULL, fence},          {"brick", 1, 0, 0, 0, NULL, slats},
    {"crate", 2, 0, 0, 0, NULL, blocks},
};
#define MODELS (sizeof models / sizeof models[0])

int main(int argc, char **argv)
{
    unsigned i;
    for (i = 0; argc == 3 && i < MODELS && strcmp(argv[1], models[i].name); i++) {}
    if (argc != 3 || i == MODELS) {
        fprintf(stderr, "usage: estimate_models NAME OUT.obj; names:");
        for (i = 0; i < MODELS; i++) fprintf(stderr, " %s", models[i].name);
        fprintf(stderr, "\n");
        return 2;
    }
    out = fopen(argv[2], "w");
    if (!out) {
        fprintf(stderr, "estimate_models: cannot write %s\n", argv[2]);
        return EXIT_FAILURE;
    }
    if (models[i].make) {
        models[i].make(models[i].n);
    } else {
        grid(models[i].n, models[i].m, models[i].closed_u, models[i].closed_v, models[i].of);
    }
    return fclose(out) ? EXIT_FAILURE : EXIT_SUCCESS;
}
