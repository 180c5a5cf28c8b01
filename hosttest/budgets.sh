#!/bin/sh
# SPDX-License-Identifier: MIT
# Every line of the budgets against its figure: prints figure, budget and headroom, and fails past a budget. A figure that is missing,
# or is no number, fails too. usage: budgets.sh REPORT_FOLDER BUDGETS
set -u
report=$1 budgets=$2
[ -s "$budgets" ] || { echo "FAIL budget: $budgets is missing"; exit 1; }
tables="" missing=0
for f in size cycles kernel_cycles; do
    if [ -s "$report/$f.csv" ]; then
        tables="$tables $report/$f.csv"
    else
        echo "FAIL budget: $report/$f.csv is missing; run make report"
        missing=1
    fi
done

# shellcheck disable=SC2086
awk -v missing=$missing '
    BEGIN { FS = "[ \t]+" }

    # A table: its first line names the columns.
    FILENAME ~ /\.csv$/ {
        n = split($0, cell, ",")
        if (FNR == 1) {
            split("", column)
            for (i = 1; i <= n; i++) column[cell[i]] = i
        } else if (FILENAME ~ /size\.csv$/) {
            where = cell[column["core"]] " " cell[column["configuration"]]
            take(where " code", "text")
            take(where " tables", "rodata")
            take(where " stack", "stack")
            sum(where " flash", "text", "rodata", "data")
            sum(where " ram", "data", "bss")
        } else if (FILENAME ~ /kernel_cycles\.csv$/) {
            where = cell[column["core"]] " " cell[column["kernel"]]
            take(where " instructions", "instructions")
            take(where " cycles", "cycles")
        } else {
            if (cell[column["format"]] != "rgb565") next
            where = cell[column["core"]] " " cell[column["scene"]] " " cell[column["model"]]
            take(where " instructions_per_pixel", "instructions_per_pixel")
            take(where " cycles_per_pixel", "cycles_per_pixel")
        }
        next
    }

    function number(text) { return text ~ /^-?[0-9]+(\.[0-9]+)?$/ }
    function take(what, name) {
        if (!(name in column)) return
        if (what in figure && figure[what] != cell[column[name]]) figure[what] = "two of them"
        else figure[what] = cell[column[name]]
    }
    function sum(what, a, b, c) {
        if (!number(cell[column[a]]) || !number(cell[column[b]]) || c != "" && !number(cell[column[c]])) figure[what] = "no number"
        else figure[what] = cell[column[a]] + cell[column[b]] + (c == "" ? 0 : cell[column[c]])
    }

    # A budget: words that name a figure, then a number. What follows a # is for the reader.
    {
        sub(/[ \t]*#.*/, "")
        sub(/^[ \t]+/, "")
        if ($0 == "") next
        budget = $NF
        what = $0
        sub(/[ \t]+[^ \t]+$/, "", what)
        gsub(/[ \t]+/, " ", what)
        lines++
        if (!number(budget)) verdict(1, what ": the budget is no number: " budget)
        else if (!(what in figure) || figure[what] == "") verdict(1, what ": no such figure, budget " budget)
        else if (!number(figure[what])) verdict(1, what ": the figure is no number: " figure[what] ", budget " budget)
        else verdict(figure[what] + 0 > budget + 0, sprintf("%s: %s, budget %s, headroom %.10g", what, figure[what], budget, budget - figure[what]))
    }
    function verdict(failed, text) {
        print (failed ? "FAIL" : "pass") " budget " text
        failures += failed
    }
    END {
        if (!lines) verdict(1, "there is no line in the budgets")
        exit failures != 0 || missing
    }' $tables "$budgets"
