/* SPDX-License-Identifier: MIT */
/* Surfaces, clearing, and whole meshes in one call. */
#include "fill.h"

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
    surface->window.depth = depth != NULL;
}

void lmb_clear(const lmb_surface *surface, lmb_rgb colour)
{
    const lmb_window *w = &surface->window;
    size_t width = (size_t)lmb_sub(w->right, w->left), height = (size_t)lmb_sub(w->bottom, w->top), x, y;
    /* level of c / 255 in 31 or 63: c * 31 / 255 + 1/2, exactly rounded for every c */
    unsigned r = (colour.r * 249u + 1014u) >> 11, g = (colour.g * 253u + 505u) >> 10, b = (colour.b * 249u + 1014u) >> 11;
    uint8_t low = (uint8_t)(g << 5 | b), high = (uint8_t)(r << 3 | g >> 3);
    for (y = 0; y < height; y++) {
        uint8_t *pixel = (uint8_t *)surface->pixels + y * surface->pitch;
        for (x = 0; x < width; x++) {
            if (lmb_format_bytes((enum lmb_format)surface->format) == 2) {
                *pixel++ = low;
                *pixel++ = high;
            } else {
                *pixel++ = colour.r;
                *pixel++ = colour.g;
                *pixel++ = colour.b;
            }
        }
    }
    if (!LMB_WITH_DEPTH || !surface->depth) return;
    for (x = 0; x < width * height; x++) surface->depth[x] = 65535;
}

uint32_t lmb_draw_mesh(const lmb_surface *surface, const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera,
                       const lmb_paint *paint, const lmb_vertex *vertices, const uint16_t *order)
{
    lmb_walk walk;
    lmb_triangle triangle;
    uint32_t pixels = 0;
    lmb_mesh_begin(&walk, mesh, pose, camera, &paint->look, &surface->window, vertices, order);
    while (lmb_mesh_next(&walk, &triangle)) pixels += lmb_fill_triangle(surface, paint, &triangle);
    return pixels;
}
