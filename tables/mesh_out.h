/* SPDX-License-Identifier: MIT */
/* Meshes in the making: quantises and welds vertices, checks triangles, writes the whole as one C file.
 *
 * What a generator prints must be the same on every machine, though sine, cosine and root may differ in their last bit and a
 * compiler may fuse a product into a sum. So no number is rounded that lies within MESH_TIE of the middle between two integers:
 * the generator stops instead. Past that check no last bit can reach the file.
 */
#ifndef LMB_TABLES_MESH_OUT_H
#define LMB_TABLES_MESH_OUT_H

#include <stdint.h>

#include "lambent.h"

#define MESH_TIE 1e-9             /* a thousand times what double loses at 16384 */
#define MESH_VERTICES_MAX 65535   /* lmb_mesh.vertices is 16 bits wide */
#define MESH_TRIANGLES_MAX 131072 /* two for each vertex, as on any closed surface */

typedef struct mesh_out {
    lmb_vec *positions, *normals;
    uint16_t *indices;
    uint32_t *slots; /* hash table of vertices; 0 is free, else one more than the vertex */
    uint32_t vertices, triangles;
} mesh_out;

/* Prints "<generator>: <message>" and ends the program with failure. */
void mesh_fail(const char *message);

/* A decimal argument in [low, high]; anything else ends the program. */
int mesh_argument(const char *text, int low, int high);

/* To the nearest integer; ends the program for |x| > 32767 or x within MESH_TIE of a tie. */
int16_t mesh_round(double x);

/* (x, y, z) at unit length in Q2.14, each component rounded to nearest. */
lmb_vec mesh_unit(double x, double y, double z);

void mesh_begin(mesh_out *mesh, const char *generator);

/* The vertex with this position and normal: one that is there already, or a new one. */
uint16_t mesh_vertex(mesh_out *mesh, lmb_vec position, lmb_vec normal);

/* Adds a triangle, counter-clockwise seen from outside. One with a corner twice is dropped: it is what a quad leaves at a pole.
 * One without area, or that turns its back to the normal of a corner, ends the program. */
void mesh_triangle(mesh_out *mesh, uint16_t a, uint16_t b, uint16_t c);

/* Writes the mesh as a C file, or as a Wavefront OBJ file if path ends in .obj, and releases it.
 *   arguments  argv[0] is dropped, the others go into the first line; the last of them is the mesh's name
 *   path       NULL: stdout
 *   scale      a mesh unit is 2^scale units of space
 *   text       one line on the shape, at most 120 characters
 * A mesh whose positions are its normals bit for bit gets one array for both. */
void mesh_write(mesh_out *mesh, char **arguments, int count, const char *path, int scale, const char *text);

#endif
