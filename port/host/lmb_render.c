/* SPDX-License-Identifier: MIT */
/* lmb-render: any Wavefront OBJ file through the library, exactly as firmware would draw it, into a BMP file. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bmp.h"
#include "mesh_build.h"

#define EXIT_USAGE 2
#define SIZE_MAX_PIXELS 8192
#define UNIT 65536.0
#define TAU 6.283185307179586
#define FILL 0.92 /* of the shorter side, for the model's bounding sphere at zoom 1 */

enum order { ORDER_DEPTH, ORDER_PAINTER, ORDER_NONE };

typedef struct job {
    const char *input, *output;
    int width, height, strip;
    int format, model, step, lobe, order, camera, weight;
    double pose[3], zoom, distance, ambient, diffuse, specular;
    long shininess;
    lmb_rgb colour, highlight, background;
    lmb_light light[LMB_LIGHTS];
    unsigned lights;
    bool quiet, drop_degenerate;
} job;

static const char *const format_names[] = {"rgb565", "rgb888", NULL};
static const char *const model_names[] = {"flat", "gouraud", "diffuse", "gloss", NULL};
static const char *const step_names[] = {"linear", "quadratic", "arc", NULL};
static const char *const lobe_names[] = {"tuned", "w2", "w4", "w8", "w16", NULL};
static const char *const order_names[] = {"depth", "painter", "none", NULL};
static const char *const camera_names[] = {"orthographic", "perspective", NULL};
static const char *const weight_names[] = {"angle", "area", NULL};

static const char help[] =
    "usage: lmb-render MODEL.obj -o OUT.bmp [options]\n"
    "\n"
    "Draws a Wavefront OBJ file through the library, exactly as firmware would, and writes the display as a 24-bit BMP.\n"
    "The model is centred and fitted to the frame.\n"
    "\n"
    "  -o FILE               the picture; - is the standard output\n"
    "  --size WxH            pixels of the frame (240x240)\n"
    "  --format F            of the display: rgb565 (default) or rgb888\n"
    "  --strip ROWS          draw in strips of so many rows, as a core without a framebuffer does; the picture is the same\n"
    "\n"
    "  --pose X,Y,Z          turn about x, then y, then z, degrees (0,0,0)\n"
    "  --camera C            orthographic (default) or perspective\n"
    "  --distance D          perspective: from the camera to the model's centre, in radii of the model, above 1 (3)\n"
    "  --zoom Z              1 fits the model to the frame (1)\n"
    "  --order O             hidden surfaces by depth buffer (depth, default), painter's order (painter), or not at all (none)\n"
    "\n"
    "  --model M             flat, gouraud, diffuse or gloss (default: diffuse and highlight for each pixel)\n"
    "  --step S              how N.L and N.H run over a triangle: linear, quadratic (default) or arc\n"
    "  --lobe L              the highlight's curve: tuned (default), or w2, w4, w8, w16 as published\n"
    "  -n N                  shininess, the exponent of the cosine, 1 to 1000 (16)\n"
    "  --colour C            of the material, #rrggbb (#3c8cff)\n"
    "  --highlight C         of its highlight, #rrggbb (#ffffff)\n"
    "  --ambient A           0 to 1 (0.1)\n"
    "  --diffuse D           0 to 1 (0.7)\n"
    "  --specular S          0 to 1 (0.5)\n"
    "  --light X,Y,Z[,C]     towards a light, x right, y up, z to the viewer, and its colour; up to four times (40,55,70)\n"
    "  --background C        #rrggbb (#12141a)\n"
    "\n"
    "  --normals W           normals that the file lacks: weighted by angle (default) or area\n"
    "  --drop-degenerate     leave out triangles without area instead of refusing the file\n"
    "  -q, --quiet           no notes, no summary\n"
    "  -h, --help            this text\n";

static int usage(const char *what, const char *which)
{
    fprintf(stderr, "lmb-render: %s%s (see lmb-render --help)\n", what, which);
    return EXIT_USAGE;
}

/* -------------------------------------------------------------------------------------------------------------------- options */

static bool parse_name(int *out, const char *text, const char *const *names)
{
    int i;
    for (i = 0; names[i]; i++) {
        if (!strcmp(text, names[i])) {
            *out = i;
            return true;
        }
    }
    return false;
}

static bool parse_numbers(double *out, const char *text, int count, char until)
{
    int i;
    for (i = 0; i < count; i++) {
        char *end;
        out[i] = strtod(text, &end);
        if (end == text || !isfinite(out[i]) || fabs(out[i]) > 1e6) return false;
        if (i < count - 1 && *end != ',') return false;
        text = end + 1;
        if (i == count - 1) return *end == 0 || (until && *end == until);
    }
    return false;
}

