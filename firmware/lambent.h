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
 *            at one. N.L and N.H count as at most one. H is the normalised half vector of L and the viewer, who is far away
 *            along +z (paper 001, eq. 12). Colours are taken as they are: no gamma is applied.
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

/* ------------------------------------------------------------------------------------------------ version, configuration */

#define LMB_VERSION_MAJOR 0
#define LMB_VERSION_MINOR 1
#define LMB_VERSION_PATCH 0

#ifdef LMB_CONFIG
#include LMB_CONFIG
#endif

/* Most directional lights a look can hold, 1 to 4. Each costs 24 bytes in a triangle and 12 in a span for each of its two
 * terms. */
#ifndef LMB_LIGHTS
#define LMB_LIGHTS 4
#endif
LMB_STATIC_ASSERT(LMB_LIGHTS >= 1 && LMB_LIGHTS <= 4);

/* What is built in, 1, or left out to save flash, 0. A call that asks for what was left out returns LMB_ERROR_VALUE.
 * `make size` prints what each saves. */
#ifndef LMB_WITH_ARC
#define LMB_WITH_ARC 1 /* LMB_STEP_ARC */
#endif
#ifndef LMB_WITH_PLANS
#define LMB_WITH_PLANS 1 /* LMB_STEP_PLANNED */
#endif
#ifndef LMB_WITH_QUADRATIC
#define LMB_WITH_QUADRATIC 1 /* LMB_STEP_QUADRATIC */
#endif
#ifndef LMB_WITH_DIFFUSE
#define LMB_WITH_DIFFUSE                                                                                                         \
    1 /* LMB_MODEL_DIFFUSE; without it and gloss nothing is reckoned for each pixel, no arcs and no plans either */
#endif
#ifndef LMB_WITH_GLOSS
#define LMB_WITH_GLOSS 1 /* LMB_MODEL_GLOSS */
#endif
#ifndef LMB_WITH_CORNERS
#define LMB_WITH_CORNERS 1 /* LMB_MODEL_FLAT and LMB_MODEL_GOURAUD */
#endif
#ifndef LMB_WITH_GOURAUD
#define LMB_WITH_GOURAUD LMB_WITH_CORNERS /* LMB_MODEL_GOURAUD */
#endif
#define LMB_WITH_PIXELS (LMB_WITH_DIFFUSE || LMB_WITH_GLOSS)
#if !LMB_WITH_PIXELS
#undef LMB_WITH_ARC
#undef LMB_WITH_PLANS
#define LMB_WITH_ARC 0
#define LMB_WITH_PLANS 0
#endif
#ifndef LMB_WITH_PERSPECTIVE
#define LMB_WITH_PERSPECTIVE 1 /* perspective cameras, and clipping at the near plane and beyond LMB_SCREEN_MAX */
#endif
#ifndef LMB_WITH_DEPTH
#define LMB_WITH_DEPTH 1 /* depth of corners and spans; without, corners have depth 0 */
#endif
/* Without both, near and far mean nothing, and a mesh is drawn if 2^15 of its units are r pixels, at most 510, and its origin is
 * within 1020 - 2 r pixels of the frame's corner, across and down. */
#ifndef LMB_WITH_LOBES
#define LMB_WITH_LOBES 1 /* lobes reckoned for each pixel, W_m of paper 000 among them; without, ramps hold exact powers */
#endif
#ifndef LMB_WITH_LARGE
#define LMB_WITH_LARGE 1 /* full accuracy for triangles over 512 pixels, 128 times longer than high, or bent across a sliver */
#endif
LMB_STATIC_ASSERT((LMB_WITH_LOBES | LMB_WITH_LARGE | LMB_WITH_ARC | LMB_WITH_CORNERS | LMB_WITH_PERSPECTIVE | LMB_WITH_DEPTH |
                   LMB_WITH_PLANS | LMB_WITH_QUADRATIC | LMB_WITH_DIFFUSE | LMB_WITH_GLOSS | LMB_WITH_GOURAUD | 1) == 1);
