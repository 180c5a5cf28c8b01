/* SPDX-License-Identifier: MIT */
/* The generated meshes: counts, seams, orientation, normals and surfaces, from the arrays alone.
 *
 * Links mesh_icosphere_320 (gen_icosphere 2), mesh_icosphere_1280 (3), mesh_torus (gen_torus 48 24), mesh_teapot (gen_teapot 6).
 */
#include "../firmware/lambent.h"
#include "test.h"

#include <string.h>

extern const lmb_mesh mesh_icosphere_320, mesh_icosphere_1280, mesh_torus, mesh_teapot;

typedef struct shape {
    const char *name;
    const lmb_mesh *mesh;
    uint32_t vertices, triangles, components;
    int32_t euler;           /* vertices - edges + triangles */
    uint32_t boundary_edges; /* edges of one triangle */
    uint32_t fingerprint;    /* FNV-1a of all numbers: the same bytes on every machine */
} shape;

/* n subdivisions of the teapot give 64 n^2 - 8 n triangles. Its components are body, lid, handle and spout. Open by design: lid
 * and rim, a whole turn each (2 * 4 n edges); the mouth of the spout and the three ends inside the body, twice half a tube each
 * (4 * 2 n edges). A component with two holes has Euler characteristic 0, with one hole 1: together 2. */
static const shape shapes[] = {
    {"icosphere_320", &mesh_icosphere_320, 162, 320, 1, 2, 0, 0x96f95a69},
    {"icosphere_1280", &mesh_icosphere_1280, 642, 1280, 1, 2, 0, 0xae2af08a},
    {"torus", &mesh_torus, 48 * 24, 2 * 48 * 24, 1, 0, 0, 0xb57f6421},
    {"teapot", &mesh_teapot, 1178, 2256, 4, 2, 96, 0x8bf48895},
};
#define SHAPES (sizeof shapes / sizeof shapes[0])

typedef struct vec3 {
    double x, y, z;
} vec3;

static vec3 real(lmb_vec v)
{
    vec3 r = {v.x, v.y, v.z};
    return r;
}
static vec3 minus(vec3 a, vec3 b)
{
    vec3 r = {a.x - b.x, a.y - b.y, a.z - b.z};
    return r;
}
static double dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec3 cross(vec3 a, vec3 b)
{
    vec3 r = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return r;
}
static vec3 unit(vec3 a)
{
    double length = sqrt(dot(a, a));
    vec3 r = {a.x / length, a.y / length, a.z / length};
    return r;
}

static vec3 corner(const lmb_mesh *m, uint32_t triangle, uint32_t k) { return real(m->positions[m->indices[3 * triangle + k]]); }

/* Twice the area, outwards. */
static vec3 facet(const lmb_mesh *m, uint32_t triangle)
{
    vec3 a = corner(m, triangle, 0);
    return cross(minus(corner(m, triangle, 1), a), minus(corner(m, triangle, 2), a));
}

/* ----------------------------------------------------------------------------------------------------- edges and components */

static int compare(const void *a, const void *b)
{
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return x < y ? -1 : x > y;
}

/* All directed edges, from in the upper and to in the lower 16 bits, sorted; the caller frees them. */
static uint32_t *edges_of(const lmb_mesh *m)
{
    uint32_t *edges = malloc(3 * m->triangles * sizeof *edges), t, k;
    for (t = 0; t < m->triangles; t++) {
        const uint16_t *v = &m->indices[3 * t];
        for (k = 0; k < 3; k++) edges[3 * t + k] = (uint32_t)v[k] << 16 | v[(k + 1) % 3];
    }
    qsort(edges, 3 * m->triangles, sizeof *edges, compare);
    return edges;
}

static uint16_t root(const uint16_t *parent, uint16_t v)
{
    while (parent[v] != v) v = parent[v];
    return v;
}

