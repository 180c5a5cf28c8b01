/* SPDX-License-Identifier: MIT */
/* The demo scenes: what `make demo` draws, the boards draw, the judge judges and the figures are about. */
#ifndef LMB_SCENES_H
#define LMB_SCENES_H

#include "../fill.h"

/* Which scenes are built in: all, or the sum of some on a board with little flash. Meshes that none of them shows are not
 * linked. */
#define SCENE_WITH_ICOSPHERE_320 0x001
#define SCENE_WITH_ICOSPHERE_320_TIGHT 0x002
#define SCENE_WITH_ICOSPHERE_1280 0x004
#define SCENE_WITH_ICOSPHERE_1280_TIGHT 0x008
#define SCENE_WITH_TORUS 0x010
#define SCENE_WITH_TORUS_TIGHT 0x020
#define SCENE_WITH_TEAPOT 0x040
#define SCENE_WITH_TEAPOT_TIGHT 0x080
#define SCENE_WITH_STILL_LIFE 0x100
#define SCENE_WITH_ICOSPHERE_128 0x200
#ifndef SCENES
#define SCENES 0x3ff
#endif
LMB_STATIC_ASSERT((SCENES) > 0 && (SCENES) <= 0x3ff);

/* Room for things in a scene. */
#if (SCENES) & SCENE_WITH_STILL_LIFE
#define SCENE_OBJECTS 6
#else
#define SCENE_OBJECTS 1
#endif

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

/* Draws a scene into a surface, all of it or the strip that the surface's window shows. */
void scene_draw(const scene *s, const lmb_surface *surface, enum lmb_model model, enum lmb_step_kind step);

/* How many pixels lie inside triangles that a window shows, each as often as it does: what is shaded, with depth before the test. */
uint32_t scene_pixels(const scene *s, const lmb_window *window);

/* Radii of the torus. */
#define SCENE_TORUS_MAJOR 0.7
#define SCENE_TORUS_MINOR 0.3

#endif
