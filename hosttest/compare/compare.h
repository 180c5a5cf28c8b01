/* SPDX-License-Identifier: MIT */
/* Other ways to shade, for comparison: whole frames, spans and lobes, measured beside the library. docs/COMPARISON.md defines
 * each of them. They divide, take roots and use floats, so they live here and never in firmware/.
 *
 * All of this is freestanding C99 and takes memory from its caller. One directional light; RGB565; no depth buffer; exponent 16
 * for frames and spans. What is common to all frames is common code: corners from lmb_mesh_project, back faces culled, edges
 * exact under the top-left rule (so coverage is the library's to the pixel), colours in packed integers.
 *
 * HOW TO MEASURE
 *   frames   compare_look_prepare; then, counted, lmb_mesh_project and compare_frames[i].draw. As for the library:
 *            lmb_look_prepare; then, counted, lmb_mesh_project and lmb_draw_mesh.
 *   spans    kernel.begin; then, counted, kernel.fill: the pixel loop alone, as the frames run it.
 *   lobes    compare_lobe_prepare and kernel.arguments; then, counted, kernel.sum over n arguments. lobe-none is the loop around
 *            an evaluation with nothing in it: take it off the others.
 * Every draw, fill and sum is a symbol of its own that nothing inlines. Build them with -fno-math-errno, so that cores with an
 * FPU take their root in one instruction.
 */
#ifndef COMPARE_H
#define COMPARE_H

#include "../../port/fill.h"

/* 0 on cores whose tool chain has no libm: what needs sqrtf or powf is left out of the tables below. */
#ifndef COMPARE_WITH_LIBM
#define COMPARE_WITH_LIBM 1
#endif

/* ---------------------------------------------------------------------------------------------------------------- material */

#define COMPARE_SHININESS 16
#define COMPARE_POWERS 256

/* Material and light, prepared once. Packed colours: colour.h. */
typedef struct compare_look {
    lmb_vec direction, half; /* unit, in space */
    uint32_t ambient_rb, diffuse_rb, specular_rb;
    uint32_t ambient_g, diffuse_g, specular_g;
    uint8_t power[COMPARE_POWERS];         /* 255 (i / 255)^16 */
    uint32_t diffuse_ramp[COMPARE_POWERS]; /* ramp-table: colours of N.L, ambient and half a level in them */
    uint32_t specular_ramp[COMPARE_POWERS];
    uint32_t unlit; /* the same where N.L is below zero */
} compare_look;

/* Prepares a look. Returns 0, or LMB_ERROR_VALUE if shininess is not COMPARE_SHININESS, or a channel's ambient and diffuse light
 * exceed one together. */
int compare_look_prepare(compare_look *look, const lmb_material *material, const lmb_light *light);

/* ------------------------------------------------------------------------------------------------------------------ frames */

/* What a renderer keeps for a vertex. */
typedef union compare_room {
    float f[3];
    int32_t q[3];
} compare_room;

/* Draws a mesh that lies wholly inside the surface's window.
 *   vertices  from lmb_mesh_project
 *   room      one for each of the mesh's vertices; scratch
 *   return    pixels painted; 0 and nothing drawn if a corner is outside the window */
typedef uint32_t compare_draw(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose, const compare_look *look,
                              const lmb_vertex *vertices, compare_room *room);

compare_draw compare_draw_float_phong, compare_draw_float_squarings; /* COMPARE_WITH_LIBM */
compare_draw compare_draw_integer_phong, compare_draw_integer_phong_textbook;
compare_draw compare_draw_schlick, compare_draw_power_table, compare_draw_ramp_table, compare_draw_gouraud;

typedef struct compare_frame {
    /* float-phong float-squarings integer-phong-sqrt integer-phong-textbook schlick power-table ramp-table integer-gouraud */
    const char *name;
    compare_draw *draw;
} compare_frame;

extern const compare_frame compare_frames[];
extern const unsigned compare_frame_count;

/* ------------------------------------------------------------------------------------------------------------------- spans */

