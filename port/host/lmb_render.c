/* SPDX-License-Identifier: MIT */
/* lmb-render: any Wavefront OBJ file through the library, exactly as firmware would draw it, into a BMP file. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bmp.h"
#include "view.h"

static const char help[] =
    "usage: lmb-render MODEL.obj -o OUT.bmp [options]\n"
    "\n"
    "Draws a Wavefront OBJ file through the library, exactly as firmware would, and writes the display as a 24-bit BMP.\n"
    "The model is centred and fitted to the frame.\n"
    "\n"
    "  -o FILE               the picture; - is the standard output\n" VIEW_HELP_FRAME "\n" VIEW_HELP_PLACE "\n" VIEW_HELP_LOOK
    "\n" VIEW_HELP_INPUT;

/* What drawing needs beside the mesh; one block of each, freed together. */
typedef struct memory {
    uint8_t *frame;
    uint16_t *depth, *order;
    int16_t *keys;
    lmb_vertex *vertices;
} memory;

static bool memory_get(memory *m, const view *v, const lmb_mesh *mesh)
{
    size_t pixels = (size_t)v->width * (size_t)v->height, strip = (size_t)v->width * (size_t)v->strip;
    m->frame = malloc(pixels * 3);
    m->vertices = malloc(mesh->vertices * sizeof *m->vertices);
    m->depth = v->order == VIEW_DEPTH ? malloc(strip * sizeof *m->depth) : NULL;
    m->order = v->order == VIEW_PAINTER ? malloc(mesh->triangles * sizeof *m->order) : NULL;
    m->keys = v->order == VIEW_PAINTER ? malloc(mesh->triangles * sizeof *m->keys) : NULL;
    return m->frame && m->vertices && (v->order != VIEW_DEPTH || m->depth) && (v->order != VIEW_PAINTER || (m->order && m->keys));
}

static void memory_free(memory *m)
{
    free(m->frame);
    free(m->depth);
    free(m->order);
    free(m->keys);
    free(m->vertices);
}

/* Draws strip by strip; the whole frame is one strip unless the job says otherwise. Returns 0 or a library error. */
static int draw(const view *v, const lmb_mesh *mesh, const memory *m, lmb_surface *frame, uint32_t *seen)
{
    size_t row_bytes = (size_t)v->width * lmb_format_bytes((enum lmb_format)v->format);
    lmb_camera camera;
    lmb_pose pose;
    lmb_look look;
    lmb_paint paint;
    int top, error = view_look(v, &look);
    if (error) return error;
    lmb_paint_prepare(&paint, &look, (enum lmb_format)v->format);
    view_place(v, &camera, &pose);
    lmb_mesh_project(mesh, &pose, &camera, m->vertices);
    if (m->order) error = lmb_mesh_sort(mesh, &pose, m->order, m->keys);
    *seen = 0;
    for (top = 0; top < v->height && !error; top += v->strip) {
        int bottom = top + v->strip < v->height ? top + v->strip : v->height;
        lmb_surface strip;
        lmb_surface_strip(&strip, (enum lmb_format)v->format, m->frame + (size_t)top * row_bytes, m->depth, v->width, top,
                          bottom);
        lmb_clear(&strip, v->background);
        *seen += lmb_draw_mesh(&strip, mesh, &pose, &camera, &paint, m->vertices, m->order);
    }
    lmb_surface_strip(frame, (enum lmb_format)v->format, m->frame, NULL, v->width, 0, v->height);
    return error;
}

static int render(const view *v, const char *output, const lmb_mesh *mesh)
{
    memory m;
    lmb_surface frame;
    uint32_t seen = 0;
    clock_t begin;
    double milliseconds;
    int error, result = EXIT_FAILURE;
    if (!memory_get(&m, v, mesh)) {
        fprintf(stderr, "lmb-render: out of memory\n");
        memory_free(&m);
        return EXIT_FAILURE;
    }
    begin = clock();
    error = draw(v, mesh, &m, &frame, &seen);
    milliseconds = 1000.0 * (double)(clock() - begin) / CLOCKS_PER_SEC;
    if (error) {
        fprintf(stderr, "%s: %s\n", v->input,
                v->order == VIEW_PAINTER ? "too many triangles for painter's order (65536); use --order depth"
                                         : "the library refused a value");
    } else if (bmp_write(output, &frame)) {
        fprintf(stderr, "%s: cannot write: %s\n", output, strerror(errno));
    } else {
        result = EXIT_SUCCESS;
        if (!v->quiet) {
            fprintf(stderr, "%s  %lu triangles, %lu seen  %s, %s, %s  %.2f ms\n", output, (unsigned long)mesh->triangles,
                    (unsigned long)seen, view_models[v->model], view_steps[v->step], view_formats[v->format], milliseconds);
        }
    }
    memory_free(&m);
    return result;
}

static int parse_output(void *own, const char *option, const char *value)
{
    if (strcmp(option, "-o")) return -1;
    *(const char **)own = value;
    return 1;
}

int main(int argc, char **argv)
{
    const char *output = NULL;
    const view_program program = {"lmb-render", help, parse_output, NULL, &output};
    view v;
    lmb_mesh mesh;
    int result = view_parse(&v, &program, argc, argv);
    if (result >= 0) return result;
    if (!output) return view_usage(&program, "where to? -o OUT.bmp is missing", "");
    if (view_read(&v, &mesh)) return EXIT_FAILURE;
    result = render(&v, output, &mesh);
    mesh_free(&mesh);
    return result;
}
