#!/bin/sh
# SPDX-License-Identifier: MIT
# A picture of docs/CHOOSING.md: a demo scene by every choice, and under each how far it is from the exact frame, with labels.
# usage: choosing_picture.sh PICTURE_CHOOSING SCENE SCRATCH OUT.png
set -u
program=$1 scene=$2 scratch=$3 out=$4
side=240 band=26
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
[ -s "$font" ] || { echo "choosing_picture: $font is missing; run make deps"; exit 1; }
rm -rf "$scratch" && mkdir -p "$scratch" || exit 1
"$program" "$scene" "$scratch" >"$scratch/tiles" || exit 1

# text Y SIZE COLOUR WORDS: an option of oiiotool, words about the middle of a tile.
text() { printf -- '--text:x=%d:y=%d:size=%d:color=%s:xalign=center:font=%s' $((side / 2)) "$1" "$2" "$3" "$font"; }
white=1,1,1 grey=0.72,0.75,0.8

while IFS='	' read -r name label apart; do
    if [ "$name" = exact ]; then
        middle=$((2 * band + side + side / 2))
        oiiotool "$scratch/$name.ppm" --create ${side}x$((2 * (side + band))) 3 --paste +0+$band \
            "$(text 19 17 $white)" "$label" "$(text $((middle - 40)) 15 $grey)" "evenly turned normals," \
            "$(text $((middle - 18)) 15 $grey)" "cos^n, double precision" "$(text $((middle + 22)) 15 $white)" "Below each picture:" \
            "$(text $((middle + 44)) 15 $white)" "its distance from this," "$(text $((middle + 66)) 15 $white)" "amplified $apart times" -o "$scratch/$name.png" || exit 1
    else
        oiiotool "$scratch/$name-apart.ppm" "$scratch/$name.ppm" --create ${side}x$((2 * (side + band))) 3 --paste +0+$band \
            --paste +0+$((2 * band + side)) "$(text 19 17 $white)" "$label" "$(text $((band + side + 18)) 14 $grey)" \
            "at most $apart" -o "$scratch/$name.png" || exit 1
    fi
done <"$scratch/tiles"

set --
for name in $(cut -f1 "$scratch/tiles"); do set -- "$@" "$scratch/$name.png"; done
oiiotool "$@" --mosaic:pad=6 4x2 --attrib png:compressionLevel 9 -o "$out"
