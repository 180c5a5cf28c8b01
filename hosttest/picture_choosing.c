/* SPDX-License-Identifier: MIT */
/* The pictures of docs/CHOOSING.md, tile by tile: a demo scene by each choice on RGB888, and how far each is from the exact frame.
 *
 *   picture_choosing SCENE FOLDER
 *
 * writes FOLDER/NAME.ppm and FOLDER/NAME-apart.ppm, and for each a line to stdout: NAME, a tab, the tile's label, a tab, and what is to
 * be said of its difference. hosttest/choosing_picture.sh puts them together.
 */
#include "reference.h"
#include "reference_scenes.h"

#include <stdio.h>
#include <stdlib.h>

#define AMPLIFIED 16

static const struct {
    const char *name, *label;
    unsigned variant;
} tiles[] = {{"flat", "flat", REF_FLAT},
             {"gouraud", "Gouraud", REF_GOURAUD},
             {"linear", "linear", REF_GLOSS_LINEAR},
             {"w4", "quadratic, W4", REF_GLOSS_W4},
             {"w16", "quadratic, W16", REF_GLOSS_W16},
             {"tuned", "quadratic, tuned", REF_GLOSS},
             {"planned", "planned, tuned", REF_GLOSS_PLANNED}};

static int write_ppm(const char *folder, const char *name, const char *end, const uint8_t *rgb, int width, int height)
{
    char path[400];
    FILE *file;
    snprintf(path, sizeof path, "%s/%s%s.ppm", folder, name, end);
    file = fopen(path, "wb");
    if (!file) {
        perror(path);
        return -1;
    }
    fprintf(file, "P6\n%d %d\n255\n", width, height);
    fwrite(rgb, 3, (size_t)width * (size_t)height, file);
    return ferror(file) | fclose(file) ? -1 : 0;
}

/* |a - b| times AMPLIFIED, over a. */
static void amplify(uint8_t *a, const uint8_t *b, size_t bytes)
{
    size_t i;
    for (i = 0; i < bytes; i++) {
        const int apart = AMPLIFIED * abs(a[i] - b[i]);
        a[i] = (uint8_t)(apart > 255 ? 255 : apart);
    }
}

/* One choice: its picture and its distance from exact, which is returned as levels. */
static int draw_tile(const scene *s, const ref_frame *exact, unsigned tile, const char *folder, uint8_t *levels)
{
    const size_t bytes = 3 * (size_t)s->width * (size_t)s->height;
    ref_drawn drawn;
    ref_score score;
    int failed;
    ref_draw_variant(&drawn, s, &ref_variants[tiles[tile].variant], LMB_RGB888);
    ref_judge(&score, exact, &drawn, levels);
    failed = write_ppm(folder, tiles[tile].name, "", drawn.levels, s->width, s->height);
    amplify(drawn.levels, levels, bytes);
    failed |= write_ppm(folder, tiles[tile].name, "-apart", drawn.levels, s->width, s->height);
    printf("%s\t%s\t%d level%s, %.1f dB\n", tiles[tile].name, tiles[tile].label, score.max_error, score.max_error == 1 ? "" : "s",
           score.psnr_db);
    ref_drawn_end(&drawn);
    return failed;
}

int main(int argc, char **argv)
{
    ref_frame exact;
    uint8_t *levels;
    unsigned i;
    int failed = 0;
    scene s;
    if (argc != 3) {
        fprintf(stderr, "usage: picture_choosing SCENE FOLDER\n");
        return 2;
    }
    if (!demo_scene(&s, argv[1])) {
        fprintf(stderr, "picture_choosing: no scene is named %s\n", argv[1]);
        return 2;
    }
    levels = malloc(3 * (size_t)s.width * (size_t)s.height);
    if (!levels) return EXIT_FAILURE;
    ref_exact(&exact, &s, true);
    for (i = 0; i < sizeof tiles / sizeof tiles[0]; i++) failed |= draw_tile(&s, &exact, i, argv[2], levels);
    failed |= write_ppm(argv[2], "exact", "", levels, s.width, s.height);
    printf("exact\texact\t%d\n", AMPLIFIED);
    ref_frame_end(&exact);
    free(levels);
    return failed || fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
