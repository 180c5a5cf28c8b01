/* SPDX-License-Identifier: MIT */
/* Lambent: glossy, smoothly lit 3D for microcontroller displays, with integers alone.
 *
 * CONVENTIONS
 *
 * Space      right-handed; x to the right, y up, z towards the viewer. The camera stands at the origin and looks along -z.
 *            A pose carries a mesh from its own space into this one; lights are given in this one.
 *
 *                 y                       screen, pixels
 *                 |                       (0,0) +------> x
 *                 |                             |
 *                 +------ x                     |
 *                /                              v y
 *               z  (towards you)
 *
 * Winding    a triangle is seen from its front when its corners run counter-clockwise, y up; others are culled.
 * Screen     x to the right, y down, in Q28.4: one pixel is 16 units. The centre of pixel (i, j) is (16 i + 8, 16 j + 8).
 * Fill rule  top-left: a pixel is painted when its centre lies inside, or on a left or a top edge. So two triangles that share
 *            an edge leave no gap along it and paint no pixel twice.
 * Fixed point Qm.n, counted the ARM way: m includes the sign bit, m + n is the width. UQm.n is unsigned. A name that ends in
 *            _qN carries N fraction bits.
 *
 *              what                                    format   one is       range
 *              unit vectors, rotation matrices         Q2.14    16384        [-1, 1]
 *              sine, cosine                            Q2.14    16384        [-1, 1]
 *              positions in a mesh                     int16    2^-scale     times 2^scale, one power of two for a mesh
 *              positions in space, camera lengths      Q16.16   65536        (-32768, 32768)
 *              screen x, y                             Q28.4    16           [-32768, 32768) pixels
 *              terms along a span (N.L, ...)           Q2.30    2^30         (-2, 2)
 *              what a lobe returns                     UQ1.15   32768        [0, 1]
 *              colours                                 UQ0.8    255 is one   [0, 1]
 *              depth                                   UQ0.16   65535 far    0 is nearest
 *
 * Light      intensity = ambient + sum over lights of diffuse * max(0, N.L) + specular * lobe(N.H), per channel, then saturated
 *            at one. H is the normalised half vector of L and the viewer, who is far away along +z (paper 001, eq. 12).
 *            Colours are taken as they are: no gamma is applied.
 * Errors     mathematics returns values, never a status. Set-up calls return 0 or a negative enum lmb_error.
 * Memory     the caller owns every struct; no heap, no globals. Everything is re-entrant: two cores may draw two strips.
 */
#ifndef LMB_LAMBENT_H
#define LMB_LAMBENT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "arith.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------------------------------------------- version, configuration */

#define LMB_VERSION_MAJOR 0
#define LMB_VERSION_MINOR 1
#define LMB_VERSION_PATCH 0

#ifdef LMB_CONFIG
#include LMB_CONFIG
#endif

/* Most directional lights a look can hold, 1 to 4. Each costs 24 bytes in a triangle and 12 in a span for each of its two terms. */
#ifndef LMB_LIGHTS
#define LMB_LIGHTS 4
#endif
LMB_STATIC_ASSERT(LMB_LIGHTS >= 1 && LMB_LIGHTS <= 4);

enum lmb_error {
    LMB_OK = 0,
    LMB_ERROR_VALUE = -1, /* an argument is outside its documented range */
    LMB_ERROR_LIGHTS = -2 /* more lights than LMB_LIGHTS */
};

/* --------------------------------------------------------------------------------------------------------------------- vectors */

/* A unit vector or a matrix row in Q2.14, or a mesh position in mesh units. */
typedef struct lmb_vec {
    int16_t x, y, z;
} lmb_vec;

/* Rotation, Q2.14, rows first: out = (row[0].v, row[1].v, row[2].v). */
typedef struct lmb_matrix {
    lmb_vec row[3];
} lmb_matrix;

/* Exact dot product of two unit vectors, Q4.28. |result| < 2^30. */
int32_t lmb_dot_q28(lmb_vec a, lmb_vec b);

/* Half the squared distance of two unit vectors, 1 - cos of the angle between them, UQ4.28 in [0, 2]. Keeps its relative
 * precision when the angle is small, where 1 - a.b cancels. Exact but for one rounding (towards zero, 2^-28). */
int32_t lmb_half_distance_q28(lmb_vec a, lmb_vec b);

/* 1/sqrt(x) of a normalised argument.
 *   x       UQ2.30 in [0.25, 1), i.e. 0x10000000...0x3fffffff; outside: unspecified value, no fault
 *   return  UQ2.30 in (1, 2]
 *   error   at most LMB_RSQRT_MAX_ERROR relative (hosttest/test_vec.c)
 *   cost    table of 96 entries, two steps of Newton's method, multiplications only */
#define LMB_RSQRT_MAX_ERROR (1.0 / (1 << 26))
uint32_t lmb_rsqrt_q30(uint32_t x);

