/* SPDX-License-Identifier: MIT */
/* Counts calls between the library's files. The library is compiled a second time for this, with each of these functions called
 * inside_... where it is defined (Makefile, COUNTED): so all others call what stands here, which counts and calls that. */
#include "count.h"

#include <math.h>

#include "../../firmware/arc.h"
#include "../../firmware/clip.h"
#include "../../firmware/curve.h"
#include "../../firmware/edge.h"
#include "../../firmware/edge_arc.h"
#include "../../firmware/plane.h"
#include "../../firmware/screen.h"
#include "../../firmware/shade.h"
#include "../../firmware/step.h"
#include "../../firmware/stride.h"
#include "../../firmware/triangle.h"

bool inside_lmb_triangle_seen(lmb_triangle *t, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c,
                              const lmb_window *w);
bool inside_lmb_triangle_front(lmb_triangle *t, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c,
                               const lmb_window *w);
void inside_lmb_shade_begin(lmb_triangle *t, lmb_lattice *lattice, const lmb_vertex *const corner[3]);
void inside_lmb_plane_begin(lmb_plane *plane, lmb_lattice *l, const lmb_net *net);
void inside_lmb_plane_exact(lmb_plane *plane, const lmb_lattice *l, const lmb_net *net);
void inside_lmb_plane_down(lmb_plane *p, int32_t rows);
void inside_lmb_edge_begin(lmb_edge *edge, const lmb_vertex *top, const lmb_vertex *bottom, int32_t row);
void inside_lmb_strides_begin(lmb_triangle *t);
void inside_lmb_strides_turn(lmb_triangle *t);
void inside_lmb_edge_arc_begin(lmb_triangle *t, unsigned side, const lmb_vertex *top, const lmb_vertex *bottom);
void inside_lmb_edge_arc_step(lmb_triangle *t);
void inside_lmb_edge_arc_span(const lmb_triangle *t, lmb_span *span, int32_t hidden);
bool inside_lmb_run_rough(const lmb_triangle *t, lmb_span *span, const lmb_run *run);
void inside_lmb_arc_prepare(lmb_arc *arc, int32_t u_q28, uint32_t length, uint32_t start);
void inside_lmb_arc_start(const lmb_arc *arc, lmb_term *term, int32_t a_q30, int32_t rise_q30);
unsigned inside_lmb_clip(const lmb_camera *camera, lmb_corner polygon[LMB_CLIP_MAX + 1], lmb_vertex out[LMB_CLIP_MAX]);
void inside_lmb_screen_project(const lmb_screen *s, const uint16_t *index, uint32_t count, lmb_vertex *corner);
int32_t inside_lmb_screen_y(const lmb_screen *s, uint32_t i);
void inside_lmb_fill_span(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span);

#define SINGLE 2 /* lmb_arc.direct of a single pixel: arc.c */

cost_counts *cost_counting;

/* Which stage calls, and what was called since. */
static bool in_shade, in_strides, took_exact, took_rough;

/* ----------------------------------------------------------------------------------------------------------------- triangles */

bool lmb_triangle_front(lmb_triangle *t, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c, const lmb_window *w)
{
    const bool begun = inside_lmb_triangle_front(t, a, b, c, w);
    cost_add(begun ? COST_BEGUN : COST_OUTSIDE, 1);
    return begun;
}

bool lmb_triangle_seen(lmb_triangle *t, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c, const lmb_window *w)
{
    const bool begun = inside_lmb_triangle_seen(t, a, b, c, w);
    const int64_t area = ((int64_t)b->x - a->x) * ((int64_t)c->y - a->y) - ((int64_t)c->x - a->x) * ((int64_t)b->y - a->y);
    cost_add(begun ? COST_BEGUN : area < 0 ? COST_OUTSIDE : COST_CULLED, 1);
    return begun;
}

unsigned lmb_clip(const lmb_camera *camera, lmb_corner polygon[LMB_CLIP_MAX + 1], lmb_vertex out[LMB_CLIP_MAX])
{
    cost_add(COST_CLIPPED, 1);
    return inside_lmb_clip(camera, polygon, out);
}

void lmb_screen_project(const lmb_screen *s, const uint16_t *index, uint32_t count, lmb_vertex *corner)
{
    cost_add(s->direct ? COST_CORNER_ANEW : s->camera->perspective ? COST_CORNER_FAR : COST_CORNER_LARGE, count);
    inside_lmb_screen_project(s, index, count, corner);
}

int32_t lmb_screen_y(const lmb_screen *s, uint32_t i)
{
    cost_add(COST_ROW_ANEW, 1);
    return inside_lmb_screen_y(s, i);
}

