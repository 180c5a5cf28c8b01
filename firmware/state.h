/* SPDX-License-Identifier: MIT */
/* Structs that callers own and the library fills. Their fields may change without notice; lambent.h says what to do with them. */
#ifndef LMB_STATE_H
#define LMB_STATE_H

#include "lambent.h"

/* A prepared lobe: s = alpha - slope * (1 - cos), clamped at zero, then up to four multiplications and one addition (lobe.h).
 * Fields may change without notice. */
typedef struct lmb_lobe {
    int32_t alpha_q30;       /* s at the centre, up to 1.5; a multiple of 2^14 */
    int32_t lift;            /* the addition: Q0.32 modulo 2^32 in the plain form, Q16.16 in the crossed one */
    uint16_t slope;          /* mantissa in [32768, 65535] */
    uint16_t floor_q15;      /* the lobe is zero where s is not above this */
    uint16_t shininess;      /* n */
    uint16_t error_uq16;     /* upper bound of |lobe - max(0, cos)^n| over all angles; 65535 for W_m, where none is promised */
    int8_t slope_shift;      /* slope = mantissa * 2^(slope_shift - 15) per unit of 1 - cos; from -4 to 8 */
    uint8_t multiplications; /* 0 to 4 */
    bool crossed;            /* which form: see lobe.h */
    bool fixed;              /* of a look: its caller has chosen this one */
} lmb_lobe;

/* The argument of the highlight at v = 1 - N.H: top - slope v, zero where the highlight ceases to be seen. */
typedef struct lmb_line {
    int32_t top_q30;
    uint16_t slope; /* mantissa in [32768, 65535] */
    int8_t shift;   /* slope = mantissa * 2^(shift - 15) */
} lmb_line;

/* Material, lights and choices, prepared once. Fields may change without notice. */
typedef struct lmb_look {
    lmb_lobe lobe;
    uint16_t tolerance; /* see lmb_look_tolerance */
    uint8_t model, step, lights;
    uint8_t specular_on;     /* bit i: light i can make a highlight on this material */
    uint16_t ambient_q15[3]; /* r, g, b in UQ1.15 */
    struct lmb_look_light {
        lmb_line line;
        int32_t quiet_q30, dark_q16; /* 1 - N.H, and s, from where on the highlight is not to be seen */
        int32_t straight_q28;        /* the bend up to which linear N.L is good enough */
#if LMB_WITH_PLANS
        struct lmb_plan {
            int32_t level_q28, gloss_level_q28;   /* how far N.L, and 1 - N.H, may range and be constant; below 0: never */
            int32_t gloss_straight_q28;           /* the bend up to which a linear argument of the highlight is good enough, */
            int32_t curved_q28, gloss_curved_q28; /* and quadratics of both: beyond, arcs */
        } plan;
#endif
        lmb_vec direction, half;                  /* unit, in space */
        uint16_t diffuse_q15[3], specular_q15[3]; /* material times light */
    } light[LMB_LIGHTS];
} lmb_look;

/* The normal at an end of a span, Q2.14, and its squared length less one, Q4.28. */
typedef struct lmb_end {
    int32_t x, y, z, excess_q28;
} lmb_end;

typedef struct lmb_ends {
    lmb_end from, to;
} lmb_ends;

/* A ray times a scale, and what comes of it where the normal meets the ray. Fields but peak_q30 may change without notice. */
typedef struct lmb_beam {
    int32_t x_q16, y_q16, z_q16, peak_q30;
} lmb_beam;

/* Light and half vectors in the space of the normals that they meet: turned once per mesh, so that normals never are. */
typedef struct lmb_rays {
#if LMB_WITH_ARC
    int32_t curve_q28; /* the bend up to which curves stand for arcs */
    bool rough;        /* rough ones do as well, up to LMB_CURVE_U_MAX */
    bool arcs;         /* planned: some triangle may want arcs */
#endif
    struct lmb_ray {
        lmb_vec direction, half;
#if LMB_WITH_ARC
        uint8_t exponent;   /* of the highlight's argument; for LMB_STEP_ARC, as all that follows */
        bool shines;        /* there is a highlight */
        int32_t offset_q30; /* its argument over 2^exponent less the term of its beam */
        lmb_beam diffuse, specular;
#endif
    } light[LMB_LIGHTS];
    int32_t bend_q28; /* what no edge's bulge exceeds */
    int32_t far_q28;  /* a triangle with a corner whose 1 - N.H is greater has no highlight of light 0 */
} lmb_rays;

/* An arc: the normal turns evenly from pixel to pixel, by phi = psi / m over m pixels, and each dot product with it obeys
 * f(t+1) = 2 cos(phi) f(t) - f(t-1) (paper 001, eq. 7 and 14). Fields may change without notice. */
typedef struct lmb_arc {
    uint16_t kappa;       /* mantissa of 4 sin^2(phi/2): what lmb_arc_step needs */
    uint8_t kappa_shift;  /* its exponent */
    uint8_t guard;        /* fraction bits that d has beyond those of f */
    uint8_t direct;       /* where the first f comes from: see arc.c */
    int32_t d_from_a_q28; /* the first d is a d_from_a + rise d_from_rise, times 2^guard, */
    int32_t d_from_rise_q28;
    int32_t f_from_a;    /* the first f is a + a f_from_a + d f_from_rise, UQ0.21 and UQ1.16; */
    int32_t f_from_rise; /* direct: a + a f_from_a + rise f_from_rise, Q4.28 */
} lmb_arc;

