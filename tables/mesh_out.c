/* SPDX-License-Identifier: MIT */
/* Meshes in the making: quantises and welds vertices, checks triangles, writes the whole as one C file. */
#include "mesh_out.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SLOTS 131072u /* a power of two, twice MESH_VERTICES_MAX: probing stays short */
#define NAME_MAX_LENGTH 40

static const char *generator_name = "mesh";

void mesh_fail(const char *message)
{
    fprintf(stderr, "%s: %s\n", generator_name, message);
    exit(EXIT_FAILURE);
}

int mesh_argument(const char *text, int low, int high)
{
    char *end;
    long value = strtol(text, &end, 10);
    if (end == text || *end != '\0' || value < low || value > high) {
        fprintf(stderr, "%s: \"%s\" is not a number from %d to %d\n", generator_name, text, low, high);
        exit(EXIT_FAILURE);
    }
    return (int)value;
}

/* ---------------------------------------------------------------------------------------------------------------- quantising */

int16_t mesh_round(double x)
{
    double below = floor(x);
    if (!(fabs(x) <= 32767.0)) mesh_fail("a value does not fit into 16 bits");
    if (fabs(x - below - 0.5) < MESH_TIE) mesh_fail("a value lies on a rounding tie; choose other arguments");
    return (int16_t)(x - below > 0.5 ? below + 1.0 : below);
}

lmb_vec mesh_unit(double x, double y, double z)
{
    double length = sqrt(x * x + y * y + z * z);
    lmb_vec unit;
    if (!(length > 0.0)) mesh_fail("a normal has no length");
    unit.x = mesh_round(16384.0 * (x / length));
    unit.y = mesh_round(16384.0 * (y / length));
    unit.z = mesh_round(16384.0 * (z / length));
    return unit;
}

/* ----------------------------------------------------------------------------------------------------- vertices and triangles */

static void *room_for(size_t count, size_t size)
{
    void *memory = calloc(count, size);
    if (!memory) mesh_fail("out of memory");
    return memory;
}

void mesh_begin(mesh_out *mesh, const char *generator)
{
    generator_name = generator;
    mesh->positions = room_for(MESH_VERTICES_MAX, sizeof *mesh->positions);
    mesh->normals = room_for(MESH_VERTICES_MAX, sizeof *mesh->normals);
    mesh->indices = room_for(3 * (size_t)MESH_TRIANGLES_MAX, sizeof *mesh->indices);
    mesh->slots = room_for(SLOTS, sizeof *mesh->slots);
    mesh->vertices = mesh->triangles = 0;
}

static uint32_t hash(uint32_t h, lmb_vec v)
{
    h = (h ^ (uint16_t)v.x) * 0x9E3779B1u;
    h = (h ^ (uint16_t)v.y) * 0x9E3779B1u;
    h = (h ^ (uint16_t)v.z) * 0x9E3779B1u;
    return h ^ h >> 15;
}

