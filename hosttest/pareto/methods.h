/* SPDX-License-Identifier: MIT */
/* The ways to draw a frame that pareto.csv compares: one list for the profiled image, which has what they cost, and for the
 * host, which has how they err. Freestanding.
 *
 *   flat gouraud                     models without a choice of steps
 *   linear quadratic arc planned     steps; one light on RGB565 looks the highlight up in a ramp
 *   linear-w4 ... arc-tuned          on RGB888, which reckons it for each pixel: the same with a lobe
 *   NAME/T                           the same where up to 1/T of full scale may be wrong in all: the look tolerates half of
 *                                    that, and the tuned lobe has the fewest multiplications that are as good. Without /T: as
 *                                    paints set it, half a level of the format in all, and the tuned lobe as good as it gets
 */
#ifndef PARETO_METHODS_H
#define PARETO_METHODS_H

#include "../../port/demo/scenes.h"

#define PARETO_NAME 24

typedef struct pareto_method {
    char name[PARETO_NAME];
    enum lmb_model model;
    enum lmb_step_kind step;
    bool has_lobe; /* a fixed one */
    enum lmb_lobe_kind lobe;
    unsigned over; /* 1/over of full scale is tolerated in all; 0: what paints set */
} pareto_method;

/* Tolerances of the sweep: 1/16, 1/32 ... 1/1024. */
#define PARETO_TOLERANCES 7u

/* How many methods a format has, and method i of them. */
unsigned pareto_methods(enum lmb_format format);
void pareto_method_set(pareto_method *method, enum lmb_format format, unsigned i);

/* The paint of a scene's first object by a method. False if the library has it not. */
bool pareto_paint(lmb_paint *paint, const scene *s, enum lmb_format format, const pareto_method *method);

/* Whether a scene is charted: those of one object with n = 16; where memory holds no whole frame, the small one alone. */
bool pareto_scene(const scene *s, bool whole);

#endif
