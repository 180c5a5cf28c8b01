#!/bin/sh
# SPDX-License-Identifier: MIT
# The tables of docs/GROWTH.md, between their marks: costs, loops, how far estimates are off.
# usage: growth.sh ESTIMATE_JUDGE REPORT_FOLDER [--check]    (--check: compare only, exit status 1 if the page differs)
set -u
cd "$(dirname "$0")/../.." || exit 2
judge=$1 report=$2 mode=${3:-write} page=docs/GROWTH.md
[ -s "$report/estimate.csv" ] || { echo "growth: $report/estimate.csv is missing; run make growth_tables"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# judged: for each core the frames, and how far they are off.
judged() {
    echo "| core | frames | mean error | largest | at |"
    echo "|---|---|---|---|---|"
    awk -F, 'NR > 1 {
        e = $NF < 0 ? -$NF : $NF; split($0, quoted, "\"")
        if (!($1 in n)) order[++cores] = $1
        n[$1]++; sum[$1] += e
        if (e > most[$1]) { most[$1] = e; at[$1] = quoted[2] }
    } END { for (i = 1; i <= cores; i++) { c = order[i]; printf "| %s | %d | %.1f %% | %.1f %% | `%s` |\n", c, n[c], 100 * sum[c] / n[c], 100 * most[c], at[c] } }' \
        "$report/estimate.csv"
}

status=0
cp "$page" "$work/page"
for table in judged costs loops; do
    {
        echo "<!-- $table: begin (make growth_tables) -->"
        if [ $table = judged ]; then judged; else "$judge" $table || exit 1; fi
        echo "<!-- $table: end -->"
    } >"$work/block"
    awk -v block="$work/block" -v name="$table" '
        index($0, "<!-- " name ": begin") { while ((getline line <block) > 0) print line; skip = 1; next }
        !skip
        index($0, "<!-- " name ": end") { skip = 0 }' "$work/page" >"$work/next"
    if [ "$mode" = --check ]; then
        if cmp -s "$work/page" "$work/next"; then
            echo "pass growth $table: $(grep -c '^| ' "$work/block") lines, as the commands print them"
        else
            echo "FAIL growth $table: $page is not what the commands print; run make growth_tables"
            diff "$work/page" "$work/next"
            status=1
        fi
    fi
    cp "$work/next" "$work/page"
done
[ "$mode" = --check ] || cat "$work/page" >"$page"
exit $status
