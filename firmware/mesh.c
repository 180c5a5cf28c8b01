/* SPDX-License-Identifier: MIT */
/* Meshes into triangles: the walk over what may be seen, and painter's order. */
#include "flash.h"

#include "clip.h"
#include "screen.h"
#include "shade.h"
#include "triangle.h"
#include "vec.h"

#define PLAIN_MAX (2046 * 16) /* 1/16 pixel: the products of a cross product fit, as they are compared and not subtracted */
LMB_STATIC_ASSERT((uint32_t)PLAIN_MAX *PLAIN_MAX <= (uint32_t)INT32_MAX);

static bool is_flat(const lmb_walk *walk) { return LMB_WITH_CORNERS && walk->look->model == LMB_MODEL_FLAT; }

/* lmb_row_at: corners up to above have no row below the window's first edge, those from below on none above its last. */
typedef struct rows {
    int32_t above, below;
} rows;

static inline rows rows_of(const lmb_window *w)
{
    rows r;
    r.above = lmb_add(lmb_shl(w->top, 4), 8);
    r.below = lmb_sub(lmb_shl(w->bottom, 4), 7);
    return r;
}

static inline bool misses(rows r, int32_t a, int32_t b, int32_t c)
{
    return a <= r.above ? b <= r.above && c <= r.above : a >= r.below && b >= r.below && c >= r.below;
}

#if LMB_SHORT_CUTS

/* Whether triangles are simply read, one after the other: with corners projected before, all of them in columns of the window and in
 * rows so near that two products of a cross product fit. LMB_NOT_ON_SCREEN is in no window. */
static bool is_plain(lmb_walk *walk)
{
    const lmb_window *w = walk->window;
    const lmb_vertex *v = walk->vertices, *end;
    const int32_t left = lmb_shl(w->left, 4), right = lmb_shl(w->right, 4), top = lmb_shl(w->top, 4),
                  bottom = lmb_shl(w->bottom, 4);
    if (!v || walk->order || is_flat(walk) || right - left >= PLAIN_MAX) return false;
    end = v + walk->screen.mesh->vertices;
    while (v != end && v->x >= left && v->x <= right && v->y >= top && v->y <= bottom) v++;
    if (v == end && bottom - top < PLAIN_MAX) {
        walk->strip = false;
        return true;
    }
    for (v = walk->vertices; v != end && v->x >= left && v->x <= right; v++) {
        if ((uint32_t)lmb_add(v->y, PLAIN_MAX / 2) >= PLAIN_MAX) return false;
    }
    walk->strip = walk->strip || v == end;
    return v == end;
}

/* The next triangle of such a mesh that has rows in the window. */
static bool next_in_strip(lmb_walk *walk, lmb_triangle *triangle)
{
    const LMB_FLASH uint16_t *index = walk->plain, *const end = walk->end;
    const lmb_vertex *const v = walk->vertices;
    const rows window = rows_of(walk->window);
    triangle->inside = true;
    while (index != end) {
        const lmb_vertex *a = &v[*index++], *b = &v[*index++], *c = &v[*index++];
        const int32_t x = a->x, y = a->y;
        if (misses(window, y, b->y, c->y)) continue;
        if (lmb_mul(lmb_sub(b->x, x), lmb_sub(c->y, y)) >= lmb_mul(lmb_sub(c->x, x), lmb_sub(b->y, y))) continue;
        walk->plain = index;
        if (lmb_triangle_front(triangle, a, b, c, walk->window)) return true;
    }
    walk->plain = end;
    return false;
}

/* The next triangle of one that lies wholly in the window. */
static bool next_plain(lmb_walk *walk, lmb_triangle *triangle)
{
    const LMB_FLASH uint16_t *index = walk->plain, *const end = walk->end;
    const lmb_vertex *const v = walk->vertices;
    if (walk->strip) return next_in_strip(walk, triangle);
    triangle->inside = true;
    while (index != end) {
        const lmb_vertex *a = &v[*index++], *b = &v[*index++], *c = &v[*index++];
        const int32_t x = a->x, y = a->y;
        if (lmb_mul(lmb_sub(b->x, x), lmb_sub(c->y, y)) >= lmb_mul(lmb_sub(c->x, x), lmb_sub(b->y, y))) continue;
        walk->plain = index;
        if (lmb_triangle_front(triangle, a, b, c, walk->window)) return true;
    }
    walk->plain = end;
    return false;
}

#endif

void lmb_mesh_begin(lmb_walk *walk, const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera, const lmb_look *look,
                    const lmb_window *window, const lmb_vertex *vertices, const uint16_t *order)
{
    walk->index = mesh->indices;
    walk->end = mesh->indices + (size_t)3 * mesh->triangles;
    walk->vertices = vertices;
    walk->look = look;
    walk->window = window;
    walk->order = order;
    if (LMB_WITH_PERSPECTIVE) walk->corners = walk->fan = 0;
    lmb_rays_prepare(&walk->rays, look, &pose->rotation);
    if (mesh->bend) lmb_shade_bend(&walk->rays, look, mesh->bend);
    walk->screen.mesh = mesh;
    walk->screen.pose = pose;
    walk->screen.camera = camera;
    if (!vertices) lmb_screen_begin(&walk->screen);
#if LMB_SHORT_CUTS
    /* less than the frame, whose middle the camera looks at, and rows are known before corners are */
    walk->strip = (window->top > 0 || lmb_shl(window->bottom, 3) < camera->y) && (vertices || lmb_screen_direct(&walk->screen));
    walk->plain = walk->end;
    if (is_plain(walk)) {
        walk->plain = walk->index;
        walk->index = walk->end;
    }
#endif
}

