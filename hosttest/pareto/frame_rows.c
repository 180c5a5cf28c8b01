/* SPDX-License-Identifier: MIT */
/* Rows of frames: what was measured on cores, each with its error. */
#include "table.h"

#include <stdio.h>
#include <string.h>

static void row_add(pareto_table *table, const pareto_frame *f, const pareto_errors *e)
{
    pareto_row r;
    memset(&r, 0, sizeof r);
    memcpy(r.core, f->core, sizeof r.core);
    snprintf(r.scope, sizeof r.scope, "frame");
    snprintf(r.scene, sizeof r.scene, "%.20s-%.10s", f->scene, f->format);
    memcpy(r.method, f->method, sizeof r.method);
    memcpy(r.unit, f->unit, sizeof r.unit);
    r.cost = f->cost;
    r.bytes = f->bytes;
    r.most = e->most;
    r.rms = pareto_rms(e);
    pareto_table_add(table, &r);
}

/* Whether the sweep of a core has the scene: others are measured as well, but not charted. */
static bool is_swept(const pareto_frame *of)
{
    const pareto_frame *f;
    unsigned i;
    for (i = 0; (f = pareto_frame_at(i)); i++) {
        if (!strcmp(f->core, of->core) && !strcmp(f->scene, of->scene) && !strcmp(f->method, "planned")) return true;
    }
    return false;
}

/* A row for each core that has drawn the frame. */
static void rows_of(pareto_table *table, const char *drawn, const char *format, const char *method, const pareto_errors *e)
{
    const pareto_frame *f;
    unsigned i;
    for (i = 0; (f = pareto_frame_at(i)); i++) {
        if (!strcmp(f->scene, drawn) && !strcmp(f->format, format) && !strcmp(f->method, method) && is_swept(f))
            row_add(table, f, e);
    }
}

static void ours(pareto_table *table, const pareto_truth *truth, enum lmb_format format)
{
    unsigned i;
    for (i = 0; i < pareto_methods(format); i++) {
        pareto_method m;
        pareto_errors e = {0, 0, 0};
        pareto_method_set(&m, format, i);
        pareto_frame_errors(&e, truth, format, &m);
        rows_of(table, truth->s->name, format == LMB_RGB565 ? "rgb565" : "rgb888", m.name, &e);
    }
}

static void rivals(pareto_table *table, const pareto_truth *truth)
{
    unsigned i;
    for (i = 0; i < compare_frame_count; i++) {
        pareto_errors e = {0, 0, 0};
        if (pareto_rival_errors(&e, truth, &compare_frames[i]))
            rows_of(table, truth->s->name, "rgb565", compare_frames[i].name, &e);
    }
}

void pareto_frames(pareto_table *table)
{
    unsigned i;
    for (i = 0; i < scene_count(); i++) {
        pareto_truth truth;
        scene s;
        scene_make(&s, i);
        if (!pareto_scene(&s, true) && !pareto_scene(&s, false)) continue;
        fprintf(stderr, "pareto: frames of %s ...\n", s.name);
        pareto_truth_begin(&truth, &s);
        ours(table, &truth, LMB_RGB565);
        rivals(table, &truth);
        ours(table, &truth, LMB_RGB888);
        pareto_truth_end(&truth);
    }
}
