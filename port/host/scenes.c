/* SPDX-License-Identifier: MIT */
/* The demo scenes: what `make demo` draws, the judge judges and the figures are about. */
#include "scenes.h"

#include <string.h>

extern const lmb_mesh mesh_icosphere_320, mesh_icosphere_1280, mesh_torus, mesh_teapot;

#define UNIT 65536
#define TURN(degrees) ((uint16_t)((degrees)*65536L / 360))

static const char *const names[] = {SCENE_NAMES};
static const lmb_rgb white = {255, 255, 255};

unsigned scene_count(void) { return (unsigned)(sizeof names / sizeof names[0]); }

/* Ambient 0.1 and diffuse 0.7 of a base colour, white highlight of 0.5. */
static lmb_material glossy(unsigned r, unsigned g, unsigned b, unsigned shininess)
{
    lmb_material m = {{0, 0, 0}, {0, 0, 0}, {128, 128, 128}, 16};
    m.ambient.r = (uint8_t)((r * 26 + 127) / 255);
    m.ambient.g = (uint8_t)((g * 26 + 127) / 255);
    m.ambient.b = (uint8_t)((b * 26 + 127) / 255);
    m.diffuse.r = (uint8_t)((r * 179 + 127) / 255);
    m.diffuse.g = (uint8_t)((g * 179 + 127) / 255);
    m.diffuse.b = (uint8_t)((b * 179 + 127) / 255);
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

static void place(scene_object *o, int32_t x, int32_t y, int32_t z)
{
    o->pose.x = x;
    o->pose.y = y;
    o->pose.z = z;
}

static void light(scene *s, int x, int y, int z, lmb_rgb colour)
{
    s->light[s->lights].direction = lmb_normalise(x, y, z);
    s->light[s->lights++].colour = colour;
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

void scene_make(scene *out, unsigned i)
{
    scene s;
    bool tight = strstr(names[i], "-tight") != NULL;
    memset(&s, 0, sizeof s);
    s.name = names[i];
    s.width = s.height = 240;
    s.background.r = 18;
    s.background.g = 20;
    s.background.b = 26;
    s.step = LMB_STEP_QUADRATIC;
    light(&s, 40, 55, 70, white);
    lmb_camera_orthographic(&s.camera, s.width, s.height, 110 * UNIT, UNIT, 8 * UNIT);
    if (!strncmp(names[i], "icosphere-320", 13)) {
        add(&s, &mesh_icosphere_320, SCENE_SPHERE, glossy(60, 140, 255, tight ? 100 : 16), lmb_rotation(TURN(17), TURN(31), 0));
    } else if (!strncmp(names[i], "icosphere-1280", 14)) {
        add(&s, &mesh_icosphere_1280, SCENE_SPHERE, glossy(60, 140, 255, tight ? 300 : 16), lmb_rotation(TURN(17), TURN(31), 0));
    } else if (!strncmp(names[i], "torus", 5)) {
        s.depth = true;
        add(&s, &mesh_torus, SCENE_TORUS, glossy(255, 120, 40, tight ? 100 : 16), lmb_rotation(TURN(-52), TURN(24), 0));
    } else if (!strncmp(names[i], "teapot", 6)) {
        s.depth = true;
        s.lights = 0;
        light(&s, 45, 18, 60, white); /* low, so that the belly has its highlight */
        lmb_camera_orthographic(&s.camera, s.width, s.height, 122 * UNIT, UNIT, 8 * UNIT);
        add(&s, &mesh_teapot, SCENE_MESH_ONLY, glossy(235, 225, 205, tight ? 100 : 16), lmb_rotation(TURN(20), TURN(-32), 0));
    } else {
        still_life(&s);
    }
    *out = s;
}

uint32_t scene_draw(const scene *s, const lmb_surface *surface, enum lmb_model model, enum lmb_step_kind step)
{
    uint32_t pixels = 0;
    unsigned i;
    lmb_clear(surface, s->background);
    for (i = 0; i < s->objects; i++) {
        lmb_look look;
        if (lmb_look_prepare(&look, &s->object[i].material, s->light, s->lights, model, step)) return 0;
        pixels += lmb_draw_mesh(surface, s->object[i].mesh, &s->object[i].pose, &s->camera, &look, NULL, NULL);
    }
    return pixels;
}