/* Sets of vertices that edges connect, among those vertices that have an edge. */
static uint32_t components(const uint32_t *edges, uint32_t count)
{
    static uint16_t parent[65536];
    static unsigned char used[65536];
    uint32_t i, sets = 0;
    for (i = 0; i < 65536; i++) parent[i] = (uint16_t)i;
    memset(used, 0, sizeof used);
    for (i = 0; i < count; i++) {
        uint16_t a = (uint16_t)(edges[i] >> 16), b = (uint16_t)edges[i];
        used[a] = used[b] = 1;
        parent[root(parent, a)] = root(parent, b);
    }
    for (i = 0; i < 65536; i++) sets += used[i] && parent[i] == i;
    return sets;
}

/* Every edge once in each direction, but for the boundary; one surface for each component, with the holes that it should have. */
static void test_seams(const shape *s)
{
    uint32_t count = 3 * s->mesh->triangles, i, doubled = 0, open = 0, parts, loops;
    uint32_t *edges = edges_of(s->mesh), *boundary = malloc(count * sizeof *boundary);
    int32_t euler;
    int good;
    for (i = 1; i < count; i++) doubled += edges[i] == edges[i - 1];
    for (i = 0; i < count; i++) {
        uint32_t back = edges[i] << 16 | edges[i] >> 16;
        if (!bsearch(&back, edges, count, sizeof *edges, compare)) boundary[open++] = edges[i];
    }
    parts = components(edges, count);
    loops = components(boundary, open);
    euler = (int32_t)s->mesh->vertices - (int32_t)((count + open) / 2) + (int32_t)s->mesh->triangles;
    good = open == s->boundary_edges && loops == (open ? 6u : 0u) && parts == s->components && euler == s->euler;
    test_verdict(good && !doubled, "mesh_seams",
                 "%s: %u edges, %u on %u boundary loops (want %u), %u doubled, %u components, Euler %d", s->name,
                 (unsigned)((count + open) / 2), (unsigned)open, (unsigned)loops, (unsigned)s->boundary_edges, (unsigned)doubled,
                 (unsigned)parts, (int)euler);
    free(boundary);
    free(edges);
}

/* ----------------------------------------------------------------------------------------------------------------- every mesh */

static uint32_t fnv(uint32_t h, uint16_t x) { return ((h ^ (x & 255u)) * 16777619u ^ (uint32_t)(x >> 8)) * 16777619u; }

static uint32_t fnv_vector(uint32_t h, lmb_vec v) { return fnv(fnv(fnv(h, (uint16_t)v.x), (uint16_t)v.y), (uint16_t)v.z); }

static void test_counts(const shape *s)
{
    const lmb_mesh *m = s->mesh;
    uint32_t i, bad = 0, h = 2166136261u;
    int largest = 0;
    for (i = 0; i < 3 * m->triangles; i++) bad += m->indices[i] >= m->vertices;
    for (i = 0; i < m->vertices; i++) {
        lmb_vec p = m->positions[i];
        if (abs(p.x) > largest) largest = abs(p.x);
        if (abs(p.y) > largest) largest = abs(p.y);
        if (abs(p.z) > largest) largest = abs(p.z);
        h = fnv_vector(fnv_vector(h, p), m->normals[i]);
    }
    for (i = 0; i < 3 * m->triangles; i++) h = fnv(h, m->indices[i]);
    test_verdict(m->vertices == s->vertices && m->triangles == s->triangles && !bad && largest > 16383 && largest <= 32767,
                 "mesh_counts", "%s: %u vertices (want %u), %u triangles (want %u), %u indices off, largest %d, scale %d",
                 s->name, (unsigned)m->vertices, (unsigned)s->vertices, (unsigned)m->triangles, (unsigned)s->triangles,
                 (unsigned)bad, largest, m->scale);
    test_verdict(h == s->fingerprint, "mesh_fingerprint", "%s: 0x%08x (want 0x%08x)", s->name, (unsigned)h,
                 (unsigned)s->fingerprint);
}

/* Rounding moves each component by up to half a unit: the length by up to sqrt(3)/2 of 2^-14, below 2^-14. */
static void test_normals_unit(const shape *s)
{
    double worst = 0.0;
    uint32_t i, at = 0;
    for (i = 0; i < s->mesh->vertices; i++) {
        vec3 n = real(s->mesh->normals[i]);
        double error = fabs(sqrt(dot(n, n)) / 16384.0 - 1.0);
        if (error > worst) worst = error, at = i;
    }
    test_verdict(worst <= 1.0 / 16384, "mesh_normals_unit", "%s: worst 2^%.2f at vertex %u", s->name, log2(worst), (unsigned)at);
}

