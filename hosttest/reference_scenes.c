/* SPDX-License-Identifier: MIT */
/* Scenes made to break things. Meshes are rounded from double; a unit is 2^14 mesh units, as in the demo's. */
#include "reference_scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CORNERS_MAX 6000
#define UNIT 16384.0
#define SPACE_UNIT 65536

typedef struct vec3 {
    double x, y, z;
} vec3;

typedef struct built {
    lmb_mesh mesh;
    lmb_vec position[CORNERS_MAX], normal[CORNERS_MAX];
    uint16_t index[CORNERS_MAX];
    uint32_t corners;
} built;

static built *library[HARD_MESHES];

static const char *const names[HARD_MESHES] = {"tetrahedron", "icosahedron", "icosphere-80", "icosphere-320", "tube-around",
                                               "tube-along",  "cone",        "sheet",        "soup"};

const char *hard_mesh_name(enum hard_mesh which) { return names[which]; }

static vec3 make(double x, double y, double z)
{
    vec3 v = {x, y, z};
    return v;
}

static vec3 unit(vec3 v)
{
    double length = sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return make(v.x / length, v.y / length, v.z / length);
}

static lmb_vec rounded(vec3 v)
{
    lmb_vec r;
    r.x = (int16_t)lround(v.x * UNIT);
    r.y = (int16_t)lround(v.y * UNIT);
    r.z = (int16_t)lround(v.z * UNIT);
    return r;
}

static void add_corner(built *b, vec3 position, vec3 normal)
{
    if (b->corners == CORNERS_MAX) {
        fprintf(stderr, "reference_scenes: mesh too large\n");
        exit(EXIT_FAILURE);
    }
    b->position[b->corners] = rounded(position);
    b->normal[b->corners] = rounded(unit(normal));
    b->index[b->corners] = (uint16_t)b->corners;
    b->corners++;
}

/* -------------------------------------------------------------------------------------------------------------------- spheres */

/* A triangle of a sphere, cut into four at its mid-edges until levels are used up. */
static void add_spherical(built *b, vec3 p, vec3 q, vec3 r, int levels)
{
    if (levels > 0) {
        vec3 pq = unit(make(p.x + q.x, p.y + q.y, p.z + q.z)), qr = unit(make(q.x + r.x, q.y + r.y, q.z + r.z));
        vec3 rp = unit(make(r.x + p.x, r.y + p.y, r.z + p.z));
        add_spherical(b, p, pq, rp, levels - 1);
        add_spherical(b, pq, q, qr, levels - 1);
        add_spherical(b, rp, qr, r, levels - 1);
        add_spherical(b, pq, qr, rp, levels - 1);
        return;
    }
    add_corner(b, p, p);
    add_corner(b, q, q);
    add_corner(b, r, r);
}

static double orientation(vec3 a, vec3 b, vec3 c)
{
    return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
}

/* All faces of a solid whose corners are given and whose edges are shorter than the square root of edge2. */
static void add_solid(built *b, const vec3 *corner, int corners, double edge2, int levels)
{
    int i, j, k;
    for (i = 0; i < corners; i++) {
        for (j = i + 1; j < corners; j++) {
            for (k = j + 1; k < corners; k++) {
                vec3 p = corner[i], q = corner[j], r = corner[k];
                bool outwards = orientation(p, q, r) > 0;
                double pq = 2 - 2 * (p.x * q.x + p.y * q.y + p.z * q.z), qr = 2 - 2 * (q.x * r.x + q.y * r.y + q.z * r.z);
                double rp = 2 - 2 * (r.x * p.x + r.y * p.y + r.z * p.z);
                if (pq > edge2 || qr > edge2 || rp > edge2) continue;
                add_spherical(b, p, outwards ? q : r, outwards ? r : q, levels);
            }
        }
    }
}

static void tetrahedron(built *b)
{
    vec3 corner[4];
    int i;
    for (i = 0; i < 4; i++) corner[i] = unit(make(i & 1 ? 1 : -1, i & 2 ? 1 : -1, (i & 1) ^ (i >> 1) ? -1 : 1));
    add_solid(b, corner, 4, 3, 0);
}