static bool same(lmb_vec a, lmb_vec b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

uint16_t mesh_vertex(mesh_out *mesh, lmb_vec position, lmb_vec normal)
{
    uint32_t slot = hash(hash(1, position), normal) % SLOTS, found;
    while ((found = mesh->slots[slot]) != 0) {
        uint32_t v = found - 1;
        if (same(mesh->positions[v], position) && same(mesh->normals[v], normal)) return (uint16_t)v;
        slot = (slot + 1) % SLOTS;
    }
    if (mesh->vertices == MESH_VERTICES_MAX) mesh_fail("too many vertices");
    mesh->positions[mesh->vertices] = position;
    mesh->normals[mesh->vertices] = normal;
    mesh->slots[slot] = ++mesh->vertices;
    return (uint16_t)(mesh->vertices - 1);
}

/* Twice the area times the outward direction. Differences of int16 have 17 bits, so each term stays below 2^33. */
static void area_vector(const mesh_out *mesh, const uint16_t *corner, int64_t area[3])
{
    lmb_vec a = mesh->positions[corner[0]], b = mesh->positions[corner[1]], c = mesh->positions[corner[2]];
    int64_t ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    area[0] = uy * vz - uz * vy;
    area[1] = uz * vx - ux * vz;
    area[2] = ux * vy - uy * vx;
}

void mesh_triangle(mesh_out *mesh, uint16_t a, uint16_t b, uint16_t c)
{
    uint16_t *corner = &mesh->indices[3 * (size_t)mesh->triangles];
    int64_t area[3];
    int i;
    if (a == b || b == c || c == a) return;
    if (mesh->triangles == MESH_TRIANGLES_MAX) mesh_fail("too many triangles");
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
    area_vector(mesh, corner, area);
    if (!area[0] && !area[1] && !area[2]) mesh_fail("a triangle has no area");
    for (i = 0; i < 3; i++) {
        lmb_vec n = mesh->normals[corner[i]];
        if (area[0] * n.x + area[1] * n.y + area[2] * n.z <= 0) mesh_fail("a triangle turns its back to a normal");
    }
    mesh->triangles++;
}

/* ------------------------------------------------------------------------------------------------------------------- writing */

static void write_vectors(FILE *file, const char *name, const char *what, const lmb_vec *v, uint32_t count)
{
    uint32_t i;
    fprintf(file, "static const LMB_FLASH lmb_vec %s_%s[] = {", name, what);
    for (i = 0; i < count; i++) fprintf(file, "%s{%d, %d, %d},", i % 5 ? " " : "\n    ", v[i].x, v[i].y, v[i].z);
    fprintf(file, "\n};\n\n");
}

static void write_indices(FILE *file, const char *name, const uint16_t *v, uint32_t triangles)
{
    uint32_t i;
    fprintf(file, "static const LMB_FLASH uint16_t %s_indices[] = {", name);
    for (i = 0; i < triangles; i++, v += 3) fprintf(file, "%s%d, %d, %d,", i % 6 ? " " : "\n    ", v[0], v[1], v[2]);
    fprintf(file, "\n};\n\n");
}

static void check_name(const char *name)
{
    const char *p;
    bool good = (isalpha((unsigned char)name[0]) || name[0] == '_') && strlen(name) <= NAME_MAX_LENGTH;
    for (p = name; *p; p++) good = good && (isalnum((unsigned char)*p) || *p == '_');
    if (!good) mesh_fail("the name is not a C identifier of at most 40 characters");
}

static unsigned bend_of(const mesh_out *mesh)
{
    const lmb_mesh built = {mesh->positions, mesh->normals, mesh->indices, (uint16_t)mesh->vertices, mesh->triangles, 0, 0};
    return lmb_mesh_bend(&built);
}

/* The mesh as a C file; shared: positions and normals are one array. */
static void write_file(FILE *file, const mesh_out *mesh, const char *name, int scale, bool shared)
{
    if (!shared) write_vectors(file, name, "positions", mesh->positions, mesh->vertices);
    write_vectors(file, name, "normals", mesh->normals, mesh->vertices);
    write_indices(file, name, mesh->indices, mesh->triangles);
    fprintf(file, "extern const lmb_mesh %s;\nconst lmb_mesh %s = {\n    ", name, name);
    fprintf(file, "%s_%s, %s_normals, %s_indices,\n", name, shared ? "normals" : "positions", name, name);
    fprintf(file, "    %lu, %lu, %d, %u,\n};\n", (unsigned long)mesh->vertices, (unsigned long)mesh->triangles, scale,
            bend_of(mesh));
}

/* The mesh as a Wavefront OBJ file: positions in space, exact in decimals, and the quantised normals. */
static void write_obj(FILE *file, const mesh_out *mesh, int scale, const char *text)
{
    const uint16_t *corner = mesh->indices;
    uint32_t i;
    fprintf(file, "# Generated by tables/%s.c. %s\n", generator_name, text);
    for (i = 0; i < mesh->vertices; i++) {
        lmb_vec p = mesh->positions[i], n = mesh->normals[i];
        fprintf(file, "v %.17g %.17g %.17g\n", ldexp(p.x, scale), ldexp(p.y, scale), ldexp(p.z, scale));
        fprintf(file, "vn %.17g %.17g %.17g\n", ldexp(n.x, -14), ldexp(n.y, -14), ldexp(n.z, -14));
    }
    for (i = 0; i < mesh->triangles; i++, corner += 3) {
        fprintf(file, "f %d//%d %d//%d %d//%d\n", corner[0] + 1, corner[0] + 1, corner[1] + 1, corner[1] + 1, corner[2] + 1,
                corner[2] + 1);
    }
}

/* Head and body of the C file. */
static void write_c(FILE *file, const mesh_out *mesh, char **arguments, int count, int scale, const char *text)
{
    const char *name = arguments[count - 1];
    size_t vectors = mesh->vertices * sizeof(lmb_vec);
    bool shared = memcmp(mesh->positions, mesh->normals, vectors) == 0;
    unsigned long bytes = (unsigned long)(vectors * (shared ? 1 : 2) + 3 * sizeof(uint16_t) * mesh->triangles);
    int i;
    fprintf(file, "/* Generated by tables/%s.c", generator_name);
    for (i = 1; i < count; i++) fprintf(file, " %s", arguments[i]);
    fprintf(file, "; do not edit.\n * %s\n", text);
    fprintf(file, " * %lu vertices, %lu triangles, ", (unsigned long)mesh->vertices, (unsigned long)mesh->triangles);
    fprintf(file, "%lu bytes. Positions: 2^%d to a unit of space; normals: Q2.14, exact but for rounding. */\n", bytes, -scale);
    fprintf(file, "#include \"lambent.h\"\n\n");
    write_file(file, mesh, name, scale, shared);
}

static bool is_obj(const char *path)
{
    size_t length = path ? strlen(path) : 0;
    return length > 4 && !strcmp(path + length - 4, ".obj");
}

void mesh_write(mesh_out *mesh, char **arguments, int count, const char *path, int scale, const char *text)
{
    FILE *file;
    check_name(arguments[count - 1]);
    file = path ? fopen(path, "w") : stdout;
    if (!file) mesh_fail("cannot write the file");
    if (is_obj(path)) {
        write_obj(file, mesh, scale, text);
    } else {
        write_c(file, mesh, arguments, count, scale, text);
    }
    if (ferror(file) | (path ? fclose(file) : fflush(file))) mesh_fail("cannot write the file");
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->indices);
    free(mesh->slots);
}
