/* SPDX-License-Identifier: MIT */
/* What was chosen for triangles, read off them, and counted. */
#include "lambent.h"

static enum lmb_way way_of(const lmb_triangle *t, bool on, const lmb_plane *plane)
{
    if (!on) return LMB_WAY_NONE;
    if (t->kind == LMB_SPAN_ARC) return LMB_WAY_ARC;
    if (t->kind == LMB_SPAN_FLAT) return LMB_WAY_CONSTANT;
    if (plane->bow | plane->dxy | plane->dyy) return LMB_WAY_QUADRATIC;
    return plane->dx | plane->dy ? LMB_WAY_LINEAR : LMB_WAY_CONSTANT;
}

enum lmb_way lmb_triangle_diffuse(const lmb_triangle *t, unsigned light)
{
    return way_of(t, lmb_bit(t->diffuse_on, light), &t->u.light[light].diffuse);
}

enum lmb_way lmb_triangle_specular(const lmb_triangle *t, unsigned light)
{
    return way_of(t, lmb_bit(t->specular_on, light), &t->u.light[light].specular);
}

void lmb_statistics_add(lmb_statistics *statistics, const lmb_triangle *t)
{
    unsigned i;
    statistics->triangles++;
    for (i = 0; i < lmb_look_lights(t->look); i++) {
        statistics->diffuse[lmb_triangle_diffuse(t, i)]++;
        statistics->specular[lmb_triangle_specular(t, i)]++;
    }
}

void lmb_mesh_statistics(lmb_walk *walk, lmb_statistics *statistics)
{
    lmb_triangle triangle;
    while (lmb_mesh_next(walk, &triangle)) lmb_statistics_add(statistics, &triangle);
}
