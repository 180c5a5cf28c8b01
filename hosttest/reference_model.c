/* SPDX-License-Identifier: MIT */
/* The reference same_model: the library's own models, with its corners on the screen, in double.
 *
 * Coverage by edge functions in whole numbers, for every pixel of the bounding box; every term from the values at its nodes and
 * the pixel's barycentric coordinates. Nothing is stepped from pixel to pixel, so nothing accumulates.
 */
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define NODES 6       /* three corners, three mid-edges: 01, 12, 20 */
#define DEPTH_SLACK 2 /* depths of 16 bits: two that differ by less may come in either order */
#define P_MAX 2.0     /* 1 / sqrt(1 - u/2) at LMB_ARC_U_MAX, the most that a mid-edge value is the mean of its ends times */

typedef struct corner {
    int64_t x, y;
    double depth;
    ref_vec normal;
} corner;

/* A triangle on the screen, clockwise with y down, and the values that its pixels are made of. */
typedef struct shaded {
    const ref_shader *shader;
    corner corner[3];
    ref_vec face; /* normal of the mesh's face */
    int64_t area2;
    ref_terms node[NODES];
    int nodes;           /* 1: constant, 3: linear, 6: quadratic, 0: along arcs */
    bool lit;            /* nodes hold intensities rather than cosines */
    ref_vec left, right; /* of the current row: normals and places where the edges cross it */
    double left_x, right_x;
} shaded;

/* ------------------------------------------------------------------------------------------------------------------- coverage */