/* Each triangle has area and faces the way of its three normals. */
static void test_orientation(const shape *s)
{
    const lmb_mesh *m = s->mesh;
    double least = 2.0, mean = 0.0, area = 1e30;
    uint32_t t, k, at = 0;
    for (t = 0; t < m->triangles; t++) {
        vec3 f = facet(m, t);
        double twice = sqrt(dot(f, f));
        if (twice < area) area = twice;
        for (k = 0; k < 3; k++) {
            double c = twice > 0.0 ? dot(unit(f), unit(real(m->normals[m->indices[3 * t + k]]))) : -1.0;
            mean += c / (3.0 * m->triangles);
            if (c < least) least = c, at = t;
        }
    }
    test_verdict(least > 0.0 && area > 0.0, "mesh_orientation",
                 "%s: least cosine between facet and normal %.3f at triangle %u, mean %.4f; smallest triangle %.1f square units",
                 s->name, least, (unsigned)at, mean, area / 2);
}

/* ----------------------------------------------------------------------------------------------------------- sphere and torus */

/* Half a unit in each component: at most sqrt(3)/2 of a mesh unit off the surface. */
#define ROUNDING 0.8661

static void test_sphere(const shape *s)
{
    double worst = 0.0;
    uint32_t i, different = 0;
    for (i = 0; i < s->mesh->vertices; i++) {
        vec3 p = real(s->mesh->positions[i]);
        double error = fabs(sqrt(dot(p, p)) - ldexp(1.0, -s->mesh->scale));
        if (error > worst) worst = error;
        different += memcmp(&s->mesh->positions[i], &s->mesh->normals[i], sizeof(lmb_vec)) != 0;
    }
    test_verdict(worst <= ROUNDING && !different, "mesh_sphere", "%s: off the unit sphere by %.3f mesh units, %u normals differ",
                 s->name, worst, (unsigned)different);
}

/* (sqrt(x^2 + y^2) - 0.7)^2 + z^2 = 0.09; the normal points from the nearest point of the circle of radius 0.7 through the
 * vertex. Seen from there, a position off by ROUNDING turns it by that over 0.3. */
static void test_torus(const shape *s)
{
    double one = ldexp(1.0, -s->mesh->scale), off = 0.0, turned = 0.0;
    double allowed = (ROUNDING + ROUNDING / 0.3 * 16384.0 / one) / 16384.0;
    uint32_t i;
    for (i = 0; i < s->mesh->vertices; i++) {
        vec3 p = real(s->mesh->positions[i]), n = real(s->mesh->normals[i]), want, d;
        double radius = sqrt(p.x * p.x + p.y * p.y), ring = radius - 0.7 * one, distance = sqrt(ring * ring + p.z * p.z);
        want.x = ring / distance * p.x / radius;
        want.y = ring / distance * p.y / radius;
        want.z = p.z / distance;
        d.x = n.x / 16384 - want.x;
        d.y = n.y / 16384 - want.y;
        d.z = n.z / 16384 - want.z;
        off = fmax(off, fabs(distance - 0.3 * one));
        turned = fmax(turned, sqrt(dot(d, d)));
    }
    test_verdict(off <= ROUNDING && turned <= allowed, "mesh_torus",
                 "%s: off the surface by %.3f mesh units, normals by %.6f (%.6f from rounding alone)", s->name, off, turned,
                 allowed);
}

/* --------------------------------------------------------------------------------------------------------------------- teapot */

/* The teapot's vertex at a point of Newell's space (x to the spout, z up; 9800 mesh units to one, the middle at (2127, 15435))
 * with this normal, of any length; UINT32_MAX if there is none. */