static void icosphere(built *b, int levels)
{
    vec3 corner[12];
    int i;
    for (i = 0; i < 12; i++) {
        double one = i & 1 ? -1 : 1, golden = (i & 2 ? -0.5 : 0.5) * (1 + sqrt(5.0));
        corner[i] = unit(i < 4 ? make(0, one, golden) : i < 8 ? make(golden, 0, one) : make(one, golden, 0));
    }
    add_solid(b, corner, 12, 1.5, levels);
}

/* -------------------------------------------------------------------------------------------------------------------- slivers */

/* A corner of a surface of revolution about y: radius top at y = 1, bottom at y = -1, smooth normals. */
static void add_turned(built *b, double top, double bottom, double around, double up)
{
    double radius = bottom + (top - bottom) * up, slope = (bottom - top) / 2, c = cos(around), s = sin(around);
    add_corner(b, make(radius * s, 2 * up - 1, radius * c), make(s, slope, c));
}

static void turned(built *b, double top, double bottom, int around, int along)
{
    const double step = 2 * acos(-1.0) / around;
    int i, j;
    for (j = 0; j < along; j++) {
        double low = (double)j / along, high = (double)(j + 1) / along;
        for (i = 0; i < around; i++) {
            double left = i * step, right = (i + 1) * step;
            add_turned(b, top, bottom, left, low);
            add_turned(b, top, bottom, right, low);
            add_turned(b, top, bottom, right, high);
            if (top == 0 && j == along - 1) continue; /* the other half has no area at the tip */
            add_turned(b, top, bottom, left, low);
            add_turned(b, top, bottom, right, high);
            add_turned(b, top, bottom, left, high);
        }
    }
}

