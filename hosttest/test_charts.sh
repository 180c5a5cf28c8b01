#!/bin/sh
# SPDX-License-Identifier: MIT
# The charts in docs/charts are what make charts draws, and the documents show each of them.
# usage: test_charts.sh CHART_DATA FOLDER    (FOLDER: scratch, beside the report's)
set -u
chart_data=$1 work=$2
cd "$(dirname "$0")/.." || exit 2
mkdir -p "$work/drawn"
if ! "$chart_data" "$work" >"$work/log" 2>&1 || ! hosttest/charts.sh "$work" "$work/drawn" >"$work/log" 2>&1; then
    echo "FAIL charts: $(tail -n 1 "$work/log")"
    exit 1
fi
for drawn in "$work"/drawn/*.svg; do
    name=$(basename "$drawn" .svg)
    if ! cmp -s "$drawn" "docs/charts/$name.svg"; then
        echo "FAIL chart $name: docs/charts/$name.svg is not what is drawn; run make charts"
    elif [ ! -s "docs/charts/$name.png" ]; then
        echo "FAIL chart $name: docs/charts/$name.png is missing; run make charts"
    elif ! grep -q "charts/$name\.\(svg\|png\)" README.md docs/*.md; then
        echo "FAIL chart $name: no document shows it"
    else
        echo "pass chart $name: drawn anew, identical"
    fi
done
