/* SPDX-License-Identifier: MIT */
/* From the faces of an OBJ file to a mesh: place, quantise, cut faces into triangles, find normals, merge vertices.
 *
 * Everything up to the rounding is double, in the file's own units. Whether a triangle has area is asked twice: of the file's
 * corners, up to the rounding of double, and of the quantised ones, exactly.
 */
#include "mesh_build.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define DROP_HINT "(--drop-degenerate leaves such triangles out)"

struct triangle {
    uint32_t corner[3]; /* of the model */
    uint32_t face;
};

struct build {
    const struct obj_model *model;
    const struct mesh_options *options;
    struct mesh_info *info;
    FILE *errors;
    lmb_vec *quantised; /* one for each v */
    unsigned char *used;
    struct point3 *sum; /* of normals, one for each v; unit in the end, or zero where cancelled out */
    double *weight;     /* that went into sum */
    struct triangle *triangle;
    uint32_t triangles;
    int scale;
    struct point3 *outline; /* of one face */
    uint32_t (*cut)[3];
    /* The mesh under construction, and an open hash table of vertices: number + 1, or 0. */
    lmb_vec *positions, *normals;
    uint16_t *indices;
    uint32_t *slot, slots, vertices, first_excess_line;
};

static int fail(const struct build *b, uint32_t line, const char *format, ...)
{
    va_list arguments;
    fprintf(b->errors, "%s:%lu: ", b->model->path, (unsigned long)line);
    va_start(arguments, format);
    vfprintf(b->errors, format, arguments);
    va_end(arguments);
    fputc('\n', b->errors);
    return -1;
}

static void *room_for(size_t count, size_t size) { return calloc(count ? count : 1, size); }

/* ------------------------------------------------------------------------------------------------------------ place and scale */

static void measure(struct build *b)
{
    const struct obj_model *m = b->model;
    struct mesh_info *info = b->info;
    for (uint32_t i = 0; i < m->corners; i++) b->used[m->corner[i].position] = 1;
    info->low = info->high = m->position[m->corner[0].position];
    for (uint32_t i = 0; i < m->positions; i++) {
        const struct point3 p = m->position[i];
        if (!b->used[i]) {
            info->unused++;
            continue;
        }
        struct point3 low = {fmin(info->low.x, p.x), fmin(info->low.y, p.y), fmin(info->low.z, p.z)};
        struct point3 high = {fmax(info->high.x, p.x), fmax(info->high.y, p.y), fmax(info->high.z, p.z)};
        info->low = low;
        info->high = high;
    }
    struct point3 middle = {(info->low.x + info->high.x) / 2, (info->low.y + info->high.y) / 2, (info->low.z + info->high.z) / 2};
    for (uint32_t i = 0; i < m->positions; i++) {
        if (b->used[i]) info->radius = fmax(info->radius, point3_length(point3_minus(m->position[i], middle)));
    }
    if (b->options->place != MESH_PLACE_KEEP) info->offset = middle;
    info->factor = b->options->place == MESH_PLACE_FIT && info->radius > 0 ? 1 / info->radius : 1;
}

static struct point3 place(const struct build *b, struct point3 p)
{
    const struct point3 zero = {0, 0, 0};
    return point3_plus_times(zero, point3_minus(p, b->info->offset), b->info->factor);
}

static int fits(double largest, int scale) { return lround(ldexp(largest, -scale)) <= INT16_MAX; }

/* The finest scale: the largest coordinate comes to 16384 to 32767 mesh units. */
static int choose_scale(struct build *b)
{
    const struct obj_model *m = b->model;
    double largest = 0;
    uint32_t line = m->face[0].line;
    for (uint32_t i = 0; i < m->positions; i++) {
        const double size = b->used[i] ? point3_largest(place(b, m->position[i])) : 0;
        if (size <= largest) continue;
        largest = size;
        line = m->position_line[i];
    }
    if (largest > MESH_SPACE_MAX) {
        return fail(b, line, "coordinate of size %g does not fit in space, which ends at %g (--fit scales the model)", largest,
                    MESH_SPACE_MAX);
    }
    b->scale = LMB_SCALE_MAX;
    while (b->scale > LMB_SCALE_MIN && fits(largest, b->scale - 1)) b->scale--;
    if (largest > 0 && b->scale == LMB_SCALE_MIN && fits(largest, LMB_SCALE_MIN - 1)) {
        return fail(b, line, "the largest coordinate, %g, is too small (--fit scales the model)", largest);
    }
    return 0;
}

