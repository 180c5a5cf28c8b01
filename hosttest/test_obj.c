/* SPDX-License-Identifier: MIT */
/* Outlines cut into triangles, and meshes built from faces in memory: port/host/polygon.c and port/host/mesh_build.c.
 *
 * A cut is right when its triangles all have area and wind like the outline, are corners - 2 in number, and their areas add up
 * to the outline's: then they neither overlap nor leave anything out. The reader and the tool are tested by test_obj.sh.
 */
#include "../port/host/mesh_build.h"
#include "test.h"

#include <string.h>

#define CORNERS 200
#define PI 3.14159265358979323846

/* A plane in space: coordinates (u, v) to a point. */
struct plane {
    struct point3 origin, u, v;
};

static struct point3 in_plane(const struct plane *plane, double u, double v)
{
    return point3_plus_times(point3_plus_times(plane->origin, plane->u, u), plane->v, v);
}

static struct plane random_plane(test_random *r)
{
    struct plane p;
    struct point3 a = {test_real(r, -1, 1), test_real(r, -1, 1), test_real(r, -1, 1)};
    struct point3 b = {test_real(r, -1, 1), test_real(r, -1, 1), test_real(r, -1, 1)};
    struct point3 o = {test_real(r, -9, 9), test_real(r, -9, 9), test_real(r, -9, 9)};
    p.origin = o;
    p.u = point3_unit(a);
    p.v = point3_unit(point3_cross(p.u, b));
    return p;
}

/* 0 if the cut is right; otherwise what is wrong: 1 not cut, 2 a triangle is flat or winds the other way, 3 the areas do not
 * add up. */
static int cut_fault(const struct point3 *corner, uint32_t corners)
{
    static uint32_t cut[CORNERS * 4][3];
    const struct point3 area2 = polygon_area2(corner, corners), normal = point3_unit(area2);
    double sum = 0;
    if (polygon_cut(corner, corners, cut) != POLYGON_CUT) return 1;
    for (uint32_t i = 0; i + 2 < corners; i++) {
        const struct point3 triangle[3] = {corner[cut[i][0]], corner[cut[i][1]], corner[cut[i][2]]};
        const double part = point3_dot(polygon_area2(triangle, 3), normal);
        if (part < 1e-9) return 2;
        sum += part;
    }
    return fabs(sum - point3_length(area2)) > 1e-9 * sum ? 3 : 0;
}

/* Seen from a point inside, every corner is in sight: concave almost always, never crossing itself. */
static void test_stars(test_random *r)
{
    struct point3 corner[CORNERS];
    unsigned long faults = 0, cuts = 0;
    int kind = 0;
    for (int round = 0; round < 20000; round++) {
        const struct plane plane = random_plane(r);
        const uint32_t corners = (uint32_t)test_integer(r, 4, round % 100 ? 12 : CORNERS);
        for (uint32_t i = 0; i < corners; i++) {
            const double angle = 2 * PI * (i + test_real(r, 0, 0.9)) / corners, radius = test_real(r, 0.05, 1);
            corner[i] = in_plane(&plane, radius * cos(angle), radius * sin(angle));
        }
        const int fault = cut_fault(corner, corners);
        faults += fault != 0;
        if (fault) kind = fault;
        cuts++;
    }
    test_verdict(faults == 0, "polygon stars", "%lu of %lu star-shaped outlines cut wrongly (last fault %d)", faults, cuts, kind);
}

/* Combs: long teeth, of which a fan sees almost nothing; corners in line along the tips and the back. */
static void test_combs(test_random *r)
{
    struct point3 corner[CORNERS];
    unsigned long faults = 0;
    int kind = 0;
    for (int round = 0; round < 2000; round++) {
        const struct plane plane = random_plane(r);
        const uint32_t teeth = (uint32_t)test_integer(r, 2, 40), turn = (uint32_t)test_integer(r, 0, 2 * (int64_t)teeth + 1);
        const uint32_t corners = 2 * teeth + 2;
        for (uint32_t i = 0; i < corners; i++) {
            const uint32_t k = (i + turn) % corners;
            const double u = k < 2 ? (k == 0 ? 0 : 2.0 * teeth) : 2.0 * teeth + 1 - k, v = k < 2 ? 0 : k % 2 ? 1 : 8;
            corner[i] = in_plane(&plane, u, v);
        }
        const int fault = cut_fault(corner, corners);
        faults += fault != 0;
        if (fault) kind = fault;
    }
    test_verdict(faults == 0, "polygon combs", "%lu of 2000 combs cut wrongly (last fault %d)", faults, kind);
}

/* A square with a square hole, joined by a bridge that is walked there and back. */
static void test_bridge(test_random *r)
{
    static const double uv[10][2] = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}};
    struct point3 corner[10];
    int faults = 0, kind = 0;
    for (int round = 0; round < 1000; round++) {
        const struct plane plane = random_plane(r);
        const int turn = round % 10;
        for (int i = 0; i < 10; i++) corner[i] = in_plane(&plane, uv[(i + turn) % 10][0], uv[(i + turn) % 10][1]);
        const int fault = cut_fault(corner, 10);
        faults += fault != 0;
        if (fault) kind = fault;
    }
    test_verdict(faults == 0, "polygon hole", "%d of 1000 squares with a hole cut wrongly (last fault %d)", faults, kind);
}

