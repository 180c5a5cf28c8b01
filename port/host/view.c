/* SPDX-License-Identifier: MIT */
/* Command lines into views, and views into what the library takes: mesh, camera, pose, look. */
#include "view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SIZE_MAX_PIXELS 8192
#define UNIT 65536.0
#define FILL 0.92 /* of the shorter side, for the model's bounding sphere at zoom 1 */

const char *const view_formats[] = {"rgb565", "rgb888", NULL};
const char *const view_models[] = {"flat", "gouraud", "diffuse", "gloss", NULL};
const char *const view_steps[] = {"linear", "quadratic", "arc", "planned", NULL};
static const char *const lobe_names[] = {"tuned", "w2", "w4", "w8", "w16", NULL};
const char *const view_orders[] = {"depth", "painter", "none", NULL};
static const char *const camera_names[] = {"orthographic", "perspective", NULL};
static const char *const weight_names[] = {"angle", "area", NULL};

static void defaults(view *v)
{
    static const lmb_rgb colour = {0x3c, 0x8c, 0xff}, highlight = {255, 255, 255}, background = {18, 20, 26};
    memset(v, 0, sizeof *v);
    v->width = v->height = 240;
    v->format = LMB_RGB565;
    v->model = LMB_MODEL_GLOSS;
    v->step = LMB_STEP_QUADRATIC;
    v->lobe = LMB_LOBE_TUNED;
    v->order = VIEW_DEPTH;
    v->zoom = 1;
    v->distance = 3;
    v->ambient = 0.1;
    v->diffuse = 0.7;
    v->specular = 0.5;
    v->shininess = 16;
    v->colour = colour;
    v->highlight = highlight;
    v->background = background;
}

/* -------------------------------------------------------------------------------------------------------------------- values */

bool view_name(int *out, const char *text, const char *const *names)
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

bool view_numbers(double *out, const char *text, int count) { return parse_numbers(out, text, count, 0); }

bool view_number(double *out, const char *text, double low, double high)
{
    return parse_numbers(out, text, 1, 0) && *out >= low && *out <= high;
}