static void quantise(struct build *b)
{
    const struct obj_model *m = b->model;
    for (uint32_t i = 0; i < m->positions; i++) {
        if (!b->used[i]) continue;
        const struct point3 p = place(b, m->position[i]);
        const double unit = ldexp(1, b->scale);
        lmb_vec *q = &b->quantised[i];
        q->x = (int16_t)lround(p.x / unit);
        q->y = (int16_t)lround(p.y / unit);
        q->z = (int16_t)lround(p.z / unit);
        struct point3 back = {q->x * unit, q->y * unit, q->z * unit};
        b->info->position_error = fmax(b->info->position_error, point3_length(point3_minus(back, p)));
    }
}

/* ------------------------------------------------------------------------------------------------------- faces into triangles */

static struct point3 corner_at(const struct build *b, uint32_t corner)
{
    return b->model->position[b->model->corner[corner].position];
}

/* Twice the area times the unit normal. */
static struct point3 triangle_area2(const struct build *b, const struct triangle *t)
{
    const struct point3 p = corner_at(b, t->corner[0]);
    return point3_cross(point3_minus(corner_at(b, t->corner[1]), p), point3_minus(corner_at(b, t->corner[2]), p));
}

/* NULL, or in which way the triangle is degenerate. */
static const char *degenerate(const struct build *b, const struct triangle *t)
{
    struct point3 p[3];
    lmb_vec q[3];
    double magnitude = 0, size = 0;
    for (int k = 0; k < 3; k++) {
        p[k] = corner_at(b, t->corner[k]);
        q[k] = b->quantised[b->model->corner[t->corner[k]].position];
        magnitude = fmax(magnitude, point3_largest(p[k]));
    }
    for (int k = 0; k < 3; k++) {
        const struct point3 edge = point3_minus(p[(k + 1) % 3], p[k]);
        if (point3_largest(edge) <= 0) return "two corners in one place";
        size = fmax(size, point3_length(edge));
    }
    if (!(point3_length(triangle_area2(b, t)) > point3_flat_limit(magnitude, size))) return "corners in one line";
    const int64_t ux = q[1].x - q[0].x, uy = q[1].y - q[0].y, uz = q[1].z - q[0].z;
    const int64_t vx = q[2].x - q[0].x, vy = q[2].y - q[0].y, vz = q[2].z - q[0].z;
    if (uy * vz != uz * vy || uz * vx != ux * vz || ux * vy != uy * vx) return NULL;
    return "no area left at 16 bits a coordinate";
}

static int cut_face(struct build *b, uint32_t number)
{
    static const char *const text[] = {
        [POLYGON_NO_AREA] = "face without area",
        [POLYGON_CROSSED] = "the outline of the face crosses itself",
        [POLYGON_TOO_MANY] = "concave face with too many corners to cut into triangles",
    };
    const struct obj_face *face = &b->model->face[number];
    for (uint32_t k = 0; k < face->corners; k++) b->outline[k] = corner_at(b, face->first + k);
    const enum polygon_verdict verdict = polygon_cut(b->outline, face->corners, b->cut);
    if (verdict != POLYGON_CUT) {
        if (!b->options->drop_degenerate) return fail(b, face->line, "degenerate: %s " DROP_HINT, text[verdict]);
        b->info->dropped++;
        return 0;
    }
    for (uint32_t i = 0; i + 2 < face->corners; i++) {
        struct triangle t = {{face->first + b->cut[i][0], face->first + b->cut[i][1], face->first + b->cut[i][2]}, number};
        const char *why = degenerate(b, &t);
        if (!why) {
            b->triangle[b->triangles++] = t;
        } else if (b->options->drop_degenerate) {
            b->info->dropped++;
        } else {
            return fail(b, face->line, "degenerate triangle: %s " DROP_HINT, why);
        }
    }
    return 0;
}

static int cut_faces(struct build *b)
{
    uint32_t most = 3;
    for (uint32_t i = 0; i < b->model->faces; i++) {
        if (b->model->face[i].corners > most) most = b->model->face[i].corners;
    }
    b->outline = room_for(most, sizeof *b->outline);
    b->cut = room_for(most, sizeof *b->cut);
    b->triangle = room_for(b->model->corners, sizeof *b->triangle);
    if (!b->outline || !b->cut || !b->triangle) return fail(b, b->model->face[0].line, "out of memory");
    for (uint32_t i = 0; i < b->model->faces; i++) {
        if (cut_face(b, i)) return -1;
    }
    if (b->triangles == 0) return fail(b, b->model->face[0].line, "all triangles are degenerate");
    if (b->triangles > UINT32_MAX / 8) return fail(b, b->model->face[0].line, "too many triangles");
    return 0;
}

