/* SPDX-License-Identifier: MIT */
/* Draws the demo scenes on a board, strip by strip in the memory it can spare, and writes each frame to a file of raw RGB565.
 * Prints one line a scene: its name, bytes and CRC-32, so that what arrived can be told from what was drawn. */
#include "../board.h"
#include "scenes.h"

/* Bytes of RAM for a strip of pixels and, behind it, their depth. */
#ifndef LMB_STRIP_BYTES
#define LMB_STRIP_BYTES 16384
#endif

static uint16_t strip[LMB_STRIP_BYTES / 2];
static scene shown;

/* The CRC-32 of Ethernet, zip and PNG, four bits at a time: 64 bytes of table. Starts and ends inverted. */
static uint32_t crc32(uint32_t crc, const uint8_t *bytes, size_t n)
{
    static const uint32_t table[16] = {0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4,
                                       0x4db26158, 0x5005713c, 0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c,
                                       0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c};
    while (n-- > 0) {
        crc ^= *bytes++;
        crc = crc >> 4 ^ table[crc & 15];
        crc = crc >> 4 ^ table[crc & 15];
    }
    return crc;
}

/* Prints a number by subtraction: boards without a divider have no business with one here. */
static void print_decimal(uint32_t value)
{
    static const uint32_t powers[] = {1000000000, 100000000, 10000000, 1000000, 100000, 10000, 1000, 100, 10, 1};
    char text[11];
    size_t n = 0, i;
    for (i = 0; i < sizeof powers / sizeof powers[0]; i++) {
        char digit = '0';
        for (; value >= powers[i]; value -= powers[i]) digit++;
        if (n > 0 || digit != '0' || powers[i] == 1) text[n++] = digit;
    }
    text[n] = '\0';
    lmb_board_print(text);
}

static void print_hex(uint32_t value)
{
    char text[9];
    unsigned i;
    for (i = 0; i < 8; i++, value <<= 4) text[i] = "0123456789abcdef"[value >> 28];
    text[8] = '\0';
    lmb_board_print(text);
}

/* name.565 in room for 32 characters. */
static const char *file_name(const char *name)
{
    static char text[32];
    const char *suffix = ".565";
    size_t n = 0;
    while (*name && n < sizeof text - 5) text[n++] = *name++;
    while (*suffix) text[n++] = *suffix++;
    text[n] = '\0';
    return text;
}

/* As many rows of a scene as a strip has room for: pixels, and depth where the scene needs it. */
static int rows_in_strip(const scene *s)
{
    uint32_t row = (uint32_t)s->width * (s->depth ? 4 : 2), used = row;
    int rows = 0;
    for (; used <= LMB_STRIP_BYTES && rows < s->height; used += row) rows++;
    return rows;
}

/* Draws and writes one scene. Returns 0, or what failed. */
static const char *show(const scene *s)
{
    lmb_surface surface;
    uint32_t crc = 0xffffffff, bytes = 0;
    int rows = rows_in_strip(s), top, bottom;
    if (rows == 0) return "a strip holds no row of it";
    if (lmb_board_open(file_name(s->name))) return "cannot open its file";
    for (top = 0; top < s->height; top = bottom) {
        size_t pixels;
        bottom = s->height - top < rows ? s->height : top + rows;
        pixels = (size_t)(bottom - top) * (size_t)s->width;
        lmb_surface_strip(&surface, LMB_RGB565, strip, s->depth ? strip + pixels : NULL, s->width, top, bottom);
        scene_draw(s, &surface, LMB_MODEL_GLOSS, s->step);
        if (lmb_board_write(strip, pixels * 2)) return "cannot write its file";
        crc = crc32(crc, (const uint8_t *)strip, pixels * 2);
        bytes += (uint32_t)pixels * 2;
    }
    if (lmb_board_close()) return "cannot close its file";
    print_decimal(bytes);
    lmb_board_print(" bytes, crc32 ");
    print_hex(~crc);
    return NULL;
}

int main(void)
{
    unsigned i;
    int status = 0;
    lmb_board_begin();
    for (i = 0; i < scene_count(); i++) {
        const char *fault;
        scene_make(&shown, i);
        lmb_board_print(shown.name);
        lmb_board_print(": ");
        fault = show(&shown);
        if (fault) {
            lmb_board_print(fault);
            status = 1;
        }
        lmb_board_print("\n");
    }
    return status;
}