/* Twice the area of (a, b, p): above zero right of a -> b as the screen is seen, y down. */
static int64_t edge(const corner *a, const corner *b, int64_t x, int64_t y)
{
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

/* An edge of a clockwise triangle is a left one if it runs up, a top one if it runs level to the right. */
static bool is_top_left(const corner *a, const corner *b) { return b->y < a->y || (b->y == a->y && b->x > a->x); }

/* Whether the centre of pixel (x, y) is inside, and its barycentric coordinates. */
static bool covers(const shaded *m, int64_t x, int64_t y, double weight[3])
{
    int k;
    for (k = 0; k < 3; k++) {
        const corner *a = &m->corner[(k + 1) % 3], *b = &m->corner[(k + 2) % 3];
        int64_t e = edge(a, b, 16 * x + 8, 16 * y + 8);
        if (e < 0 || (e == 0 && !is_top_left(a, b))) return false;
        weight[k] = (double)e / (double)m->area2;
    }
    return true;
}

/* --------------------------------------------------------------------------------------------------------------------- values */

/* The mid-edge normal is the normalised sum of two unit ones. Where they are more than 120 degrees apart, where the sum gets
 * short and then loses its direction, it is that sum itself: as documented in firmware/shade.c. */
static ref_vec mid_normal(ref_vec a, ref_vec b)
{
    ref_vec sum = ref_add(a, b);
    return 1 - ref_dot(a, b) > LMB_ARC_U_MAX / 268435456.0 ? ref_scale(sum, P_MAX / 2) : ref_unit(sum);
}

static void nodes_begin(shaded *m, enum lmb_model kind, enum lmb_step_kind step)
{
    int k;
    m->lit = kind == LMB_MODEL_FLAT || kind == LMB_MODEL_GOURAUD;
    m->nodes = kind == LMB_MODEL_FLAT                                 ? 1
               : kind == LMB_MODEL_GOURAUD || step == LMB_STEP_LINEAR ? 3
               : step == LMB_STEP_QUADRATIC                           ? 6
                                                                      : 0;
    for (k = 0; k < m->nodes; k++) {
        ref_vec normal = m->nodes == 1 ? m->face
                         : k < 3       ? m->corner[k].normal
                                       : mid_normal(m->corner[k - 3].normal, m->corner[(k - 2) % 3].normal);
        ref_terms_of(m->shader, normal, &m->node[k]);
        if (m->lit) ref_terms_light(m->shader, &m->node[k]);
    }
}

/* The polynomial of Lagrange through the nodes. */
static void blend(const shaded *m, const double l[3], ref_terms *out)
{
    double weight[NODES] = {1, 0, 0, 0, 0, 0};
    unsigned i;
    int k;
    for (k = 0; k < 3 && m->nodes > 1; k++) weight[k] = m->nodes == 3 ? l[k] : l[k] * (2 * l[k] - 1);
    for (k = 3; k < m->nodes; k++) weight[k] = 4 * l[k - 3] * l[(k - 2) % 3];
    for (i = 0; i < m->shader->lights; i++) {
        out->diffuse[i] = out->specular[i] = 0;
        for (k = 0; k < m->nodes; k++) {
            out->diffuse[i] += weight[k] * m->node[k].diffuse[i];
            out->specular[i] += weight[k] * m->node[k].specular[i];
        }
    }
}

/* ----------------------------------------------------------------------------------------------------------------------- arcs */

/* Where the edge from a down to b crosses the centre line of row y, and the normal there, turned evenly on the way. */
static double cross_edge(const corner *a, const corner *b, int y, ref_vec *normal)
{
    double t = (double)(16 * (int64_t)y + 8 - a->y) / (double)(b->y - a->y);
    *normal = ref_unit(ref_slerp(a->normal, b->normal, t));
    return (double)a->x + t * (double)(b->x - a->x);
}

static void row_begin(shaded *m, int y)
{
    const corner *top = &m->corner[0], *middle = &m->corner[1], *bottom = &m->corner[2], *swap;
    double a, b;
    ref_vec normal_a, normal_b;
    if (middle->y < top->y) swap = top, top = middle, middle = swap;
    if (bottom->y < middle->y) swap = middle, middle = bottom, bottom = swap;
    if (middle->y < top->y) swap = top, top = middle, middle = swap;
    a = cross_edge(top, bottom, y, &normal_a);
    b = 16 * (int64_t)y + 8 < middle->y ? cross_edge(top, middle, y, &normal_b) : cross_edge(middle, bottom, y, &normal_b);
    m->left_x = fmin(a, b);
    m->right_x = fmax(a, b);
    m->left = a < b ? normal_a : normal_b;
    m->right = a < b ? normal_b : normal_a;
}

/* --------------------------------------------------------------------------------------------------------------------- pixels */

static void paint_pixel(ref_frame *frame, const shaded *m, int x, int y, const double weight[3], uint32_t triangle)
{
    double depth = 0, rgb[3];
    ref_terms terms;
    int k;
    for (k = 0; k < 3; k++) depth += weight[k] * m->corner[k].depth;
    if (m->nodes) {
        blend(m, weight, &terms);
    } else {
        double t = (16 * x + 8 - m->left_x) / (m->right_x - m->left_x);
        ref_terms_of(m->shader, ref_slerp(m->left, m->right, t), &terms);
    }
    if (!m->lit) ref_terms_light(m->shader, &terms);
    ref_terms_colour(m->shader, &terms, rgb);
    ref_frame_add(frame, x, y, depth, rgb, triangle);
}

static int least(int64_t a, int64_t b, int64_t c, int limit)
{
    int64_t x = (a < b ? a : b) < c ? (a < b ? a : b) : c;
    return x < 0 ? 0 : x / 16 > limit ? limit : (int)(x / 16);
}

static int most(int64_t a, int64_t b, int64_t c, int limit)
{
    int64_t x = (a > b ? a : b) > c ? (a > b ? a : b) : c;
    return x < 0 ? 0 : x / 16 + 1 > limit ? limit : (int)(x / 16 + 1);
}

static void paint_triangle(ref_frame *frame, shaded *m, uint32_t triangle)
{
    const corner *a = &m->corner[0], *b = &m->corner[1], *c = &m->corner[2];
    int left = least(a->x, b->x, c->x, frame->width), right = most(a->x, b->x, c->x, frame->width);
    int top = least(a->y, b->y, c->y, frame->height), bottom = most(a->y, b->y, c->y, frame->height), x, y;
    for (y = top; y < bottom; y++) {
        bool begun = false;
        for (x = left; x < right; x++) {
            double weight[3];
            if (!covers(m, x, y, weight)) continue;
            if (!begun && m->nodes == 0) row_begin(m, y);
            begun = true;
            paint_pixel(frame, m, x, y, weight, triangle);
        }
    }
}

/* From the positions in the mesh, exactly. */
static ref_vec face_normal(const lmb_mesh *mesh, uint32_t triangle)
{
    const uint16_t *index = mesh->indices + 3 * triangle;
    ref_vec a = ref_make(mesh->positions[index[0]]);
    ref_vec ab = ref_sub(ref_make(mesh->positions[index[1]]), a), ac = ref_sub(ref_make(mesh->positions[index[2]]), a);
    return ref_unit(ref_cross(ab, ac));
}

static void paint_object(ref_frame *frame, const scene *s, unsigned object, enum lmb_model kind, enum lmb_step_kind step)
{
    const scene_object *o = &s->object[object];
    lmb_vertex *vertices = malloc(o->mesh->vertices * sizeof *vertices);
    ref_shader shader;
    uint32_t t;
    int k;
    if (!vertices) {
        fprintf(stderr, "reference: out of memory\n");
        exit(EXIT_FAILURE);
    }
    ref_shader_begin(&shader, s, o, kind != LMB_MODEL_DIFFUSE);
    lmb_mesh_project(o->mesh, &o->pose, &s->camera, vertices);
    for (t = 0; t < o->mesh->triangles; t++) {
        static const int clockwise[3] = {0, 2, 1};
        bool off_screen = false;
        shaded m;
        m.shader = &shader;
        for (k = 0; k < 3; k++) {
            const lmb_vertex *v = &vertices[o->mesh->indices[3 * t + (uint32_t)clockwise[k]]];
            if (v->x == INT32_MIN) off_screen = true;
            m.corner[k].x = v->x;
            m.corner[k].y = v->y;
            m.corner[k].depth = v->depth;
            m.corner[k].normal = ref_unit(ref_make(v->normal));
        }
        frame->clipped += off_screen;
        m.area2 = edge(&m.corner[0], &m.corner[1], m.corner[2].x, m.corner[2].y);
        if (off_screen || m.area2 <= 0) continue;
        m.face = face_normal(o->mesh, t);
        nodes_begin(&m, kind, step);
        paint_triangle(frame, &m, (uint32_t)object << 24 | t);
    }
    free(vertices);
}

void ref_same_model(ref_frame *frame, const scene *s, enum lmb_model model, enum lmb_step_kind step)
{
    unsigned i;
    ref_frame_begin(frame, s, DEPTH_SLACK);
    for (i = 0; i < s->objects; i++) paint_object(frame, s, i, model, step);
}

void ref_exact(ref_frame *frame, const scene *s, bool highlight)
{
    ref_same_model(frame, s, highlight ? LMB_MODEL_GLOSS : LMB_MODEL_DIFFUSE, LMB_STEP_ARC);
}
