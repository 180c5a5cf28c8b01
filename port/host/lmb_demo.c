/* SPDX-License-Identifier: MIT */
/* lmb-demo: renders the demo scenes to BMP files, as firmware would, and says what each took. */
#include "bmp.h"
#include "../demo/scenes.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static uint32_t triangles_of(const scene *s)
{
    uint32_t sum = 0;
    unsigned i;
    for (i = 0; i < s->objects; i++) sum += s->object[i].mesh->triangles;
    return sum;
}

/* Draws one scene into memory of its own and writes it. Returns 0, or -1 after a message. */
static int show(const scene *s, const char *folder)
{
    static const char *const step_name[] = {"linear", "quadratic", "arc"};
    size_t pixels = (size_t)s->width * (size_t)s->height;
    void *frame = malloc(pixels * 3);
    uint16_t *depth = malloc(pixels * sizeof *depth);
    char path[512];
    int result = -1;
    if (frame && depth && snprintf(path, sizeof path, "%s/%s.bmp", folder, s->name) < (int)sizeof path) {
        lmb_surface surface;
        clock_t begin;
        double milliseconds;
        lmb_surface_strip(&surface, LMB_RGB565, frame, s->depth ? depth : NULL, s->width, 0, s->height);
        begin = clock();
        scene_draw(s, &surface, LMB_MODEL_GLOSS, s->step);
        milliseconds = 1000.0 * (double)(clock() - begin) / CLOCKS_PER_SEC;
        result = bmp_write(path, &surface);
        if (result) {
            fprintf(stderr, "%s: cannot write: %s\n", path, strerror(errno));
        } else {
            printf("%-38s %6lu pixels  %5lu triangles  gloss, %s, RGB565%s  %6.2f ms\n", path,
                   (unsigned long)scene_pixels(s, &surface.window), (unsigned long)triangles_of(s), step_name[s->step],
                   s->depth ? ", depth" : "", milliseconds);
        }
    } else {
        fprintf(stderr, "lmb-demo: out of memory or path too long\n");
    }
    free(frame);
    free(depth);
    return result;
}

int main(int argc, char **argv)
{
    unsigned i;
    if (argc != 2 || argv[1][0] == '-') {
        fprintf(stderr, "usage: lmb-demo FOLDER\nRenders the demo scenes into FOLDER/*.bmp, one line each.\n");
        return argc == 2 && !strcmp(argv[1], "--help") ? EXIT_SUCCESS : 2;
    }
    for (i = 0; i < scene_count(); i++) {
        scene s;
        scene_make(&s, i);
        if (show(&s, argv[1])) return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
