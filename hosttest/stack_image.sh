#!/bin/sh
# SPDX-License-Identifier: MIT
# Links stack_main.c with the objects that size_image.sh has left in FOLDER, those that stack.sh follows, into FOLDER/marked.elf:
# an image that runs on the target and prints how deep its stack went.
# usage: stack_image.sh FOLDER PREFIX FLAGS LINK FILE...
#   LINK  what links an image for the target's board;  FILE  sources: the board's, and the mesh
set -u
cd "$(dirname "$0")/.." || exit 2
folder=$1 cc=${2}gcc flags=$3 link=$4
shift 4

objects=
for f in firmware/*.c port/*.c; do objects="$objects $folder/$(basename "$f" .c).o"; done
rm -rf "$folder/board"
mkdir -p "$folder/board" || exit 1
for f in hosttest/stack_main.c "$@"; do
    # shellcheck disable=SC2046,SC2086
    $cc -std=c99 $flags -ffreestanding -ffunction-sections -fdata-sections -fno-tree-loop-distribute-patterns -fno-strict-aliasing \
        -Ifirmware -Os $(cat "$folder/defines") -c "$f" -o "$folder/board/$(basename "$f").o" || exit 1
done
# shellcheck disable=SC2086
$cc $flags "$folder"/board/*.o $objects -o "$folder/marked.elf" $link -lgcc