static bool parse_number(double *out, const char *text, double low, double high)
{
    return parse_numbers(out, text, 1, 0) && *out >= low && *out <= high;
}

static bool parse_colour(lmb_rgb *out, const char *text)
{
    char *end;
    unsigned long v;
    if (text[0] != '#' || strlen(text) != 7 || strspn(text + 1, "0123456789abcdefABCDEF") != 6) return false;
    v = strtoul(text + 1, &end, 16);
    out->r = (uint8_t)(v >> 16 & 255u);
    out->g = (uint8_t)(v >> 8 & 255u);
    out->b = (uint8_t)(v & 255u);
    return true;
}

static bool parse_size(job *j, const char *text)
{
    char *end;
    long w = strtol(text, &end, 10), h;
    if (end == text || *end != 'x') return false;
    text = end + 1;
    h = strtol(text, &end, 10);
    if (end == text || *end || w < 1 || h < 1 || w > SIZE_MAX_PIXELS || h > SIZE_MAX_PIXELS) return false;
    j->width = (int)w;
    j->height = (int)h;
    return true;
}

static bool parse_light(job *j, const char *text)
{
    double v[3], length;
    const char *colour = strchr(text, '#');
    lmb_light *light;
    if (j->lights >= LMB_LIGHTS || !parse_numbers(v, text, 3, ',')) return false;
    light = &j->light[j->lights];
    light->colour.r = light->colour.g = light->colour.b = 255;
    length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (length < 1e-9) return false;
    if (strchr(text, ',') && colour && (colour[-1] != ',' || !parse_colour(&light->colour, colour))) return false;
    light->direction.x = (int16_t)lround(v[0] / length * 16384);
    light->direction.y = (int16_t)lround(v[1] / length * 16384);
    light->direction.z = (int16_t)lround(v[2] / length * 16384);
    j->lights++;
    return true;
}

/* One option with a value. Returns 1 if understood, 0 if its value is not, -1 if there is no such option. */
static int parse_option(job *j, const char *option, const char *value)
{
    double number;
    if (!strcmp(option, "-o")) return (j->output = value) != NULL;
    if (!strcmp(option, "--size")) return parse_size(j, value);
    if (!strcmp(option, "--format")) return parse_name(&j->format, value, format_names);
    if (!strcmp(option, "--model")) return parse_name(&j->model, value, model_names);
    if (!strcmp(option, "--step")) return parse_name(&j->step, value, step_names);
    if (!strcmp(option, "--lobe")) return parse_name(&j->lobe, value, lobe_names);
    if (!strcmp(option, "--order")) return parse_name(&j->order, value, order_names);
    if (!strcmp(option, "--camera")) return parse_name(&j->camera, value, camera_names);
    if (!strcmp(option, "--normals")) return parse_name(&j->weight, value, weight_names);
    if (!strcmp(option, "--pose")) return parse_numbers(j->pose, value, 3, 0);
    if (!strcmp(option, "--zoom")) return parse_number(&j->zoom, value, 0.01, 100);
    if (!strcmp(option, "--distance")) return parse_number(&j->distance, value, 1.01, 100);
    if (!strcmp(option, "--ambient")) return parse_number(&j->ambient, value, 0, 1);
    if (!strcmp(option, "--diffuse")) return parse_number(&j->diffuse, value, 0, 1);
    if (!strcmp(option, "--specular")) return parse_number(&j->specular, value, 0, 1);
    if (!strcmp(option, "--colour")) return parse_colour(&j->colour, value);
    if (!strcmp(option, "--highlight")) return parse_colour(&j->highlight, value);
    if (!strcmp(option, "--background")) return parse_colour(&j->background, value);
    if (!strcmp(option, "--light")) return parse_light(j, value);
    if (!strcmp(option, "-n")) {
        if (!parse_number(&number, value, 1, LMB_SHININESS_MAX) || number != floor(number)) return 0;
        j->shininess = (long)number;
        return 1;
    }
    if (!strcmp(option, "--strip")) {
        if (!parse_number(&number, value, 1, SIZE_MAX_PIXELS) || number != floor(number)) return 0;
        j->strip = (int)number;
        return 1;
    }
    return -1;
}

/* One line that says what the option takes: its own line of the help. */
static int refuse_value(const char *option, const char *value)
{
    char start[32];
    const char *line;
    int blanks = 0;
    snprintf(start, sizeof start, "\n  %s ", option);
    line = strstr(help, start);
    if (line) line += strspn(line, "\n ");
    fprintf(stderr, "lmb-render: '%s' will not do; ", value);
    for (; line && *line && *line != '\n'; line++) { /* runs of blanks, which align the help, become a colon */
        if (*line == ' ' && ++blanks > 1) continue;
        if (*line != ' ' && blanks > 1) fputs(": ", stderr);
        if (*line != ' ' && blanks == 1) fputc(' ', stderr);
        if (*line == ' ') continue;
        blanks = 0;
        fputc(*line, stderr);
    }
    fputc('\n', stderr);
    return EXIT_USAGE;
}

