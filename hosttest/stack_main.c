/* SPDX-License-Identifier: MIT */
/* How deep the stack really goes: marks it, draws a sphere, and looks how far the marks are gone. Prints "deepest BYTES", of all that
 * the configuration can draw. Configurations as in size_main.c. */
#include "../port/board.h"
#include "../port/fill.h"

extern const lmb_mesh mesh_icosphere_320;

#define SIDE 32
#define MARKED 2560 /* bytes below the caller's frame */

static uint16_t pixels[SIDE * SIDE * 3 / 2], depths[SIDE * SIDE];

/* The first byte that is in use: a call would push below it. */
static inline volatile uint8_t *stack_pointer(void)
{
    volatile uint8_t *p;
#if defined(__AVR__)
    __asm__ volatile("in %A0, __SP_L__\n\tin %B0, __SP_H__" : "=r"(p));
    p++; /* it points to the next byte that is free */
#elif defined(__XTENSA__)
    __asm__ volatile("mov %0, a1" : "=r"(p));
#elif defined(__riscv)
    __asm__ volatile("mv %0, sp" : "=r"(p));
#elif defined(__arm__)
    __asm__ volatile("mov %0, sp" : "=r"(p));
#else
#error no stack pointer
#endif
    return p;
}

/* Bytes of stack that one call takes, or less by what happens to look like a mark. The frame of this function itself
 * does not move while it runs: no argument is pushed. */
static unsigned depth_of(const lmb_surface *surface, const lmb_pose *pose, const lmb_camera *camera, const lmb_paint *paint,
                         uint8_t mark)
{
    volatile uint8_t *top = stack_pointer();
    int n;
    for (n = 1; n <= MARKED; n++) top[-n] = mark;
    lmb_draw_mesh(surface, &mesh_icosphere_320, pose, camera, paint, NULL, NULL);
    for (n = MARKED; n > 0 && top[-n] == mark; n--) {}
    return (unsigned)n;
}

static unsigned deepest;

/* One frame of the sphere, lit by some lights, z in front of the camera. */
static void draw(enum lmb_model model, enum lmb_step_kind step, enum lmb_format format, bool depth, unsigned lights,
                 const lmb_camera *camera, int32_t z)
{
    static const lmb_material material = {{6, 14, 26}, {42, 98, 179}, {128, 128, 128}, 16};
    static uint8_t mark = 0xa5;
    static lmb_paint paint;
    const lmb_rgb black = {0, 0, 0};
    lmb_light light[LMB_LIGHTS];
    lmb_pose pose;
    lmb_look look;
    lmb_surface surface;
    unsigned i, n;
    for (i = 0; i < LMB_LIGHTS; i++) {
        light[i].direction = lmb_normalise(40 - 30 * (int)i, 55, 70);
        light[i].colour.r = light[i].colour.g = light[i].colour.b = 255;
    }
    pose.rotation = lmb_rotation(3095, 5643, 0);
    pose.x = pose.y = 0;
    pose.z = z;
    if (lmb_look_prepare(&look, &material, light, lights, model, step)) lmb_board_exit(2);
    lmb_paint_prepare(&paint, &look, format);
    lmb_surface_strip(&surface, format, pixels, depth ? depths : NULL, SIDE, 0, SIDE);
    lmb_clear(&surface, black);
    n = depth_of(&surface, &pose, camera, &paint, mark);
    if (n > deepest) deepest = n;
    mark ^= 0xff;
}

/* All that a lean configuration draws; or every model and step, seen from afar, in perspective and cut by the near plane, and from so
 * close that a triangle is thousands of pixels wide. */
static void draw_all(void)
{
    const int32_t afar = -4 * 65536L;
    lmb_camera camera;
    lmb_camera_orthographic(&camera, SIDE, SIDE, 14L << 16, 1L << 16, 8L << 16);
#if defined(SIZE_MODEL)
    draw(SIZE_MODEL, SIZE_STEP, SIZE_FORMAT, false, LMB_LIGHTS, &camera, afar);
    draw(SIZE_MODEL, SIZE_STEP, SIZE_FORMAT, false, LMB_LIGHTS, &camera, afar);
#else
    const int32_t close = -98304L;
    lmb_camera cut_camera, large_camera;
    int model, step;
    if (lmb_camera_perspective(&cut_camera, SIDE, SIDE, 30L << 16, 1L << 16, 8L << 16)) lmb_board_exit(2);
    if (lmb_camera_perspective(&large_camera, SIDE, SIDE, 2000L << 16, 1L << 14, 8L << 16)) lmb_board_exit(2);
    for (model = 0; model < 4; model++) {
        for (step = 0; step < 3; step++) {
            const enum lmb_model m = (enum lmb_model)model;
            const enum lmb_step_kind s = (enum lmb_step_kind)step;
            draw(m, s, LMB_RGB565, false, 1, &camera, afar);
            draw(m, s, LMB_RGB888, true, LMB_LIGHTS, &camera, afar);
            draw(m, s, LMB_RGB565, step == 0, step == 1 ? 1 : LMB_LIGHTS, &cut_camera, close);
            draw(m, s, LMB_RGB565, step == 2, step == 1 ? LMB_LIGHTS : 1, &large_camera, close);
        }
    }
#endif
}

static void print_decimal(unsigned value)
{
    static const unsigned powers[] = {1000, 100, 10, 1};
    char text[2] = {'0', '\0'};
    unsigned i;
    for (i = 0; i < 4; i++) {
        for (text[0] = '0'; value >= powers[i]; value -= powers[i]) text[0]++;
        lmb_board_print(text);
    }
}

int main(void);

int main(void)
{
    lmb_board_begin();
#if defined(__arm__)
    __asm__ volatile("cpsid i"); /* an interrupt would leave its marks */
#endif
    draw_all();
    lmb_board_print("deepest ");
    print_decimal(deepest);
    lmb_board_print("\n");
    return deepest > 0 && deepest < MARKED ? 0 : 1;
}