/* The outline of a random patch of squares, grown from one: all its corners on a grid, most of them in line with others, and
 * touching itself where squares meet at a corner only. Walked with the patch on the left, turning right wherever possible.
 * Returns the number of corners, or 0 if the patch has a hole that does not touch the outside. */
#define GRID 7

static uint32_t patch_outline(test_random *r, int uv[CORNERS][2])
{
    static const int step[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}; /* counter-clockwise */
    static const int left[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}, right[4][2] = {{0, -1}, {0, 0}, {-1, 0}, {-1, -1}};
    unsigned char cell[GRID + 2][GRID + 2] = {{0}}; /* [y][x], with an empty border */
    int squares = (int)test_integer(r, 2, GRID * GRID / 2), x = 1, y = 1, direction = 0, area2 = 0, first = -1;
    uint32_t corners = 0;
    cell[GRID / 2][GRID / 2] = 1;
    for (int grown = 1; grown < squares;) {
        const int i = (int)test_integer(r, 1, GRID), j = (int)test_integer(r, 1, GRID);
        if (cell[i][j] || !(cell[i - 1][j] || cell[i + 1][j] || cell[i][j - 1] || cell[i][j + 1])) continue;
        cell[i][j] = 1;
        grown++;
    }
    while (!cell[y][x]) x = x == GRID ? (y++, 1) : x + 1; /* the lowest square: its lower edge is on the outline */
    const int start_x = x, start_y = y;
    do {
        if (corners == CORNERS) return 0;
        uv[corners][0] = x;
        uv[corners++][1] = y;
        x += step[direction][0];
        y += step[direction][1];
        area2 += (x - step[direction][0]) * y - x * (y - step[direction][1]);
        for (int turn = 3; turn <= 5; turn++) { /* right, straight on, left */
            const int d = (direction + turn) % 4;
            if (cell[y + left[d][1]][x + left[d][0]] && !cell[y + right[d][1]][x + right[d][0]]) {
                direction = d;
                break;
            }
        }
        first = x == start_x && y == start_y && direction == 0;
    } while (!first);
    return area2 == 2 * squares ? corners : 0;
}

static void test_patches(test_random *r)
{
    static int uv[CORNERS][2];
    struct point3 corner[CORNERS];
    unsigned long faults = 0, cuts = 0;
    int kind = 0;
    while (cuts < 20000) {
        const struct plane plane = random_plane(r);
        const uint32_t corners = patch_outline(r, uv), shift = (uint32_t)test_integer(r, 0, CORNERS);
        if (corners == 0) continue;
        for (uint32_t i = 0; i < corners; i++) {
            const int *at = uv[(i + shift) % corners];
            corner[i] = in_plane(&plane, at[0], at[1]);
        }
        const int fault = cut_fault(corner, corners);
        faults += fault != 0;
        if (fault) kind = fault;
        cuts++;
    }
    test_verdict(faults == 0, "polygon patches", "%lu of %lu outlines on a grid cut wrongly (last fault %d)", faults, cuts, kind);
}

static void test_refusals(void)
{
    uint32_t cut[8][3];
    const struct point3 line[4] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    const struct point3 bow[4] = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    const struct point3 cross[5] = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, -1, 0}, {0, 3, 0}};
    const int got[3] = {(int)polygon_cut(line, 4, cut), (int)polygon_cut(bow, 4, cut), (int)polygon_cut(cross, 5, cut)};
    test_verdict(got[0] == POLYGON_NO_AREA && got[1] == POLYGON_NO_AREA && got[2] == POLYGON_CROSSED, "polygon refusals",
                 "line %d, bow tie %d, crossing %d", got[0], got[1], got[2]);
}

/* A sphere of faces in memory, anywhere and of any size. */
#define RINGS 24
#define AROUND 48

struct ball {
    struct point3 position[RINGS * AROUND + 2];
    uint32_t line[RINGS * AROUND + 2];
    struct obj_corner corner[4 * (RINGS + 1) * AROUND];
    struct obj_face face[(RINGS + 1) * AROUND];
    struct obj_model model;
};

static uint32_t ball_position(int ring, int around)
{
    if (ring < 0) return RINGS * AROUND;
    if (ring >= RINGS) return RINGS * AROUND + 1;
    return (uint32_t)(ring * AROUND + around % AROUND);
}

