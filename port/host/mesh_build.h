/* SPDX-License-Identifier: MIT */
/* From the faces of an OBJ file to a mesh as the library draws it: 16-bit positions, unit normals, triangles. Host tools only.
 *
 * Positions  one power of two for the mesh, the finest that fits; rounded to nearest.
 * Normals    from the file where a face names them, normalised; else computed: for each v the sum over its faces that have none,
 *            weighted by the angle of the face's corner or by the area of the face. Each component is rounded to nearest, Q2.14.
 *            Where a sum cancels out (two sides of one sheet), each face keeps its own normal.
 * Vertices   one for each distinct pair of quantised position and normal, in the order of first use. So a v with several vn stays
 *            a hard edge, and equal v that meet with equal normals become one.
 * Refused    with one line `file:line: what is wrong`: triangles of no area, in the file or after quantisation, and outlines that
 *            cross themselves (unless dropped by option), more than MESH_VERTICES_MAX vertices, coordinates that do not fit in
 *            space.
 */
#ifndef LMB_HOST_MESH_BUILD_H
#define LMB_HOST_MESH_BUILD_H

#include <stdio.h>

#include "lambent.h"
#include "obj.h"

#define MESH_VERTICES_MAX 65535
#define MESH_SPACE_MAX 8191.75 /* 32767 mesh units at LMB_SCALE_MAX */

enum mesh_weight { MESH_WEIGHT_ANGLE, MESH_WEIGHT_AREA };

enum mesh_place {
    MESH_PLACE_KEEP,   /* coordinates as they are in the file */
    MESH_PLACE_CENTRE, /* the middle of the bounding box moves to the origin */
    MESH_PLACE_FIT     /* and the farthest vertex then comes to distance one */
};

struct mesh_options {
    enum mesh_weight normals;
    enum mesh_place place;
    bool drop_degenerate; /* triangles of no area are left out and counted */
};

/* What became of the model. space = (file - offset) * factor; mesh unit = space / 2^scale. */
struct mesh_info {
    struct point3 offset;
    double factor;
    struct point3 low, high; /* bounding box in the file's units, of what faces use */
    double radius;           /* from the middle of that box to the farthest vertex, in the file's units */
    double position_error;   /* largest distance in space between a position and its quantised one */
    uint32_t unused;         /* v that no face uses */
    uint32_t dropped;        /* triangles or faces without area */
    uint32_t cancelled;      /* corners where normals cancelled out */
    uint32_t contrary;       /* triangles that wind against their normals from the file */
};

/* Builds a mesh in heap memory; options may be NULL, info may not.
 *   return  0, or -1 after one line on errors and with an empty *mesh */
int mesh_build(lmb_mesh *mesh, struct mesh_info *info, const struct obj_model *model, const struct mesh_options *options,
               FILE *errors);

/* One line for each thing that its author may want to know. path: the name to put in front. */
void mesh_print_notes(const struct mesh_info *info, const char *path, FILE *notes);

/* Bytes of the arrays, without struct lmb_mesh itself. */
unsigned long mesh_bytes(const lmb_mesh *mesh);

void mesh_free(lmb_mesh *mesh);

#endif