LMB_STATIC_ASSERT(LMB_WITH_GOURAUD <= LMB_WITH_CORNERS && LMB_WITH_PIXELS + LMB_WITH_CORNERS > 0);

enum lmb_error {
    LMB_OK = 0,
    LMB_ERROR_VALUE = -1, /* an argument is outside its documented range */
    LMB_ERROR_LIGHTS = -2 /* more lights than LMB_LIGHTS */
};

/* ----------------------------------------------------------------------------------------------------------------- types */

/* A unit vector or a matrix row in Q2.14, or a mesh position in mesh units. */
typedef struct lmb_vec {
    int16_t x, y, z;
} lmb_vec;

/* Rotation, Q2.14, rows first: out = (row[0].v, row[1].v, row[2].v). */
typedef struct lmb_matrix {
    lmb_vec row[3];
} lmb_matrix;

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

/* Which polynomial stands for cos^n: the tuned one, or W_m of paper 000 with its argument clamped at zero. */
enum lmb_lobe_kind { LMB_LOBE_TUNED, LMB_LOBE_W2, LMB_LOBE_W4, LMB_LOBE_W8, LMB_LOBE_W16 };

/* What is computed for each pixel. */
enum lmb_model {
    LMB_MODEL_FLAT, /* one intensity for a triangle, at the normalised sum of its normals; of a mesh, at the face's own normal */
    LMB_MODEL_GOURAUD, /* diffuse and specular at the corners, linear between */
    LMB_MODEL_DIFFUSE, /* N.L for each pixel, no highlight */
    LMB_MODEL_GLOSS    /* N.L and the lobe of N.H for each pixel */
};

/* How the dot products N.L and N.H get from the corners to a pixel. */
enum lmb_step_kind {
    LMB_STEP_LINEAR,    /* linear over the triangle */
    LMB_STEP_QUADRATIC, /* quadratic over the triangle through the corners and the normalised mid-edge normals */
    LMB_STEP_ARC,       /* normals turn evenly along the edges and along each span (paper 001) */
    LMB_STEP_PLANNED /* for each triangle and term the cheapest of these, or a constant, that the display cannot tell from arcs */
};

/* A corner on the screen. */
typedef struct lmb_vertex {
    int32_t x, y;   /* Q28.4, at most LMB_SCREEN_MAX in magnitude */
    lmb_vec normal; /* unit, in the space of the rays */
    uint16_t depth;
} lmb_vertex;

/* Pixels left <= x < right, top <= y < bottom of the frame, and whether spans in it are to carry their depth. */
typedef struct lmb_window {
    int16_t left, top, right, bottom;
    bool depth;
} lmb_window;

/* One dot product (N.L, N.H, or a component of a normal) from pixel to pixel, Q2.30 times a power of two that its owner knows.
 * Over a triangle: f += d, d += c. Along an arc: see arc.h. */
typedef struct lmb_term {
    int32_t f, d, c;
} lmb_term;

/* Where constant data live: a qualifier of tables and meshes, and of what the pointers that read them point to. Empty where flash
 * is in the address space. On AVR it is __flash of avr-gcc (-std=gnu99 or later): the first 64 KB, read by LPM, so what such a
 * pointer points to cannot be in RAM. */
#ifndef LMB_FLASH
#if defined(__AVR__) && !defined(__cplusplus)
#define LMB_FLASH __flash
#else
#define LMB_FLASH
#endif
#endif

#define LMB_SCALE_MIN (-30)
#define LMB_SCALE_MAX (-2) /* 8192 units: a quarter of what Q16.16 holds, so that sums of products do */

