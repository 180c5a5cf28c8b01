#!/bin/sh
# SPDX-License-Identifier: MIT
# The tables of docs/PARETO.md, between their marks.
# usage: page.sh PARETO_CSV [--check]    (--check: compare only, exit status 1 if the page differs)
set -u
csv=$1 mode=${2:-write} page=docs/PARETO.md
cd "$(dirname "$0")/../.." || exit 2
[ -s "$csv" ] || { echo "pareto: $csv is missing; make pareto writes it"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
awk -f hosttest/pareto/bars.awk "$csv" >"$work/figures" || exit 1

# One row a scene on Cortex-M0+: NAME CORE SCENE FIGURE COST against COST of METHOD, errors E and E.
frames() {
    echo "| scene | planned, cycles | fastest fixed choice as good | cycles | planned takes | arcs everywhere | planned is faster | curve off the front, at worst |"
    echo "|---|---|---|---|---|---|---|---|"
    awk '$2 != "m0plus" { next }
        $1 == "planned" { sub(/,$/, "", $9); s[++n] = $3; cost[$3] = $5; fixed[$3] = $9; other[$3] = $7; more[$3] = $4 }
        $1 == "curve" { curve[$3] = $4; at[$3] = $5 }
        $1 == "arcs" { times[$3] = $4; arc[$3] = $7 }
        END {
            for (i = 1; i <= n; i++) printf "| %s | %s | `%s` | %s | %+.1f %% | %s | %s times | %.1f %%, `%s` |\n", s[i], cost[s[i]], \
                fixed[s[i]], other[s[i]], more[s[i]], arc[s[i]], times[s[i]], curve[s[i]], at[s[i]]
        }' "$work/figures"
}

# fronts SCOPE: what is on the front of each scene, the cheapest first: cycles (instructions on RV32IMC) and error. Ours in bold.
fronts() {
    echo "| core | scene | on the front: cost (error) |"
    echo "|---|---|---|"
    awk -F, -v scope="$1" '
        $2 == scope && $11 == 1 {
            key = $1 " | " $3
            if (!(key in count)) order[++n] = key
            k = ++count[key]
            cost[key, k] = $5 + 0
            bold = $4 ~ /^(lambent|tuned)/ ? "**" : ""
            text[key, k] = sprintf("%s%s%s " ($5 >= 100 ? "%.0f" : "%.1f") " (%.2g)", bold, $4, bold, $5, $7)
        }
        END {
            for (i = 1; i <= n; i++) {
                key = order[i]
                line = ""
                for (done = 0; done < count[key]; done++) {
                    best = 0
                    for (k = 1; k <= count[key]; k++) if (!((key, k) in out) && (!best || cost[key, k] < cost[key, best])) best = k
                    out[key, best] = 1
                    line = line (done ? ", " : "") text[key, best]
                }
                printf "| %s | %s |\n", key, line
            }
        }' "$csv" | sort -s -t '|' -k 2,2
}

cp "$page" "$work/page"
status=0
for table in frames lobes ways; do
    {
        echo "<!-- $table: begin (make pareto) -->"
        case $table in
        frames) frames ;;
        lobes) fronts lobe ;;
        ways) fronts span ;;
        esac
        echo "<!-- $table: end -->"
    } >"$work/block"
    awk -v block="$work/block" -v name="$table" '
        index($0, "<!-- " name ": begin") { while ((getline line <block) > 0) print line; skip = 1; next }
        !skip
        index($0, "<!-- " name ": end") { skip = 0 }' "$work/page" >"$work/next"
    if [ "$mode" = --check ]; then
        if cmp -s "$work/page" "$work/next"; then
            echo "pass pareto page $table: $(grep -c '^| ' "$work/block") lines, as the commands print them"
        else
            echo "FAIL pareto page $table: $page is not what the commands print; run make pareto"
            diff "$work/page" "$work/next"
            status=1
        fi
    fi
    cp "$work/next" "$work/page"
done
[ "$mode" = --check ] || cat "$work/page" >"$page"
exit $status
