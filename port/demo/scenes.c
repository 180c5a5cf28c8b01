/* SPDX-License-Identifier: MIT */
/* The demo scenes: what `make demo` draws, the boards draw, the judge judges and the figures are about. */
#include "scenes.h"

extern const lmb_mesh mesh_icosphere_320, mesh_icosphere_1280, mesh_torus, mesh_teapot;

#define UNIT 65536L
#define TURN(degrees) ((uint16_t)((degrees)*65536L / 360)) /* of constants alone: boards need not divide */

enum show { SHOW_ICOSPHERE_320, SHOW_ICOSPHERE_1280, SHOW_TORUS, SHOW_TEAPOT, SHOW_STILL_LIFE, SHOW_ICOSPHERE_128 };

static const struct {
    const char *name;
    uint8_t show;       /* enum show */
    uint16_t shininess; /* where the scene shows one thing */
} list[] = {
#if (SCENES) & SCENE_WITH_ICOSPHERE_320
    {"icosphere-320", SHOW_ICOSPHERE_320, 16},
#endif
#if (SCENES) & SCENE_WITH_ICOSPHERE_320_TIGHT
    {"icosphere-320-tight", SHOW_ICOSPHERE_320, 100},
#endif
#if (SCENES) & SCENE_WITH_ICOSPHERE_1280
    {"icosphere-1280", SHOW_ICOSPHERE_1280, 16},
#endif
#if (SCENES) & SCENE_WITH_ICOSPHERE_1280_TIGHT
    {"icosphere-1280-tight", SHOW_ICOSPHERE_1280, 300},
#endif
#if (SCENES) & SCENE_WITH_TORUS
    {"torus", SHOW_TORUS, 16},
#endif
#if (SCENES) & SCENE_WITH_TORUS_TIGHT
    {"torus-tight", SHOW_TORUS, 100},
#endif
#if (SCENES) & SCENE_WITH_TEAPOT
    {"teapot", SHOW_TEAPOT, 16},
#endif
#if (SCENES) & SCENE_WITH_TEAPOT_TIGHT
    {"teapot-tight", SHOW_TEAPOT, 100},
#endif
#if (SCENES) & SCENE_WITH_STILL_LIFE
    {"still-life", SHOW_STILL_LIFE, 0},
#endif
#if (SCENES) & SCENE_WITH_ICOSPHERE_128
    {"icosphere-128", SHOW_ICOSPHERE_128, 16},
#endif
};

static const lmb_rgb white = {255, 255, 255};

unsigned scene_count(void) { return (unsigned)(sizeof list / sizeof list[0]); }

/* level * share / 255, rounded; exact while the product stays below 65408. */
static uint8_t part(unsigned level, unsigned share)
{
    unsigned product = level * share + 127;
    return (uint8_t)((product + 1 + (product >> 8)) >> 8);
}

/* Ambient 0.1 and diffuse 0.7 of a base colour, white highlight of 0.5. */
static lmb_material glossy(unsigned r, unsigned g, unsigned b, unsigned shininess)
{
    lmb_material m = {{0, 0, 0}, {0, 0, 0}, {128, 128, 128}, 16};
    m.ambient.r = part(r, 26);
    m.ambient.g = part(g, 26);
    m.ambient.b = part(b, 26);
    m.diffuse.r = part(r, 179);
    m.diffuse.g = part(g, 179);
    m.diffuse.b = part(b, 179);
    m.shininess = (uint16_t)shininess;
    return m;
}

static scene_object *add(scene *s, const lmb_mesh *mesh, enum scene_surface surface, lmb_material material, lmb_matrix rotation)
{
    scene_object *o = &s->object[s->objects++];
    o->mesh = mesh;
    o->surface = surface;
    o->material = material;
    o->pose.rotation = rotation;
    o->pose.x = o->pose.y = 0;
    o->pose.z = -4 * UNIT;
    return o;
}

static void light(scene *s, int x, int y, int z, lmb_rgb colour)
{
    s->light[s->lights].direction = lmb_normalise(x, y, z);
    s->light[s->lights++].colour = colour;
}

#if (SCENES) & SCENE_WITH_STILL_LIFE
static void place(scene_object *o, int32_t x, int32_t y, int32_t z)
{
    o->pose.x = x;
    o->pose.y = y;
    o->pose.z = z;
}

/* Objects of all kinds in perspective, two lights, one of them warm and low. */
static void still_life(scene *s)
{
    static const lmb_rgb key = {235, 240, 255}, warm = {120, 70, 30};
    s->lights = 0;
    light(s, 45, 40, 60, key);
    light(s, -80, 10, 40, warm);
    s->width = 320;
    s->depth = true;
    lmb_camera_perspective(&s->camera, s->width, s->height, 400 * UNIT, UNIT, 16 * UNIT);
    place(add(s, &mesh_teapot, SCENE_MESH_ONLY, glossy(235, 235, 240, 60), lmb_rotation(TURN(20), TURN(-30), 0)), -UNIT / 2,
          -UNIT / 8, -UNIT * 4);
    place(add(s, &mesh_torus, SCENE_TORUS, glossy(220, 60, 40, 30), lmb_rotation(TURN(-62), TURN(20), 0)), UNIT * 6 / 7,
          -UNIT / 2, -5 * UNIT);
    place(add(s, &mesh_icosphere_1280, SCENE_SPHERE, glossy(60, 140, 230, 120), lmb_rotation(0, 0, 0)), UNIT * 5 / 4, UNIT / 2,
          -7 * UNIT);
    place(add(s, &mesh_icosphere_320, SCENE_SPHERE, glossy(90, 190, 80, 12), lmb_rotation(TURN(10), TURN(40), 0)), -UNIT * 7 / 4,
          UNIT * 3 / 4, -8 * UNIT);
}
#endif