/* A mesh, const and ready for flash; lmb-mesh writes it from a Wavefront OBJ file. */
typedef struct lmb_mesh {
    const LMB_FLASH lmb_vec *positions; /* mesh units */
    const LMB_FLASH lmb_vec *normals;   /* unit, Q2.14, one per vertex */
    const LMB_FLASH uint16_t *indices;  /* three per triangle, counter-clockwise seen from outside */
    uint16_t vertices;
    uint32_t triangles;
    int8_t scale;  /* a mesh unit is 2^scale units of space, LMB_SCALE_MIN to LMB_SCALE_MAX */
    uint16_t bend; /* what lmb_mesh_bend says; 0: unknown, and found for each triangle anew */
} lmb_mesh;

/* Where a mesh stands: turned first, then moved. */
typedef struct lmb_pose {
    lmb_matrix rotation;
    int32_t x, y, z; /* Q16.16 */
} lmb_pose;

/* A position in space, Q16.16. */
typedef struct lmb_point {
    int32_t x, y, z;
} lmb_point;

#ifdef __cplusplus
}
#endif

/* What callers own and the library fills: lmb_lobe, lmb_look, lmb_rays, lmb_end, lmb_beam, lmb_arc, lmb_curve,
 * lmb_triangle, lmb_camera, lmb_walk. */
#include "state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --------------------------------------------------------------------------------------------------------------- vectors */

/* Exact dot product of two unit vectors, Q4.28. |result| < 2^28 * 1.001. Vectors up to 1.41 long do not overflow. */
int32_t lmb_dot_q28(lmb_vec a, lmb_vec b);

/* Half the squared distance of two unit vectors, 1 - cos of the angle between them, UQ4.28 in [0, 2]. Keeps its relative
 * precision when the angle is small, where 1 - a.b cancels. Exact but for one rounding (towards zero, 2^-28). Vectors up to
 * 1.41 long do not overflow. */
int32_t lmb_half_distance_q28(lmb_vec a, lmb_vec b);

/* 1/sqrt(x) of a normalised argument.
 *   x       UQ2.30 in [0.25, 1), i.e. 0x10000000...0x3fffffff; outside: unspecified value, no fault
 *   return  UQ2.30 in (1 - 2^-26, 2): it fits int32_t
 *   error   at most LMB_RSQRT_MAX_ERROR relative, either way (every argument, hosttest/test_vec.c)
 *   cost    four steps of Newton's method in 13 32-bit products; no table */
#define LMB_RSQRT_MAX_ERROR (0.8 / (1L << 26))
uint32_t lmb_rsqrt_q30(uint32_t x);

/* (x, y, z) scaled to unit length, without division or square root.
 *   x, y, z  any one scale, |.| < 2^30 (-2^30 passes as well); a single unit will do: nothing is lost for small ones
 *   return   unit vector, Q2.14; the zero vector gives (0, 0, 16384). Axes stay axes exactly
 *   error    of each component at most LMB_NORMALISE_MAX_ERROR, of which 0.5 / 16384 is the rounding to nearest. Beside a tie
 *            the rounding may differ between v and -v
 *   cost     lmb_rsqrt_q30 and 18 32-bit products */
#define LMB_NORMALISE_MAX_ERROR (0.501 / 16384)
lmb_vec lmb_normalise(int32_t x, int32_t y, int32_t z);

/* m times v, rounded to nearest, halves up, saturated at int16. v: any; m: rows and columns up to 1.01 long, or sums overflow. */
lmb_vec lmb_rotate(const lmb_matrix *m, lmb_vec v);

/* m times v with all 14 fraction bits: exact, |out| < 2^30. v: any; rows of m up to 1.01 long. */
void lmb_rotate_wide(const lmb_matrix *m, lmb_vec v, int32_t out[3]);

/* The transpose of m times v: the inverse rotation. Otherwise as lmb_rotate. */
lmb_vec lmb_rotate_back(const lmb_matrix *m, lmb_vec v);

/* Sine and cosine, Q2.14, of an angle in 1/65536 of a turn. Exact at quarter turns, exactly odd and even; error at most
 * LMB_SINE_MAX_ERROR (every angle, hosttest/test_vec.c). */
