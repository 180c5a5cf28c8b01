/* SPDX-License-Identifier: MIT */
/* Surfaces, clearing, and whole meshes in one call. */
#include "levels.h"
#include "paint.h"

#include "../firmware/look.h"

void lmb_surface_strip(lmb_surface *surface, enum lmb_format format, void *pixels, uint16_t *depth, int width, int top,
                       int bottom)
{
    surface->pixels = pixels;
    surface->depth = depth;
    surface->pitch = (size_t)width * lmb_format_bytes(format);
    surface->format = (uint8_t)format;
    surface->window.left = 0;
    surface->window.right = (int16_t)width;
    surface->window.top = (int16_t)top;
    surface->window.bottom = (int16_t)bottom;
    surface->window.depth = LMB_WITH_DEPTH && depth != NULL;
}

static uint16_t pixel_of(const lmb_rgb *colour)
{
    uint16_t q15[3];
    lmb_colour_fold(q15, colour, NULL);
    return STORE_ORDER(lmb_shade_565(NULL, q15, 32768));
}

void lmb_clear(const lmb_surface *surface, lmb_rgb colour)
{
    const lmb_window *w = &surface->window;
    const bool rgb565 = lmb_format_bytes((enum lmb_format)surface->format) == 2;
    const uint16_t pixel565 = rgb565 ? pixel_of(&colour) : 0;
    uint8_t *row = surface->pixels;
    int32_t width = lmb_sub(w->right, w->left), height = lmb_sub(w->bottom, w->top), x, y;
    uint16_t *depth = surface->depth;
    for (y = height; y > 0; y--, row += surface->pitch) {
        uint8_t *pixel = row;
        for (x = width; x > 0; x--) {
            if (rgb565) {
                *(uint16_t *)(void *)pixel = pixel565;
                pixel += 2;
            } else {
                *pixel++ = colour.r;
                *pixel++ = colour.g;
                *pixel++ = colour.b;
            }
            if (LMB_WITH_DEPTH && depth) *depth++ = 65535;
        }
    }
}

uint32_t lmb_draw_mesh(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera,
                       const lmb_paint *paint, const lmb_vertex *vertices, const uint16_t *order)
{
    lmb_walk walk;
    lmb_triangle triangle;
    uint32_t triangles = 0;
    lmb_mesh_begin(&walk, mesh, pose, camera, &paint->look, &surface->window, vertices, order);
    for (; lmb_mesh_next(&walk, &triangle); triangles++) lmb_fill_triangle(surface, paint, &triangle);
    return triangles;
}