/* Bits that edges keep for the cross product: two products of 14 bits each, less than 2^29. */
#define FACE_BITS 14

/* The normal of a face, from its corners: the cross product of two edges, normalised. Without area: some unit vector. */
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

static bool off_screen(const lmb_vertex *const corner[3])
{
    return corner[0]->x == LMB_NOT_ON_SCREEN || corner[1]->x == LMB_NOT_ON_SCREEN || corner[2]->x == LMB_NOT_ON_SCREEN;
}

/* Cuts a triangle that is not wholly on the screen; the walk hands the polygon out as a fan. */
static LMB_APART void clip(lmb_walk *walk, const LMB_FLASH uint16_t *index, const lmb_vertex *const corner[3])
{
    lmb_corner polygon[LMB_CLIP_MAX + 1];
    unsigned i;
    for (i = 0; i < 3; i++) {
        polygon[i].p = lmb_mesh_place(walk->screen.mesh, walk->screen.pose, index[i]);
        polygon[i].screen = *corner[i];
    }
    walk->corners = (uint8_t)lmb_clip(walk->screen.camera, polygon, walk->polygon);
    walk->fan = 1;
}

/* Whether a triangle that is not read simply is known to have no row in the window. */
static bool is_missed(const lmb_walk *walk, const LMB_FLASH uint16_t *index)
{
    int32_t y[3];
    unsigned i;
    if (!LMB_SHORT_CUTS || !walk->strip) return false;
    for (i = 0; i < 3; i++) {
        if (!walk->vertices) {
            y[i] = lmb_screen_y(&walk->screen, index[i]);
        } else {
            const lmb_vertex *v = &walk->vertices[index[i]];
            if (LMB_SCREEN_EXACT && v->x == LMB_NOT_ON_SCREEN) return false;
            y[i] = v->y;
        }
    }
    return misses(rows_of(walk->window), y[0], y[1], y[2]);
}

/* The corners of the next triangle: of a clipped one's next piece, of the next one in order, projected on the way, with the
 * normal of their face, as the case may be; and its indices. False at the end. */
static bool take(lmb_walk *walk, const lmb_vertex *corner[3], const LMB_FLASH uint16_t **indices)
{
    const LMB_FLASH uint16_t *index;
    unsigned i;
    if (LMB_WITH_PERSPECTIVE && walk->fan + 1 < walk->corners) {
        corner[0] = &walk->polygon[0];
        corner[1] = &walk->polygon[walk->fan++];
        corner[2] = &walk->polygon[walk->fan];
        return true;
    }
    do {
        index = walk->index;
        if (index == walk->end) return false;
        walk->index = index + 3;
        if (walk->order) index = walk->screen.mesh->indices + (size_t)3 * *walk->order++;
    } while (is_missed(walk, index));
    *indices = index;
    if (!walk->vertices) lmb_screen_project(&walk->screen, index, 3, walk->polygon);
    for (i = 0; i < 3; i++) {
        corner[i] = walk->vertices ? &walk->vertices[index[i]] : &walk->polygon[i];
        if (!is_flat(walk)) continue;
        if (walk->vertices) walk->polygon[i] = *corner[i];
        walk->polygon[i].normal = face_normal(walk->screen.mesh, index);
        corner[i] = &walk->polygon[i];
    }
    return true;
}

/* The next triangle of any kind. */
static LMB_APART bool next_of_any(lmb_walk *walk, lmb_triangle *triangle)
{
    const lmb_vertex *corner[3];
    const LMB_FLASH uint16_t *index = walk->index;
    while (take(walk, corner, &index)) {
        if (LMB_SCREEN_EXACT && off_screen(corner)) {
            if (LMB_WITH_PERSPECTIVE) clip(walk, index, corner);
        } else if (lmb_triangle_seen(triangle, corner[0], corner[1], corner[2], walk->window)) {
            return true;
        }
    }
    return false;
}

bool lmb_mesh_next(lmb_walk *walk, lmb_triangle *triangle)
{
    triangle->look = walk->look;
    triangle->rays = &walk->rays;
#if LMB_SHORT_CUTS
    if (next_plain(walk, triangle)) return true;
#endif
    return next_of_any(walk, triangle);
}

uint16_t lmb_mesh_bend(const lmb_mesh *mesh)
{
    const LMB_FLASH uint16_t *index = mesh->indices, *end = index + (size_t)3 * mesh->triangles;
    int32_t most = 0;
    unsigned i;
    for (; index != end; index += 3) {
        for (i = 0; i < 3; i++) {
            const lmb_vec a = mesh->normals[index[i]], b = mesh->normals[index[i == 2 ? 0 : i + 1]];
            most = lmb_max(most, lmb_vec_half_distance_q28(&a, &b));
        }
    }
    return (uint16_t)lmb_max(1, lmb_min(65535, lmb_add(lmb_shr(most, 13), 1)));
}

/* How near a triangle is: the sum of its corners along the view axis, in mesh units; the pose's place is common to all. */
static int16_t nearness(const lmb_mesh *mesh, const lmb_pose *pose, uint32_t triangle)
{
    const LMB_FLASH uint16_t *index = mesh->indices + (size_t)3 * triangle;
    int32_t sum = 0;
    int i;
    for (i = 0; i < 3; i++) {
        lmb_vec room;
        int32_t turned = lmb_vec_dot_q28(&pose->rotation.row[2], lmb_vec_read(&mesh->positions[index[i]], &room));
        sum = lmb_add(sum, lmb_shr(turned, 2));
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