static uint32_t find(const lmb_mesh *m, const double p[3], const double n[3])
{
    vec3 want = {n[0], n[2], -n[1]};
    uint32_t i;
    want = unit(want);
    for (i = 0; i < m->vertices; i++) {
        lmb_vec q = m->positions[i];
        vec3 o = real(m->normals[i]);
        if (q.x != lround(9800 * p[0]) - 2127 || q.y != lround(9800 * p[2]) - 15435 || q.z != lround(-9800 * p[1])) continue;
        if (fmax(fmax(fabs(o.x - 16384 * want.x), fabs(o.y - 16384 * want.y)), fabs(o.z - 16384 * want.z)) < 0.501) return i;
    }
    return UINT32_MAX;
}

/* Corners of Newell's patches with their normals: there the tangents are differences of neighbouring control points. */
static void test_teapot_corners(const shape *s)
{
    static const double corners[][2][3] = {{{0, 0, 3.15}, {0, 0, 1}}, /* knob */
                                           {{0, 0.2, 2.7}, {0, 0.15, 0.2}},
                                           {{-1.3, 0, 2.4}, {-1, 0, 0}}, /* lid */
                                           {{1.4, 0, 2.4}, {-0.13125, 0, -0.0625}},
                                           {{0, 1.5, 2.4}, {0, 0.525, 0.25}}, /* rim */
                                           {{2, 0, 0.9}, {1, 0, 0}},
                                           {{0, -2, 0.9}, {0, -1, 0}}, /* body */
                                           {{1.5, 0, 0.15}, {1, 0, 0}},
                                           {{0, 0, 0}, {0, 0, -1}}, /* bottom */
                                           {{-1.6, 0, 2.025}, {0, 0, -1}},
                                           {{-1.5, 0, 2.25}, {0, 0, 1}}, /* handle */
                                           {{-2.7, 0, 1.8}, {1, 0, 0}},
                                           {{-3, 0, 1.8}, {-1, 0, 0}},
                                           {{-2, 0, 0.9}, {0.225, 0, 0.5}},
                                           {{-1.9, 0, 0.6}, {-0.3375, 0, -0.75}},
                                           {{1.7, 0, 1.425}, {0, 0, 1}},
                                           {{1.7, 0, 0.6}, {0.225, 0, -1.4}}, /* spout */
                                           {{2.7, 0, 2.4}, {-0.3, 0, 0.4}},
                                           {{3.3, 0, 2.4}, {0.375, 0, -0.9}},
                                           {{2.8, 0, 2.4}, {0.075, 0, -0.1}},
                                           {{3.2, 0, 2.4}, {-0.1125, 0, 0.25}}};
    uint32_t i, missing = 0, count = sizeof corners / sizeof corners[0];
    for (i = 0; i < count; i++) missing += find(s->mesh, corners[i][0], corners[i][1]) == UINT32_MAX;
    test_verdict(!missing, "teapot_corners", "%u of %u corners of patches missing or with another normal", (unsigned)missing,
                 (unsigned)count);
}

/* Its own mirror image in z, positions and normals; inside the unit sphere; in the middle of its box. */
static void test_teapot_frame(const shape *s)
{
    const lmb_mesh *m = s->mesh;
    double far = 0.0;
    uint32_t i, j, alone = 0;
    int low[2] = {32767, 32767}, high[2] = {-32767, -32767};
    for (i = 0; i < m->vertices; i++) {
        lmb_vec p = m->positions[i], n = m->normals[i];
        for (j = 0; j < m->vertices; j++) {
            lmb_vec q = m->positions[j], o = m->normals[j];
            if (p.x == q.x && p.y == q.y && p.z == -q.z && n.x == o.x && n.y == o.y && n.z == -o.z) break;
        }
        alone += j == m->vertices;
        far = fmax(far, sqrt(dot(real(p), real(p))));
        low[0] = p.x < low[0] ? p.x : low[0], high[0] = p.x > high[0] ? p.x : high[0];
        low[1] = p.y < low[1] ? p.y : low[1], high[1] = p.y > high[1] ? p.y : high[1];
    }
    test_verdict(!alone && far < 32768.0 && low[1] == -high[1] && abs(low[0] + high[0]) <= 16, "teapot_frame",
                 "%u vertices without mirror image, farthest %.1f of 32768, x %d...%d, y %d...%d", (unsigned)alone, far, low[0],
                 high[0], low[1], high[1]);
}