/* A span of some method: its values at the first pixel and their steps. */
typedef struct compare_span {
    const compare_look *look;
    int32_t direction[3], half[3];   /* Q2.14, in the space of the normals */
    float direction_f[3], half_f[3]; /* the same; direction times 4096 */
    float value_f[3], step_f[3];     /* float methods: the normal */
    int32_t value[3], step[3];       /* integer methods: the normal; N.L and N.H; or r, g, b */
} compare_span;

typedef struct compare_span_kernel {
    const char *name; /* span- and the frame's name */
    /* A span whose normal runs linearly from the first pixel to the one past the last. length: 1 to 1024 */
    void (*begin)(compare_span *span, const compare_look *look, lmb_vec from, lmb_vec to, unsigned length);
    /* Paints length pixels. */
    void (*fill)(const compare_span *span, uint16_t *pixel, unsigned length);
} compare_span_kernel;

/* The library's own spans are measured where they are drawn, by the same profiler. */
extern const compare_span_kernel compare_spans[];
extern const unsigned compare_span_count;

/* ------------------------------------------------------------------------------------------------------------------- lobes */

/* C - a W - b W^1/2, W = n x^2: the parabola of paper 003 in a form whose numbers hardly depend on n. */
typedef struct compare_parabola {
    int32_t c_q30;
    uint16_t a_q15, b_q15;
} compare_parabola;

/* Refitted coefficients of paper 003 as laws in t = 1 / n: 10^6 a, b and C = c0 + c1 t + c2 t^2 + c3 t^3 with A = -n a and
 * B = -n^1/2 b (hosttest/papers/chebyshev.h; test_papers_lobes compares). */
/* clang-format off */
#define COMPARE_LAW_A {266253, 94276, 10310, 22039}
#define COMPARE_LAW_B {129296, -45086, -3122, -15060}
#define COMPARE_LAW_C {1009090, -2853, 3, -1133}
/* clang-format on */

typedef struct compare_lobe {
    lmb_lobe tuned;           /* the library's own */
    lmb_lobe w2, w4, w8, w16; /* (1 - n/m (1 - cos))^m, W_m of paper 000, in the library's integers */
    int32_t n, n_mirrored;    /* 1 to 1000; n / 4 to nearest, at least 1 */
    float n_f, ratio;         /* n, n / 16 */
    float published_f[2];     /* A, B as printed */
    compare_parabola published, refit;
    uint32_t parabola_end_q30, gauss_end_q30; /* x^2 / 2 from where these are zero */
    uint16_t gauss_scale_q15;                 /* n / ln 2 over 2^gauss_shift, in [1, 2) */
    uint8_t gauss_shift;
    uint16_t power[COMPARE_POWERS]; /* (i / 255)^n, UQ1.15 */
} compare_lobe;

typedef union compare_argument {
    float f;
    int32_t q;
} compare_argument;

/* Prepares all lobes for cos^n. Returns 0 or LMB_ERROR_VALUE. */
int compare_lobe_prepare(compare_lobe *lobe, unsigned n);

/* Cosines, Q2.30, of angles spread evenly from 0 to where cos^n is about 1/256. */
#define COMPARE_ARGUMENTS 64
void compare_lobe_cosines(int32_t cosine_q30[COMPARE_ARGUMENTS], unsigned n);

typedef struct compare_lobe_kernel {
    const char *name; /* lobe- and a name of hosttest/papers/lobes.h, or one of docs/COMPARISON.md */
    bool is_float;    /* a value is the bit pattern of a float, rather than UQ1.15 */
    /* cosines in the form that the lobe takes */
    void (*arguments)(const compare_lobe *lobe, compare_argument *argument, const int32_t *cosine_q30, unsigned count);
    /* the sum, modulo 2^32, of the lobe's values as words; for count = 1 the value itself */
    uint32_t (*sum)(const compare_lobe *lobe, const compare_argument *argument, unsigned count);
} compare_lobe_kernel;

extern const compare_lobe_kernel compare_lobes[];
extern const unsigned compare_lobe_count;

#endif
