#!/bin/sh
# SPDX-License-Identifier: MIT
# docs/CHOOSING.md: its pictures are what is drawn, its code compiles, and choosing.sh refuses figures that it does not have.
# usage: test_choosing.sh BUILD_FOLDER CC
set -u
build=$1 cc=$2
cd "$(dirname "$0")/.." || exit 2
page=docs/CHOOSING.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
verdict() { if [ "$1" = 0 ]; then echo "pass $2"; else echo "FAIL $2"; [ -s "$work/log" ] && tail -n 5 "$work/log"; status=1; fi; }

pictures=0
for picture in docs/pictures/choosing-*.png; do
    name=$(basename "$picture" .png)
    hosttest/choosing_picture.sh "$build/bin/picture_choosing" "${name#choosing-}" "$work/$name" "$work/$name.png" >"$work/log" 2>&1 &&
        oiiotool "$picture" "$work/$name.png" --fail 0 --diff >>"$work/log" 2>&1
    verdict $? "picture $name: as it is drawn; if not, run make choosing"
    grep -q "pictures/$name.png" "$page"
    verdict $? "picture $name: $page shows it"
    pictures=$((pictures + 1))
done
[ "$pictures" -ge 2 ]
verdict $? "pictures: $pictures"
# The comparison sees a single pixel.
oiiotool "$work/$name.png" --fill:color=1,0,1 1x1+300+300 -o "$work/wrong.png" >"$work/log" 2>&1
! oiiotool "$work/$name.png" "$work/wrong.png" --fail 0 --diff >"$work/log" 2>&1
verdict $? "pictures: one wrong pixel is found"

# Each block of code as the body of a function.
awk '/^```c$/ { printf "void example_%d(void);\nvoid example_%d(void)\n{\n", ++n, n; on = 1; next } /^```$/ { if (on) print "}"; on = 0 } on' \
    "$page" >"$work/blocks"
{
    echo '#include "port/fill.h"'
    echo 'extern lmb_look look; extern lmb_material material; extern lmb_light light; extern lmb_paint paint;'
    echo 'extern lmb_surface surface; extern lmb_pose pose; extern lmb_camera camera; extern const lmb_mesh mesh_teapot;'
    cat "$work/blocks"
} >"$work/example.c"
blocks=$(grep -c 'void example_[0-9]*(void);' "$work/blocks")
$cc -std=c99 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -Ifirmware -I. -c "$work/example.c" -o "$work/example.o" >"$work/log" 2>&1 &&
    [ "$blocks" -ge 2 ]
verdict $? "$page: $blocks blocks of code compile without a warning"

# A report without a figure is refused, and the page stays as it is.
mkdir "$work/report"
for f in cycles size kernel_cycles lobe image plan; do echo core,scene >"$work/report/$f.csv"; done
cp "$page" "$work/before"
! hosttest/choosing.sh "$work/report" >"$work/log" 2>&1 && grep -q "figures are missing" "$work/log" && cmp -s "$page" "$work/before"
verdict $? "choosing: refuses a report without figures"
rm "$work/report/plan.csv"
! hosttest/choosing.sh "$work/report" >"$work/log" 2>&1 && grep -q "plan.csv is missing; run make choosing" "$work/log" && cmp -s "$page" "$work/before"
verdict $? "choosing: refuses a report without a file"
lines=$(wc -l <"$page")
[ "$lines" -le 160 ]
verdict $? "$page: $lines lines, at most 160"
exit $status
