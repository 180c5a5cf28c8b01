/* SPDX-License-Identifier: MIT */
/* Figure 3 of paper 001 with this library: a torus, and an icosahedron whose normals are 63 degrees apart, each by arcs, by Phong's
 * normalised normals in double, and sixteen times their difference. usage: picture_arc OUT.ppm */
#include "reference.h"
#include "reference_scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 240, PANELS = 3, ROWS = 2, AMPLIFIED = 16, CHANNELS = 3 };

static uint8_t picture[ROWS * SIDE][PANELS * SIDE][CHANNELS];

static void put(int row, int panel, int x, int y, const uint8_t *levels)
{
    memcpy(picture[row * SIDE + y][panel * SIDE + x], levels, CHANNELS);
}

/* One row: what the library draws, what Phong's normals give, and how far they are apart. */
static void draw_row(int row, const scene *s)
{
    static uint8_t phong[SIDE * SIDE * CHANNELS];
    ref_frame frame;
    ref_drawn drawn;
    ref_score score;
    int x, y, c;
    ref_draw(&drawn, s, LMB_MODEL_GLOSS, LMB_STEP_ARC, LMB_RGB888);
    ref_normalised_phong(&frame, s, true);
    ref_judge(&score, &frame, &drawn, phong);
    for (y = 0; y < SIDE; y++) {
        for (x = 0; x < SIDE; x++) {
            const uint8_t *ours = drawn.levels + (y * SIDE + x) * CHANNELS, *theirs = phong + (y * SIDE + x) * CHANNELS;
            uint8_t apart[CHANNELS];
            for (c = 0; c < CHANNELS; c++) apart[c] = (uint8_t)fmin(AMPLIFIED * abs(ours[c] - theirs[c]), 255);
            put(row, 0, x, y, ours);
            put(row, 1, x, y, theirs);
            put(row, 2, x, y, apart);
        }
    }
    printf("%s: %.3f %% of pixels within one level of 255, at most %d\n", s->name, 100 * score.share_within_1, score.max_error);
    ref_frame_end(&frame);
    ref_drawn_end(&drawn);
}

int main(int argc, char **argv)
{
    scene s;
    FILE *file;
    if (argc != 2 || !demo_scene(&s, "torus") || s.width != SIDE || s.height != SIDE) {
        fprintf(stderr, "usage: picture_arc OUT.ppm\n");
        return 2;
    }
    draw_row(0, &s);
    hard_scene(&s, "icosahedron", SIDE, 100, hard_mesh(HARD_ICOSAHEDRON),
               lmb_rotation(hard_turn(20), hard_turn(30), hard_turn(0)));
    draw_row(1, &s);
    hard_meshes_end();
    file = fopen(argv[1], "wb");
    if (!file) return EXIT_FAILURE;
    fprintf(file, "P6\n%d %d\n255\n", PANELS * SIDE, ROWS * SIDE);
    fwrite(picture, sizeof picture, 1, file);
    return ferror(file) | fclose(file) ? EXIT_FAILURE : EXIT_SUCCESS;
}
