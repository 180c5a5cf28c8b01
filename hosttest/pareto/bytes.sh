#!/bin/sh
# SPDX-License-Identifier: MIT
# Bytes of flash of each lobe and of each way along a span: an image of the very objects that are profiled, collected from that kernel
# alone, so with all that it calls and all constants that it reads.
# usage: bytes.sh CORE PREFIX FLAGS FOLDER LIBRARY...    prints core,kernel,bytes
#   FLAGS    what the linker needs for the core
#   FOLDER   objects, built for the profiler: all of hosttest/compare
#   LIBRARY  what they may call: archives and objects
set -eu
cd "$(dirname "$0")/../.."
core=$1 prefix=$2 flags=$3 folder=$4
shift 4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"${prefix}nm" "$folder"/*.o | awk 'NF == 3 && $2 == "T" { print $3 }' >"$work/defined"

# flash SYMBOL...: bytes of what the linker keeps for them.
flash() {
    keep="-Wl,-e,$1"
    for s; do keep="$keep -Wl,-u,$s"; done
    # shellcheck disable=SC2086
    "${prefix}gcc" $flags -nostartfiles -nostdlib -Wl,--gc-sections $keep -T hosttest/size.ld "$folder"/*.o $libraries -lgcc \
        -o "$work/image" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
    "${prefix}size" -A "$work/image" | awk '$1 ~ /^\.(text|flash|rodata|data)$/ { n += $2 } END { print n + 0 }'
}

{
    sed -n 's/^ *{"\(lobe-[a-z0-9_-]*\)", [a-z]*, [a-z0-9_]*, \(compare_[a-z0-9_]*\)},$/\1 \2/p' hosttest/compare/lobes.c
    sed -n 's/^ *{"\([a-z0-9_]*\)", "[a-z0-9_]*", [0-9]*, \(compare_[a-z0-9_]*\), \(compare_[a-z0-9_]*\)},$/step-\1 \2 \3/p' \
        hosttest/compare/steps.c
} >"$work/kernels"
[ "$(wc -l <"$work/kernels")" -gt 30 ] || { echo "bytes: the tables of kernels cannot be read" >&2; exit 1; }
libraries=$*
while read -r name first second; do
    grep -qx "$first" "$work/defined" || continue
    # shellcheck disable=SC2086
    bytes=$(flash $first $second) || exit 1
    echo "$core,$name,$bytes"
done <"$work/kernels"