static void make_ball(struct ball *b, struct point3 middle, double radius)
{
    memset(b, 0, sizeof *b);
    for (int ring = -1; ring <= RINGS; ring++) {
        for (int a = 0; a < AROUND; a++) {
            const double down = PI * (ring + 1) / (RINGS + 1), turn = 2 * PI * a / AROUND;
            const struct point3 out = {sin(down) * sin(turn), cos(down), sin(down) * cos(turn)};
            b->position[ball_position(ring, a)] = point3_plus_times(middle, out, radius);
        }
    }
    static char name[] = "ball";
    struct obj_model model = {.path = name, .position = b->position, .position_line = b->line};
    model.corner = b->corner;
    model.face = b->face;
    model.positions = RINGS * AROUND + 2;
    for (int ring = 0; ring <= RINGS; ring++) {
        for (int a = 0; a < AROUND; a++) {
            struct obj_face face = {model.corners, 0, 1};
            const uint32_t p[4] = {ball_position(ring - 1, a), ball_position(ring, a), ball_position(ring, a + 1),
                                   ball_position(ring - 1, a + 1)};
            for (int k = 0; k < 4; k++) {
                if ((k == 3 && ring == 0) || (k == 2 && ring == RINGS)) continue;
                const struct obj_corner corner = {p[k], OBJ_NONE};
                b->corner[face.first + face.corners++] = corner;
            }
            model.corners += face.corners;
            b->face[model.faces++] = face;
        }
    }
    b->model = model;
}

/* The angle between a mesh normal and the direction from the ball's middle, and the length's distance from one. */
static void measure_normals(const lmb_mesh *mesh, const struct mesh_info *info, struct point3 middle, double *angle,
                            double *length)
{
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        const lmb_vec p = mesh->positions[i], n = mesh->normals[i];
        const double unit = ldexp(1, mesh->scale);
        struct point3 at = {p.x * unit, p.y * unit, p.z * unit}, normal = {n.x / 16384.0, n.y / 16384.0, n.z / 16384.0};
        const struct point3 file = point3_plus_times(info->offset, at, 1 / info->factor);
        const struct point3 out = point3_unit(point3_minus(file, middle));
        *angle = fmax(*angle, point3_length(point3_minus(point3_unit(normal), out)));
        *length = fmax(*length, fabs(point3_length(normal) - 1));
    }
}

/* A corner's normal lies among those of the faces around it, which are no farther off than half a face's diagonal. */
static void test_balls(test_random *r)
{
    const double ring = PI / (RINGS + 1), around = 2 * PI / AROUND, bound = sqrt(ring * ring + around * around) / 2;
    static struct ball ball;
    double angle[2] = {0, 0}, length = 0, error = 0, reach = 32767;
    int failed = 0, wrong = 0;
    for (int round = 0; round < 300; round++) {
        const double radius = exp(test_real(r, -6, 6));
        struct point3 middle = {test_real(r, -1, 1) * radius, test_real(r, -1, 1) * radius, test_real(r, -1, 1) * radius};
        const enum mesh_weight weight = round & 1 ? MESH_WEIGHT_AREA : MESH_WEIGHT_ANGLE;
        const struct mesh_options options = {weight, (enum mesh_place)(round % 3), false};
        struct mesh_info info;
        lmb_mesh mesh;
        int16_t largest = 0;
        make_ball(&ball, middle, radius);
        if (mesh_build(&mesh, &info, &ball.model, &options, stdout)) {
            failed++;
            continue;
        }
        measure_normals(&mesh, &info, middle, &angle[weight], &length);
        for (uint32_t i = 0; i < mesh.vertices; i++) {
            const int16_t part[3] = {mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z};
            for (int k = 0; k < 3; k++) largest = (int16_t)(abs(part[k]) > largest ? abs(part[k]) : largest);
        }
        reach = fmin(reach, largest);
        error = fmax(error, info.position_error / ldexp(1, mesh.scale));
        wrong += mesh.vertices != RINGS * AROUND + 2 || mesh.triangles != 2 * RINGS * AROUND;
        mesh_free(&mesh);
    }
    test_verdict(failed == 0 && wrong == 0, "balls built", "%d refused, %d of other than %d vertices and %d triangles", failed,
                 wrong, RINGS * AROUND + 2, 2 * RINGS * AROUND);
    test_verdict(length <= 0.8661 / 16384, "balls unit normals", "length off by %.3f/16384 at most, want sqrt(3)/2",
                 length * 16384);
    test_verdict(angle[MESH_WEIGHT_ANGLE] <= bound, "balls normals by angle", "%.5f from the sphere's at most, bound %.5f",
                 angle[MESH_WEIGHT_ANGLE], bound);
    test_verdict(angle[MESH_WEIGHT_AREA] <= bound, "balls normals by area", "%.5f from the sphere's at most, bound %.5f",
                 angle[MESH_WEIGHT_AREA], bound);
    test_verdict(error <= 0.8661, "balls positions", "off by %.3f mesh units at most, want sqrt(3)/2", error);
    test_verdict(reach > 16383, "balls scale", "largest coordinate at least %.0f", reach);
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    test_stars(&r);
    test_combs(&r);
    test_bridge(&r);
    test_patches(&r);
    test_refusals();
    test_balls(&r);
    return test_end();
}