/* -------------------------------------------------------------------------------------------------------------------- planes */

/* How far a highlight of light 0 is tested. Bends are as exact as the largest of the mesh here, or of the triangle. */
static void count_gloss(const lmb_triangle *t, const lmb_vertex *const corner[3], bool bends, int32_t most_q28)
{
    unsigned i, k;
    for (i = 0; i < t->look->lights; i++) {
        const lmb_vec half = t->rays->light[i].half;
        int32_t v[3], low;
        if (!(t->look->specular_on >> i & 1)) continue;
        for (k = 0; k < 3; k++) v[k] = lmb_half_distance_q28(corner[k]->normal, half);
        if (i == 0 && v[0] > t->rays->far_q28) continue;
        cost_add(COST_GLOSS_TESTED, 1);
        if (t->specular_on >> i & 1) cost_add(COST_GLOSS, 1);
        low = lmb_min(lmb_min(v[0], v[1]), v[2]);
        if (bends && most_q28 > t->look->light[i].plan.gloss_straight_q28 &&
            low - 2 * (int64_t)most_q28 <= t->look->light[i].quiet_q30 >> 2) {
            cost_add(COST_GLOSS_BENT, 1);
        }
    }
}

/* What an edge between normals u apart bulges at most, Q4.28: see shade.c. */
static int32_t bend_of(int32_t u_q28)
{
    const double u = lmb_min(u_q28, LMB_ARC_U_MAX) / 268435456.0;
    return (int32_t)((1 / sqrt(1 - u / 2) - 1) * 268435456.0);
}

/* Whether a light's terms ask for the bends of a triangle: those of the mesh are too strong for planes without. */
static bool asks_bends(const lmb_triangle *t, unsigned i, int32_t mesh)
{
    const struct lmb_look_light *light = &t->look->light[i];
    return (t->diffuse_on >> i & 1 && mesh > light->straight_q28) ||
           (t->specular_on >> i & 1 && mesh > light->plan.gloss_straight_q28);
}

/* Bends of a triangle's edges where some term has asked for them; returns the largest that is known then, Q4.28. */
static int32_t count_bends(const lmb_triangle *t, const lmb_vertex *const corner[3])
{
    const int32_t mesh = t->rays->bend_q28;
    int32_t u[3], most = 0;
    bool asked = mesh == LMB_BEND_UNKNOWN || t->rays->arcs;
    unsigned i;
    for (i = 0; i < 3; i++) u[i] = lmb_half_distance_q28(corner[i]->normal, corner[i == 2 ? 0 : i + 1]->normal);
    for (i = 0; i < t->look->lights; i++) asked = asked || asks_bends(t, i, mesh);
    if (!asked) return mesh;
    cost_add(COST_BENDS, 1);
    for (i = 0; i < 3; i++) {
        if (u[i] > 1 << 24) cost_add(u[i] > 1 << 26 ? COST_BEND_ROOT : COST_BEND_STRONG, 1);
        most = lmb_max(most, bend_of(u[i]));
    }
    return most;
}

/* Terms that wants_arcs of shade.c looks at: bent too strongly for quadratics, until one shows. */
static void count_wishes(const lmb_triangle *t, const lmb_vertex *const corner[3], int32_t most_q28)
{
    bool wants = false;
    unsigned i, k;
    cost_add(COST_PLANNED_ASKED, 1);
    for (i = 0; i < t->look->lights && !wants; i++) {
        const struct lmb_look_light *light = &t->look->light[i];
        if (most_q28 > light->plan.curved_q28) {
            cost_add(COST_PLANNED_TERM, 1);
            for (k = 0; k < 3; k++) wants = wants || lmb_dot_q28(corner[k]->normal, t->rays->light[i].direction) > 0;
        }
        if (!wants && most_q28 > light->plan.gloss_curved_q28 && t->look->specular_on >> i & 1) {
            int32_t low = INT32_MAX;
            cost_add(COST_PLANNED_TERM, 1);
            for (k = 0; k < 3; k++) low = lmb_min(low, lmb_half_distance_q28(corner[k]->normal, t->rays->light[i].half));
            wants = low - 2 * (int64_t)most_q28 <= light->quiet_q30 >> 2;
        }
    }
}