/* A parabola along a span. Fields may change without notice. */
typedef struct lmb_curve {
    int32_t first_q16, step_q16, above_q22, slant_q19, bow_q20;
    unsigned down;
} lmb_curve;

/* One edge of a triangle, walked row by row without error: x is the first pixel whose centre is not left of the edge, gap how far
 * that centre lies behind the edge, in pixels times modulus. */
typedef struct lmb_edge {
    int32_t x, step, gap, part, modulus;
} lmb_edge;

/* The same as one number a row: x plus one less a unit, and its step, with 20 fraction bits, so that a shift rounds x up. For triangles
 * of up to 512 pixels. */
#define LMB_STRIDE_BITS 20
#define LMB_STRIDE_MAX (512 * 16)
typedef struct lmb_stride {
    int32_t x, step;
} lmb_stride;
#define LMB_WALKED_EDGES 1
#define LMB_WALKED_STRIDES 2

/* A normal that turns evenly along an edge, row by row; along one beyond LMB_ARC_U_MAX its components run linearly and it is
 * normalised on every row. */
typedef struct lmb_edge_arc {
    lmb_arc arc;
    lmb_term component[3];
    int32_t inverse; /* of the edge's modulus: half of what lmb_reciprocal gives, and its shift */
    uint8_t inverse_shift;
    bool straight; /* beyond LMB_ARC_U_MAX, or close to it */
} lmb_edge_arc;

/* A quadratic over the triangle in wrapping Q2.30, at some pixel: value, slope to the right at that pixel, first difference down, half
 * the second difference to the right, the two others. n columns on it is f + n dx + n^2 bow. */
typedef struct lmb_plane {
    int32_t f, dx, dy, bow, dxy, dyy;
} lmb_plane;

/* A triangle on its way into spans. Its planes stand in one column, at the next row. What rows need comes first, where cores with
 * short offsets reach it in one instruction. Fields may change without notice. */
typedef struct lmb_triangle {
    uint8_t kind, diffuse_on, specular_on, exponent[LMB_LIGHTS];
    uint8_t walked;  /* what walk holds: 0 nothing yet, or LMB_WALKED_... */
    bool long_right; /* the edge from top to bottom is the right one */
    bool depth_on;   /* depth is set */
    bool inside;     /* no column lies outside of the window */
    bool rough;      /* planes may leave their bounds by more than 1/64 */
    const lmb_look *look;
    const lmb_rays *rays;
    int32_t column;             /* of the planes */
    int32_t y, y_switch, y_end; /* next row, first row below the middle corner, first row below the triangle */
    int32_t y_turn;             /* strides: the row where some are to be begun anew */
    union {
        lmb_edge edge[2]; /* left, right */
        lmb_stride stride[2];
    } walk;
    union {
        struct {
            lmb_plane diffuse, specular;
        } light[LMB_LIGHTS];
#if LMB_WITH_ARC
        struct {
            lmb_edge_arc left, right;
        } arc;
#endif
    } u;
    int32_t window_left, window_right;
    int32_t y_long;              /* strides: the row where that from top to bottom is to be begun anew */
    int32_t low, high, gleam;    /* bounds of light 0 over the triangle, Q4.28: of diffuse, upper one of specular */
    int32_t glare;               /* for the filler: from which argument on its highlights may saturate, Q2.30 */
    const lmb_vertex *corner[3]; /* top, middle, bottom */
#if LMB_WITH_DEPTH
    lmb_plane depth;
#endif
} lmb_triangle;

/* Projection onto the screen. Fields may change without notice. */
typedef struct lmb_camera {
    int32_t focal_q16; /* orthographic: pixels per unit; perspective: pixels per unit at distance one */
    int32_t near_q16, far_q16;
    int32_t x, y;        /* where the axis meets the screen, Q28.4 */
    uint32_t depth_gain; /* orthographic: 2^(30 + depth_shift) / (far - near); perspective: far / (far - near), UQ16.16 */
    uint8_t depth_shift;
    uint8_t focal_up, near_up; /* perspective: zeros above focal_q16 and near_q16, but for the sign */
    bool perspective;
} lmb_camera;

/* Corners a polygon can have after clipping a triangle against the near plane and the four sides. */
#define LMB_CLIP_MAX (LMB_WITH_PERSPECTIVE ? 8 : 3)

/* Whether the near plane or a depth buffer wants to know how far away vertices are. */
#define LMB_SCREEN_EXACT (LMB_WITH_PERSPECTIVE || LMB_WITH_DEPTH)

/* The way of a mesh to the screen: see screen.c. */
typedef struct lmb_screen {
    const lmb_mesh *mesh;
    const lmb_pose *pose;
    const lmb_camera *camera;
    int32_t gain, origin[2]; /* of x and y; gain is 0 if these do not hold */
#if LMB_SCREEN_EXACT
    bool direct; /* these hold and the next two do; otherwise through space */
    int32_t depth_gain, depth;
#endif
} lmb_screen;

/* A walk over the visible triangles of a mesh. Fields may change without notice. */
typedef struct lmb_walk {
#if !LMB_WITH_ARC
    lmb_rays rays;
#endif
    const LMB_FLASH uint16_t *plain, *index, *end; /* of the next triangle that is simply read, and of any other */
    const lmb_vertex *vertices;
    const lmb_look *look;
    const lmb_window *window;
    const uint16_t *order;
    uint8_t corners, fan; /* of the clipped polygon that is being handed out */
    bool strip;           /* many triangles may lie above or below the window */
    lmb_screen screen;
    lmb_vertex polygon[LMB_CLIP_MAX];
#if LMB_WITH_ARC
    lmb_rays rays; /* long */
#endif
} lmb_walk;

#endif
