#!/bin/sh
# SPDX-License-Identifier: MIT
# The tables of docs/REPLICATION.md, between their marks: claims of each paper, lobes, ways along a span, stability.
# usage: replicate.sh PROGRAMS REPORT_FOLDER [--check]    (PROGRAMS: where replicate and stability are; --check: compare only, exit
# status 1 if the page differs)
set -u
programs=$1 report=$2 mode=${3:-write} page=docs/REPLICATION.md
for f in kernel_cycles arc; do
    [ -s "$report/$f.csv" ] || { echo "replicate: $report/$f.csv is missing; run make replicate"; exit 1; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$page" "$work/page"
status=0
for table in $(sed -n 's/^<!-- \(claims [0-9]*\|lobes\|steps\|stability\): begin.*/\1/p' "$page" | tr ' ' -); do
    name=$(echo "$table" | tr - ' ')
    {
        echo "<!-- $name: begin (make replicate) -->"
        case $table in
        lobes) "$programs/replicate" --lobes "$report" || exit 1 ;;
        steps) hosttest/steps_table.sh "$report" || exit 1 ;;
        stability) "$programs/stability" --markdown 2>"$work/progress" || exit 1 ;;
        *) "$programs/replicate" --markdown "${table#claims-}" "$report" || exit 1 ;;
        esac
        echo "<!-- $name: end -->"
    } >"$work/block" || exit 1
    awk -v block="$work/block" -v name="$name" -f hosttest/block.awk "$work/page" >"$work/next"
    if [ "$mode" = --check ]; then
        if cmp -s "$work/page" "$work/next"; then
            echo "pass replication $name: $(grep -c '^| ' "$work/block") lines, as the commands print them"
        else
            echo "FAIL replication $name: $page is not what the commands print; run make replicate"
            diff "$work/page" "$work/next"
            status=1
        fi
    fi
    cp "$work/next" "$work/page"
done
[ "$mode" = --check ] || cat "$work/page" >"$page"
exit $status
