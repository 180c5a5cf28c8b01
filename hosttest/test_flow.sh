#!/bin/sh
# SPDX-License-Identifier: MIT
# Diagrams of functions: each function that one shows is defined in the library, each call is in the body of the caller, and the
# committed drawing is what the description draws. usage: test_flow.sh
set -u
cd "$(dirname "$0")/.." || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Bodies of functions, one line each: NAME TEXT. A definition begins in the first column and ends with a brace there, or on its line.
awk '
    /^[a-z].*\(/ && !/;[ \t]*$/ && !/^(typedef|struct|enum|return|else|if|for|while)/ {
        name = $0
        sub(/\(.*/, "", name)
        sub(/.*[ *]/, "", name)
        body = $0
        if ($0 ~ /\}[ \t]*$/) { print name, body; next }
        inside = 1
        next
    }
    inside { body = body " " $0 }
    inside && /^}/ { print name, body; inside = 0 }' firmware/*.[ch] port/*.[ch] >"$work/bodies"

status=0
for flow in hosttest/charts/*.flow; do
    name=$(basename "$flow" .flow)
    awk -F'|' '
        NR == FNR { n = index($0, " "); f = substr($0, 1, n - 1); body[f] = body[f] " " substr($0, n + 1); next }
        $1 == "box" { boxes++; if (!($4 in body)) missing = missing " " $4 }
        $1 == "calls" { calls++; if (!match(body[$2], "[^a-z_0-9]" $3 "\\(")) missing = missing " " $2 ">" $3 }
        END {
            if (missing != "" || boxes == 0) { print "FAIL flow_functions: " name ": not in the sources:" missing; exit 1 }
            print "pass flow_functions: " name ": " boxes " functions and " calls " calls are in the sources"
        }' name="$name" FS=' ' "$work/bodies" FS='|' "$flow" || status=1
    if hosttest/flow.sh "$flow" "$work/$name.svg" >/dev/null && cmp -s "$work/$name.svg" "docs/charts/$name.svg"; then
        echo "pass flow_drawn: docs/charts/$name.svg is what its description draws"
    else
        echo "FAIL flow_drawn: docs/charts/$name.svg is not what $flow draws; run make charts"
        status=1
    fi
done
exit $status
