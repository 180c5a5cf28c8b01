/* SPDX-License-Identifier: MIT */
/* What lmb-render draws and lmb-estimate reckons: a model, its look, its display, as options of a command line. */
#ifndef LMB_HOST_VIEW_H
#define LMB_HOST_VIEW_H

#include "../fill.h"
#include "mesh_build.h"

#define VIEW_USAGE 2 /* exit status for a wrong command line */

enum view_order { VIEW_DEPTH, VIEW_PAINTER, VIEW_NONE };

typedef struct view {
    const char *input;
    int width, height, strip;
    int format, model, step, lobe, order, camera, weight;
    double pose[3], zoom, distance, ambient, diffuse, specular;
    long shininess;
    lmb_rgb colour, highlight, background;
    lmb_light light[LMB_LIGHTS];
    unsigned lights;
    bool quiet, drop_degenerate;
} view;

/* Names of what format, model, step and order count, each list with NULL behind. */
extern const char *const view_formats[], *const view_models[], *const view_steps[], *const view_orders[];

/* A program that takes these options and some of its own. */
typedef struct view_program {
    const char *name, *help;
    int (*option)(void *own, const char *option,
                  const char *value);            /* 1 if understood, 0 if its value is not, -1 for no such option */
    bool (*flag)(void *own, const char *option); /* NULL, or whether it is an option without value */
    void *own;
} view_program;

/* Lines of --help on options that all programs share. */
#define VIEW_HELP_FRAME                                                                                                          \
    "  --size WxH            pixels of the frame (240x240)\n"                                                                    \
    "  --format F            of the display: rgb565 (default) or rgb888\n"                                                       \
    "  --strip ROWS          draw in strips of so many rows, as a core without a framebuffer does; the picture is the same\n"
#define VIEW_HELP_PLACE                                                                                                          \
    "  --pose X,Y,Z          turn about x, then y, then z, degrees (0,0,0)\n"                                                    \
    "  --camera C            orthographic (default) or perspective\n"                                                            \
    "  --distance D          perspective: from the camera to the model's centre, in radii of the model, above 1 (3)\n"           \
    "  --zoom Z              1 fits the model to the frame (1)\n"                                                                \
    "  --order O             hidden surfaces by depth buffer (depth, default), painter's order (painter), or not at all "        \
    "(none)\n"
#define VIEW_HELP_LOOK                                                                                                           \
    "  --model M             flat, gouraud, diffuse or gloss (default: diffuse and highlight for each pixel)\n"                  \
    "  --step S              how N.L and N.H run over a triangle: linear, quadratic (default), arc, or planned, what is "        \
    "enough\n"                                                                                                                   \
    "  --lobe L              the highlight's curve: tuned (default), or w2, w4, w8, w16 as published\n"                          \
    "  -n N                  shininess, the exponent of the cosine, 1 to 1000 (16)\n"                                            \
    "  --colour C            of the material, #rrggbb (#3c8cff)\n"                                                               \
    "  --highlight C         of its highlight, #rrggbb (#ffffff)\n"                                                              \
    "  --ambient A           0 to 1 (0.1)\n"                                                                                     \
    "  --diffuse D           0 to 1 (0.7)\n"                                                                                     \
    "  --specular S          0 to 1 (0.5)\n"                                                                                     \
    "  --light X,Y,Z[,C]     towards a light, x right, y up, z to the viewer, and its colour; up to four times (40,55,70)\n"     \
    "  --background C        #rrggbb (#12141a)\n"
#define VIEW_HELP_INPUT                                                                                                          \
    "  --normals W           normals that the file lacks: weighted by angle (default) or area\n"                                 \
    "  --drop-degenerate     leave out triangles without area instead of refusing the file\n"                                    \
    "  -q, --quiet           no notes, no summary\n"                                                                             \
    "  -h, --help            this text\n"

/* Reads a command line into a view. Returns -1 to go on, or the exit status after --help or one line on what is wrong. */
int view_parse(view *v, const view_program *program, int argc, char **argv);

/* One line on a wrong command line; returns VIEW_USAGE. */
int view_usage(const view_program *program, const char *what, const char *which);

/* Whole numbers and others within limits; false for anything else. */
bool view_number(double *out, const char *text, double low, double high);
bool view_whole(int *out, const char *text, int low, int high);
bool view_numbers(double *out, const char *text, int count);
bool view_name(int *out, const char *text, const char *const *names);

/* Reads the model and fits it to radius 1. Returns 0, or -1 after one line on the standard error. */
int view_read(const view *v, lmb_mesh *mesh);

/* Camera and pose that show a mesh of radius 1 about the origin. */
typedef struct view_lens {
    int32_t focal_q16, near_q16, far_q16, z_q16;
    uint16_t turn[3]; /* 1/65536 of a turn about x, y, z */
} view_lens;
void view_lens_of(const view *v, view_lens *lens);
void view_place(const view *v, lmb_camera *camera, lmb_pose *pose);

/* The material, and the look of it. Returns what lmb_look_prepare does. */
lmb_material view_material(const view *v);
int view_look(const view *v, lmb_look *look);

#endif