static void sheet(built *b)
{
    static const double corner[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    int i;
    for (i = 0; i < 6; i++) {
        add_corner(b, make(corner[i][0], corner[i][1], 0), make(0.6 * corner[i][0], 0.6 * corner[i][1], 1));
    }
}

/* A plain generator, so that the mesh is the same on every machine. */
static double any(uint32_t *state, double low, double high)
{
    *state = *state * 1664525u + 1013904223u;
    return low + (high - low) * (*state >> 8) / 16777216.0;
}

static void soup(built *b)
{
    uint32_t state = 20;
    int i, k;
    for (i = 0; i < 60; i++) {
        vec3 p[3], axis = unit(make(any(&state, -1, 1), any(&state, -1, 1), any(&state, -0.5, 1.5)));
        double size = i % 3 == 0 ? 0.08 : 0.7, spread = any(&state, 0, 0.8);
        double x = any(&state, -0.8, 0.8), y = any(&state, -0.8, 0.8);
        for (k = 0; k < 3; k++) {
            p[k] = make(x + any(&state, -size, size), y + any(&state, -size, size), any(&state, -0.9, 0.9));
        }
        if ((p[1].x - p[0].x) * (p[2].y - p[0].y) < (p[1].y - p[0].y) * (p[2].x - p[0].x)) {
            vec3 swap = p[1];
            p[1] = p[2];
            p[2] = swap;
        }
        for (k = 0; k < 3; k++) {
            vec3 off = make(any(&state, -spread, spread), any(&state, -spread, spread), any(&state, -spread, spread));
            add_corner(b, p[k], make(axis.x + off.x, axis.y + off.y, axis.z + off.z));
        }
    }
}

/* ---------------------------------------------------------------------------------------------------------------- the library */

const lmb_mesh *hard_mesh(enum hard_mesh which)
{
    built *b = library[which];
    if (b) return &b->mesh;
    library[which] = b = calloc(1, sizeof *b);
    if (!b) {
        fprintf(stderr, "reference_scenes: out of memory\n");
        exit(EXIT_FAILURE);
    }
    if (which == HARD_TETRAHEDRON) tetrahedron(b);
    if (which >= HARD_ICOSAHEDRON && which <= HARD_ICOSPHERE_320) icosphere(b, (int)which - HARD_ICOSAHEDRON);
    if (which == HARD_TUBE_AROUND) turned(b, 1, 1, 200, 4);
    if (which == HARD_TUBE_ALONG) turned(b, 1, 1, 4, 200);
    if (which == HARD_CONE) turned(b, 0, 1, 200, 1);
    if (which == HARD_SHEET) sheet(b);
    if (which == HARD_SOUP) soup(b);
    b->mesh.positions = b->position;
    b->mesh.normals = b->normal;
    b->mesh.indices = b->index;
    b->mesh.vertices = (uint16_t)b->corners;
    b->mesh.triangles = b->corners / 3;
    b->mesh.scale = -14;
    return &b->mesh;
}

void hard_meshes_end(void)
{
    int i;
    for (i = 0; i < HARD_MESHES; i++) {
        free(library[i]);
        library[i] = NULL;
    }
}

/* --------------------------------------------------------------------------------------------------------------------- scenes */

bool demo_scene(scene *s, const char *name)
{
    unsigned i;
    for (i = 0; i < scene_count(); i++) {
        scene_make(s, i);
        if (!strcmp(s->name, name)) return true;
    }
    return false;
}

void hard_light(scene *s, unsigned i, double x, double y, double z, lmb_rgb colour)
{
    s->light[i].direction = rounded(unit(make(x, y, z)));
    s->light[i].colour = colour;
    if (i >= s->lights) s->lights = i + 1;
}

void hard_scene(scene *s, const char *name, int size, double radius, const lmb_mesh *mesh, lmb_matrix rotation)
{
    static const lmb_rgb white = {255, 255, 255};
    static const lmb_material material = {{24, 14, 6}, {90, 130, 179}, {128, 120, 110}, 40};
    memset(s, 0, sizeof *s);
    s->name = name;
    s->width = s->height = size;
    s->objects = 1;
    s->object[0].mesh = mesh;
    s->object[0].pose.rotation = rotation;
    s->object[0].pose.z = -4 * SPACE_UNIT;
    s->object[0].material = material;
    s->background.r = 18;
    s->background.g = 20;
    s->background.b = 26;
    s->depth = true;
    s->step = LMB_STEP_QUADRATIC;
    hard_light(s, 0, 40, 55, 70, white);
    lmb_camera_orthographic(&s->camera, size, size, (int32_t)lround(radius * SPACE_UNIT), SPACE_UNIT, 8 * SPACE_UNIT);
}

void hard_scene_near(scene *s, double radius, double distance)
{
    s->object[0].pose.z = (int32_t)-lround(distance * SPACE_UNIT);
    lmb_camera_perspective(&s->camera, s->width, s->height, (int32_t)lround(radius * distance * SPACE_UNIT), SPACE_UNIT / 4,
                           16 * SPACE_UNIT);
}

uint16_t hard_turn(double degrees) { return (uint16_t)(lround(degrees * 65536 / 360) & 0xffff); }

static lmb_matrix rotation(double x, double y, double z) { return lmb_rotation(hard_turn(x), hard_turn(y), hard_turn(z)); }

/* ----------------------------------------------------------------------------------------------------------------------- sets */

static void name_scene(char label[HARD_LABEL], const char *what, double which)
{
    snprintf(label, HARD_LABEL, "%s-%g", what, which);
}

static const lmb_mesh *demo_mesh(unsigned i)
{
    scene s;
    scene_make(&s, i);
    return s.object[0].mesh;
}

static void make_coarse(scene *s, unsigned i, char label[HARD_LABEL])
{
    enum hard_mesh which = (enum hard_mesh)(HARD_TETRAHEDRON + i / 2);
    name_scene(label, hard_mesh_name(which), i & 1);
    hard_scene(s, label, 200, 95, hard_mesh(which), rotation(20, i & 1 ? 107 : 47, 10));
    if (i & 1) hard_scene_near(s, 95, 2.5);
}

static void make_sliver(scene *s, unsigned i, char label[HARD_LABEL])
{
    static const double tilt[5] = {0, 3, 50, 88.5, 91};
    enum hard_mesh which = (enum hard_mesh)(HARD_TUBE_AROUND + i / 5);
    name_scene(label, hard_mesh_name(which), tilt[i % 5]);
    hard_scene(s, label, 200, 68, hard_mesh(which), rotation(tilt[i % 5], 13, 31 * (i % 5)));
}

static void make_shiny(scene *s, unsigned i, char label[HARD_LABEL])
{
    static const uint16_t n[9] = {1, 2, 3, 7, 12, 50, 200, 500, 1000};
    name_scene(label, "shininess", n[i]);
    hard_scene(s, label, 180, 85, hard_mesh(HARD_ICOSPHERE_320), rotation(17, 31 + 7.0 * i, 0));
    s->object[0].material.shininess = n[i];
}

/* Grazing, straight on, and from behind. */
static void make_light(scene *s, unsigned i, char label[HARD_LABEL])
{
    static const double to[7][3] = {{1, 0, 0.01}, {-1, 0.2, 0}, {0, -1, -0.2}, {0.3, 0.3, -1},
                                    {0, 0, 1},    {0, 0, -1},   {0.2, 0, -1}};
    name_scene(label, "light", i);
    hard_scene(s, label, 160, 75, hard_mesh(HARD_ICOSPHERE_320), rotation(40, 20, 5));
    hard_light(s, 0, to[i][0], to[i][1], to[i][2], s->light[0].colour);
}

/* One to four lights of different colours, whose sum is far above one in places. */
static void make_saturated(scene *s, unsigned i, char label[HARD_LABEL])
{
    static const lmb_material bright = {{60, 60, 60}, {255, 240, 220}, {255, 255, 255}, 25};
    static const lmb_rgb red = {255, 40, 20}, green = {30, 255, 60}, blue = {50, 30, 255}, white = {255, 255, 255};
    name_scene(label, "lights", i + 1);
    hard_scene(s, label, 200, 95, i & 1 ? hard_mesh(HARD_ICOSPHERE_80) : demo_mesh(4), rotation(-50, 24, 0));
    s->object[0].material = bright;
    if (i > 0) hard_light(s, 0, 40, 55, 70, red);
    if (i > 0) hard_light(s, 1, -60, 10, 40, green);
    if (i > 1) hard_light(s, 2, 10, -70, 50, blue);
    if (i > 2) hard_light(s, 3, 45, 50, 60, white);
}

static void make_small(scene *s, unsigned i, char label[HARD_LABEL])
{
    name_scene(label, "small", i);
    hard_scene(s, label, 24 + (int)i, 10 + 0.37 * i, i < 4 ? demo_mesh(i & 1 ? 4 : 2) : hard_mesh(HARD_ICOSAHEDRON),
               rotation(33 * i, 71 * i, 0));
}

static void make_large(scene *s, unsigned i, char label[HARD_LABEL])
{
    name_scene(label, "large", i);
    hard_scene(s, label, 1024, i ? 500 : 900, hard_mesh(i ? HARD_ICOSPHERE_320 : HARD_SHEET), rotation(20, -30, 12));
    s->object[0].material.shininess = i ? 40 : 200;
}

/* Triangles of many times the frame's size, most of them outside it, none so far out that it is cut. */
static void make_outside(scene *s, unsigned i, char label[HARD_LABEL])
{
    static const double radius[3] = {700, 3000, 11000};
    name_scene(label, "outside", i);
    hard_scene(s, label, 160, radius[i % 3], hard_mesh(i < 3 ? HARD_ICOSAHEDRON : HARD_ICOSPHERE_320), rotation(47 * i, 20, 3));
}

static void make_soup(scene *s, unsigned i, char label[HARD_LABEL])
{
    static const uint16_t n[3] = {8, 60, 300};
    name_scene(label, "soup", i);
    hard_scene(s, label, 256, 120, hard_mesh(HARD_SOUP), rotation(25 * i, 30 * i, 41 * i));
    s->object[0].material.shininess = n[i];
}

const hard_set hard_sets[] = {
    {"image_coarse", 6, make_coarse, false, true, false},
    {"image_slivers", 15, make_sliver, false, true, false},
    {"image_shininess", 9, make_shiny, false, false, true},
    {"image_lights", 7, make_light, false, false, false},
    {"image_saturation", 4, make_saturated, false, false, false},
    {"image_small", 8, make_small, true, false, false},
    {"image_large", 2, make_large, false, true, false},
    {"image_outside", 6, make_outside, false, true, false},
    {"image_soup", 3, make_soup, false, false, false},
};
const unsigned hard_set_count = sizeof hard_sets / sizeof hard_sets[0];
