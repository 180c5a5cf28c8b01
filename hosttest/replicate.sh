#!/bin/sh
# SPDX-License-Identifier: MIT
# The tables of docs/REPLICATION.md, from what replicate prints: claims between each paper's marks, and the lobes.
# usage: replicate.sh REPLICATE REPORT_FOLDER [--check]    (--check: compare only, exit status 1 if the page differs)
set -u
replicate=$1 report=$2 mode=${3:-write} page=docs/REPLICATION.md
[ -s "$report/kernel_cycles.csv" ] || { echo "replicate: $report/kernel_cycles.csv is missing; run make replicate"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$page" "$work/page"
status=0
for table in $(sed -n 's/^<!-- \(claims [0-9]*\|lobes\): begin.*/\1/p' "$page" | tr ' ' -); do
    name=$(echo "$table" | tr - ' ')
    {
        echo "<!-- $name: begin (make replicate) -->"
        case $table in
        lobes) "$replicate" --lobes "$report" || exit 1 ;;
        *) "$replicate" --markdown "${table#claims-}" "$report" || exit 1 ;;
        esac
        echo "<!-- $name: end -->"
    } >"$work/block" || exit 1
    awk -v block="$work/block" -v name="$name" '
        index($0, "<!-- " name ": begin") { while ((getline line <block) > 0) print line; skip = 1; next }
        !skip
        index($0, "<!-- " name ": end") { skip = 0 }' "$work/page" >"$work/next"
    if [ "$mode" = --check ]; then
        if cmp -s "$work/page" "$work/next"; then
            echo "pass replication $name: $(grep -c '^| ' "$work/block") lines, as replicate prints them"
        else
            echo "FAIL replication $name: $page is not what replicate prints; run make replicate"
            diff "$work/page" "$work/next"
            status=1
        fi
    fi
    cp "$work/next" "$work/page"
done
[ "$mode" = --check ] || cat "$work/page" >"$page"
exit $status
