#!/bin/sh
# SPDX-License-Identifier: MIT
# pareto.csv is whole, its fronts are fronts, and its figures keep to hosttest/pareto/bars.txt. Figures that miss what was asked for are
# said, and must not get worse. Doctored files must fail.
# usage: test_pareto.sh PARETO_CSV
set -u
cd "$(dirname "$0")/.." || exit 2
csv=${1:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
[ -s "$csv" ] || { echo "FAIL pareto: ${csv:-pareto.csv} is missing; make pareto writes it; usage: test_pareto.sh PARETO_CSV"; exit 1; }

# judge FILE: all verdicts on a file.
judge() {
    awk -f hosttest/pareto/judge.awk hosttest/pareto/missing.txt "$1"
    awk -f hosttest/pareto/bars.awk "$1" >"$work/figures" || return
    awk -v quiet="${2:-}" '
        /^#/ || NF < 5 { next }
        FNR == NR { limit[$1 " " $2 " " $3] = $4; held[$1 " " $2 " " $3] = $5; bars++; next }
        {
            key = $1 " " $2 " " $3
            if (!(key in limit)) next
            seen++
            more = $1 == "arcs" # the more the better
            is_met = more ? $4 >= limit[key] : $4 <= limit[key]
            is_held = more ? $4 >= held[key] : $4 <= held[key]
            unit = more ? " times" : " %"
            text = $4 unit " of " limit[key] ":"
            for (i = 5; i <= NF; i++) text = text " " $i
            if (!is_met) { missed++; if (!quiet) print "  missed " key ": " text }
            if (!is_held) worse = worse "; " key ": " text ", and was " held[key]
        }
        END {
            if (worse != "") print "FAIL pareto bars" worse
            else if (seen != bars) print "FAIL pareto bars: " bars - seen " of hosttest/pareto/bars.txt have no figure"
            else print "pass pareto bars: " bars - missed " of " bars " met, " missed + 0 " missed and no worse than they were"
        }' hosttest/pareto/bars.txt "$work/figures"
}
judge "$csv"

# doctored TEXT AWK-PROGRAM: the file, changed, must fail.
doctored() {
    awk -F, -v OFS=, "$2" "$csv" >"$work/doctored.csv"
    if cmp -s "$csv" "$work/doctored.csv"; then
        echo "FAIL pareto doctored: $1: nothing was changed"
    elif judge "$work/doctored.csv" quiet | grep -q '^FAIL'; then
        echo "pass pareto doctored: $1 is noticed"
    else
        echo "FAIL pareto doctored: $1 is not noticed"
    fi
}
doctored "a front with a point too many" '$11 == 0 && !done { $11 = 1; done = 1 } { print }'
doctored "a front with a point too few" 'NR > 1 && $11 == 1 && $2 == "frame" && !done { $11 = 0; done = 1 } { print }'
doctored "a method left out" '!($1 == "m4" && $2 == "span" && $4 == "linear")'
doctored "a scene left out" '!($1 == "rv32imc" && $3 == "torus-rgb888")'
doctored "a row twice" '{ print } NR == 7'
doctored "a figure of another row" 'NR == 9 { $9 += 6 } { print }'
doctored "a planner that takes a tenth more" '$1 == "m0plus" && $4 == "planned" { $5 *= 1.1; } { print }'
doctored "a lobe that rivals dominate" '$2 == "lobe" && $4 ~ /^(tuned|lambent)/ { $7 = 0.3 } { print }'