void scene_make(scene *s, unsigned i)
{
    s->name = list[i].name;
    s->width = s->height = 240;
    s->objects = s->lights = 0;
    s->background.r = 18;
    s->background.g = 20;
    s->background.b = 26;
    s->depth = false;
    s->step = LMB_STEP_QUADRATIC;
    light(s, 40, 55, 70, white);
    lmb_camera_orthographic(&s->camera, s->width, s->height, 110 * UNIT, UNIT, 8 * UNIT);
    switch (list[i].show) {
#if (SCENES) & (SCENE_WITH_ICOSPHERE_320 | SCENE_WITH_ICOSPHERE_320_TIGHT)
    case SHOW_ICOSPHERE_320:
        add(s, &mesh_icosphere_320, SCENE_SPHERE, glossy(60, 140, 255, list[i].shininess), lmb_rotation(TURN(17), TURN(31), 0));
        break;
#endif
#if (SCENES) & (SCENE_WITH_ICOSPHERE_1280 | SCENE_WITH_ICOSPHERE_1280_TIGHT)
    case SHOW_ICOSPHERE_1280:
        add(s, &mesh_icosphere_1280, SCENE_SPHERE, glossy(60, 140, 255, list[i].shininess), lmb_rotation(TURN(17), TURN(31), 0));
        break;
#endif
#if (SCENES) & (SCENE_WITH_TORUS | SCENE_WITH_TORUS_TIGHT)
    case SHOW_TORUS:
        s->depth = true;
        add(s, &mesh_torus, SCENE_TORUS, glossy(255, 120, 40, list[i].shininess), lmb_rotation(TURN(-52), TURN(24), 0));
        break;
#endif
#if (SCENES) & (SCENE_WITH_TEAPOT | SCENE_WITH_TEAPOT_TIGHT)
    case SHOW_TEAPOT:
        s->depth = true;
        s->lights = 0;
        light(s, 45, 18, 60, white); /* low, so that the belly has its highlight */
        lmb_camera_orthographic(&s->camera, s->width, s->height, 122 * UNIT, UNIT, 8 * UNIT);
        add(s, &mesh_teapot, SCENE_MESH_ONLY, glossy(235, 225, 205, list[i].shininess), lmb_rotation(TURN(20), TURN(-32), 0));
        break;
#endif
#if (SCENES) & SCENE_WITH_ICOSPHERE_128
    case SHOW_ICOSPHERE_128: /* for small displays: 117 pixels wide */
        s->width = s->height = 128;
        lmb_camera_orthographic(&s->camera, s->width, s->height, 58 * UNIT + UNIT / 2, UNIT, 8 * UNIT);
        add(s, &mesh_icosphere_320, SCENE_SPHERE, glossy(60, 140, 255, list[i].shininess), lmb_rotation(TURN(17), TURN(31), 0));
        break;
#endif
#if (SCENES) & SCENE_WITH_STILL_LIFE
    case SHOW_STILL_LIFE:
        still_life(s);
        break;
#endif
    default:
        break;
    }
}

/* The paint of an object: prepared anew only when the look is not the one before, as it is not from strip to strip. */
static const lmb_paint *paint_of(const lmb_look *look, enum lmb_format format)
{
    static lmb_paint paint;
    static lmb_look last;
    const uint8_t *a = (const uint8_t *)look;
    uint8_t *b = (uint8_t *)&last;
    bool same = paint.format == format;
    size_t i;
    for (i = 0; i < sizeof last; i++) {
        same = same && a[i] == b[i];
        b[i] = a[i];
    }
    if (!same) lmb_paint_prepare(&paint, look, format);
    return &paint;
}

void scene_draw(const scene *s, const lmb_surface *surface, enum lmb_model model, enum lmb_step_kind step)
{
    unsigned i;
    lmb_clear(surface, s->background);
    for (i = 0; i < s->objects; i++) {
        lmb_look look;
        if (lmb_look_prepare(&look, &s->object[i].material, s->light, s->lights, model, step)) return;
        lmb_draw_mesh(surface, s->object[i].mesh, &s->object[i].pose, &s->camera,
                      paint_of(&look, (enum lmb_format)surface->format), NULL, NULL);
    }
}

uint32_t scene_pixels(const scene *s, const lmb_window *window)
{
    uint32_t pixels = 0;
    lmb_look look;
    unsigned i;
    for (i = 0; i < s->objects; i++) {
        lmb_walk walk;
        lmb_triangle triangle;
        lmb_span span;
        if (lmb_look_prepare(&look, &s->object[i].material, s->light, s->lights, LMB_MODEL_DIFFUSE, LMB_STEP_LINEAR)) return 0;
        lmb_mesh_begin(&walk, s->object[i].mesh, &s->object[i].pose, &s->camera, &look, window, NULL, NULL);
        while (lmb_mesh_next(&walk, &triangle)) {
            while (lmb_triangle_next(&triangle, &span)) pixels += span.length;
        }
    }
    return pixels;
}