#define LMB_SINE_MAX_ERROR (0.56 / 16384)
int32_t lmb_sin_q14(uint16_t angle);
int32_t lmb_cos_q14(uint16_t angle);

/* Rotation about x, then y, then z, by angles in 1/65536 of a turn, counter-clockwise seen from the axis' tip. Elements err at
 * most LMB_ROTATION_MAX_ERROR, so rows are unit within 1.8 times and at right angles within 3.5 times that. */
#define LMB_ROTATION_MAX_ERROR (0.75 / 16384)
lmb_matrix lmb_rotation(uint16_t x, uint16_t y, uint16_t z);

/* 1/x, never above the true value.
 *   x       1 to 2^32 - 1; 0 is taken as 1
 *   return  in [2^30, 2^31); x * result = 2^(31 + *shift) (1 - e), 0 < e <= LMB_RECIPROCAL_MAX_ERROR
 *           (every argument, hosttest/test_vec.c). A power of two gives slightly less than its true 2^31, too
 *   shift   31 - lmb_clz32(x)
 *   cost    three steps of Newton's method in six 32-bit products; no table */
#define LMB_RECIPROCAL_MAX_ERROR (0.8 / (1L << 28))
uint32_t lmb_reciprocal(uint32_t x, unsigned *shift);

/* -------------------------------------------------------------------------------------------------------------- the lobe */

#define LMB_SHININESS_MAX 1000

/* Prepares a lobe for cos^n.
 *   n          1 to LMB_SHININESS_MAX
 *   tolerance  largest error that is good enough, UQ0.16; the fewest multiplications that promise it are taken. 0: the most
 *              accurate. W_m has nothing to choose and ignores it
 *   return     0 or LMB_ERROR_VALUE
 * The largest error over every n and every angle, integer arithmetic, tolerance 0, is LMB_LOBE_MAX_ERROR
 * (exhaustive, hosttest/test_lobe.c). */
#define LMB_LOBE_MAX_ERROR (1.0 / 1000)
int lmb_lobe_prepare(lmb_lobe *lobe, enum lmb_lobe_kind kind, unsigned n, uint16_t tolerance);

/* ------------------------------------------------------------------------------------------------- look: what light does */

/* How many lights a look has: a constant where there can be but one. */
static inline unsigned lmb_look_lights(const lmb_look *look) { return LMB_LIGHTS == 1 ? 1u : look->lights; }

/* Prepares a look: folds material and lights together, builds the half vectors, prepares the tuned lobe.
 *   return  0; LMB_ERROR_VALUE for a shininess, model or step out of range or a direction that is not a unit vector (5 %);
 *           LMB_ERROR_LIGHTS for none or more than LMB_LIGHTS */
int lmb_look_prepare(lmb_look *look, const lmb_material *material, const lmb_light *lights, unsigned light_count,
                     enum lmb_model model, enum lmb_step_kind step);

/* Takes another lobe than the tuned one, or fewer multiplications where tolerance allows: see lmb_lobe_prepare. Returns as
 * that does. */
int lmb_look_lobe(lmb_look *look, enum lmb_lobe_kind kind, uint16_t tolerance);

/* What does not show: highlights fainter than tolerance, UQ0.16, are left out, which saves their pixels most of the cost.
 * lmb_look_prepare sets LMB_TOLERANCE_RGB888; 0 leaves nothing out but where the lobe ends.
 * LMB_STEP_PLANNED: all of a pixel stays within twice the tolerance of exact normals and powers, beside what the arithmetic of spans
 * and lobes errs by: half a level with what paints set (docs/NUMERICS.md, Plans). Lights share it, and the lobe is the cheapest that
 * leaves room for the rest, unless lmb_look_lobe has chosen one.
 * Specular terms carry the highlight's argument, which is above zero where there is something to be seen: s of the lobe (lobe.h)
 * less its value where the highlight ends, light[i].dark_q16; after lmb_look_ramp a ramp's. */
