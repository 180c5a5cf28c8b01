#!/bin/sh
# SPDX-License-Identifier: MIT
# The deepest chains of calls in an image of size_image.sh: see stack.awk. Interrupts are not counted.
# usage: stack.sh chains PREFIX FOLDER TITLE [HEADER...]      a line for each entry point, then a verdict; exit status 1 if it fails
#        stack.sh figure PREFIX FOLDER ENTRY [HEADER...]      the bytes from one entry point alone
#        stack.sh watermark PREFIX FOLDER TITLE COMMAND...    the figure of lmb_draw_mesh against what COMMAND, the run of
#                                                             stack_main.c on a target, has measured
# HEADER: whose functions are entry points; those of the library and the filler if none is named
set -u
mode=$1 prefix=$2 folder=$3 what=$4
shift 4
here=$(dirname "$0")

[ -s "$folder/whole.elf" ] || { echo "FAIL stack $what: $folder/whole.elf is missing"; exit 1; }

# follow TITLE ENTRY HEADER...: stack.awk on the image; ENTRY may be empty.
follow() {
    title=$1 entry=$2
    shift 2
    "${prefix}objdump" -t "$folder/whole.elf" >"$folder/symbols" &&
        "${prefix}objdump" -d --no-show-raw-insn "$folder/whole.elf" >"$folder/code" || return 1
    graphs=$(ls "$folder"/*.ci 2>/dev/null) || graphs=$(ls "$folder"/*.su)
    # A call on AVR pushes the return address, which its compiler counts in frames.
    return_bytes=0 pointer=sp
    case $prefix in avr-) return_bytes=2 ;; xtensa-*) pointer=a1 ;; esac
    # shellcheck disable=SC2086
    awk -v title="$title" -v entry="$entry" -v return_bytes=$return_bytes -v pointer=$pointer -f "$here/stack.awk" \
        "$@" "$folder/symbols" "$folder/code" $graphs
}

if [ "$mode" = watermark ]; then
    predicted=$(follow "$what" lmb_draw_mesh "$here/../port/fill.h")
    "$@" >"$folder/marked" 2>&1 </dev/null
    status=$?
    measured=$(awk '$1 == "deepest" { print $2 + 0 }' "$folder/marked")
    if [ $status != 0 ] || [ -z "$measured" ]; then
        echo "FAIL watermark $what: the image ends with status $status: $(head -c 200 "$folder/marked")"
    elif ! [ "$measured" -le "$predicted" ] 2>/dev/null; then
        echo "FAIL watermark $what: lmb_draw_mesh takes $measured bytes, predicted $predicted"
    elif [ $((measured * 10)) -lt $((predicted * 9)) ]; then
        echo "FAIL watermark $what: lmb_draw_mesh takes $measured bytes, far from the $predicted predicted: one of them is wrong"
    else
        echo "pass watermark $what: lmb_draw_mesh takes $measured bytes, predicted $predicted"
        exit 0
    fi
    exit 1
fi
[ $# != 0 ] || set -- "$here/../firmware/lambent.h" "$here/../port/fill.h"
if [ "$mode" = figure ]; then
    follow "$what" "$what" "$@"
else
    echo "$what: bytes, and the frames they lie in"
    follow "$what" "" "$@"
fi
