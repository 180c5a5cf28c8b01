#!/bin/sh
# SPDX-License-Identifier: MIT
# Compiles the library as a configuration wants it and links it twice: size.elf with the sections that drawing needs, for size.sh,
# and whole.elf with all of them, for stack.sh. Leaves the objects, and beside them what the compiler says of frames and calls
# (.ci, or .su where it knows no .ci).
# usage: size_image.sh FOLDER PREFIX FLAGS [FILE...]
#   FOLDER  its last part is configuration and optimisation: gloss-Os. Configurations: empty; flat, gouraud, diffuse, gloss, each with
#           what it needs on RGB565; arc, planned, rgb888: gloss by other steps, or on RGB888; everything, and everything without one
#           part: without-ARC; and what lmb-estimate adds up, vertices projected once and large triangles exact: draw+flat, +gouraud,
#           +diffuse, +gloss, +arc, +planned; gloss with one part more: draw+gloss+depth, +perspective, +rgb888, +lights, +painter
#   FLAGS   what compiler and linker need for the core
#   FILE    more sources: helpers that the compiler calls and its libgcc lacks
set -u
cd "$(dirname "$0")/.." || exit 2
folder=$1 cc=${2}gcc flags=$3
shift 3
root=$(pwd)
name=$(basename "$folder")
configuration=${name%-*} optimisation=${name##*-}

command -v "$cc" >/dev/null 2>&1 || { echo "size: $cc is missing; run make deps"; exit 1; }

# From mesh to the pixels of one format with one light, and nothing that this does not need.
lean="-DLMB_LIGHTS=1 -DLMB_WITH_ARC=0 -DLMB_WITH_PERSPECTIVE=0 -DLMB_WITH_DEPTH=0 -DLMB_WITH_LARGE=0 -DLMB_WITH_LOBES=0 -DLMB_WITH_PLANS=0
    -DLMB_WITH_RGB888=0"
# lean_but PART...: the same with some parts.
lean_but() {
    kept=$lean
    for part in "$@"; do kept=$(echo "$kept" | sed "s/-DLMB_WITH_$part=0//"); done
    echo "$kept"
}
drawn() { echo "-DSIZE_MODEL=$1 -DSIZE_STEP=LMB_STEP_$2 -DSIZE_FORMAT=LMB_RGB565"; }
case $configuration in
empty) defines=-DSIZE_EMPTY ;;
flat) defines="$lean -DLMB_WITH_DIFFUSE=0 -DLMB_WITH_GLOSS=0 -DLMB_WITH_GOURAUD=0 $(drawn LMB_MODEL_FLAT LINEAR)" ;;
gouraud) defines="$lean -DLMB_WITH_DIFFUSE=0 -DLMB_WITH_GLOSS=0 $(drawn LMB_MODEL_GOURAUD LINEAR)" ;;
diffuse) defines="$lean -DLMB_WITH_CORNERS=0 -DLMB_WITH_GLOSS=0 $(drawn LMB_MODEL_DIFFUSE QUADRATIC)" ;;
gloss) defines="$lean -DLMB_WITH_CORNERS=0 $(drawn LMB_MODEL_GLOSS QUADRATIC)" ;;
arc) defines="$(lean_but ARC) -DLMB_WITH_CORNERS=0 -DLMB_WITH_DIFFUSE=0 -DLMB_WITH_QUADRATIC=0 $(drawn LMB_MODEL_GLOSS ARC)" ;;
planned) defines="$(lean_but ARC PLANS) -DLMB_WITH_CORNERS=0 -DLMB_WITH_DIFFUSE=0 $(drawn LMB_MODEL_GLOSS PLANNED)" ;;
rgb888) defines="$(lean_but LOBES RGB888) -DLMB_WITH_CORNERS=0 -DLMB_WITH_RGB565=0
    -DSIZE_MODEL=LMB_MODEL_GLOSS -DSIZE_STEP=LMB_STEP_QUADRATIC -DSIZE_FORMAT=LMB_RGB888" ;;