/* -------------------------------------------------------------------------------------------------------------------- normals */

static void add_normal(struct build *b, uint32_t corner, struct point3 unit, double weight)
{
    const uint32_t v = b->model->corner[corner].position;
    b->sum[v] = point3_plus_times(b->sum[v], unit, weight);
    b->weight[v] += weight;
}

/* By angle: triangle by triangle, which comes to the same however a flat face is cut. */
static void sum_by_angle(struct build *b)
{
    for (uint32_t i = 0; i < b->triangles; i++) {
        const struct triangle *t = &b->triangle[i];
        const struct point3 unit = point3_unit(triangle_area2(b, t));
        if (b->model->corner[t->corner[0]].normal != OBJ_NONE) continue;
        for (int k = 0; k < 3; k++) {
            const struct point3 p = corner_at(b, t->corner[k]);
            const struct point3 u = point3_unit(point3_minus(corner_at(b, t->corner[(k + 1) % 3]), p));
            const struct point3 v = point3_unit(point3_minus(corner_at(b, t->corner[(k + 2) % 3]), p));
            add_normal(b, t->corner[k], unit, atan2(point3_length(point3_cross(u, v)), point3_dot(u, v)));
        }
    }
}

/* By area: face by face, since the number of triangles that meet in a corner depends on how the face is cut. */
static void sum_by_area(struct build *b)
{
    const struct obj_model *m = b->model;
    for (uint32_t i = 0; i < b->triangles; i++) {
        const struct obj_face *face = &m->face[b->triangle[i].face];
        const bool done = i > 0 && b->triangle[i - 1].face == b->triangle[i].face;
        if (done || m->corner[face->first].normal != OBJ_NONE) continue;
        for (uint32_t k = 0; k < face->corners; k++) b->outline[k] = corner_at(b, face->first + k);
        const struct point3 area2 = polygon_area2(b->outline, face->corners);
        for (uint32_t k = 0; k < face->corners; k++) add_normal(b, face->first + k, point3_unit(area2), point3_length(area2));
    }
}

/* Sums that cancelled out up to rounding become zero, the others unit. */
static int find_normals(struct build *b)
{
    b->sum = room_for(b->model->positions, sizeof *b->sum);
    b->weight = room_for(b->model->positions, sizeof *b->weight);
    if (!b->sum || !b->weight) return fail(b, b->model->face[0].line, "out of memory");
    if (b->options->normals == MESH_WEIGHT_AREA) {
        sum_by_area(b);
    } else {
        sum_by_angle(b);
    }
    for (uint32_t i = 0; i < b->model->positions; i++) {
        const struct point3 zero = {0, 0, 0};
        b->sum[i] = point3_length(b->sum[i]) > 1e-9 * b->weight[i] ? point3_unit(b->sum[i]) : zero;
    }
    return 0;
}

static lmb_vec quantise_normal(struct point3 unit)
{
    lmb_vec q = {(int16_t)lround(unit.x * 16384), (int16_t)lround(unit.y * 16384), (int16_t)lround(unit.z * 16384)};
    return q;
}

static lmb_vec normal_of(struct build *b, const struct triangle *t, int k, struct point3 area2)
{
    const struct obj_corner *c = &b->model->corner[t->corner[k]];
    if (c->normal != OBJ_NONE) return quantise_normal(b->model->normal[c->normal]);
    if (point3_largest(b->sum[c->position]) > 0) return quantise_normal(b->sum[c->position]);
    b->info->cancelled++;
    return quantise_normal(point3_unit(area2));
}

static bool is_contrary(const struct build *b, const struct triangle *t, struct point3 area2)
{
    double along = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t normal = b->model->corner[t->corner[k]].normal;
        if (normal == OBJ_NONE) return false;
        along += point3_dot(b->model->normal[normal], point3_unit(area2));
    }
    return along < 0;
}

/* ---------------------------------------------------------------------------------------------------------- vertices, indices */

