/* SPDX-License-Identifier: MIT */
/* What the demo scenes leave out: mathematics, lobes, every model, step and format, clipping, several lights, painter's order.
 * Each part is drawn from pseudo-random numbers or small frames and comes down to one number, printed; the numbers of a board must
 * be those of the host. Integers of 16 bits, tables in flash, and compilers show here. */
#include "../board.h"
#include "../fill.h"

enum { WIDTH = 40, HEIGHT = 30, LARGE = 1600, TRIANGLES = 320, VIEWS = 7 };

extern const lmb_mesh mesh_icosphere_320;

/* A cube with smoothed normals: few and large triangles that turn a lot. */
static const LMB_FLASH lmb_vec cube_positions[8] = {
    {-8000, -8000, -8000}, {8000, -8000, -8000}, {-8000, 8000, -8000}, {8000, 8000, -8000},
    {-8000, -8000, 8000},  {8000, -8000, 8000},  {-8000, 8000, 8000},  {8000, 8000, 8000},
};
static const LMB_FLASH lmb_vec cube_normals[8] = {
    {-9459, -9459, -9459}, {9459, -9459, -9459}, {-9459, 9459, -9459}, {9459, 9459, -9459},
    {-9459, -9459, 9459},  {9459, -9459, 9459},  {-9459, 9459, 9459},  {9459, 9459, 9459},
};
static const LMB_FLASH uint16_t cube_indices[36] = {
    4, 5, 7, 4, 7, 6, 1, 0, 2, 1, 2, 3, 5, 1, 3, 5, 3, 7, 0, 4, 6, 0, 6, 2, 6, 7, 3, 6, 3, 2, 0, 1, 5, 0, 5, 4,
};
static const lmb_mesh cube = {cube_positions, cube_normals, cube_indices, 8, 12, -13, 0};

static uint16_t frame[WIDTH * HEIGHT * 3 / 2], depth[WIDTH * HEIGHT], order[TRIANGLES];
static int16_t keys[TRIANGLES];
static lmb_vertex corners[8];

/* FNV-1a over the value's bytes, low first. */
static uint32_t hash, seed;

static void take(uint32_t value, unsigned bytes)
{
    for (; bytes > 0; bytes--, value >>= 8) hash = (hash ^ (value & 255)) * 16777619;
}

static void take_vec(lmb_vec v)
{
    take((uint16_t)v.x, 2);
    take((uint16_t)v.y, 2);
    take((uint16_t)v.z, 2);
}

static uint32_t random_bits(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 17;
    return seed ^= seed << 5;
}

/* Of any magnitude. */
static uint32_t random_scaled(void)
{
    uint32_t value = random_bits();
    return value >> (random_bits() & 31);
}

/* Of any magnitude from 2^(bits - 15) to 2^bits. */
static int32_t random_signed(unsigned bits)
{
    int32_t value = (int32_t)(random_bits() >> (33 - bits));
    value >>= random_bits() & 15;
    return random_bits() & 1 ? -value : value;
}

/* One statement each: in which order arguments are computed is the compiler's choice. */
static lmb_vec random_unit(unsigned bits)
{
    int32_t x = random_signed(bits), y = random_signed(bits), z = random_signed(bits);
    return lmb_normalise(x, y, z);
}

static lmb_matrix random_rotation(void)
{
    uint16_t x = (uint16_t)random_bits(), y = (uint16_t)random_bits(), z = (uint16_t)random_bits();
    return lmb_rotation(x, y, z);
}

static void start(void)
{
    hash = 2166136261u;
    seed = 2463534242u;
}

static void say(const char *name)
{
    char text[11] = " ";
    unsigned i;
    for (i = 0; i < 8; i++) text[i + 1] = "0123456789abcdef"[hash >> (28 - 4 * i) & 15];
    text[9] = '\n';
    lmb_board_print(name);
    lmb_board_print(text);
}

static void digest_vectors(void)
{
    uint32_t i;
    start();
    for (i = 0; i < 500; i++) {
        unsigned shift;
        uint32_t x = random_scaled();
        lmb_matrix m = random_rotation();
        lmb_vec a = random_unit(30);
        lmb_vec b = random_unit(30);
        take_vec(a);
        take_vec(lmb_rotate(&m, a));
        take_vec(lmb_rotate_back(&m, b));
        take((uint32_t)lmb_dot_q28(a, b), 4);
        take((uint32_t)lmb_half_distance_q28(a, b), 4);
        take((uint32_t)lmb_excess_q28(a), 4);
        take(lmb_rsqrt_q30((random_bits() & 0x3fffffff) | 0x10000000), 4);
        take(lmb_reciprocal(x, &shift), 4);
        take(shift, 1);
        take((uint16_t)lmb_sin_q14((uint16_t)random_bits()), 2);
    }
    say("vectors");
}

/* Each kind and tolerance; from W_m on tolerance does nothing. */
static void digest_lobes(void)
{
    unsigned i, kind;
    start();
    for (i = 0; i < 300; i++) {
        for (kind = LMB_LOBE_TUNED; kind <= LMB_LOBE_W16; kind++) {
            lmb_lobe lobe;
            unsigned n = (unsigned)(random_bits() & 1023);
            uint16_t tolerance = (uint16_t)(i & 3 ? random_bits() & 4095 : 0);
            int32_t v_q30 = random_signed(30);
            take(lmb_lobe_prepare(&lobe, (enum lmb_lobe_kind)kind, n, tolerance) == 0, 1);
            if (n < 1 || n > LMB_SHININESS_MAX) continue;
            take(lobe.error_uq16, 2);
            take((uint32_t)lmb_lobe_eval(&lobe, v_q30), 4);
        }
    }
    say("lobes");
}

