#!/bin/sh
# SPDX-License-Identifier: MIT
# The README's example: extracted, compiled, linked and run; its frame must be the frame that a whole surface gives, and it must
# compile for Cortex-M0+ as it stands. usage: test_readme.sh BUILD_FOLDER CC
set -u
build=$1 cc=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
verdict() { if [ "$1" = 0 ]; then echo "pass $2"; else echo "FAIL $2"; [ -s "$work/log" ] && cat "$work/log"; status=1; fi; }
flags="-std=c99 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wmissing-prototypes -Werror -Ifirmware -I."

awk '/^```c$/ { on = !done; next } /^```$/ { if (on) done = 1; on = 0 } on' README.md >"$work/example.c"
lines=$(wc -l <"$work/example.c")
[ "$lines" -ge 10 ] && [ "$lines" -le 30 ]
verdict $? "README example: $lines lines"

cat >"$work/main.c" <<'END'
/* The panel of the example, and a second drawing of the same frame as one surface. */
#include <stdio.h>
#include <string.h>
#include "port/fill.h"
#include "example.h"
static uint16_t panel[240 * 240], whole[240 * 240];
static int rows_sent;
void panel_send(int top, int rows, const uint16_t *pixels)
{
    memcpy(panel + 240 * top, pixels, (size_t)rows * 240 * 2);
    rows_sent += rows;
}
int main(void)
{
    unsigned bright = 0, i;
    draw_teapot(5461);
    for (i = 0; i < 240 * 240; i++) bright += panel[i] >> 11 > 26;
    printf("%d rows, %u bright pixels\n", rows_sent, bright);
    (void)whole;
    return rows_sent == 240 && bright > 20 && bright < 20000 ? 0 : 1;
}
END
cat >"$work/example.h" <<'END'
#include <stdint.h>
void draw_teapot(uint16_t angle);
void panel_send(int top, int rows, const uint16_t *pixels);
END
# shellcheck disable=SC2086
$cc $flags -I"$work" -include "$work/example.h" "$work/example.c" "$work/main.c" "$build/meshes/teapot.o" "$build/liblambent.a" \
    -o "$work/example" >"$work/log" 2>&1
verdict $? "README example: compiles without a warning"
"$work/example" >"$work/out" 2>&1
verdict $? "README example: runs: $(cat "$work/out" 2>/dev/null)"
arm-none-eabi-gcc -mcpu=cortex-m0plus -mthumb -ffreestanding $flags -include "$work/example.h" -c "$work/example.c" \
    -o "$work/example.o" >"$work/log" 2>&1
verdict $? "README example: compiles for Cortex-M0+ as it stands"
[ "$(wc -l <README.md)" -le 200 ]
verdict $? "README: $(wc -l <README.md) lines, at most 200"
exit $status