/* Returns -1 to go on, or the exit status. */
static int parse(job *j, int argc, char **argv)
{
    static char option_colour[] = "--colour";
    int i, result;
    for (i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "-h") || !strcmp(argv[i], "--help")) {
            fputs(help, stdout);
            return EXIT_SUCCESS;
        } else if (!strcmp(argv[i], "-q") || !strcmp(argv[i], "--quiet")) {
            j->quiet = true;
        } else if (!strcmp(argv[i], "--drop-degenerate")) {
            j->drop_degenerate = true;
        } else if (argv[i][0] == '-' && argv[i][1]) {
            if (!strcmp(argv[i], "--color")) argv[i] = option_colour;
            result = parse_option(j, argv[i], i + 1 < argc ? argv[i + 1] : "");
            if (result < 0) return usage("no such option: ", argv[i]);
            if (i + 1 >= argc) return usage("a value is missing after ", argv[i]);
            if (result == 0) return refuse_value(argv[i], argv[i + 1]);
            i++;
        } else if (j->input) {
            return usage("one model at a time; unexpected: ", argv[i]);
        } else {
            j->input = argv[i];
        }
    }
    if (!j->input) return usage("which model? MODEL.obj is missing", "");
    if (!j->output) return usage("where to? -o OUT.bmp is missing", "");
    return -1;
}

/* -------------------------------------------------------------------------------------------------------------------- drawing */

static lmb_rgb scaled(lmb_rgb colour, double by)
{
    lmb_rgb c;
    c.r = (uint8_t)lround(colour.r * by);
    c.g = (uint8_t)lround(colour.g * by);
    c.b = (uint8_t)lround(colour.b * by);
    return c;
}

static uint16_t turn(double degrees) { return (uint16_t)((unsigned long)llround(degrees / 360 * 65536) & 65535u); }

/* Camera and pose that show a mesh of radius 1 about the origin. */
static void place(const job *j, lmb_camera *camera, lmb_pose *pose)
{
    double half = 0.5 * FILL * j->zoom * (j->width < j->height ? j->width : j->height), d = j->distance;
    pose->rotation = lmb_rotation(turn(j->pose[0]), turn(j->pose[1]), turn(j->pose[2]));
    pose->x = pose->y = 0;
    if (j->camera == 1) { /* the sphere's outline is seen under the angle whose sine is 1 / d */
        pose->z = (int32_t)lround(-d * UNIT);
        (void)lmb_camera_perspective(camera, j->width, j->height, (int32_t)lround(half * sqrt(d * d - 1) * UNIT),
                                     (int32_t)lround(fmax(0.005, (d - 1) * 0.9) * UNIT), (int32_t)lround((d + 1.1) * UNIT));
    } else {
        pose->z = (int32_t)(-4 * UNIT);
        (void)lmb_camera_orthographic(camera, j->width, j->height, (int32_t)lround(half * UNIT), (int32_t)(2 * UNIT),
                                      (int32_t)(6 * UNIT));
    }
}

static int look_prepare(const job *j, lmb_look *look)
{
    lmb_material material;
    int error;
    material.ambient = scaled(j->colour, j->ambient);
    material.diffuse = scaled(j->colour, j->diffuse);
    material.specular = scaled(j->highlight, j->specular);
    material.shininess = (uint16_t)j->shininess;
    error = lmb_look_prepare(look, &material, j->light, j->lights, (enum lmb_model)j->model, (enum lmb_step_kind)j->step);
    return error ? error : lmb_look_lobe(look, (enum lmb_lobe_kind)j->lobe, 0);
}

/* What drawing needs beside the mesh; one block of each, freed together. */
typedef struct memory {
    uint8_t *frame;
    uint16_t *depth, *order;
    int16_t *keys;
    lmb_vertex *vertices;
} memory;

