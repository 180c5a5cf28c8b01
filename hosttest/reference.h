/* SPDX-License-Identifier: MIT */
/* Whole frames in double, from the definitions, and how far the library's frames are from them.
 *
 * Three references, never mixed. All take the quantised numbers that the library is given (normals, positions, light directions,
 * rotation, colours), normalise the vectors and are exact from there on:
 *
 *   same_model        the same model: corners where the library projects them, terms linear, quadratic or along arcs. What
 *                     arithmetic costs: this one has bars
 *   normalised_phong  triangles met by the ray through the pixel's centre, the normal interpolated linearly in space and
 *                     normalised at the pixel. What the method costs
 *   true_surface      the sphere or torus behind the mesh, met by the same ray, with its own normal. What the mesh costs
 *
 * and, of the first, what every choice of model, step and lobe is chosen against:
 *
 *   exact             normals that turn evenly along edges and along each row, and the power itself
 *
 * Only same_model shares anything with the library: lmb_mesh_project, since coverage is to be identical.
 */
#ifndef LMB_REFERENCE_H
#define LMB_REFERENCE_H

#include "../port/demo/scenes.h"

/* -------------------------------------------------------------------------------------------------------------------- vectors */

typedef struct ref_vec {
    double x, y, z;
} ref_vec;

ref_vec ref_make(lmb_vec v);
ref_vec ref_add(ref_vec a, ref_vec b);
ref_vec ref_sub(ref_vec a, ref_vec b);
ref_vec ref_scale(ref_vec a, double s);
double ref_dot(ref_vec a, ref_vec b);
ref_vec ref_cross(ref_vec a, ref_vec b);

/* At unit length; the zero vector gives (0, 0, 1), as lmb_normalise has it. */
ref_vec ref_unit(ref_vec a);

/* From a to b, both unit, evenly by angle: sin((1-t) psi) / sin(psi) a + sin(t psi) / sin(psi) b (paper 001, eq. 2). Linearly
 * beyond LMB_ARC_U_MAX, as the library documents. */
ref_vec ref_slerp(ref_vec a, ref_vec b, double t);

/* m times v and its transpose times v, m as it stands in Q2.14. */
ref_vec ref_turn(const lmb_matrix *m, ref_vec v);
ref_vec ref_turn_back(const lmb_matrix *m, ref_vec v);

/* ------------------------------------------------------------------------------------------------------------------ materials */

/* One object's material under the scene's lights, in the object's own space. */
typedef struct ref_shader {
    double ambient[3];
    struct {
        ref_vec direction, half;
        double diffuse[3], specular[3]; /* material times light, 1 is full */
    } light[LMB_LIGHTS];
    unsigned lights;
    double shininess;
    bool highlight;
} ref_shader;

void ref_shader_begin(ref_shader *shader, const scene *s, const scene_object *object, bool highlight);

/* The dot products that light pixels: N.L and N.H of each light, and what they come to. Both are cosines: they count as one above
 * one (quadratics overshoot) and as zero below zero. */
typedef struct ref_terms {
    double diffuse[LMB_LIGHTS], specular[LMB_LIGHTS];
} ref_terms;

void ref_terms_of(const ref_shader *shader, ref_vec normal, ref_terms *terms);

/* max(0, N.L) and max(0, N.H)^n in place of N.L and N.H; and the colour from those, saturated at one. */
void ref_terms_light(const ref_shader *shader, ref_terms *terms);
void ref_terms_colour(const ref_shader *shader, const ref_terms *lit, double rgb[3]);

/* Both in one, for a unit normal. */
void ref_colour(const ref_shader *shader, ref_vec normal, double rgb[3]);

/* --------------------------------------------------------------------------------------------------------------------- frames */

#define REF_LAYERS 4

/* One surface at one pixel. */
typedef struct ref_fragment {
    double depth;
    float rgb[3];      /* intensities */
    uint32_t triangle; /* object * 2^24 + triangle */
} ref_fragment;

/* The nearest REF_LAYERS fragments of each pixel, nearest first; without a depth buffer the last one drawn alone. */
typedef struct ref_frame {
    int width, height;
    bool depth;
    double slack;           /* fragments this near to the nearest may be taken for it: units of depth */
    uint64_t fragments;     /* all that were added */
    uint32_t clipped;       /* same_model: triangles left out, since they are not wholly on the screen and in front */
    ref_fragment *fragment; /* REF_LAYERS per pixel */
    uint8_t *layers;        /* how many of them are there */
} ref_frame;