/* A triangle by planes, or a planned one; begun: some plane was. Those that take arcs at once have none. */
static void count_planes(const lmb_triangle *t, const lmb_vertex *const corner[3], bool begun, unsigned shining)
{
    const bool planned = t->look->step == LMB_STEP_PLANNED, arcs = t->kind == LMB_SPAN_ARC && !begun;
    const int32_t most = t->look->step == LMB_STEP_LINEAR ? 0 : count_bends(t, corner);
    if (t->rays->arcs) count_wishes(t, corner, most);
    if (arcs) {
        cost_add(COST_PLANNED_ARC, 1);
        return;
    }
    cost_add(COST_SHADED, 1);
    if (planned) cost_add(COST_PLANNED, 1);
    if (t->look->lights > 1) cost_add(COST_SHADED_LIGHT, t->look->lights);
    if (!t->diffuse_on) cost_add(COST_DULL_TRIANGLE, 1);
    if (shining) count_gloss(t, corner, t->look->step != LMB_STEP_LINEAR, most);
}

void lmb_shade_begin(lmb_triangle *t, lmb_lattice *lattice, const lmb_vertex *const corner[3])
{
    const unsigned lights = t->look->lights;
    unsigned shining = 0, i;
    in_shade = true;
    inside_lmb_shade_begin(t, lattice, corner);
    in_shade = false;
    for (i = 0; i < lights; i++) shining += t->look->specular_on >> i & 1u;
    if (t->look->model == LMB_MODEL_FLAT) {
        cost_add(COST_SHADED_FACE, 1);
        cost_add(COST_SHADED_FACE_LIGHT, lights);
        cost_add(COST_LOBE, shining);
    } else if (t->look->model == LMB_MODEL_GOURAUD) {
        cost_add(COST_SHADED_CORNERS, lights);
        cost_add(COST_LOBE, 3 * shining);
    } else if (t->look->step == LMB_STEP_ARC) {
        cost_add(COST_SHADED_ARC, 1);
    } else {
        count_planes(t, corner, lattice->ready, shining);
    }
}

void lmb_plane_begin(lmb_plane *plane, lmb_lattice *l, const lmb_net *net)
{
    const bool ready = l->ready;
    bool curved;
    took_exact = false;
    inside_lmb_plane_begin(plane, l, net);
    curved = net->curved && !l->flat;
    if (!in_shade) {
        cost_add(took_exact ? COST_DEPTH_EXACT : COST_DEPTH_PLANE, 1);
        if (!ready) cost_add(COST_DEPTH_LATTICE, 1);
        return;
    }
    if (!ready) cost_add(COST_LATTICE, 1);
    if (!ready && l->large) cost_add(COST_LATTICE_LARGE, 1);
    cost_add(took_exact ? COST_EXACT : COST_PLANE, 1);
    if (curved) cost_add(took_exact ? COST_EXACT_CURVE : COST_CURVE, 1);
    if (took_exact && l->large) cost_add(COST_EXACT_LARGE, 1);
}

void lmb_plane_exact(lmb_plane *plane, const lmb_lattice *l, const lmb_net *net)
{
    took_exact = true;
    inside_lmb_plane_exact(plane, l, net);
}

void lmb_plane_down(lmb_plane *p, int32_t rows)
{
    cost_add(COST_DOWN, 1);
    inside_lmb_plane_down(p, rows);
}

/* --------------------------------------------------------------------------------------------------------------------- sides */

/* How often a divisor is doubled before it passes |a|: turns of the loops of edge.c. */
static double doublings(int64_t a, int64_t by)
{
    double n = 0;
    for (a = a < 0 ? ~a : a; by <= a; by <<= 1) n++;
    return n;
}

void lmb_edge_begin(lmb_edge *edge, const lmb_vertex *top, const lmb_vertex *bottom, int32_t row)
{
    const int64_t dx = bottom->x - top->x, dy = bottom->y - top->y, first = lmb_row_at(top->y);
    const int64_t part = dx < 0 ? dx + dy : dx, below = first * 16 + 8 - top->y, left = (int64_t)top->x - 8;
    double bits = part < 0 || part >= dy ? doublings(dx, dy) : 0;
    int64_t skipped = row - first;
    bits += doublings((left & 15) * dy + dx * below, 16 * dy);
    inside_lmb_edge_begin(edge, top, bottom, row);
    cost_add(in_strides ? COST_STRIDES_FAR : COST_EDGE, 1);
    for (; skipped > 0; skipped -= 127) bits += 2 + doublings((skipped < 127 ? skipped : 127) * edge->part, edge->modulus);
    cost_add(COST_EDGE_BIT, bits);
}

void lmb_strides_begin(lmb_triangle *t)
{
    in_strides = true;
    inside_lmb_strides_begin(t);
    in_strides = false;
    cost_add(t->y_long == t->y_end ? COST_STRIDES : COST_STRIDES_ODD, 1);
}