#define LMB_TOLERANCE_RGB888 64  /* a quarter of a level of 255 */
#define LMB_TOLERANCE_RGB565 260 /* a quarter of a level of 63 */
void lmb_look_tolerance(lmb_look *look, uint16_t tolerance);

/* For those who look the highlight up: lets the argument fall from one, Q2.30, where N.H is one to zero where the highlight ends, so
 * that a ramp spends no step on what is not seen. What to put into it: lmb_look_ramp_at gives the lobe, UQ1.15, at an argument in
 * UQ2.30 for light i. lmb_look_tolerance undoes it. */
void lmb_look_ramp(lmb_look *look);
int32_t lmb_look_ramp_at(const lmb_look *look, unsigned i, uint32_t argument_q30);

/* The rays of a look for normals of a mesh turned by rotation; NULL: normals are given in space. To be prepared anew when the look
 * changes, tolerance and lobe included. */
void lmb_rays_prepare(lmb_rays *rays, const lmb_look *look, const lmb_matrix *rotation);

/* ------------------------------------------------------------------------------------------- terms along a row of pixels */

/* Set-up of an arc from the angle psi between its end normals and its length: neither arccos, sine, root nor division.
 *   u_q28   1 - cos(psi), UQ4.28 in [0, 2]. Up to LMB_ARC_U_MAX (psi = 120 degrees) the normal turns evenly; beyond, where the
 *           turn loses its direction, terms run linearly instead
 *   length  of the arc, LMB_ARC_PIXEL to a pixel, 1 to LMB_ARC_LENGTH_MAX. So fine because normals can turn through a right angle
 *           in a tenth of a pixel, at outlines: with 256 to a pixel some of their pixels are off by five levels of 255
 *   start   distance of the first pixel centre from the start of the arc in the same unit, below LMB_ARC_PIXEL; past the end of
 *           a shorter arc: its end
 * Largest error of a term of amplitude one from first to last pixel, hosttest/test_arc.c: LMB_ARC_MAX_ERROR up to 90 degrees
 * and 1024 pixels, LMB_ARC_WIDE_MAX_ERROR up to 120 degrees and 4096 pixels. */
#define LMB_ARC_U_MAX 0x18000000
#define LMB_ARC_PIXEL 65536u
#define LMB_ARC_LENGTH_MAX 0xffffffffu /* 65536 pixels less a unit */
#define LMB_ARC_MAX_ERROR (1.0 / (1 << 14))
#define LMB_ARC_WIDE_MAX_ERROR (1.0 / (1 << 13))
void lmb_arc_prepare(lmb_arc *arc, int32_t u_q28, uint32_t length, uint32_t start);

/* Starts a term on an arc.
 *   a_q30     its value at the start of the arc, Q2.30
 *   rise_q30  value at the end minus value at the start, Q2.30
 * Values and angle must belong together: a cos + b sin with an amplitude of at most 1.06, as dot products of vectors that are
 * unit within 5 % have. To scale a term, scale a and rise. */
void lmb_arc_start(const lmb_arc *arc, lmb_term *term, int32_t a_q30, int32_t rise_q30);

/* The same from the two normals at the ends of the arc, in Q2.14. Rounded vectors are not quite unit, which at n = 1000 is seen;
 * lmb_arc_between and lmb_arc_dot take them as if they were normalised, up to the square of what they lack.
 * Vectors more than 5 % off, the zero vector and opposite normals give some value in [-1, 1] at both ends.
 *   ray    unit vector, Q2.14: the term is its dot product with the normal
 *   scale  UQ1.16 in [0, 65536]: factor of the term
 * Error of the term with scale 65536: LMB_SPAN_DIFFUSE_MAX_ERROR up to 90 degrees and 1024 pixels. What a highlight makes of it,
 * beside the lobe's own error: LMB_SPAN_SPECULAR_MAX_ERROR (n up to 256), LMB_SPAN_GLOSS_MAX_ERROR (n up to 1000).
 * From 90 to 120 degrees, double those. lmb_arc_dot wants an arc that lmb_arc_between has prepared for the same normals. */