void ref_frame_end(ref_frame *frame);

/* Adds a fragment to a pixel of the frame. */
void ref_frame_add(ref_frame *frame, int x, int y, double depth, const double rgb[3], uint32_t triangle);

/* The references. Each begins a frame, which ref_frame_end releases; memory that is short ends the program. true_surface returns
 * false, and begins nothing, if an object of the scene has no surface but its mesh. */
void ref_same_model(ref_frame *frame, const scene *s, enum lmb_model model, enum lmb_step_kind step);
void ref_exact(ref_frame *frame, const scene *s, bool highlight);
void ref_normalised_phong(ref_frame *frame, const scene *s, bool highlight);
bool ref_true_surface(ref_frame *frame, const scene *s, bool highlight);

/* The ray through the centre of pixel (x, y): points at origin + t direction, t the distance in front of the camera. */
typedef struct ref_ray {
    ref_vec origin, direction;
} ref_ray;
ref_ray ref_pixel_ray(const lmb_camera *camera, double x, double y);

/* For references alone: begins an empty frame of the scene's size. */
void ref_frame_begin(ref_frame *frame, const scene *s, double slack);

/* ------------------------------------------------------------------------------------------------------------------ judgement */

/* A frame drawn by the library: levels as stored, three a pixel, and whether the pixel was painted. */
typedef struct ref_drawn {
    int width, height;
    enum lmb_format format;
    uint8_t *levels;
    bool *painted;
    uint64_t shaded; /* what scene_pixels says of it */
} ref_drawn;

/* The greatest level of a channel; and pixels of levels as 8-bit RGB. */
int ref_top(enum lmb_format format, int channel);
void ref_visible(uint8_t *rgb, const uint8_t *levels, size_t pixels, enum lmb_format format);

/* How far a drawn frame is from a reference, in levels of its format. */
typedef struct ref_score {
    uint64_t pixels;            /* painted by both */
    uint64_t coverage_mismatch; /* painted by one */
    uint64_t ambiguous;         /* where a fragment not quite nearest was taken, since it is closer to what was drawn */
    uint64_t within_1;
    int max_error, x, y; /* the largest, and where it is first */
    int drawn[3], wanted[3];
    uint32_t triangle;
    double share_within_1, psnr_db; /* each channel's error over its greatest level; 99 if there is none */
} ref_score;

/* Judges. levels, if not NULL, takes the reference quantised as the drawn frame is, with the drawn frame's own levels where
 * either has nothing. */
void ref_judge(ref_score *score, const ref_frame *frame, const ref_drawn *drawn, uint8_t *levels);

/* What frames are judged by name: a model, a step, or the scene's own step, and a lobe. REF_GLOSS is the scene's default once more;
 * behind it stand the lobes of paper 000, whose model has an error of its own. */
typedef struct ref_variant {
    const char *name;
    enum lmb_model model;
    int step; /* -1: the scene's own */
    enum lmb_lobe_kind lobe;
} ref_variant;

enum {
    REF_FLAT,
    REF_GOURAUD,
    REF_DIFFUSE,
    REF_GLOSS_LINEAR,
    REF_GLOSS_QUADRATIC,
    REF_GLOSS_ARC,
    REF_GLOSS_PLANNED,
    REF_GLOSS,
    REF_GLOSS_W2,
    REF_GLOSS_W4,
    REF_GLOSS_W8,
    REF_GLOSS_W16,
    REF_VARIANTS
};
extern const ref_variant ref_variants[REF_VARIANTS];
enum lmb_step_kind ref_step_of(const ref_variant *v, const scene *s);

/* Draws a scene twice, over two backgrounds that differ in every channel: what shows neither was painted. */
void ref_draw(ref_drawn *drawn, const scene *s, enum lmb_model model, enum lmb_step_kind step, enum lmb_format format);
void ref_draw_variant(ref_drawn *drawn, const scene *s, const ref_variant *v, enum lmb_format format);
void ref_drawn_end(ref_drawn *drawn);

#endif
