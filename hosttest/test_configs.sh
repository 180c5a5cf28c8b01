#!/bin/sh
# SPDX-License-Identifier: MIT
# Every part that can be left out: the rest compiles without a warning, draws the same frame, and refuses what is not there.
# usage: test_configs.sh BUILD_FOLDER CC    (BUILD_FOLDER holds meshes/icosphere_320.c)
set -u
build=$1 cc=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
flags="-std=c99 -O1 -Wall -Wextra -Wpedantic -Wshadow -Wundef -Wconversion -Wmissing-prototypes -Werror -Ifirmware -I."

cat >"$work/main.c" <<'END'
/* Draws an icosphere in gloss over what format there is, without depth, and writes the levels of its pixels. */
#include <stdio.h>
#include "port/fill.h"
#ifndef MODEL
#define MODEL LMB_MODEL_GLOSS
#endif
#ifndef STEP
#define STEP LMB_STEP_QUADRATIC
#endif
extern const lmb_mesh mesh_icosphere_320;
static uint16_t frame[240 * 240 * 3 / 2];
int main(int argc, char **argv)
{
    static const lmb_material material = {{10, 20, 30}, {40, 120, 170}, {128, 128, 128}, 40};
    static const lmb_light light = {{6700, 9200, 11800}, {255, 255, 255}};
    static const lmb_rgb night = {18, 20, 26};
    const enum lmb_format format = argc > 1 && argv[1][0] == '8' ? LMB_RGB888 : LMB_RGB565;
    lmb_pose pose = {lmb_rotation(3000, 5000, 0), 0, 0, -4 * 65536L};
    lmb_camera camera;
    lmb_surface surface;
    lmb_look look;
    static lmb_paint paint;
    if (!LMB_WITH_ARC && lmb_look_prepare(&look, &material, &light, 1, LMB_MODEL_GLOSS, LMB_STEP_ARC) != LMB_ERROR_VALUE) return 1;
    if (!LMB_WITH_PLANS && lmb_look_prepare(&look, &material, &light, 1, LMB_MODEL_GLOSS, LMB_STEP_PLANNED) != LMB_ERROR_VALUE) return 8;
    if (!LMB_WITH_DIFFUSE && lmb_look_prepare(&look, &material, &light, 1, LMB_MODEL_DIFFUSE, LMB_STEP_LINEAR) != LMB_ERROR_VALUE) return 9;
    if (!LMB_WITH_GOURAUD && lmb_look_prepare(&look, &material, &light, 1, LMB_MODEL_GOURAUD, LMB_STEP_LINEAR) != LMB_ERROR_VALUE) return 10;
    if (!LMB_WITH_GLOSS && lmb_look_prepare(&look, &material, &light, 1, LMB_MODEL_GLOSS, LMB_STEP_LINEAR) != LMB_ERROR_VALUE) return 11;
    if (!LMB_WITH_QUADRATIC && lmb_look_prepare(&look, &material, &light, 1, MODEL, LMB_STEP_QUADRATIC) != LMB_ERROR_VALUE) return 12;
    if (!LMB_WITH_CORNERS && lmb_look_prepare(&look, &material, &light, 1, LMB_MODEL_FLAT, LMB_STEP_LINEAR) != LMB_ERROR_VALUE) return 2;
    if (!LMB_WITH_PERSPECTIVE && lmb_camera_perspective(&camera, 240, 240, 240 * 65536L, 65536L, 8 * 65536L) != LMB_ERROR_VALUE) return 3;
    if (lmb_camera_orthographic(&camera, 240, 240, 110 * 65536L, 65536L, 8 * 65536L)) return 4;
    if (lmb_look_prepare(&look, &material, &light, 1, MODEL, STEP)) return 5;
    lmb_paint_prepare(&paint, &look, format);
    lmb_surface_strip(&surface, format, frame, NULL, 240, 0, 240);
    lmb_clear(&surface, night);
    if (lmb_draw_mesh(&surface, &mesh_icosphere_320, &pose, &camera, &paint, NULL, NULL) < 150) return 6;
    return fwrite(frame, 240 * 240 * lmb_format_bytes(format), 1, stdout) == 1 ? 0 : 7;
}
END