bool view_whole(int *out, const char *text, int low, int high)
{
    double number;
    if (!view_number(&number, text, low, high) || number != floor(number)) return false;
    *out = (int)number;
    return true;
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

static bool parse_size(view *v, const char *text)
{
    char *end;
    long w = strtol(text, &end, 10), h;
    if (end == text || *end != 'x') return false;
    text = end + 1;
    h = strtol(text, &end, 10);
    if (end == text || *end || w < 1 || h < 1 || w > SIZE_MAX_PIXELS || h > SIZE_MAX_PIXELS) return false;
    v->width = (int)w;
    v->height = (int)h;
    return true;
}

static bool parse_light(view *v, const char *text)
{
    double to[3], length;
    const char *colour = strchr(text, '#');
    lmb_light *light;
    if (v->lights >= LMB_LIGHTS || !parse_numbers(to, text, 3, ',')) return false;
    light = &v->light[v->lights];
    light->colour.r = light->colour.g = light->colour.b = 255;
    length = sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
    if (length < 1e-9) return false;
    if (strchr(text, ',') && colour && (colour[-1] != ',' || !parse_colour(&light->colour, colour))) return false;
    light->direction.x = (int16_t)lround(to[0] / length * 16384);
    light->direction.y = (int16_t)lround(to[1] / length * 16384);
    light->direction.z = (int16_t)lround(to[2] / length * 16384);
    v->lights++;
    return true;
}

/* One option with a value. Returns 1 if understood, 0 if its value is not, -1 if there is no such option. */
static int parse_option(view *v, const char *option, const char *value)
{
    int number;
    if (!strcmp(option, "--size")) return parse_size(v, value);
    if (!strcmp(option, "--format")) return view_name(&v->format, value, view_formats);
    if (!strcmp(option, "--model")) return view_name(&v->model, value, view_models);
    if (!strcmp(option, "--step")) return view_name(&v->step, value, view_steps);
    if (!strcmp(option, "--lobe")) return view_name(&v->lobe, value, lobe_names);
    if (!strcmp(option, "--order")) return view_name(&v->order, value, view_orders);
    if (!strcmp(option, "--camera")) return view_name(&v->camera, value, camera_names);
    if (!strcmp(option, "--normals")) return view_name(&v->weight, value, weight_names);
    if (!strcmp(option, "--pose")) return parse_numbers(v->pose, value, 3, 0);
    if (!strcmp(option, "--zoom")) return view_number(&v->zoom, value, 0.01, 100);
    if (!strcmp(option, "--distance")) return view_number(&v->distance, value, 1.01, 100);
    if (!strcmp(option, "--ambient")) return view_number(&v->ambient, value, 0, 1);
    if (!strcmp(option, "--diffuse")) return view_number(&v->diffuse, value, 0, 1);
    if (!strcmp(option, "--specular")) return view_number(&v->specular, value, 0, 1);
    if (!strcmp(option, "--colour")) return parse_colour(&v->colour, value);
    if (!strcmp(option, "--highlight")) return parse_colour(&v->highlight, value);
    if (!strcmp(option, "--background")) return parse_colour(&v->background, value);
    if (!strcmp(option, "--light")) return parse_light(v, value);
    if (!strcmp(option, "--strip")) return view_whole(&v->strip, value, 1, SIZE_MAX_PIXELS);
    if (!strcmp(option, "-n")) {
        if (!view_whole(&number, value, 1, LMB_SHININESS_MAX)) return 0;
        v->shininess = number;
        return 1;
    }
    return -1;
}

/* -------------------------------------------------------------------------------------------------------------------- command line */

int view_usage(const view_program *program, const char *what, const char *which)
{
    fprintf(stderr, "%s: %s%s (see %s --help)\n", program->name, what, which, program->name);
    return VIEW_USAGE;
}

/* One line that says what the option takes: its own line of the help. */
static int refuse_value(const view_program *program, const char *option, const char *value)
{
    char start[32];
    const char *line;
    int blanks = 0;
    snprintf(start, sizeof start, "\n  %s ", option);
    line = strstr(program->help, start);
    if (line) line += strspn(line, "\n ");
    fprintf(stderr, "%s: '%s' will not do; ", program->name, value);
    for (; line && *line && *line != '\n'; line++) { /* runs of blanks, which align the help, become a colon */
        if (*line == ' ' && ++blanks > 1) continue;
        if (*line != ' ' && blanks > 1) fputs(": ", stderr);
        if (*line != ' ' && blanks == 1) fputc(' ', stderr);
        if (*line == ' ') continue;
        blanks = 0;
        fputc(*line, stderr);
    }
    fputc('\n', stderr);
    return VIEW_USAGE;
}

static bool parse_flag(view *v, const char *text)
{
    if (!strcmp(text, "-q") || !strcmp(text, "--quiet")) {
        v->quiet = true;
    } else if (!strcmp(text, "--drop-degenerate")) {
        v->drop_degenerate = true;
    } else {
        return false;
    }
    return true;
}

int view_parse(view *v, const view_program *program, int argc, char **argv)
{
    int i, result;
    defaults(v);
    for (i = 1; i < argc; i++) {
        const char *option = strcmp(argv[i], "--color") ? argv[i] : "--colour", *value = i + 1 < argc ? argv[i + 1] : "";
        if (!strcmp(option, "-h") || !strcmp(option, "--help")) {
            fputs(program->help, stdout);
            return EXIT_SUCCESS;
        } else if (parse_flag(v, option) || (program->flag && program->flag(program->own, option))) {
            continue;
        } else if (option[0] == '-' && option[1]) {
            result = program->option(program->own, option, value);
            if (result < 0) result = parse_option(v, option, value);
            if (result < 0) return view_usage(program, "no such option: ", option);
            if (i + 1 >= argc) return view_usage(program, "a value is missing after ", option);
            if (result == 0) return refuse_value(program, option, value);
            i++;
        } else if (v->input) {
            return view_usage(program, "one model at a time; unexpected: ", option);
        } else {
            v->input = option;
        }
    }
    if (!v->input) return view_usage(program, "which model? MODEL.obj is missing", "");
    if (v->lights == 0) (void)parse_light(v, "40,55,70");
    if (v->strip == 0 || v->strip > v->height) v->strip = v->height;
    return -1;
}

/* ------------------------------------------------------------------------------------------------------------ for the library */

int view_read(const view *v, lmb_mesh *mesh)
{
    struct mesh_options options = {MESH_WEIGHT_ANGLE, MESH_PLACE_FIT, false};
    struct mesh_info info;
    struct obj_model model;
    int result = obj_read(&model, v->input, NULL, stderr);
    options.normals = v->weight ? MESH_WEIGHT_AREA : MESH_WEIGHT_ANGLE;
    options.drop_degenerate = v->drop_degenerate;
    if (!result) result = mesh_build(mesh, &info, &model, &options, stderr);
    if (!result && !v->quiet) {
        obj_print_notes(&model, stderr);
        mesh_print_notes(&info, v->input, stderr);
    }
    obj_free(&model);
    return result;
}

static lmb_rgb scaled(lmb_rgb colour, double by)
{
    lmb_rgb c;
    c.r = (uint8_t)lround(colour.r * by);
    c.g = (uint8_t)lround(colour.g * by);
    c.b = (uint8_t)lround(colour.b * by);
    return c;
}

static uint16_t turn(double degrees) { return (uint16_t)((unsigned long)llround(degrees / 360 * 65536) & 65535u); }

void view_lens_of(const view *v, view_lens *lens)
{
    double half = 0.5 * FILL * v->zoom * (v->width < v->height ? v->width : v->height), d = v->distance;
    int i;
    for (i = 0; i < 3; i++) lens->turn[i] = turn(v->pose[i]);
    if (v->camera == 1) { /* the sphere's outline is seen under the angle whose sine is 1 / d */
        lens->z_q16 = (int32_t)lround(-d * UNIT);
        lens->focal_q16 = (int32_t)lround(half * sqrt(d * d - 1) * UNIT);
        lens->near_q16 = (int32_t)lround(fmax(0.005, (d - 1) * 0.9) * UNIT);
        lens->far_q16 = (int32_t)lround((d + 1.1) * UNIT);
    } else {
        lens->z_q16 = (int32_t)(-4 * UNIT);
        lens->focal_q16 = (int32_t)lround(half * UNIT);
        lens->near_q16 = (int32_t)(2 * UNIT);
        lens->far_q16 = (int32_t)(6 * UNIT);
    }
}

void view_place(const view *v, lmb_camera *camera, lmb_pose *pose)
{
    view_lens lens;
    view_lens_of(v, &lens);
    pose->rotation = lmb_rotation(lens.turn[0], lens.turn[1], lens.turn[2]);
    pose->x = pose->y = 0;
    pose->z = lens.z_q16;
    if (v->camera == 1) {
        (void)lmb_camera_perspective(camera, v->width, v->height, lens.focal_q16, lens.near_q16, lens.far_q16);
    } else {
        (void)lmb_camera_orthographic(camera, v->width, v->height, lens.focal_q16, lens.near_q16, lens.far_q16);
    }
}

lmb_material view_material(const view *v)
{
    lmb_material material;
    material.ambient = scaled(v->colour, v->ambient);
    material.diffuse = scaled(v->colour, v->diffuse);
    material.specular = scaled(v->highlight, v->specular);
    material.shininess = (uint16_t)v->shininess;
    return material;
}

int view_look(const view *v, lmb_look *look)
{
    const lmb_material material = view_material(v);
    const int error =
        lmb_look_prepare(look, &material, v->light, v->lights, (enum lmb_model)v->model, (enum lmb_step_kind)v->step);
    if (error || v->lobe == LMB_LOBE_TUNED) return error; /* of tuned ones planned looks take the cheapest that serves */
    return lmb_look_lobe(look, (enum lmb_lobe_kind)v->lobe, 0);
}
