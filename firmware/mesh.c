/* SPDX-License-Identifier: MIT */
/* Meshes into triangles: pose, projection, the walk over what may be seen, and painter's order. */
#include "flash.h"

#include "clip.h"
#include "triangle.h"
#include "vec.h"

#define NOT_ON_SCREEN INT32_MIN /* x of a corner that must be clipped */

lmb_point lmb_mesh_place(const lmb_mesh *mesh, const lmb_pose *pose, uint32_t i)
{
    int32_t turned[3];
    lmb_vec room;
    /* Q.14 in mesh units to Q16.16 in units: times 2^(scale + 2), and scale <= -2 */
    unsigned down = (unsigned)-(mesh->scale + 2);
    int32_t half = lmb_shr(lmb_shl(1, down), 1);
    lmb_point p;
    lmb_vec_rotate_wide(&pose->rotation, lmb_vec_read(&mesh->positions[i], &room), turned);
    p.x = lmb_add(pose->x, lmb_shr(lmb_add(turned[0], half), down));
    p.y = lmb_add(pose->y, lmb_shr(lmb_add(turned[1], half), down));
    p.z = lmb_add(pose->z, lmb_shr(lmb_add(turned[2], half), down));
    return p;
}

static bool beyond_guard(int32_t q4) { return q4 > LMB_GUARD_NEAR * 16L || q4 < -LMB_GUARD_NEAR * 16L; }

static void project(const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera, uint32_t i, lmb_vertex *vertex)
{
    lmb_vec room;
    lmb_vec_copy(&vertex->normal, lmb_vec_read(&mesh->normals[i], &room));
    if (!lmb_project(camera, lmb_mesh_place(mesh, pose, i), vertex) ||
        (LMB_WITH_PERSPECTIVE && (beyond_guard(lmb_sub(vertex->x, camera->x)) || beyond_guard(lmb_sub(vertex->y, camera->y))))) {
        vertex->x = NOT_ON_SCREEN;
    }
}

void lmb_mesh_project(const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera, lmb_vertex *vertices)
{
    uint32_t i;
    for (i = 0; i < mesh->vertices; i++) project(mesh, pose, camera, i, &vertices[i]);
}

void lmb_mesh_begin(lmb_walk *walk, const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera, const lmb_look *look,
                    const lmb_window *window, const lmb_vertex *vertices, const uint16_t *order)
{
    walk->mesh = mesh;
    walk->pose = pose;
    walk->camera = camera;
    walk->look = look;
    walk->vertices = vertices;
    walk->order = order;
    walk->window = window;
    walk->next = 0;
    walk->corners = walk->fan = 0;
    lmb_rays_prepare(&walk->rays, look, &pose->rotation);
}

/* Bits that edges keep for the cross product: two products of 14 bits each, less than 2^29. */
#define FACE_BITS 14

/* The normal of a face, from its corners: the cross product of two edges, normalised. Of a face without area: some unit vector.
 * */
static lmb_vec face_normal(const lmb_mesh *mesh, const LMB_FLASH uint16_t *index)
{
    const lmb_vec a = mesh->positions[index[0]], b = mesh->positions[index[1]], c = mesh->positions[index[2]];
    int32_t e[6], largest = 0;
    unsigned size, i;
    e[0] = lmb_sub(b.x, a.x);
    e[1] = lmb_sub(b.y, a.y);
    e[2] = lmb_sub(b.z, a.z);
    e[3] = lmb_sub(c.x, a.x);
    e[4] = lmb_sub(c.y, a.y);
    e[5] = lmb_sub(c.z, a.z);
    for (i = 0; i < 6; i++) largest |= e[i] < 0 ? -e[i] : e[i];
    size = 32u - lmb_clz32((uint32_t)largest);
    for (i = 0; i < 6 && size > FACE_BITS; i++) e[i] = lmb_shr_round(e[i], size - FACE_BITS);
    return lmb_normalise(lmb_sub(lmb_mul(e[1], e[5]), lmb_mul(e[2], e[4])), lmb_sub(lmb_mul(e[2], e[3]), lmb_mul(e[0], e[5])),
                         lmb_sub(lmb_mul(e[0], e[4]), lmb_mul(e[1], e[3])));
}

