/* SPDX-License-Identifier: MIT */
/* The demo scenes: what `make demo` draws, the judge judges and the figures are about. */
#ifndef LMB_SCENES_H
#define LMB_SCENES_H

#include "../fill.h"

#define SCENE_OBJECTS 6
#define SCENE_NAMES                                                                                                              \
    "icosphere-320", "icosphere-320-tight", "icosphere-1280", "icosphere-1280-tight", "torus", "torus-tight", "teapot",          \
        "teapot-tight", "still-life"

enum scene_surface { SCENE_MESH_ONLY, SCENE_SPHERE, SCENE_TORUS }; /* the true surface behind a mesh, where there is one */

/* One thing in a scene: where it stands and what it is made of. */
typedef struct scene_object {
    const lmb_mesh *mesh;
    lmb_pose pose;
    lmb_material material;
    enum scene_surface surface;
} scene_object;

typedef struct scene {
    const char *name;
    int width, height;
    scene_object object[SCENE_OBJECTS];
    unsigned objects;
    lmb_light light[LMB_LIGHTS];
    unsigned lights;
    lmb_camera camera;
    lmb_rgb background;
    bool depth;              /* needs a depth buffer */
    enum lmb_step_kind step; /* the cheapest that shows no fault here */
} scene;

/* How many scenes there are, and scene i of them. */
unsigned scene_count(void);
void scene_make(scene *out, unsigned i);

/* Draws a scene into a surface, all of it or the strip that the surface's window shows. Returns the pixels shaded. */
uint32_t scene_draw(const scene *s, const lmb_surface *surface, enum lmb_model model, enum lmb_step_kind step);

/* Radii of the torus. */
#define SCENE_TORUS_MAJOR 0.7
#define SCENE_TORUS_MINOR 0.3

#endif