static void digest_arcs(void)
{
    unsigned i, k;
    start();
    for (i = 0; i < 200; i++) {
        lmb_arc arc;
        lmb_term term;
        lmb_vec from = random_unit(14);
        lmb_vec to = random_unit(14);
        lmb_vec ray = random_unit(14);
        uint32_t length = random_scaled() | 1, start_at = random_bits() & 65535;
        lmb_arc_between(&arc, from, to, length, length < LMB_ARC_PIXEL ? 0 : start_at);
        lmb_arc_dot(&arc, &term, from, to, ray, random_bits() & 65535);
        for (k = 0; k < 16; k++) {
            take((uint32_t)term.f, 4);
            lmb_arc_step(&arc, &term);
        }
    }
    say("arcs");
}

/* Where view i looks from: the even ones at a sphere, the odd ones at a cube; the third to the sixth in perspective, the fifth
 * and sixth so near that the mesh is cut on all sides. The last is a piece of a frame of LARGE pixels. */
static const lmb_mesh *view(unsigned i, lmb_camera *camera, lmb_pose *pose)
{
    pose->rotation = lmb_rotation((uint16_t)(i * 7919u), (uint16_t)(i * 5003u + 3000u), (uint16_t)(i * 911u));
    pose->x = pose->y = 0;
    pose->z = i < 4 || i == VIEWS - 1 ? -4 * 65536L : -3 * 65536L / 2;
    if (i == VIEWS - 1) {
        lmb_camera_orthographic(camera, LARGE, LARGE, LARGE * 65536L, 65536, 8 * 65536L);
    } else if (i < 2) {
        lmb_camera_orthographic(camera, WIDTH, HEIGHT, 12 * 65536L, 65536, 8 * 65536L);
    } else {
        lmb_camera_perspective(camera, WIDTH, HEIGHT, (i < 4 ? 36 : 48) * 65536L, 65536 / 2, 16 * 65536L);
    }
    return i & 1 || i == VIEWS - 1 ? &cube : &mesh_icosphere_320;
}

static void draw(unsigned i, enum lmb_model model, enum lmb_step_kind step, enum lmb_format format)
{
    static const lmb_material material = {{20, 30, 40}, {90, 160, 120}, {200, 128, 90}, 23};
    static const lmb_light light[3] = {
        {{6700, 9200, 11800}, {255, 250, 240}}, {{-12000, 2000, 10970}, {120, 70, 30}}, {{2000, -14000, 8270}, {20, 60, 130}}};
    static const lmb_rgb night = {18, 20, 26};
    lmb_surface surface;
    lmb_camera camera;
    lmb_pose pose;
    lmb_look look;
    static lmb_paint paint;
    const lmb_mesh *mesh = view(i, &camera, &pose);
    unsigned lights = 1 + (i & 1) + (i >> 2);
    uint16_t k, bytes = (uint16_t)(WIDTH * HEIGHT * lmb_format_bytes(format));
    if (lights > LMB_LIGHTS) lights = LMB_LIGHTS;
    lmb_surface_strip(&surface, format, frame, i & 2 ? depth : NULL, WIDTH, 0, HEIGHT);
    if (i == VIEWS - 1) { /* WIDTH x HEIGHT pixels just off its middle */
        surface.window.left = LARGE / 2 - 3 * WIDTH / 2;
        surface.window.right = LARGE / 2 - WIDTH / 2;
        surface.window.top = LARGE / 2 - HEIGHT / 3;
        surface.window.bottom = LARGE / 2 + HEIGHT - HEIGHT / 3;
    }
    lmb_clear(&surface, night);
    take((uint32_t)lmb_look_prepare(&look, &material, light, lights, model, step), 4);
    if (i == 1) take((uint32_t)lmb_look_lobe(&look, LMB_LOBE_TUNED, 1000), 4);
    if (!surface.depth) take((uint32_t)lmb_mesh_sort(mesh, &pose, order, keys), 4);
    if (mesh == &cube) lmb_mesh_project(mesh, &pose, &camera, corners);
    lmb_paint_prepare(&paint, &look, (enum lmb_format)surface.format);
    take(lmb_draw_mesh(&surface, mesh, &pose, &camera, &paint, mesh == &cube ? corners : NULL, surface.depth ? NULL : order), 4);
    for (k = 0; k < bytes; k++) take(((const uint8_t *)frame)[k], 1);
    for (k = 0; surface.depth && k < WIDTH * HEIGHT; k++) take(depth[k], 2);
}

/* The sphere, which takes its time, with one kind of step for each view; the cube with all. */
static void digest_frames(enum lmb_model model, const char *name)
{
    static const uint8_t first[VIEWS] = {LMB_STEP_PLANNED, 0, LMB_STEP_ARC, 0, LMB_STEP_LINEAR, 0, 0};
    unsigned i, step;
    start();
    for (i = 0; i < VIEWS; i++) {
        const bool sphere = !(i & 1) && i != VIEWS - 1;
        for (step = first[i]; step <= (sphere ? first[i] : LMB_STEP_PLANNED); step++) {
            draw(i, model, (enum lmb_step_kind)step, (i + step) & 2 ? LMB_RGB888 : LMB_RGB565);
        }
    }
    say(name);
}

int main(void)
{
    lmb_board_begin();
    digest_vectors();
    digest_lobes();
    digest_arcs();
    digest_frames(LMB_MODEL_FLAT, "flat");
    digest_frames(LMB_MODEL_GOURAUD, "gouraud");
    digest_frames(LMB_MODEL_DIFFUSE, "diffuse");
    digest_frames(LMB_MODEL_GLOSS, "gloss");
    return 0;
}
