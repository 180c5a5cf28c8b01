#!/bin/sh
# SPDX-License-Identifier: MIT
# The block and the memory map that docs/PORTING.md shows are those of a board that works.
# usage: test_porting.sh BUILD_FOLDER
set -u
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

# excerpt LANGUAGE: the block of that language.
excerpt() { awk -v start="\`\`\`$1" '$0 == start { inside = 1; next } /^```/ { inside = 0 } inside' docs/PORTING.md; }

excerpt ld >"$work/mine.ld"
excerpt make | sed "s|linker/mine.ld|$work/mine.ld|" >"$work/mine.mk"
if ! grep -q MEMORY "$work/mine.ld" || ! grep -q '^TARGETS += mine' "$work/mine.mk"; then
    echo "FAIL porting: docs/PORTING.md shows no block or no memory map"
    exit 1
fi
for what in boards frames gate; do
    ${MAKE:-make} -s B="$build" MORE="$work/mine.mk" TARGET=mine "$what" >"$work/log" 2>&1 || status=1
    grep -E '^(pass|FAIL) ' "$work/log" || { echo "FAIL porting: make $what: $(tail -n 1 "$work/log")"; status=1; }
done
exit $status
