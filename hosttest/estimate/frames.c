/* SPDX-License-Identifier: MIT */
/* A list of frames that go through all that the library can do: each way to draw in turn, with each order, and all else by chance.
 * usage: estimate_frames training|other COUNT SEED > LIST    (training: models to fit costs on; other: those of held-out.txt) */
#include "../test.h"

#include <stdbool.h>
#include <string.h>

#define COUNT_OF(list) ((int)(sizeof list / sizeof list[0]))

static test_random chance;

static int one_of(int n) { return (int)test_integer(&chance, 0, n - 1); }
static bool now_and_then(int percent) { return test_integer(&chance, 1, 100) <= percent; }

static const char *const training[] = {
    "icosphere_20", "icosphere_80", "icosphere_320", "icosphere_1280", "icosphere_5120", "globe",  "bead",  "gem",  "ring",
    "hoop",         "waves",        "rod",           "reed",           "crystal",        "blocks", "sheet", "coil", "cups",
    "brick",        "crate",        "fence"};
static const char *const other[] = {"teapot", "torus", "icosphere_320", "icosphere_1280", "knot", "cone", "shell", "burr",
                                    "hills",  "vase",  "box",           "town",           "slats"};

/* Ways to draw; %: a light or two more. */
static const char *const ways[] = {
    "--model gloss",
    "--model diffuse",
    "--model gloss --step arc",
    "--model gouraud",
    "--model flat",
    "--model gloss --format rgb888",
    "--model gloss",
    "--model diffuse --step arc",
    "--model gloss %",
    "--model diffuse --format rgb888",
    "--model gloss --step linear",
    "--model gloss --step arc --format rgb888",
    "--model gloss",
    "--model diffuse --step arc --format rgb888",
    "--model gouraud --format rgb888",
    "--model flat --format rgb888",
    "--model gloss --format rgb888 %",
    "--model diffuse %",
    "--model gouraud",
    "--model gouraud %",
    "--model gloss",
    "--model flat %",
    "--model flat",
    "--model gloss --step arc %",
    "--model diffuse --step linear",
    "--model diffuse --step arc %",
    "--model gloss --step arc",
    "--model gloss --step planned",
    "--model gloss --step planned --format rgb888",
    "--model diffuse --step planned",
    "--model gloss --step planned %",
    "--model gloss --step planned",
    "--model diffuse --step planned --format rgb888",
    "--model gloss --step planned --format rgb888 %",
    "--model diffuse --step planned %",
    "--model gloss --step planned --format rgb888",
};

static void print_light(void)
{
    printf(" --light %d,%d,%d", one_of(121) - 60, one_of(121) - 60, 5 + one_of(66));
    if (now_and_then(20)) printf(",#ff8040");
}

static void print_way(const char *way)
{
    const size_t n = strcspn(way, "%");
    int i;
    printf(" %.*s", (int)n - (way[n] != 0), way);
    if (!way[n]) {
        if (now_and_then(40)) print_light();
        return;
    }
    for (i = 2 + one_of(2); i > 0; i--) print_light();
}

static void print_size(void)
{
    static const int sizes[] = {48, 64, 96, 128, 160, 200, 240, 240, 320, 400};
    const int width = sizes[one_of(COUNT_OF(sizes))], parts[] = {2, 3, 4, 4, 4, 4, 5}, height = width * parts[one_of(7)] / 4;
    const int strips[] = {2, 4, 8, 16, 24, 30, 40, 60, 80};
    printf(" --size %dx%d", width, height);
    if (!now_and_then(25)) return;
    printf(" --strip %d", strips[one_of(9)]);
    if (now_and_then(40)) printf(" --vertices anew");
}

static void print_material(void)
{
    static const int shininess[] = {1, 3, 5, 8, 12, 16, 20, 30, 32, 45, 60, 90, 120, 180, 250, 300, 400, 700};
    static const char *const lobes[] = {"w2", "w4", "w8", "w16"};
    printf(" -n %d", shininess[one_of(COUNT_OF(shininess))]);
    if (now_and_then(60))
        printf(" --diffuse %.1f --specular %.1f --ambient %.1f", one_of(10) / 10.0, one_of(11) / 10.0, one_of(4) / 10.0);
    if (now_and_then(40)) printf(" --colour #%02x%02x%02x", 20 + one_of(236), 20 + one_of(236), 20 + one_of(236));
    if (now_and_then(15)) printf(" --lobe %s", lobes[one_of(4)]);
}

static void print_place(void)
{
    static const double zooms[] = {0.2, 0.35, 0.5, 0.7, 0.85, 1.2, 1.5, 2, 3};
    static const double distances[] = {1.2, 1.5, 2, 3, 6};
    printf(" --pose %d,%d,%d", one_of(361) - 180, one_of(361) - 180, one_of(361) - 180);
    if (now_and_then(40)) printf(" --zoom %g", zooms[one_of(COUNT_OF(zooms))]);
    if (now_and_then(20)) printf(" --camera perspective --distance %g", distances[one_of(COUNT_OF(distances))]);
}

int main(int argc, char **argv)
{
    static const char *const orders[] = {"depth", "none", "depth", "painter"};
    const bool fit = argc == 4 && !strcmp(argv[1], "training");
    const int count = argc == 4 ? atoi(argv[2]) : 0;
    int i;
    if (count < 1 || (!fit && strcmp(argv[1], "other"))) {
        fprintf(stderr, "usage: estimate_frames training|other COUNT SEED > LIST\n");
        return 2;
    }
    printf("# ");
    chance = test_seed(argc - 2, argv + 2);
    for (i = 0; i < count; i++) {
        printf("%s", fit ? training[one_of(COUNT_OF(training))] : other[one_of(COUNT_OF(other))]);
        print_way(ways[i % COUNT_OF(ways)]);
        printf(" --order %s", orders[i / COUNT_OF(ways) % 4]);
        print_size();
        print_material();
        print_place();
        printf("\n");
    }
    return 0;
}