/* (x, y, z) scaled to unit length, without division or square root; components any int32 with |.| < 2^30.
 * The zero vector gives (0, 0, 16384), so that the result is always a unit vector. Components are rounded to nearest. */
lmb_vec lmb_normalise(int32_t x, int32_t y, int32_t z);

/* m times v, rounded to nearest, saturated at int16. */
lmb_vec lmb_rotate(const lmb_matrix *m, lmb_vec v);

/* The transpose of m times v: the inverse rotation. */
lmb_vec lmb_rotate_back(const lmb_matrix *m, lmb_vec v);

/* Sine and cosine, Q2.14, of an angle in 1/65536 of a turn. Error at most LMB_SINE_MAX_ERROR. */
#define LMB_SINE_MAX_ERROR (0.75 / 16384)
int32_t lmb_sin_q14(uint16_t angle);
int32_t lmb_cos_q14(uint16_t angle);

/* Rotation about x, then y, then z, by angles in 1/65536 of a turn, counter-clockwise seen from the axis' tip. */
lmb_matrix lmb_rotation(uint16_t x, uint16_t y, uint16_t z);

/* 1/x for x >= 1: x * result = 2^(31 + *shift) up to a relative error of LMB_RECIPROCAL_MAX_ERROR; result in (2^30, 2^31],
 * *shift = 31 - lmb_clz32(x). x = 0 is taken as 1. */
#define LMB_RECIPROCAL_MAX_ERROR (1.0 / (1 << 28))
uint32_t lmb_reciprocal(uint32_t x, unsigned *shift);

/* ------------------------------------------------------------------------------------------------------------------- the lobe */

/* Which polynomial stands for cos^n: the tuned one, or W_m of paper 000 with its argument clamped at zero. */
enum lmb_lobe_kind { LMB_LOBE_TUNED, LMB_LOBE_W2, LMB_LOBE_W4, LMB_LOBE_W8, LMB_LOBE_W16 };

/* A prepared lobe. s = alpha - slope * (1 - cos); then s <- s*s + lift once, then squarings - 1 times s <- s*s.
 * Fields may change without notice. */
typedef struct lmb_lobe {
    int32_t alpha_q30;   /* value of s at the centre */
    uint16_t slope;      /* mantissa in [32768, 65535], or 0 */
    int8_t slope_shift;  /* slope = mantissa * 2^(slope_shift - 15) per unit of 1 - cos; from -3 to 10 */
    uint8_t squarings;   /* 0 to 4 */
    int32_t lift_q30;    /* added after the first squaring */
    uint16_t floor_q15;  /* s is clamped from below here, so that s*s + lift starts at zero and the curve stays monotone */
    uint16_t shininess;  /* n */
} lmb_lobe;

#define LMB_SHININESS_MAX 1000

/* Prepares a lobe for cos^n.
 *   n          1 to LMB_SHININESS_MAX
 *   tolerance  largest error that is good enough, UQ0.16; the fewest squarings that meet it are taken. 0: the most accurate
 *   return     0 or LMB_ERROR_VALUE
 * The largest error over every n and every angle, integer arithmetic, tolerance 0, is LMB_LOBE_MAX_ERROR
 * (exhaustive, hosttest/test_lobe.c). */
#define LMB_LOBE_MAX_ERROR (1.0 / 700)
int lmb_lobe_prepare(lmb_lobe *lobe, enum lmb_lobe_kind kind, unsigned n, uint16_t tolerance);

/* ----------------------------------------------------------------------------------------------------------- look: what light does */

typedef struct lmb_rgb {
    uint8_t r, g, b;
} lmb_rgb;

typedef struct lmb_material {
    lmb_rgb ambient, diffuse, specular;
    uint16_t shininess; /* n of cos^n, 1 to LMB_SHININESS_MAX */
} lmb_material;

/* A directional light: unit vector from the surface towards it, and its colour. */
typedef struct lmb_light {
    lmb_vec direction;
    lmb_rgb colour;
} lmb_light;

/* What is computed for each pixel. */
enum lmb_model {
    LMB_MODEL_FLAT,    /* one intensity for a triangle, at the normalised sum of its normals */
    LMB_MODEL_GOURAUD, /* diffuse and specular at the corners, linear between */
    LMB_MODEL_DIFFUSE, /* N.L for each pixel, no highlight */
    LMB_MODEL_GLOSS    /* N.L and the lobe of N.H for each pixel */
};

/* How the dot products N.L and N.H get from the corners to a pixel. */
enum lmb_step_kind {
    LMB_STEP_LINEAR,    /* linear over the triangle */
    LMB_STEP_QUADRATIC, /* quadratic over the triangle through the corners and the normalised mid-edge normals */
    LMB_STEP_ARC        /* normals turn evenly along the edges and along each span (paper 001) */
};

