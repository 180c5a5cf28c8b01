/* SPDX-License-Identifier: MIT */
/* The ways to draw a frame that pareto.csv compares. */
#include "methods.h"


static const struct {
    const char *name;
    enum lmb_lobe_kind kind;
} lobes[] = {{"-w4", LMB_LOBE_W4}, {"-w8", LMB_LOBE_W8}, {"-w16", LMB_LOBE_W16}, {"-tuned", LMB_LOBE_TUNED}};
#define LOBES ((unsigned)(sizeof lobes / sizeof lobes[0]))

static const char *const steps[] = {"linear", "quadratic", "arc", "planned"};
enum { CORNERS = 2, FIXED_STEPS = 3, SWEPT = PARETO_TOLERANCES + 1 };

static unsigned lobes_of(enum lmb_format format) { return format == LMB_RGB888 ? LOBES : 1; }

/* First the models of corners, then the fixed steps with each lobe at each tolerance, then the planner at each. */
unsigned pareto_methods(enum lmb_format format) { return CORNERS + (FIXED_STEPS * lobes_of(format) + 1) * SWEPT; }

static void append(char name[PARETO_NAME], const char *text)
{
    unsigned n = 0;
    while (name[n]) n++;
    while (*text && n + 1 < PARETO_NAME) name[n++] = *text++;
    name[n] = 0;
}

void pareto_method_set(pareto_method *m, enum lmb_format format, unsigned i)
{
    static const char *const over[SWEPT] = {"", "/16", "/32", "/64", "/128", "/256", "/512", "/1024"};
    const unsigned count = lobes_of(format);
    unsigned way = 0, step = 0;
    m->name[0] = 0;
    m->model = LMB_MODEL_GLOSS;
    m->step = LMB_STEP_QUADRATIC;
    m->has_lobe = false;
    m->lobe = LMB_LOBE_TUNED;
    m->over = 0;
    if (i < CORNERS) {
        m->model = i ? LMB_MODEL_GOURAUD : LMB_MODEL_FLAT;
        append(m->name, i ? "gouraud" : "flat");
        return;
    }
    for (i -= CORNERS; i >= SWEPT; i -= SWEPT) way++; /* boards need not divide */
    for (; way >= count && step < FIXED_STEPS; way -= count) step++;
    append(m->name, steps[step]);
    m->step = step == FIXED_STEPS ? LMB_STEP_PLANNED : (enum lmb_step_kind)step;
    m->has_lobe = step < FIXED_STEPS && count > 1;
    if (m->has_lobe) {
        m->lobe = lobes[way].kind;
        append(m->name, lobes[way].name);
    }
    append(m->name, over[i]);
    if (i) m->over = 8u << i;
}

bool pareto_paint(lmb_paint *paint, const scene *s, enum lmb_format format, const pareto_method *m)
{
    static const uint16_t tolerances[PARETO_TOLERANCES] = {2048, 1024, 512, 256, 128, 64, 32};
    lmb_look look;
    unsigned i = 0;
    uint16_t tolerance;
    if (lmb_look_prepare(&look, &s->object[0].material, s->light, s->lights, m->model, m->step)) return false;
    while (m->over && m->over != 16u << i) i++;
    tolerance = m->over ? tolerances[i] : 0;
    if (m->has_lobe && lmb_look_lobe(&look, m->lobe, tolerance)) return false;
    if (m->over) {
        lmb_paint_within(paint, &look, format, tolerance);
    } else {
        lmb_paint_prepare(paint, &look, format);
    }
    return true;
}

/* The small one is icosphere-128. */
bool pareto_scene(const scene *s, bool whole)
{
    return s->objects == 1 && s->object[0].material.shininess == 16 && (s->width == 128) != whole;
}