static bool memory_get(memory *m, const job *j, const lmb_mesh *mesh)
{
    size_t pixels = (size_t)j->width * (size_t)j->height, strip = (size_t)j->width * (size_t)j->strip;
    m->frame = malloc(pixels * 3);
    m->vertices = malloc(mesh->vertices * sizeof *m->vertices);
    m->depth = j->order == ORDER_DEPTH ? malloc(strip * sizeof *m->depth) : NULL;
    m->order = j->order == ORDER_PAINTER ? malloc(mesh->triangles * sizeof *m->order) : NULL;
    m->keys = j->order == ORDER_PAINTER ? malloc(mesh->triangles * sizeof *m->keys) : NULL;
    return m->frame && m->vertices && (j->order != ORDER_DEPTH || m->depth) &&
           (j->order != ORDER_PAINTER || (m->order && m->keys));
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
static int draw(const job *j, const lmb_mesh *mesh, const memory *m, lmb_surface *frame, uint32_t *seen)
{
    size_t row_bytes = (size_t)j->width * lmb_format_bytes((enum lmb_format)j->format);
    lmb_camera camera;
    lmb_pose pose;
    lmb_look look;
    lmb_paint paint;
    int top, error = look_prepare(j, &look);
    if (error) return error;
    lmb_paint_prepare(&paint, &look, (enum lmb_format)j->format);
    place(j, &camera, &pose);
    lmb_mesh_project(mesh, &pose, &camera, m->vertices);
    if (m->order) error = lmb_mesh_sort(mesh, &pose, m->order, m->keys);
    *seen = 0;
    for (top = 0; top < j->height && !error; top += j->strip) {
        int bottom = top + j->strip < j->height ? top + j->strip : j->height;
        lmb_surface strip;
        lmb_surface_strip(&strip, (enum lmb_format)j->format, m->frame + (size_t)top * row_bytes, m->depth, j->width, top,
                          bottom);
        lmb_clear(&strip, j->background);
        *seen += lmb_draw_mesh(&strip, mesh, &pose, &camera, &paint, m->vertices, m->order);
    }
    lmb_surface_strip(frame, (enum lmb_format)j->format, m->frame, NULL, j->width, 0, j->height);
    return error;
}

static int render(const job *j, const lmb_mesh *mesh)
{
    memory m;
    lmb_surface frame;
    uint32_t seen = 0;
    clock_t begin;
    double milliseconds;
    int error, result = EXIT_FAILURE;
    if (!memory_get(&m, j, mesh)) {
        fprintf(stderr, "lmb-render: out of memory\n");
        memory_free(&m);
        return EXIT_FAILURE;
    }
    begin = clock();
    error = draw(j, mesh, &m, &frame, &seen);
    milliseconds = 1000.0 * (double)(clock() - begin) / CLOCKS_PER_SEC;
    if (error) {
        fprintf(stderr, "%s: %s\n", j->input,
                j->order == ORDER_PAINTER ? "too many triangles for painter's order (65536); use --order depth"
                                          : "the library refused a value");
    } else if (bmp_write(j->output, &frame)) {
        fprintf(stderr, "%s: cannot write: %s\n", j->output, strerror(errno));
    } else {
        result = EXIT_SUCCESS;
        if (!j->quiet) {
            fprintf(stderr, "%s  %lu triangles, %lu seen  %s, %s, %s  %.2f ms\n", j->output, (unsigned long)mesh->triangles,
                    (unsigned long)seen, model_names[j->model], step_names[j->step], format_names[j->format], milliseconds);
        }
    }
    memory_free(&m);
    return result;
}

/* Reads the model and fits it to radius 1. Returns 0, or -1 after one line on the standard error. */
static int read_mesh(const job *j, lmb_mesh *mesh)
{
    struct mesh_options options = {MESH_WEIGHT_ANGLE, MESH_PLACE_FIT, false};
    struct mesh_info info;
    struct obj_model model;
    int result = obj_read(&model, j->input, NULL, stderr);
    options.normals = j->weight ? MESH_WEIGHT_AREA : MESH_WEIGHT_ANGLE;
    options.drop_degenerate = j->drop_degenerate;
    if (!result) result = mesh_build(mesh, &info, &model, &options, stderr);
    if (!result && !j->quiet) {
        obj_print_notes(&model, stderr);
        mesh_print_notes(&info, j->input, stderr);
    }
    obj_free(&model);
    return result;
}

int main(int argc, char **argv)
{
    job j = {NULL,
             NULL,
             240,
             240,
             0,
             LMB_RGB565,
             LMB_MODEL_GLOSS,
             LMB_STEP_QUADRATIC,
             LMB_LOBE_TUNED,
             ORDER_DEPTH,
             0,
             0,
             {0, 0, 0},
             1,
             3,
             0.1,
             0.7,
             0.5,
             16,
             {0x3c, 0x8c, 0xff},
             {255, 255, 255},
             {18, 20, 26},
             {{{0, 0, 0}, {0, 0, 0}}},
             0,
             false,
             false};
    lmb_mesh mesh;
    int result = parse(&j, argc, argv);
    if (result >= 0) return result;
    if (j.lights == 0) (void)parse_light(&j, "40,55,70");
    if (j.strip == 0 || j.strip > j.height) j.strip = j.height;
    if (read_mesh(&j, &mesh)) return EXIT_FAILURE;
    result = render(&j, &mesh);
    mesh_free(&mesh);
    return result;
}