/* Material, lights and choices, prepared once. Fields may change without notice. */
typedef struct lmb_look {
    lmb_lobe lobe;
    uint8_t model, step, lights;
    uint16_t ambient_q15[3]; /* r, g, b in UQ1.15 */
    struct lmb_look_light {
        lmb_vec direction, half;                  /* unit, in space */
        uint16_t diffuse_q15[3], specular_q15[3]; /* material times light */
    } light[LMB_LIGHTS];
} lmb_look;

/* Prepares a look: folds material and lights together, builds the half vectors, prepares the tuned lobe.
 *   return  0; LMB_ERROR_VALUE for a shininess, model or step out of range or a direction that is not a unit vector (5 %);
 *           LMB_ERROR_LIGHTS for none or more than LMB_LIGHTS */
int lmb_look_prepare(lmb_look *look, const lmb_material *material, const lmb_light *lights, unsigned light_count,
                     enum lmb_model model, enum lmb_step_kind step);

/* Light and half vectors in the space of the normals that they meet: turned once per mesh, so that normals never are. */
typedef struct lmb_rays {
    struct lmb_ray {
        lmb_vec direction, half;
    } light[LMB_LIGHTS];
} lmb_rays;

/* The rays of a look for normals of a mesh turned by rotation; NULL: normals are given in space. */
void lmb_rays_prepare(lmb_rays *rays, const lmb_look *look, const lmb_matrix *rotation);

/* --------------------------------------------------------------------------------------------------- terms along a row of pixels */

/* One dot product (N.L, N.H, or a component of a normal) from pixel to pixel, Q2.30 times a power of two that its owner knows.
 * Over a triangle: f += d, d += c. Along an arc: see arc.h. */
typedef struct lmb_term {
    int32_t f, d, c;
} lmb_term;

/* What all terms of one arc share: the turn of the normal from pixel to pixel. Fields may change without notice. */
typedef struct lmb_arc {
    uint16_t kappa;      /* mantissa of 4 sin^2(phi/2), 14 bits */
    uint8_t kappa_shift; /* its exponent: see lmb_arc_step */
    uint8_t guard;       /* extra fraction bits of d */
    int32_t w;           /* sin(phi) / sin(psi), fitted to the rounded kappa */
    uint8_t w_shift;
} lmb_arc;

/* Set-up of an arc from the angle psi between its end normals and its length: neither arccos, sine, root nor division.
 *   u_q28   1 - cos(psi) as lmb_half_distance_q28 gives it, [0, 2]. Up to LMB_ARC_U_MAX (psi = 120 degrees) the normal turns
 *           evenly; beyond, where the turn loses its direction, terms run linearly instead
 *   length  of the arc in 1/16 pixel, 1 to 65536 */
#define LMB_ARC_U_MAX 0x18000000
void lmb_arc_prepare(lmb_arc *arc, int32_t u_q28, uint32_t length);

/* Starts a term on an arc.
 *   a_q30       its value at the start of the arc, [-1.0001, 1.0001] in Q2.30
 *   rise_q30    value at the end minus value at the start, from a difference of vectors rather than of values
 *   start       distance of the first pixel centre from the start of the arc in 1/16 pixel, 0 to 16 */
void lmb_arc_start(const lmb_arc *arc, lmb_term *term, int32_t a_q30, int32_t rise_q30, uint32_t start);

/* ------------------------------------------------------------------------------------------------------------ triangles into spans */

/* A corner on the screen. Corners beyond LMB_SCREEN_MAX are clipped before (lmb_mesh_next does it). */
typedef struct lmb_vertex {
    int32_t x, y;   /* Q28.4 */
    lmb_vec normal; /* unit, in the space of the rays */
    uint16_t depth;
} lmb_vertex;

/* Largest |x| and |y| of a corner, in 1/16 pixel. */
#define LMB_SCREEN_MAX (32767 * 16)

/* Pixels left <= x < right, top <= y < bottom of the frame. */
typedef struct lmb_window {
    int16_t left, top, right, bottom;
} lmb_window;

/* A run of pixels in one row with its terms at the first pixel's centre. */
typedef struct lmb_span {
    int16_t x, y;
    uint16_t length;                 /* at least 1 */
    uint8_t kind;                    /* enum lmb_span_kind */
    uint8_t lights;                  /* how many of diffuse[] and specular[] are in use */
    uint8_t exponent[LMB_LIGHTS];    /* specular[i] holds s in Q2.30 divided by 2^exponent[i] */
    lmb_arc arc;                     /* for LMB_SPAN_ARC */
    lmb_term diffuse[LMB_LIGHTS];    /* N.L */
    lmb_term specular[LMB_LIGHTS];   /* the lobe's argument s, or its value for LMB_MODEL_GOURAUD and LMB_MODEL_FLAT */
    uint32_t depth;                  /* UQ16.16 */
    int32_t depth_step;
} lmb_span;
#ifdef __cplusplus
}
#endif

#include "step.h"

#endif
