/* SPDX-License-Identifier: MIT */
/* Surfaces: bytes of a pixel, clearing, the depth test. */
#include "guarded.h"

/* -------------------------------------------------------------------------------------------------------- layout and clearing */

static void test_layout(void)
{
    static const struct {
        uint8_t r, g, b, low, high;
    } known[] = {{255, 0, 0, 0x00, 0xf8}, {0, 255, 0, 0xe0, 0x07}, {0, 0, 255, 0x1f, 0x00},   {255, 255, 255, 0xff, 0xff},
                 {0, 0, 0, 0x00, 0x00},   {8, 4, 8, 0x21, 0x08},   {132, 130, 16, 0x02, 0x84}};
    static memory m;
    int i, faults = 0;
    for (i = 0; i < (int)(sizeof known / sizeof *known); i++) {
        const uint8_t *bytes = (const uint8_t *)(m.pixels + 64);
        memory_surface(&m, LMB_RGB565, window_of(0, 0, 1, 1), 0, false);
        lmb_clear(&m.surface, rgb(known[i].r, known[i].g, known[i].b));
        faults += bytes[0] != known[i].low || bytes[1] != known[i].high;
        memory_surface(&m, LMB_RGB888, window_of(0, 0, 1, 1), 0, false);
        lmb_clear(&m.surface, rgb(known[i].r, known[i].g, known[i].b));
        faults += bytes[0] != known[i].r || bytes[1] != known[i].g || bytes[2] != known[i].b;
    }
    test_verdict(!faults, "layout: known colours as bytes", "%d faults in %d colours of two formats", faults, i);
}

/* Every value of every channel goes to the nearest level; no value of 255 is half way between two of 31 or 63. */
static void test_clear_levels(void)
{
    static memory m;
    int c, faults = 0;
    for (c = 0; c < 256; c++) {
        int32_t five = (int32_t)floor(c * 31 / 255.0 + 0.5), six = (int32_t)floor(c * 63 / 255.0 + 0.5), got;
        memory_surface(&m, LMB_RGB565, window_of(3, 4, 5, 6), 0, false);
        lmb_clear(&m.surface, rgb(c, 0, 0));
        got = pixel_of(&m.surface, 4, 5)[0] | pixel_of(&m.surface, 4, 5)[1] << 8;
        faults += got != five << 11;
        lmb_clear(&m.surface, rgb(0, c, 0));
        got = pixel_of(&m.surface, 4, 5)[0] | pixel_of(&m.surface, 4, 5)[1] << 8;
        faults += got != six << 5;
        lmb_clear(&m.surface, rgb(0, 0, c));
        got = pixel_of(&m.surface, 4, 5)[0] | pixel_of(&m.surface, 4, 5)[1] << 8;
        faults += got != five;
    }
    test_verdict(!faults, "clear: every value to its nearest level", "%d faults in 768", faults);
}

/* Any window, any pitch, either format: all of the surface and nothing else. */
static void test_clear_bounds(test_random *random)
{
    static memory m;
    int i, spilt = 0, missed = 0, x, y;
    for (i = 0; i < 400; i++) {
        int left = (int)test_integer(random, -50, 1000), top = (int)test_integer(random, -50, 1000);
        lmb_window w = window_of(left, top, left + (int)test_integer(random, 1, 70), top + (int)test_integer(random, 1, 70));
        memory_surface(&m, i & 1, w, i % 3 ? (size_t)test_integer(random, 0, 40) : 0, i & 2);
        lmb_clear(&m.surface, rgb(255, 255, 255));
        spilt += memory_spilt(&m);
        for (y = w.top; y < w.bottom; y++) {
            for (x = w.left; x < w.right; x++) {
                const uint8_t *p = pixel_of(&m.surface, x, y);
                missed += p[0] != 255 || p[1] != 255 || (i & 1 && p[2] != 255);
                if (i & 2) missed += m.surface.depth[(y - w.top) * (w.right - w.left) + (x - w.left)] != 65535;
            }
        }
    }
    test_verdict(!spilt && !missed, "clear: the whole surface, its depth, and nothing else",
                 "%d bytes spilt, %d pixels missed, %d surfaces", spilt, missed, i);
}

/* ---------------------------------------------------------------------------------------------------------------------- depth */

static void flat_span(lmb_span *span, int x, int y, int length, int depth)
{
    memset(span, 0, sizeof *span);
    span->x = (int16_t)x;
    span->y = (int16_t)y;
    span->length = (uint16_t)length;
    span->kind = LMB_SPAN_FLAT;
    span->depth.f = depth * 16384;
}

/* Nearer wins, equal and farther keep what is there, pixel by pixel along a span whose depth runs; what is nearer than nearest counts
 * as that. */
static void test_depth(test_random *random)
{
    static memory m;
    lmb_look look[2];
    lmb_paint paint[2];
    int i, k, faults = 0;
    for (i = 0; i < 20000; i++) {
        lmb_span span;
        int first = (int)test_integer(random, 0, 65534), second = (int)test_integer(random, 0, 65534);
        int rise = (int)test_integer(random, -99, 99);
        if (i % 3 == 0) second = first;
        if (i % 3 == 1) second = first + (int)test_integer(random, -40, 40);
        if (i % 5 == 0) first = (int)test_integer(random, 0, 400), second = (int)test_integer(random, -200, 400);
        if (second + 20 * rise < -1000 || second + 20 * rise > 65534 || second > 65534) continue;
        for (k = 0; k < 2; k++) {
            lmb_material material = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1};
            lmb_light light = {{0, 0, 16384}, {255, 255, 255}};
            material.ambient = k ? rgb(200, 200, 200) : rgb(100, 100, 100);
            if (lmb_look_prepare(&look[k], &material, &light, 1, LMB_MODEL_FLAT, LMB_STEP_LINEAR) != 0) abort();
            lmb_paint_prepare(&paint[k], &look[k], LMB_RGB888);
        }
        memory_surface(&m, LMB_RGB888, window_of(5, 7, 30, 9), 0, true);
        lmb_clear(&m.surface, rgb(1, 1, 1));
        flat_span(&span, 6, 8, 20, first);
        lmb_fill_span(&m.surface, &paint[0], &span);
        flat_span(&span, 6, 8, 20, second);
        span.depth.d = rise * 16384;
        lmb_fill_span(&m.surface, &paint[1], &span);
        for (k = 0; k < 20; k++) {
            int now = second + k * rise, wins = now < first, kept = now < 0 ? 0 : now;
            faults += pixel_of(&m.surface, 6 + k, 8)[0] != (wins ? 200 : 100);
            faults += m.surface.depth[25 + 1 + k] != (wins ? kept : first);
        }
        faults += pixel_of(&m.surface, 5, 8)[0] != 1 || pixel_of(&m.surface, 26, 8)[0] != 1 || m.surface.depth[25] != 65535 ||
                  m.surface.depth[25 + 21] != 65535;
    }
    test_verdict(!faults, "depth: nearer wins, equal keeps the first, cleared is farthest", "%d faults, %d pairs of spans",
                 faults, i);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_layout();
    test_clear_levels();
    test_clear_bounds(&random);
    test_depth(&random);
    return test_end();
}
