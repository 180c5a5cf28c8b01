/* SPDX-License-Identifier: MIT */
/* Clipping in space against the near plane and the screen's guard band (Sutherland & Hodgman 1974), for the few triangles that
 * reach nearer than the near plane or beyond LMB_SCREEN_MAX. Everything else is clipped by spans, in pixels, for nothing.
 *
 * Neighbours cut their common edge at the same point, bit for bit: a cut is always reckoned from the inner end to the outer.
 */
#include "clip.h"
#include "screen.h"

LMB_STATIC_ASSERT((LMB_GUARD + 16384) * 16L < LMB_SCREEN_MAX && LMB_GUARD_NEAR < LMB_GUARD);

enum plane { PLANE_NEAR, PLANE_RIGHT, PLANE_LEFT, PLANE_TOP, PLANE_BOTTOM, PLANES };

typedef struct clipper {
    const lmb_camera *camera;
    int32_t reach_q16; /* LMB_GUARD / focal */
    enum plane plane;
} clipper;

/* Distance inside the plane, Q16.16, negative outside; saturates at half the range so that differences fit. */
static int32_t inside(const clipper *c, const lmb_point *p)
{
    int32_t half = INT32_MAX / 2, w = lmb_sub(0, p->z), reach = c->reach_q16, d;
    if (c->plane == PLANE_NEAR) return lmb_shr(lmb_sub(lmb_shr(w, 1), lmb_shr(c->camera->near_q16, 1)), 1);
    if (c->camera->perspective) reach = lmb_mul_shr_sat(w, reach, 16);
    reach = lmb_shr(reach, 2);
    d = lmb_shr(c->plane <= PLANE_LEFT ? p->x : p->y, 2);
    d = c->plane == PLANE_RIGHT || c->plane == PLANE_TOP ? lmb_sub(reach, d) : lmb_add(reach, d);
    return lmb_max(-half, lmb_min(half, d));
}

/* from + (to - from) t, rounded; differences are halved to fit. */
static int32_t between(int32_t from, int32_t to, int32_t t_q30)
{
    int32_t half = lmb_sub(lmb_shr(to, 1), lmb_shr(from, 1)), low = lmb_sub(to & 1, from & 1);
    int32_t quarter = lmb_mul_shr(half, t_q30, 30), rest = lmb_mul_shr(half, t_q30, 29) & 1;
    return lmb_add(lmb_add(from, quarter), lmb_add(quarter, lmb_add(rest, lmb_shr(lmb_mul(low, lmb_shr(t_q30, 1)), 29))));
}

static lmb_corner cut(const lmb_corner *in, const lmb_corner *out, int32_t d_in, int32_t d_out)
{
    const lmb_vec *a = &in->screen.normal, *b = &out->screen.normal;
    unsigned shift;
    uint32_t reciprocal = lmb_reciprocal((uint32_t)lmb_sub(d_in, d_out), &shift);
    int32_t t_q30 = lmb_min((int32_t)1 << 30, lmb_mul_shr_sat(d_in, (int32_t)(reciprocal >> 1), shift));
    lmb_corner c;
    c.p.x = between(in->p.x, out->p.x, t_q30);
    c.p.y = between(in->p.y, out->p.y, t_q30);
    c.p.z = between(in->p.z, out->p.z, t_q30);
    c.screen.x = LMB_NOT_ON_SCREEN;
    c.screen.normal = lmb_normalise(between(lmb_mul(a->x, 1024), lmb_mul(b->x, 1024), t_q30),
                                    between(lmb_mul(a->y, 1024), lmb_mul(b->y, 1024), t_q30),
                                    between(lmb_mul(a->z, 1024), lmb_mul(b->z, 1024), t_q30));
    return c;
}

/* Clips polygon[0..corners-1] against one plane in place: it first moves up one place, and a convex polygon never writes ahead of
 * what it has read, since the one corner that it may gain comes when the first crossing has been passed. */
static unsigned clip_plane(const clipper *c, lmb_corner polygon[LMB_CLIP_MAX + 1], unsigned corners)
{
    lmb_corner first, a;
    int32_t da, db;
    unsigned i, kept = 0;
    for (i = corners; i > 0; i--) polygon[i] = polygon[i - 1];
    first = polygon[1];
    a = first;
    da = inside(c, &a.p);
    for (i = 1; i <= corners; i++) {
        lmb_corner b = i < corners ? polygon[i + 1] : first;
        db = inside(c, &b.p);
        if (da >= 0) polygon[kept++] = a;
        if (da >= 0 && db < 0) polygon[kept++] = cut(&a, &b, da, db);
        if (da < 0 && db >= 0) polygon[kept++] = cut(&b, &a, db, da);
        a = b;
        da = db;
    }
    return kept < 3 ? 0 : kept;
}

unsigned lmb_clip(const lmb_camera *camera, lmb_corner polygon[LMB_CLIP_MAX + 1], lmb_vertex out[LMB_CLIP_MAX])
{
    clipper c;
    unsigned corners = 3, i, kept = 0, shift, plane;
    uint32_t reciprocal = lmb_reciprocal((uint32_t)camera->focal_q16, &shift);
    /* LMB_GUARD / focal in Q16.16: LMB_GUARD * 2^32 * reciprocal / 2^(31 + shift) */
    c.camera = camera;
    c.reach_q16 = lmb_mul_shr_sat(LMB_GUARD, (int32_t)(reciprocal >> 1), shift < 2 ? 0 : shift - 2);
    for (plane = PLANE_NEAR; plane < PLANES && corners > 0; plane++) {
        c.plane = (enum plane)plane;
        corners = clip_plane(&c, polygon, corners);
    }
    for (i = 0; i < corners; i++) {
        lmb_point *p = &polygon[i].p;
        p->z = lmb_min(p->z, lmb_sub(0, camera->near_q16)); /* a cut may round to just before the plane */
        out[kept] = polygon[i].screen;
        if (out[kept].x != LMB_NOT_ON_SCREEN || lmb_project(camera, *p, &out[kept])) kept++;
    }
    return kept < 3 ? 0 : kept;
}
