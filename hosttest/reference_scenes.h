/* SPDX-License-Identifier: MIT */
/* Scenes made to break things: coarse and slivered meshes, odd lights, extreme sizes. For test_image. */
#ifndef LMB_REFERENCE_SCENES_H
#define LMB_REFERENCE_SCENES_H

#include "../port/demo/scenes.h"

enum hard_mesh {
    HARD_TETRAHEDRON,   /* 4 triangles, normals 109 degrees apart */
    HARD_ICOSAHEDRON,   /* 20, 63 degrees */
    HARD_ICOSPHERE_80,  /* 36 degrees */
    HARD_ICOSPHERE_320, /* the demo's, but with a vertex for each corner */
    HARD_TUBE_AROUND,   /* 200 segments around, 4 along: upright slivers */
    HARD_TUBE_ALONG,    /* 4 around, 200 along: normals 90 degrees apart across slivers */
    HARD_CONE,          /* 200 slivers that meet in a point */
    HARD_SHEET,         /* two triangles, normals bent 40 degrees outwards at the corners */
    HARD_SOUP,          /* 60 triangles of any shape and place, seen from the front unless the pose turns them, normals within
                         * 70 degrees of some direction */
    HARD_MESHES
};

/* A mesh of the list, built when it is first asked for; it stays until hard_meshes_end. */
const lmb_mesh *hard_mesh(enum hard_mesh which);
const char *hard_mesh_name(enum hard_mesh which);
void hard_meshes_end(void);

/* The demo scene of that name; false if there is none. */
bool demo_scene(scene *s, const char *name);

/* A scene of one object in the middle, four units away, of the default material, white light from (40, 55, 70), depth buffer,
 * orthographic: radius is how many pixels a unit is. */
void hard_scene(scene *s, const char *name, int size, double radius, const lmb_mesh *mesh, lmb_matrix rotation);

/* The same in perspective, distance units away, with the focal length that keeps the size. */
void hard_scene_near(scene *s, double radius, double distance);

/* Takes another light in place of light i (or one more); the direction need not be normalised. */
void hard_light(scene *s, unsigned i, double x, double y, double z, lmb_rgb colour);

/* Degrees as the library counts angles. */
uint16_t hard_turn(double degrees);

#define HARD_LABEL 48

/* A family of hard scenes. make writes scene i of it, named by label, which must outlive it. */
typedef struct hard_set {
    const char *name;
    unsigned scenes;
    void (*make)(scene *s, unsigned i, char label[HARD_LABEL]);
    bool small;       /* frames of a few hundred pixels, to be counted together */
    bool large_faces; /* a face can be much of a frame */
    bool gloss_only;  /* what varies does not concern the other models */
} hard_set;

extern const hard_set hard_sets[];
extern const unsigned hard_set_count;

#endif
