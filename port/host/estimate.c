/* SPDX-License-Identifier: MIT */
/* Views as lmb-estimate takes them. */
#include "estimate.h"

#include <string.h>

int estimate_option(void *own, const char *option, const char *value)
{
    static const char *const ways[] = {"kept", "anew", NULL};
    estimate_view *e = own;
    if (!strcmp(option, "--vertices")) return view_name(&e->vertices, value, ways);
    return -1;
}

int estimate_count(const estimate_view *e, const lmb_mesh *mesh, cost_counts *counts)
{
    const view *v = &e->view;
    lmb_look look;
    lmb_paint paint;
    lmb_camera camera;
    lmb_pose pose;
    const cost_frame frame = {mesh,
                              &pose,
                              &camera,
                              &paint,
                              v->width,
                              v->height,
                              v->strip,
                              e->vertices == 1,
                              v->order == VIEW_DEPTH,
                              v->order == VIEW_PAINTER};
    if (view_look(v, &look)) {
        fprintf(stderr, "%s: the library refused a value\n", v->input);
        return -1;
    }
    lmb_paint_prepare(&paint, &look, (enum lmb_format)v->format);
    view_place(v, &camera, &pose);
    if (!cost_count(counts, &frame)) return 0;
    fprintf(stderr, "%s: %s\n", v->input,
            v->order == VIEW_PAINTER && mesh->triangles > 65536
                ? "too many triangles for painter's order (65536); use --order depth"
                : "out of memory");
    return -1;
}
