/* SPDX-License-Identifier: MIT */
/* What pareto.csv says of frames is of the frames that are drawn: intensities as hosttest/pareto has them, rounded, are the
 * library's pixels. Errors that are known are found. */
#include "pareto/errors.h"
#include "test.h"

#include <string.h>

enum { SIDE = 240, PIXELS = SIDE * SIDE };

static double rgb[PIXELS][3];
static bool painted[PIXELS];
static uint8_t bytes[PIXELS * 3];
static uint16_t depth[PIXELS];
static lmb_paint paint;

static void method_named(pareto_method *m, enum lmb_format format, const char *name)
{
    unsigned i;
    for (i = 0; i < pareto_methods(format); i++) {
        pareto_method_set(m, format, i);
        if (!strcmp(m->name, name)) return;
    }
    printf("FAIL method: there is no %s\n", name);
    exit(EXIT_FAILURE);
}

static void draw(const scene *s, enum lmb_format format, const pareto_method *m)
{
    const scene_object *o = &s->object[0];
    lmb_surface surface;
    if (!pareto_paint(&paint, s, format, m)) abort();
    lmb_surface_strip(&surface, format, bytes, s->depth ? depth : NULL, s->width, 0, s->height);
    lmb_clear(&surface, s->background);
    lmb_draw_mesh(&surface, o->mesh, &o->pose, &s->camera, &paint, NULL, NULL);
}

/* A channel's level as it was drawn. */
static int drawn(enum lmb_format format, size_t pixel, int channel)
{
    unsigned word;
    if (format == LMB_RGB888) return bytes[3 * pixel + (size_t)channel];
    word = (unsigned)(bytes[2 * pixel] | bytes[2 * pixel + 1] << 8);
    return (int)(channel == 0 ? word >> 11 : channel == 1 ? word >> 5 & 63u : word & 31u);
}

/* The largest distance in levels between what was drawn and what intensities come to. */
static int apart(const scene *s, enum lmb_format format)
{
    const size_t pixels = (size_t)s->width * (size_t)s->height;
    int most = 0, k;
    size_t i;
    for (i = 0; i < pixels; i++) {
        for (k = 0; k < 3 && painted[i]; k++) {
            const int want = (int)floor(rgb[i][k] * ref_top(format, k) + 0.5), off = abs(drawn(format, i, k) - want);
            most = off > most ? off : most;
        }
    }
    return most;
}

static void test_scene(const scene *s, enum lmb_format format)
{
    static const char *const names[2][9] = {
        {"flat", "gouraud", "linear", "quadratic", "quadratic/1024", "arc", "arc/16", "planned", "planned/64"},
        {"flat", "gouraud", "linear-w4/32", "quadratic-w8", "quadratic-tuned/64", "arc-w16", "arc-tuned/1024", "planned",
         "planned/16"}};
    int most = 0, wrong = 0, off, i;
    for (i = 0; i < 9; i++) {
        pareto_method m;
        method_named(&m, format, names[format == LMB_RGB888][i]);
        pareto_frame_intensities(rgb, painted, s, format, &m);
        draw(s, format, &m);
        off = apart(s, format);
        most = off > most ? off : most;
    }
    { /* the same with another method's pixels */
        pareto_method m;
        method_named(&m, format, "flat");
        draw(s, format, &m);
        wrong = apart(s, format);
    }
    test_verdict(most <= 1 && wrong > 3, "frames",
                 "%s, %s: pixels are the intensities within %d level of 1; another method's within %d", s->name,
                 format == LMB_RGB565 ? "rgb565" : "rgb888", most, wrong);
}

/* The best method is as good as arithmetic is, and each step of its tolerance is seen. */
static void test_errors(const scene *s)
{
    static const char *const names[] = {"arc-tuned/1024", "arc-tuned/256", "arc-tuned/64", "arc-tuned/16"};
    pareto_truth truth;
    double last = 0;
    bool rises = true;
    int i;
    pareto_truth_begin(&truth, s);
    for (i = 0; i < 4; i++) {
        const double allowed = ldexp(1, 2 * i - 10); /* the whole of the tolerance, of which left out highlights take half */
        pareto_errors e = {0, 0, 0};
        pareto_method m;
        method_named(&m, LMB_RGB888, names[i]);
        pareto_frame_errors(&e, &truth, LMB_RGB888, &m);
        rises = rises && e.most > last && e.most <= allowed && pareto_rms(&e) <= e.most;
        last = e.most;
    }
    test_verdict(rises, "errors", "%s along arcs: each within its tolerance, and more where more is tolerated; at 1/16: %.5f",
                 s->name, last);
    pareto_truth_end(&truth);
}

int main(void)
{
    unsigned i;
    for (i = 0; i < scene_count(); i++) {
        scene s;
        scene_make(&s, i);
        if (!pareto_scene(&s, true) && !pareto_scene(&s, false)) continue;
        test_scene(&s, LMB_RGB565);
        test_scene(&s, LMB_RGB888);
        test_errors(&s);
    }
    return test_end();
}