void lmb_strides_turn(lmb_triangle *t)
{
    const bool usual = t->y == t->y_switch && t->y_long >= t->y_end && t->corner[2]->y - t->corner[1]->y >= 4;
    in_strides = true;
    inside_lmb_strides_turn(t);
    in_strides = false;
    cost_add(usual ? COST_STRIDES_TURN : COST_STRIDES_ODD, 1);
}

/* --------------------------------------------------------------------------------------------------------------------- arcs */

void lmb_edge_arc_begin(lmb_triangle *t, unsigned side, const lmb_vertex *top, const lmb_vertex *bottom)
{
    cost_add(COST_ARC_EDGE, 1);
    cost_add(COST_ARC_EDGE_SKIP, t->y - lmb_row_at(top->y));
    inside_lmb_edge_arc_begin(t, side, top, bottom);
}

void lmb_edge_arc_step(lmb_triangle *t)
{
    cost_add(COST_ARC_ROW, 1);
    inside_lmb_edge_arc_step(t);
}

void lmb_arc_prepare(lmb_arc *arc, int32_t u_q28, uint32_t length, uint32_t start)
{
    inside_lmb_arc_prepare(arc, u_q28, length, start);
    cost_add(arc->direct == SINGLE        ? COST_ARC_SINGLE
             : length < 2 * LMB_ARC_PIXEL ? COST_ARC_TWO
             : u_q28 > LMB_ARC_U_MAX      ? COST_ARC_LINE
             : arc->direct                ? COST_ARC_STEEP
                                          : COST_ARC_FLAT,
             1);
}

void lmb_arc_start(const lmb_arc *arc, lmb_term *term, int32_t a_q30, int32_t rise_q30)
{
    cost_add(arc->direct == SINGLE ? COST_ARC_STARTED_SINGLE : arc->direct ? COST_ARC_STARTED_DIRECT : COST_ARC_STARTED, 1);
    inside_lmb_arc_start(arc, term, a_q30, rise_q30);
}

bool lmb_run_rough(const lmb_triangle *t, lmb_span *span, const lmb_run *run)
{
    took_rough = inside_lmb_run_rough(t, span, run);
    cost_add(took_rough ? COST_ARC_ROUGH : COST_ARC_TRIED, 1);
    return took_rough;
}

void lmb_edge_arc_span(const lmb_triangle *t, lmb_span *span, int32_t hidden)
{
    unsigned i, lights = t->look->lights, shining = 0;
    took_rough = false;
    inside_lmb_edge_arc_span(t, span, hidden);
    for (i = 0; i < lights; i++) shining += t->look->specular_on >> i & 1u;
    cost_add(COST_ARC_SPAN, 1);
    cost_add(COST_ARC_STRAIGHT, t->u.arc.left.straight + t->u.arc.right.straight);
    cost_add(COST_ARC_HIDDEN, hidden * (double)(lights + shining));
    if (took_rough) {
        cost_add(COST_ARC_ROUGH, lights - 1);
        cost_add(COST_ARC_ROUGH_GLOSS, shining);
    } else if (span->kind == LMB_SPAN_PLANE) {
        cost_add(COST_ARC_CURVE, lights);
        cost_add(COST_ARC_CURVE_GLOSS, shining);
    } else {
        const int direct = span->arc.direct == SINGLE ? COST_ARC_BEAM_SINGLE : span->arc.direct ? COST_ARC_BEAM_DIRECT : -1;
        cost_add(direct < 0 ? COST_ARC_BEAM : direct, lights);
        cost_add(direct < 0 ? COST_ARC_BEAM_GLOSS : direct, shining);
    }
}

/* --------------------------------------------------------------------------------------------------------------------- spans */

/* Planes of a triangle that its spans' terms come from. */
static double planes_of(const lmb_triangle *t)
{
    double n = t->depth_on;
    unsigned i;
    for (i = 0; i < t->look->lights && t->kind == LMB_SPAN_PLANE; i++) n += (t->diffuse_on >> i & 1) + (t->specular_on >> i & 1);
    return n;
}

bool lmb_triangle_next(lmb_triangle *t, lmb_span *span)
{
    const int32_t y = t->y;
    const bool found = inside_lmb_triangle_next(t, span);
    cost_add(COST_ROW, t->y - y);
    cost_add(COST_ROW_TERM, (t->y - y) * planes_of(t));
    if (found) cost_add(COST_SPAN_TERM, planes_of(t));
    return found;
}

void lmb_fill_span(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span)
{
    if (cost_counting) count_span(surface, paint, span);
    inside_lmb_fill_span(surface, paint, span);
}