static bool same(lmb_vec a, lmb_vec b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/* FNV-1a over the six numbers, its high bits mixed into the low ones that pick the slot. */
static uint32_t hash(lmb_vec p, lmb_vec n)
{
    const int16_t part[6] = {p.x, p.y, p.z, n.x, n.y, n.z};
    uint32_t h = 2166136261u;
    for (int i = 0; i < 6; i++) h = (h ^ (uint16_t)part[i]) * 16777619u;
    return h ^ h >> 15;
}

/* The number of a vertex, a new one if it is not there yet. */
static uint32_t vertex_number(struct build *b, lmb_vec p, lmb_vec n)
{
    uint32_t s = hash(p, n) & (b->slots - 1);
    while (b->slot[s] && !(same(b->positions[b->slot[s] - 1], p) && same(b->normals[b->slot[s] - 1], n))) {
        s = (s + 1) & (b->slots - 1);
    }
    if (!b->slot[s]) {
        b->positions[b->vertices] = p;
        b->normals[b->vertices] = n;
        b->slot[s] = ++b->vertices;
    }
    return b->slot[s] - 1;
}

/* Counts on past the limit, so that the message can say how many vertices there are. */
static int merge_vertices(struct build *b)
{
    const uint32_t most = 3 * b->triangles;
    for (b->slots = 16; b->slots < most + most / 2; b->slots *= 2) continue;
    b->slot = room_for(b->slots, sizeof *b->slot);
    b->positions = room_for(most, sizeof *b->positions);
    b->normals = room_for(most, sizeof *b->normals);
    b->indices = room_for(most, sizeof *b->indices);
    if (!b->slot || !b->positions || !b->normals || !b->indices) return fail(b, b->model->face[0].line, "out of memory");
    for (uint32_t i = 0; i < b->triangles; i++) {
        const struct triangle *t = &b->triangle[i];
        const struct point3 area2 = triangle_area2(b, t);
        if (is_contrary(b, t, area2)) b->info->contrary++;
        for (int k = 0; k < 3; k++) {
            const lmb_vec p = b->quantised[b->model->corner[t->corner[k]].position];
            b->indices[3 * i + (uint32_t)k] = (uint16_t)vertex_number(b, p, normal_of(b, t, k, area2));
        }
        if (b->vertices > MESH_VERTICES_MAX && !b->first_excess_line) b->first_excess_line = b->model->face[t->face].line;
    }
    if (!b->first_excess_line) return 0;
    return fail(b, b->first_excess_line, "more than %d vertices from here on: the model has %lu (pairs of position and normal)",
                MESH_VERTICES_MAX, (unsigned long)b->vertices);
}

/* ------------------------------------------------------------------------------------------------------------- the whole mesh */

static int build_all(struct build *b)
{
    b->quantised = room_for(b->model->positions, sizeof *b->quantised);
    b->used = room_for(b->model->positions, sizeof *b->used);
    if (!b->quantised || !b->used) return fail(b, b->model->face[0].line, "out of memory");
    measure(b);
    if (choose_scale(b)) return -1;
    quantise(b);
    if (cut_faces(b) || find_normals(b)) return -1;
    return merge_vertices(b);
}

int mesh_build(lmb_mesh *mesh, struct mesh_info *info, const struct obj_model *model, const struct mesh_options *options,
               FILE *errors)
{
    static const struct mesh_options plain = {MESH_WEIGHT_ANGLE, MESH_PLACE_KEEP, false};
    struct build b = {.model = model, .options = options ? options : &plain, .info = info, .errors = errors};
    memset(info, 0, sizeof *info);
    memset(mesh, 0, sizeof *mesh);
    const int result = build_all(&b);
    free(b.quantised);
    free(b.used);
    free(b.sum);
    free(b.weight);
    free(b.triangle);
    free(b.outline);
    free(b.cut);
    free(b.slot);
    if (result == 0) {
        lmb_mesh built = {b.positions, b.normals, b.indices, (uint16_t)b.vertices, b.triangles, (int8_t)b.scale, 0};
        *mesh = built;
        mesh->bend = lmb_mesh_bend(mesh);
    } else {
        free(b.positions);
        free(b.normals);
        free(b.indices);
    }
    return result;
}

static void note(FILE *notes, const char *path, uint32_t count, const char *what)
{
    if (count > 0) fprintf(notes, "%s: note: %lu %s\n", path, (unsigned long)count, what);
}

void mesh_print_notes(const struct mesh_info *info, const char *path, FILE *notes)
{
    note(notes, path, info->unused, "v not used by any face, left out");
    note(notes, path, info->dropped, "degenerate, left out");
    note(notes, path, info->cancelled, "corners whose normals cancel out, given the normal of their face");
    note(notes, path, info->contrary, "triangles wind clockwise about their vn: they are culled when those face the viewer");
}

unsigned long mesh_bytes(const lmb_mesh *mesh)
{
    return 2UL * sizeof(lmb_vec) * mesh->vertices + 3UL * sizeof(uint16_t) * mesh->triangles;
}

void mesh_free(lmb_mesh *mesh)
{
    free((void *)(uintptr_t)mesh->positions);
    free((void *)(uintptr_t)mesh->normals);
    free((void *)(uintptr_t)mesh->indices);
    memset(mesh, 0, sizeof *mesh);
}