everything) defines=-DSIZE_EVERYTHING ;;
without-LIGHTS) defines="-DSIZE_EVERYTHING -DLMB_LIGHTS=1" ;;
without-*) defines="-DSIZE_EVERYTHING -DLMB_WITH_${configuration#without-}=0" ;;
draw+*)
    exact=$(echo "$lean" | sed 's/-DLMB_WITH_LARGE=0//')
    defines="$exact -DLMB_WITH_CORNERS=0 -DSIZE_PROJECT $(drawn LMB_MODEL_GLOSS QUADRATIC)"
    case $configuration in
    draw+flat) defines="$exact -DLMB_WITH_DIFFUSE=0 -DLMB_WITH_GLOSS=0 -DLMB_WITH_GOURAUD=0 -DSIZE_PROJECT $(drawn LMB_MODEL_FLAT LINEAR)" ;;
    draw+gouraud) defines="$exact -DLMB_WITH_DIFFUSE=0 -DLMB_WITH_GLOSS=0 -DSIZE_PROJECT $(drawn LMB_MODEL_GOURAUD LINEAR)" ;;
    draw+diffuse) defines="$(echo "$defines" | sed s/MODEL_GLOSS/MODEL_DIFFUSE/) -DLMB_WITH_GLOSS=0" ;;
    draw+gloss) ;;
    draw+arc) defines=$(echo "$defines" | sed 's/-DLMB_WITH_ARC=0//; s/STEP_QUADRATIC/STEP_ARC/') ;;
    draw+planned) defines=$(echo "$defines" | sed 's/-DLMB_WITH_ARC=0//; s/-DLMB_WITH_PLANS=0//; s/STEP_QUADRATIC/STEP_PLANNED/') ;;
    draw+gloss+depth) defines=$(echo "$defines" | sed 's/-DLMB_WITH_DEPTH=0//') ;;
    draw+gloss+perspective) defines=$(echo "$defines" | sed 's/-DLMB_WITH_PERSPECTIVE=0/-DSIZE_PERSPECTIVE/') ;;
    draw+gloss+rgb888) defines=$(echo "$defines" | sed 's/RGB888=0/RGB565=0/; s/-DLMB_WITH_LOBES=0//; s/=LMB_RGB565/=LMB_RGB888/') ;;
    draw+gloss+lights) defines=$(echo "$defines" | sed 's/-DLMB_LIGHTS=1//; s/-DLMB_WITH_LOBES=0//') ;;
    draw+gloss+painter) defines="$defines -DSIZE_SORT" ;;
    *) echo "size: no configuration $configuration"; exit 2 ;;
    esac
    ;;
*) echo "size: no configuration $configuration"; exit 2 ;;
esac

# Frames and calls: a graph where the compiler can draw it; otherwise frames alone, and calls are read from the image.
frames=-fstack-usage
$cc -fcallgraph-info=su -E -x c /dev/null >/dev/null 2>&1 && frames=-fcallgraph-info=su

more=
for f in "$@"; do more="$more $root/$f"; done
rm -rf "$folder"
mkdir -p "$folder" && cd "$folder" || exit 1
# shellcheck disable=SC2086
set -- "$root"/hosttest/size_main.c "$root"/firmware/*.c "$root"/port/*.c $more
twice=$(basename -a "$@" | sort | uniq -d)
[ -z "$twice" ] || { echo "size: two files are named $twice"; exit 1; }
echo "$defines" >defines
# shellcheck disable=SC2086
$cc -std=c99 $flags -ffreestanding -ffunction-sections -fdata-sections -I"$root/firmware" \
    "-$optimisation" $defines $frames -c "$@" >log 2>&1 || { cat log; exit 1; }
for image in size whole; do
    collect=
    [ $image = size ] && collect=-Wl,--gc-sections
    # shellcheck disable=SC2086
    $cc $flags -nostartfiles -nostdlib $collect -Wl,-e,main \
        -T "$root/hosttest/size.ld" ./*.o -lgcc -o $image.elf >log 2>&1 || { cat log; exit 1; }
done