#define LMB_SPAN_DIFFUSE_MAX_ERROR (1.0 / 2000)
#define LMB_SPAN_SPECULAR_MAX_ERROR (1.0 / 255)
#define LMB_SPAN_GLOSS_MAX_ERROR (2.0 / 255)
void lmb_arc_between(lmb_arc *arc, lmb_vec from, lmb_vec to, uint32_t length, uint32_t start);
void lmb_arc_dot(const lmb_arc *arc, lmb_term *term, lmb_vec from, lmb_vec to, lmb_vec ray, uint32_t scale);

/* The squared length of a vector less one, Q4.28, exact. */
int32_t lmb_excess_q28(lmb_vec v);

/* The same for spans by the hundred: ends are prepared once a row, beams once a mesh, and each term takes a third of the time.
 *   lmb_end_prepare   takes a normal; it is normalised if its squared length is more than 2^-11 off one
 *   lmb_beam_prepare  takes a ray and a scale as lmb_arc_dot does. Its components are rounded, so that terms are up to 2^-15 of
 *                     one off, but all by the same part: beam.peak_q30 is what a term is where the normal meets the ray, and peak
 *                     less term is scale times 1 - cos as exactly as highlights want it
 *   lmb_ends_u_q28    1 - cos of the angle between the ends, UQ4.28, for lmb_arc_prepare and lmb_curve_prepare */
void lmb_end_prepare(lmb_end *end, lmb_vec normal);
void lmb_beam_prepare(lmb_beam *beam, lmb_vec ray, uint32_t scale);
int32_t lmb_ends_u_q28(const lmb_ends *ends);

/* Starts the term of a beam on an arc that has been prepared for the ends; term->c is left alone. lmb_arc_beam is as exact as
 * lmb_arc_dot. The rough one takes half of its time and is for diffuse terms: LMB_SPAN_DIFFUSE_MAX_ERROR, but not for highlights.
 * lmb_arc_start_rough is lmb_arc_start in that manner. */
void lmb_arc_beam(const lmb_arc *arc, lmb_term *term, const lmb_ends *ends, const lmb_beam *beam);
void lmb_arc_beam_rough(const lmb_arc *arc, lmb_term *term, const lmb_ends *ends, const lmb_beam *beam);
void lmb_arc_start_rough(const lmb_arc *arc, lmb_term *term, int32_t a_q30, int32_t rise_q30);

/* Where the normals turn little a parabola stands for the arc, through its ends and its middle. Its terms run by lmb_plane_step,
 * as those of LMB_SPAN_PLANE; set-up takes two thirds of an arc's time. lmb_curve_prepare takes length and start as for arcs, and
 * returns false, with nothing written, for u_q28 above LMB_CURVE_U_MAX or length above LMB_CURVE_LENGTH_MAX: that wants an arc.
 * lmb_curve_limit_q28 gives the u up to which lmb_curve_beam is good enough for diffuse terms and for a highlight of exponent n: with
 * the errors that arcs have (LMB_SPAN_...). lmb_curve_beam_rough takes half of its time, needs no excess of the ends, and serves any
 * u for diffuse terms and exponents up to LMB_CURVE_ROUGH_SHININESS: LMB_CURVE_ROUGH_MAX_ERROR, a quarter of a level of 63. */
#define LMB_CURVE_U_MAX 0xe00000 /* 19 degrees */
#define LMB_CURVE_LENGTH_MAX (64ul * LMB_ARC_PIXEL)
#define LMB_CURVE_ROUGH_MAX_ERROR (0.25 / 63)
#define LMB_CURVE_ROUGH_SHININESS 32
int32_t lmb_curve_limit_q28(unsigned n);
bool lmb_curve_prepare(lmb_curve *curve, int32_t u_q28, uint32_t length, uint32_t start);
void lmb_curve_start(const lmb_curve *curve, lmb_term *term, int32_t a_q30, int32_t rise_q30);
void lmb_curve_beam(const lmb_curve *curve, lmb_term *term, const lmb_ends *ends, const lmb_beam *beam);
void lmb_curve_beam_rough(const lmb_curve *curve, lmb_term *term, const lmb_ends *ends, const lmb_beam *beam);

