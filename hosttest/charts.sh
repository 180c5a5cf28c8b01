#!/bin/sh
# SPDX-License-Identifier: MIT
# Draws every chart of hosttest/charts as SVG and PNG.
# usage: charts.sh DATA_FOLDER FOLDER [NAME...]    (NAME: only these)
set -eu
here=$(dirname "$0")/charts data=$1 out=$2
shift 2
command -v gnuplot >/dev/null || { echo "charts: gnuplot is missing; make deps installs it"; exit 1; }
mkdir -p "$out"
[ $# -gt 0 ] || set -- $(cd "$here" && ls ./*.gp | sed 's/^\.\///; s/\.gp$//; /^style$/d; /^maps/d; /^panels$/d; /^growth$/d')
for name; do
    [ -f "$here/$name.gp" ] || { echo "charts: there is no $name; hosttest/charts/*.gp has them"; exit 1; }
    height=$(sed -n 's/^# height: //p' "$here/$name.gp")
    for type in svg png; do
        if ! gnuplot -c "$here/style.gp" "$here/$name.gp" "$data" "$out/$name.$type" "${height:-500}" 2>"$data/log" || [ -s "$data/log" ]; then
            echo "charts: $name.$type:"
            cat "$data/log"
            exit 1
        fi
    done
    echo "$out/$name.svg"
done