/* 1 if the first triangle that the ray meets shows its front, -1 its back, 0 for none. */
static int first_side(const lmb_mesh *m, vec3 origin, vec3 way)
{
    double nearest = 1e30;
    int side = 0;
    uint32_t t;
    for (t = 0; t < m->triangles; t++) {
        vec3 a = minus(corner(m, t, 0), origin), b = minus(corner(m, t, 1), origin), c = minus(corner(m, t, 2), origin);
        double u = dot(way, cross(a, b)), v = dot(way, cross(b, c)), w = dot(way, cross(c, a)), sum = u + v + w, distance;
        if (sum == 0.0 || (u < 0.0 || v < 0.0 || w < 0.0) == (u > 0.0 || v > 0.0 || w > 0.0)) continue;
        distance = dot(a, cross(minus(b, a), minus(c, a))) / sum;
        if (distance < nearest) nearest = distance, side = sum < 0.0 ? 1 : -1;
    }
    return side;
}

/* Rays from all around, each aimed at a point of some triangle. From below the horizon, where neither the lid's gap nor the
 * spout's mouth shows, every ray meets a front first: nothing is missing, inside out or cracked. From above, backs show through
 * those two openings only. */
static void test_teapot_outside(const shape *s, test_random *r)
{
    uint32_t i, hits[2] = {0, 0}, fronts[2] = {0, 0};
    for (i = 0; i < 20000; i++) {
        uint32_t t = (uint32_t)test_integer(r, 0, s->mesh->triangles - 1);
        double y = test_real(r, -1.0, 1.0), turn = test_real(r, 0.0, 6.283185307179586), across = sqrt(1.0 - y * y);
        double u = test_real(r, 0.0, 1.0), v = test_real(r, 0.0, 1.0 - u), w = 1.0 - u - v;
        vec3 a = corner(s->mesh, t, 0), b = corner(s->mesh, t, 1), c = corner(s->mesh, t, 2), origin;
        vec3 way = {-across * cos(turn), -y, -across * sin(turn)};
        int above = y > 0.0;
        origin.x = u * a.x + v * b.x + w * c.x - 70000 * way.x;
        origin.y = u * a.y + v * b.y + w * c.y - 70000 * way.y;
        origin.z = u * a.z + v * b.z + w * c.z - 70000 * way.z;
        hits[above]++;
        fronts[above] += first_side(s->mesh, origin, way) == 1;
    }
    test_verdict(fronts[0] == hits[0] && fronts[1] * 10.0 > hits[1] * 9.0, "teapot_outside",
                 "fronts met by %u of %u rays from below, %u of %u from above", (unsigned)fronts[0], (unsigned)hits[0],
                 (unsigned)fronts[1], (unsigned)hits[1]);
}

/* mesh.bend: 1 - cos of the largest angle between normals along an edge, rounded up. Normals of Q2.14 are unit within 2^-13.8. */
static void test_bend(const shape *s)
{
    const lmb_mesh *m = s->mesh;
    double most = 0, said = m->bend / 32768.0;
    uint32_t i;
    for (i = 0; i < 3 * m->triangles; i++) {
        const vec3 a = unit(real(m->normals[m->indices[i]]));
        const vec3 b = unit(real(m->normals[m->indices[i % 3 == 2 ? i - 2 : i + 1]]));
        most = fmax(most, 1 - dot(a, b));
    }
    test_verdict(said >= most - 2e-4 * most && said <= most + 2e-4 * most + 1.0 / 32768 + 1e-9, "bend",
                 "%s: %.6f, of doubles %.6f", s->name, said, most);
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    size_t i;
    for (i = 0; i < SHAPES; i++) {
        test_counts(&shapes[i]);
        test_seams(&shapes[i]);
        test_normals_unit(&shapes[i]);
        test_orientation(&shapes[i]);
        test_bend(&shapes[i]);
    }
    test_sphere(&shapes[0]);
    test_sphere(&shapes[1]);
    test_torus(&shapes[2]);
    test_teapot_corners(&shapes[3]);
    test_teapot_frame(&shapes[3]);
    test_teapot_outside(&shapes[3], &r);
    return test_end();
}