/* -------------------------------------------------------------------------------------------------- triangles into spans */

/* Largest |x| and |y| of a corner, in 1/16 pixel. Triangles that reach further are clipped before (lmb_mesh_next does it). */
#define LMB_SCREEN_MAX (32767L * 16)

/* How the terms of a span run from pixel to pixel. */
enum lmb_span_kind {
    LMB_SPAN_FLAT,  /* terms are constant */
    LMB_SPAN_PLANE, /* lmb_plane_step: f += d, d += c */
    LMB_SPAN_ARC    /* lmb_arc_step */
};

/* A run of pixels in one row, its terms at the first pixel's centre. A light whose diffuse (specular) bit is not set adds nothing
 * of that kind anywhere in the span, and its term is not written. */
typedef struct lmb_span {
    int16_t x, y;
    uint16_t length;               /* pixels, at least 1 */
    uint8_t kind;                  /* enum lmb_span_kind */
    uint8_t diffuse_on;            /* bit i: diffuse[i] may be above zero */
    uint8_t specular_on;           /* bit i: specular[i] may be above zero */
    uint8_t exponent[LMB_LIGHTS];  /* specular[i] holds the argument over 2^exponent[i] */
    lmb_arc arc;                   /* for LMB_SPAN_ARC */
    lmb_term diffuse[LMB_LIGHTS];  /* N.L, Q2.30 */
    lmb_term specular[LMB_LIGHTS]; /* gloss: the argument, see lmb_look_tolerance; flat and gouraud: the lobe's value; Q2.30 */
    lmb_term depth; /* if the window asks for it: UQ0.16 in the upper half of Q2.30: depth.f >> 14; runs by lmb_plane_step */
} lmb_span;

/* Sets a triangle up: culls, clips to the window, chooses nothing that the look has not chosen.
 *   a, b, c  corners, counter-clockwise on the screen with y up; they must stay in place until the last span
 *   return   false if there is nothing to draw: seen from behind, no area, outside the window, or a corner beyond
 *            LMB_SCREEN_MAX */
bool lmb_triangle_begin(lmb_triangle *triangle, const lmb_look *look, const lmb_rays *rays, const lmb_vertex *a,
                        const lmb_vertex *b, const lmb_vertex *c, const lmb_window *window);

/* Diffuse terms from here on count as one, Q2.30: 1.125 (N.L itself can pass one by rounding and by bulging). */
#define LMB_DIFFUSE_TOP 0x48000000

/* For loops that walk the rows themselves (step.h): begins the edges at the next row, y; takes the one below the middle corner when y
 * has reached y_switch. */
void lmb_triangle_walk(lmb_triangle *triangle);
void lmb_triangle_turn(lmb_triangle *triangle);

/* The next span, top to bottom; false when there is none left. Every pixel of the triangle inside the window comes once. */
bool lmb_triangle_next(lmb_triangle *triangle, lmb_span *span);

/* How a term is reckoned over a triangle. */
enum lmb_way { LMB_WAY_NONE, LMB_WAY_CONSTANT, LMB_WAY_LINEAR, LMB_WAY_QUADRATIC, LMB_WAY_ARC };
#define LMB_WAYS 5

/* What was chosen for the terms of a light in a triangle that lmb_triangle_begin or lmb_mesh_next has set up. */
enum lmb_way lmb_triangle_diffuse(const lmb_triangle *triangle, unsigned light);
enum lmb_way lmb_triangle_specular(const lmb_triangle *triangle, unsigned light);

