#!/bin/sh
# SPDX-License-Identifier: MIT
# Ways along a span, cost beside error, as a table: from arc.csv and kernel_cycles.csv of make report.
# usage: steps_table.sh REPORT_FOLDER
set -eu
report=$1
awk -F, '
    FILENAME ~ /kernel_cycles/ && $2 ~ /^step-/ {
        name = substr($2, 6)
        if (sub(/-setup$/, "", name)) set[$1, name] = $4
        else { pixel[$1, name] = $4; if ($1 == "m0plus") order[++n] = name }
    }
    FILENAME ~ /arc/ { error[$1, $2, $3] = $4 }
    function figure(x) { return x == "" ? "" : sprintf("%.3g", x) }
    function count(x) { return x == "" ? "" : sprintf("%.0f", x) }
    END {
        print "| way | Cortex-M0+: a pixel | set-up | 32 pixels with set-up, each | Cortex-M4: a pixel | error at 5°, 100 px | 15°, 240 | 45°, 100 | 90°, 240 | 90°, 800 |"
        print "|---|---|---|---|---|---|---|---|---|---|"
        for (i = 1; i <= n; i++) {
            s = order[i]; p = pixel["m0plus", s]; u = set["m0plus", s]
            print "| " s " | " count(p) " | " count(u) " | " count(p + u / 32) " | " count(pixel["m4", s]) " | " figure(error[s, 5, 100]) " | " \
                figure(error[s, 15, 240]) " | " figure(error[s, 45, 100]) " | " figure(error[s, 90, 240]) " | " figure(error[s, 90, 800]) " |"
        }
        exit n == 0
    }' "$report/kernel_cycles.csv" "$report/arc.csv" || { echo "steps_table: run make report first" >&2; exit 1; }