/* Cuts a triangle that is not wholly on the screen; the walk hands the polygon out as a fan. */
static void clip(lmb_walk *walk, const LMB_FLASH uint16_t *index)
{
    lmb_corner corner[3];
    int i;
    for (i = 0; i < 3; i++) {
        corner[i].p = lmb_mesh_place(walk->mesh, walk->pose, index[i]);
        corner[i].normal = LMB_WITH_CORNERS && walk->look->model == LMB_MODEL_FLAT ? face_normal(walk->mesh, index)
                                                                                   : walk->mesh->normals[index[i]];
    }
    walk->corners = (uint8_t)lmb_clip(walk->camera, corner, walk->polygon);
    walk->fan = 1;
}

/* For flat shading: the corners again, each with the normal of the face. */
static void flatten(lmb_walk *walk, const LMB_FLASH uint16_t *index, const lmb_vertex *corner[3])
{
    const lmb_vec normal = face_normal(walk->mesh, index);
    int i;
    for (i = 0; i < 3; i++) {
        if (corner[i] != &walk->polygon[i]) walk->polygon[i] = *corner[i];
        walk->polygon[i].normal = normal;
        corner[i] = &walk->polygon[i];
    }
}

bool lmb_mesh_next(lmb_walk *walk, lmb_triangle *triangle)
{
    triangle->look = walk->look;
    triangle->rays = &walk->rays;
    for (;;) {
        const lmb_vertex *corner[3];
        const LMB_FLASH uint16_t *index;
        int i;
        while (LMB_WITH_PERSPECTIVE && walk->fan + 1 < walk->corners) {
            unsigned k = walk->fan++;
            if (lmb_triangle_seen(triangle, &walk->polygon[0], &walk->polygon[k], &walk->polygon[k + 1], walk->window)) {
                return true;
            }
        }
        if (walk->next >= walk->mesh->triangles) return false;
        index = walk->mesh->indices + (size_t)3 * (walk->order ? walk->order[walk->next] : walk->next);
        walk->next++;
        walk->corners = 0;
        for (i = 0; i < 3; i++) {
            corner[i] = &walk->polygon[i];
            if (walk->vertices) {
                corner[i] = &walk->vertices[index[i]];
            } else {
                project(walk->mesh, walk->pose, walk->camera, index[i], &walk->polygon[i]);
            }
        }
        /* without clipping, lmb_triangle_begin drops it */
        if (LMB_WITH_PERSPECTIVE &&
            (corner[0]->x == NOT_ON_SCREEN || corner[1]->x == NOT_ON_SCREEN || corner[2]->x == NOT_ON_SCREEN)) {
            clip(walk, index);
            continue;
        }
        if (LMB_WITH_CORNERS && walk->look->model == LMB_MODEL_FLAT) flatten(walk, index, corner);
        if (lmb_triangle_seen(triangle, corner[0], corner[1], corner[2], walk->window)) { return true; }
    }
}

/* How near a triangle is: the sum of its corners along the view axis, in mesh units; the pose's place is common to all. */
static int16_t nearness(const lmb_mesh *mesh, const lmb_pose *pose, uint32_t triangle)
{
    const LMB_FLASH uint16_t *index = mesh->indices + (size_t)3 * triangle;
    int32_t sum = 0;
    int i;
    for (i = 0; i < 3; i++) {
        int32_t turned[3];
        lmb_vec room;
        lmb_vec_rotate_wide(&pose->rotation, lmb_vec_read(&mesh->positions[index[i]], &room), turned);
        sum = lmb_add(sum, lmb_shr(turned[2], 2));
    }
    return (int16_t)lmb_shr(sum, 15); /* |turned| < 2^30, |sum| < 3 * 2^28 < 2^30 */
}

int lmb_mesh_sort(const lmb_mesh *mesh, const lmb_pose *pose, uint16_t *order, int16_t *keys)
{
    uint32_t n = mesh->triangles, gap = 1, i;
    if (n > 65536) return LMB_ERROR_VALUE;
    for (i = 0; i < n; i++) {
        order[i] = (uint16_t)i;
        keys[i] = nearness(mesh, pose, i);
    }
    while (gap < n) gap = gap * 3 + 1; /* Shell's sort with Knuth's gaps: no recursion, no memory of its own */
    while (gap > 0) {
        for (i = gap; i < n; i++) {
            uint16_t moving = order[i];
            uint32_t j = i;
            for (; j >= gap && keys[order[j - gap]] > keys[moving]; j -= gap) order[j] = order[j - gap];
            order[j] = moving;
        }
        /* the gaps are 1, 4, 13, 40, ...: (gap - 1) / 3 without a division */
        {
            uint32_t next = 0;
            while (next * 3 + 1 < gap) next = next * 3 + 1;
            gap = next;
        }
    }
    return LMB_OK;
}