/* The same, counted: begin with zeros, add what is drawn. Terms of several lights count each. */
typedef struct lmb_statistics {
    uint32_t triangles, diffuse[LMB_WAYS], specular[LMB_WAYS];
} lmb_statistics;
void lmb_statistics_add(lmb_statistics *statistics, const lmb_triangle *triangle);

/* ------------------------------------------------------------------------------------------------- meshes into triangles */

/* Cameras for a frame of width x height pixels, axis through its middle.
 *   focal_q16  UQ16.16, above 0: pixels per unit (orthographic) or focal length in pixels (perspective)
 *   near, far  distances in front of the camera, Q16.16, near < far, far - near < 32768; perspective: near >= 256 (1/256 unit).
 *              Nothing nearer than near is drawn; what is farther than far is drawn, at the greatest depth
 *   return     0 or LMB_ERROR_VALUE */
int lmb_camera_orthographic(lmb_camera *camera, int width, int height, int32_t focal_q16, int32_t near_q16, int32_t far_q16);
int lmb_camera_perspective(lmb_camera *camera, int width, int height, int32_t focal_q16, int32_t near_q16, int32_t far_q16);

/* The position of vertex i of a mesh in space. Rounded to nearest. */
lmb_point lmb_mesh_place(const lmb_mesh *mesh, const lmb_pose *pose, uint32_t i);

/* Projects a point to the screen and its depth. False, and nothing written, if it lies nearer than the near plane or beyond
 * LMB_SCREEN_MAX. Error at most LMB_PROJECT_MAX_ERROR pixels; of the depth, where far is at least twice as far as near,
 * LMB_PROJECT_MAX_DEPTH_ERROR (hosttest/test_mesh.c, test_vertex.c). */
#define LMB_PROJECT_MAX_ERROR 0.05
#define LMB_PROJECT_MAX_DEPTH_ERROR (2.5 / 65536)
bool lmb_project(const lmb_camera *camera, lmb_point p, lmb_vertex *vertex);

/* Starts a walk. Pointers must stay valid to its end.
 *   vertices  NULL, or room for mesh->vertices corners that lmb_mesh_project has filled: without it each corner is projected
 *             anew for each of its triangles
 *   order     NULL, or the triangles' order from lmb_mesh_sort */
void lmb_mesh_begin(lmb_walk *walk, const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera, const lmb_look *look,
                    const lmb_window *window, const lmb_vertex *vertices, const uint16_t *order);

/* Begins the next triangle that may be seen; false at the end. */
bool lmb_mesh_next(lmb_walk *walk, lmb_triangle *triangle);

/* Adds the triangles of a walk that lmb_mesh_begin has started, to its end, and draws nothing. What draws counts nothing, so that
 * who does not ask does not pay. */
void lmb_mesh_statistics(lmb_walk *walk, lmb_statistics *statistics);

/* Projects all vertices of a mesh into vertices[0 .. mesh->vertices - 1], once a frame for any number of strips. Errors are those
 * of lmb_mesh_place and lmb_project together; of orthographic meshes with half sides of up to 375 pixels those of lmb_project. */
void lmb_mesh_project(const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera, lmb_vertex *vertices);

/* How strongly a mesh is bent: 1 - cos of the largest angle between the normals of an edge, UQ1.15 rounded up, 1 to 65535. For tools,
 * and for meshes made at run time: frames of fine meshes take some 3 % less with it, and are the same. */
uint16_t lmb_mesh_bend(const lmb_mesh *mesh);

/* Painter's order, farthest triangle first, for meshes of at most 65536 triangles drawn without a depth buffer.
 * Depths are told apart from 3 mesh units on.
 *   order, keys  room for mesh->triangles each; keys is scratch
 *   return       0, or LMB_ERROR_VALUE for too many triangles */
int lmb_mesh_sort(const lmb_mesh *mesh, const lmb_pose *pose, uint16_t *order, int16_t *keys);

#ifdef __cplusplus
}
#endif

#include "step.h"

#endif
