/* SPDX-License-Identifier: MIT */
/* The planner: up to which bend and range each way of a term cannot be told from arcs. Inside the library only. */
#ifndef LMB_PLAN_H
#define LMB_PLAN_H

#include "lambent.h"

static inline bool lmb_is_planned(const lmb_look *look) { return LMB_WITH_PLANS && look->step == LMB_STEP_PLANNED; }

/* What each light may leave out: of a planned look all lights share the tolerance. */
static inline uint16_t lmb_light_tolerance(const lmb_look *look)
{
    const unsigned lights = lmb_look_lights(look);
    if (!lmb_is_planned(look) || lights == 1) return look->tolerance;
    return (uint16_t)(look->tolerance >> (lights == 2 ? 1 : 2));
}

#if LMB_WITH_PLANS

/* Sets the plan of a light from look->step, the tolerance, the exponent, the lobe unless ramps hold it, and the light's strengths. */
void lmb_plan_light(const lmb_look *look, struct lmb_look_light *light, bool ramp);

/* The largest error of the lobe that a planned look may have, UQ0.16. */
uint16_t lmb_plan_lobe(const lmb_look *look);

static inline const struct lmb_plan *lmb_plan_of(const struct lmb_look_light *light) { return &light->plan; }

#else

/* No constants, highlights quadratic wherever they bend, no arcs. */
struct lmb_plan {
    int32_t level_q28, gloss_level_q28, gloss_straight_q28, curved_q28, gloss_curved_q28;
};
static inline const struct lmb_plan *lmb_plan_of(const struct lmb_look_light *light)
{
    static const struct lmb_plan none = {-1, -1, 0, INT32_MAX, INT32_MAX};
    (void)light;
    return &none;
}
static inline void lmb_plan_light(const lmb_look *look, struct lmb_look_light *light, bool ramp)
{
    (void)look;
    (void)light;
    (void)ramp;
}
static inline uint16_t lmb_plan_lobe(const lmb_look *look)
{
    (void)look;
    return 0;
}

#endif
#endif
