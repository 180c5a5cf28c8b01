/* SPDX-License-Identifier: MIT */
/* The filler: spans into pixels. A surface is the caller's memory for a frame or for a strip of one.
 *
 * Pixels are stored as bytes in the same order on every machine:
 *   LMB_RGB565  two bytes, low byte first: blue in bits 0-4, green in 5-10, red in 11-15 of a little-endian half word
 *   LMB_RGB888  three bytes: red, green, blue
 * A channel's level is its intensity times 31, 63 or 255, rounded to nearest; no dither, no gamma.
 */
#ifndef LMB_FILL_H
#define LMB_FILL_H

#include "../firmware/lambent.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Formats built in, 1, or left out to save flash, 0. */
#ifndef LMB_WITH_RGB565
#define LMB_WITH_RGB565 1
#endif
#ifndef LMB_WITH_RGB888
#define LMB_WITH_RGB888 1
#endif
LMB_STATIC_ASSERT(LMB_WITH_RGB565 + LMB_WITH_RGB888 >= 1);

/* Ramps in paints, 720 bytes of RAM, and loops that use them, 1; 0: none, and one light on RGB565 takes several times longer, for
 * the same pixels. */
#ifndef LMB_WITH_RAMPS
#define LMB_WITH_RAMPS 1
#endif
#if !LMB_WITH_PIXELS
#undef LMB_WITH_RAMPS
#define LMB_WITH_RAMPS 0
#endif

enum lmb_format { LMB_RGB565, LMB_RGB888 };

/* Bytes of a pixel. */
static inline unsigned lmb_format_bytes(enum lmb_format format)
{
    return LMB_WITH_RGB565 && (!LMB_WITH_RGB888 || format == LMB_RGB565) ? 2 : 3;
}

/* How many loops are built for one light on RGB565: 1, one for each kind of triangle, with nothing in it that the kind does not
 * need, with depth or without, Gouraud's among them; 0, one for all but flat triangles, which saves some KB of flash and draws the
 * same. */
#ifndef LMB_LOOPS
#if defined(__OPTIMIZE_SIZE__) || defined(__AVR__)
#define LMB_LOOPS 0
#else
#define LMB_LOOPS 1
#endif
#endif

/* Memory for the pixels of window. The same frame drawn whole or strip by strip gives the same bytes. */
typedef struct lmb_surface {
    void *pixels;      /* of the window's top left corner; RGB565: aligned to 2 bytes */
    uint16_t *depth;   /* NULL: no depth test. Else one per pixel of the window, which asks for depth, row by row without gaps */
    size_t pitch;      /* bytes from one row to the next; RGB565: even */
    lmb_window window; /* which part of the frame it holds */
    uint8_t format;    /* enum lmb_format */
} lmb_surface;

/* A surface over a whole frame or a strip of it: rows top to bottom - 1 of a frame width pixels wide, no gaps between rows. */
void lmb_surface_strip(lmb_surface *surface, enum lmb_format format, void *pixels, uint16_t *depth, int width, int top,
                       int bottom);

/* Fills the window with one colour, and its depth, if any, with the farthest. */
void lmb_clear(const lmb_surface *surface, lmb_rgb colour);

/* Steps of the ramps: of N.L from 0 to 1, of the highlight from where it begins to be seen to its centre, and an eighth more, which
 * rounding and bulges ask for. 720 bytes in all. */
#define LMB_RAMP 64
#define LMB_RAMP_TOP (LMB_WITH_RGB565 ? 72 : 1)
#define LMB_GLEAM 256
#define LMB_GLEAM_TOP (LMB_WITH_RGB565 && LMB_WITH_GLOSS ? 288 : 1)

/* A look in the colours of a format, prepared once: what is drawn is drawn with it. Fields may change without notice. */
typedef struct lmb_paint {
#if LMB_WITH_RAMPS
    uint16_t
        ramp[LMB_RAMP_TOP + LMB_GLEAM_TOP]; /* one light on RGB565: ambient and diffuse by N.L, then highlights by argument */
#endif
    uint8_t format;
    bool ramped;         /* they are set */
    lmb_look look;       /* leaves out what the format cannot show */
    uint32_t ambient[3]; /* r, g, b with half a level added, in levels times 2^shift[] */
    struct {
        uint16_t diffuse[3], specular[3];
    } light[LMB_LIGHTS];
} lmb_paint;

/* Prepares a paint; the look may go afterwards. Sets the look's tolerance (lmb_look_tolerance): where more than the format's quarter of a
 * level may be wrong frames are cheaper. Ramps have 64 steps of N.L, so that plans take less than LMB_TOLERANCE_RGB565 as that. */
void lmb_paint_within(lmb_paint *paint, const lmb_look *look, enum lmb_format format, uint16_t tolerance);

/* The same with a quarter of a level of the format: what is left out cannot be seen. */
static inline void lmb_paint_prepare(lmb_paint *paint, const lmb_look *look, enum lmb_format format)
{
    lmb_paint_within(paint, look, format, lmb_format_bytes(format) == 2 ? LMB_TOLERANCE_RGB565 : LMB_TOLERANCE_RGB888);
}

/* Stores the pixels of one span, which must lie in the surface's window. The surface has the paint's format. */
void lmb_fill_span(const lmb_surface *surface, const lmb_paint *paint, const lmb_span *span);

/* Stores all pixels of a triangle that lmb_triangle_begin has set up for the surface's window: the same as span by span, with
 * less in between. */
void lmb_fill_triangle(const lmb_surface *surface, const lmb_paint *paint, lmb_triangle *triangle);

/* Draws a mesh: all of the above in one call.
 *   paint            in the surface's format
 *   vertices, order  as in lmb_mesh_begin; both may be NULL
 *   return           how many triangles may have been seen; none: there is nothing on the surface */
uint32_t lmb_draw_mesh(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera,
                       const lmb_paint *paint, const lmb_vertex *vertices, const uint16_t *order);

#ifdef __cplusplus
}
#endif
#endif