# draw NAME FORMAT DEFINE...
draw() {
    name=$1 format=$2
    shift 2
    # shellcheck disable=SC2086
    $cc $flags "$@" "$work/main.c" "$build/meshes/icosphere_320.c" firmware/*.c port/*.c -o "$work/draw" >"$work/log" 2>&1 ||
        { head -n 5 "$work/log"; return 1; }
    "$work/draw" "$format" >"$work/$name" || { echo "exit status $?"; return 1; }
}

draw full565 5 && draw full888 8 || { echo "FAIL configurations: the full one does not draw"; exit 1; }
for left_out in ARC PLANS DIFFUSE CORNERS GOURAUD PERSPECTIVE DEPTH LARGE LOBES RAMPS RGB888 RGB565; do
    format=5 full=full565
    [ $left_out = RGB565 ] && format=8 full=full888
    if why=$(draw lean $format "-DLMB_WITH_$left_out=0") && cmp -s "$work/lean" "$work/$full"; then
        echo "pass configurations: without LMB_WITH_$left_out the same frame"
    else
        echo "FAIL configurations: without LMB_WITH_$left_out: ${why:-another frame}"
        status=1
    fi
done
# What a model does not need may go, and what is left draws as before.
# alike NAME DRAWN DEFINE...: the frame of DRAWN, without and with DEFINE
alike() {
    what=$1 drawn=$2
    shift 2
    # shellcheck disable=SC2086
    if why=$(draw with 5 $drawn && draw lean 5 $drawn "$@") && cmp -s "$work/lean" "$work/with"; then
        echo "pass configurations: $what alone draws as it does among all"
    else
        echo "FAIL configurations: $what alone: ${why:-another frame}"
        status=1
    fi
}
alike flat "-DMODEL=LMB_MODEL_FLAT -DSTEP=LMB_STEP_LINEAR" -DLMB_WITH_DIFFUSE=0 -DLMB_WITH_GLOSS=0 -DLMB_WITH_GOURAUD=0
alike Gouraud "-DMODEL=LMB_MODEL_GOURAUD -DSTEP=LMB_STEP_LINEAR" -DLMB_WITH_DIFFUSE=0 -DLMB_WITH_GLOSS=0 -DLMB_WITH_QUADRATIC=0
alike diffuse "-DMODEL=LMB_MODEL_DIFFUSE" -DLMB_WITH_GLOSS=0 -DLMB_WITH_CORNERS=0
alike "linear gloss" -DSTEP=LMB_STEP_LINEAR -DLMB_WITH_QUADRATIC=0 -DLMB_WITH_DIFFUSE=0
alike "planned gloss" -DSTEP=LMB_STEP_PLANNED -DLMB_WITH_DIFFUSE=0 -DLMB_WITH_CORNERS=0
all="-DLMB_LIGHTS=1 -DLMB_WITH_ARC=0 -DLMB_WITH_CORNERS=0 -DLMB_WITH_PERSPECTIVE=0 -DLMB_WITH_DEPTH=0 -DLMB_WITH_LARGE=0
    -DLMB_WITH_LOBES=0 -DLMB_WITH_PLANS=0 -DLMB_WITH_DIFFUSE=0 -DLMB_WITH_RGB888=0"
# shellcheck disable=SC2086
if why=$(draw leanest 5 $all) && cmp -s "$work/leanest" "$work/full565"; then
    echo "pass configurations: the leanest, whose flash is measured, draws the same frame"
else
    echo "FAIL configurations: the leanest: ${why:-another frame}"
    status=1
fi
# shellcheck disable=SC2086
if why=$(draw leanest 5 $all -DLMB_WITH_RAMPS=0) && cmp -s "$work/leanest" "$work/full565"; then
    echo "pass configurations: the leanest without ramps draws the same frame"
else
    echo "FAIL configurations: the leanest without ramps: ${why:-another frame}"
    status=1
fi
printf '#define LMB_LIGHTS 2\n#define LMB_WITH_ARC 0\n' >"$work/my_config.h"
if why=$(draw config 5 "-DLMB_CONFIG=\"$work/my_config.h\"") && cmp -s "$work/config" "$work/full565"; then
    echo "pass configurations: LMB_CONFIG names a header"
else
    echo "FAIL configurations: LMB_CONFIG: ${why:-another frame}"
    status=1
fi
exit $status
