/* SPDX-License-Identifier: MIT */
/* Frames of every fixed choice and of the planner, at the formats' own tolerances and at those of a sweep: what pareto.csv has
 * them cost. */
#include "bench.h"

#include "../pareto/methods.h"

static bool scene_swept(const scene *s, enum lmb_format format)
{
    pareto_method m;
    bool any = false;
    unsigned i;
    for (i = 0; i < pareto_methods(format); i++) {
        pareto_method_set(&m, format, i);
        if (!profile_chosen(profile_model, m.name) || !pareto_paint(&profile_work.paint, s, format, &m)) continue;
        profile_frame(s, m.name);
        any = true;
    }
    return any;
}

bool profile_sweep(void)
{
    scene *s = &profile_work.scene;
    bool any = false;
    unsigned i, format;
    for (i = 0; i < scene_count(); i++) {
        scene_make(s, i);
        if (!pareto_scene(s, LMB_PROFILE_WHOLE)) continue;
        for (format = LMB_RGB565; format <= LMB_RGB888; format++) {
            if (profile_measures(s, (enum lmb_format)format)) any = scene_swept(s, (enum lmb_format)format) || any;
        }
    }
    return any;
}
