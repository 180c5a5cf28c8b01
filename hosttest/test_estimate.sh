#!/bin/sh
# SPDX-License-Identifier: MIT
# lmb-estimate as its user meets it: figures that hang together, growth the right way, errors. Whether they are true is for make
# estimate. usage: test_estimate.sh LMB_ESTIMATE TORUS.obj
set -u
estimate=$(cd "$(dirname "$1")" && pwd)/$(basename "$1") torus=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$torus" "$work/torus.obj" && cd "$work" || exit 2
status=0
pass() { echo "pass $1"; }
fail() { echo "FAIL $1"; status=1; }

# cycles OPTION...: of one pose.
cycles() { "$estimate" torus.obj -q --csv --turn 0 --size 96x96 "$@" 2>>log | awk -F, 'NR == 2 { print $8 }'; }
# more WHAT LESS_OPTIONS MORE_OPTIONS: the second line costs more than the first.
more() {
    # shellcheck disable=SC2086
    less=$(cycles $2) greater=$(cycles $3)
    if [ -n "$less" ] && [ -n "$greater" ] && [ "$less" -gt 0 ] && [ "$greater" -gt "$less" ]; then
        pass "$1: $less, $greater"
    else
        fail "$1: '$less', '$greater'"
    fi
}
more "more pixels cost more" "" "--size 192x192"
more "strips cost more than a frame" "" "--strip 8"
more "vertices projected anew cost more" "--strip 8" "--strip 8 --vertices anew"
more "arcs cost more than quadratics" "" "--step arc"
more "a highlight costs more than none" "--model diffuse" ""
more "RGB888 costs more than RGB565" "" "--format rgb888"
more "two lights cost more than one" "--format rgb888" "--format rgb888 --light 1,2,3 --light 3,2,1"
more "a depth buffer costs more than none" "--order none" "--order depth"
more "painter's order costs more than none" "--order none" "--order painter"
more "perspective costs more than none" "" "--camera perspective"
more "M0+ takes more cycles than M4" "--core m4" "--core m0plus"
[ "$(cycles --depth)" = "$(cycles --order depth)" ] && pass "--depth is --order depth" || fail "--depth is not --order depth"

"$estimate" torus.obj -q --csv --turn 12 --pose 1,2,3 --pose 40,0,0 >csv.txt 2>>log
awk -F, 'NR == 1 { n = NF; next } { lines++; sum = 0; for (i = 15; i <= NF; i++) sum += $i; off = sum - $8; if (off < 0) off = -off
    if (NF != n || off > 5 || $2 != "m0plus" || $10 < 0.99 * 48e6 / $8 || $10 > 1.01 * 48e6 / $8) bad++; of[$4]++ }
    END { exit !(lines == 14 && of["pose"] == 2 && of["turn"] == 12 && !bad) }' csv.txt &&
    pass "--csv: 2 poses and 12 of a turn, parts add up to cycles" || fail "--csv: $(head -n 2 csv.txt)"

"$estimate" torus.obj -q --turn 12 --pose 1,2,3 >text.txt 2>>log
worst=$(awk -F, '$4 == "turn" && $8 + 0 > w { w = $8 } END { print w }' csv.txt)
grep -q "^worst .* $worst " text.txt && pass "the worst of a turn is the worst of its poses: $worst" || fail "the worst of a turn is not $worst"
grep -q "frame 115200, depth 115200, vertices $((1152 * 16))," text.txt && pass "RAM: frame, depth and 1152 vertices" ||
    fail "RAM: $(grep RAM text.txt)"
"$estimate" torus.obj -q --turn 0 --order none --strip 24 --vertices anew >strip.txt 2>>log
grep -q "strip 11520, paint" strip.txt && pass "RAM: a strip alone" || fail "RAM: $(grep RAM strip.txt)"
# flash CORE OPTION...: bytes of code with -Os.
flash() { "$estimate" torus.obj -q --turn 0 "$@" 2>>log | sed -n 's/^flash  code \([0-9]*\) .* or \([0-9]*\) .*/\2/p'; }
lean=$(flash --order none) deep=$(flash --order depth) full=$(flash --order depth --camera perspective)
[ "$lean" -gt 3000 ] && [ "$deep" -gt "$lean" ] && [ "$full" -gt "$deep" ] &&
    pass "flash: $lean bytes of code, with depth $deep, with perspective $full" || fail "flash: $lean, $deep, $full"
for core in $("$estimate" --core list | awk '{ print $1 }'); do
    [ "$(cycles --core "$core")" -gt 100000 ] && [ "$(flash --core "$core")" -gt 3000 ] && pass "core $core: $(cycles --core "$core")" ||
        fail "core $core"
done
"$estimate" torus.obj -q --turn 0 --classes >classes.txt 2>>log
awk '/^class / { on = 1; next } /^$/ { on = 0 } on { sum += $4 } /^pose / && $2 ~ /,/ { want = $3 }
    END { off = sum - want; if (off < 0) off = -off; exit !(want > 0 && off < 100) }' classes.txt &&
    pass "--classes: add up to the frame" || fail "--classes: do not add up"

# chosen TERM WAY OPTION...: how many terms of triangles, as the line says.
chosen() {
    term=$1 way=$2
    shift 2
    "$estimate" torus.obj -q --turn 0 --size 96x96 --pose 30,20,0 "$@" 2>>log |
        sed -n 's/^chosen: //p' | tr ';' '\n' | sed -n "s/^ *$term //p" | tr ',' '\n' | awk -v way="$way" '$2 == way { print $1 }'
}
# sum TERM STEP: over all ways.
sum() {
    total=0
    for way_of in constant linear quadratic arcs dark; do total=$((total + $(chosen "$1" $way_of --step "$2"))); done
    echo $total
}
all=$(sum N.L arc)
[ "$(chosen N.L linear --step linear)" -gt 100 ] && [ "$(chosen N.L quadratic --step linear)" = 0 ] &&
    [ "$(chosen N.L arcs --step arc)" = "$all" ] && [ "$all" -gt 100 ] && [ "$(chosen highlight quadratic -n 20)" -gt 10 ] &&
    [ -z "$(chosen highlight dark --model diffuse)" ] && [ "$(sum N.L planned)" = "$all" ] && [ "$(sum highlight planned)" = "$all" ] &&
    pass "chosen: all $all triangles of a step have its way" ||
    fail "chosen: $all of arcs, $(sum N.L planned) planned in all"
weak="--step planned --diffuse 0.05 --specular 1 -n 500"
# shellcheck disable=SC2086
constant=$(chosen N.L constant $weak) linear=$(chosen N.L linear $weak) arcs=$(chosen N.L arcs $weak)
[ "$constant" -gt 0 ] && [ "$linear" -gt 0 ] && [ "$arcs" -gt 0 ] && [ "$(chosen N.L quadratic --step planned)" -gt 100 ] &&
    pass "chosen: of weak diffuse light $constant constant, $linear linear, $arcs arcs; of strong light quadratics" ||
    fail "chosen: of weak diffuse light $constant constant, $linear linear, $arcs arcs"
more "arcs cost more than what is planned" "--step planned" "--step arc"
[ "$(flash --step planned)" -gt "$(flash --step arc)" ] && pass "flash: $(flash --step planned) bytes of code with a planner" ||
    fail "flash: $(flash --step planned) bytes with a planner, $(flash --step arc) with arcs alone"

# refuse NAME PATTERN ARGUMENT...: one line on stderr that matches.
refuse() {
    name=$1 pattern=$2
    shift 2
    "$estimate" "$@" >out.txt 2>err.txt
    code=$?
    if [ $code != 0 ] && [ "$(wc -l <err.txt)" = 1 ] && grep -q -- "$pattern" err.txt && [ ! -s out.txt ]; then
        pass "refuses $name: $(cat err.txt)"
    else
        fail "refuses $name: exit status $code, says '$(cat err.txt)'"
    fi
}
refuse "no model" "MODEL.obj"
refuse "a missing file" "nothere.obj" nothere.obj
refuse "an unknown core" "m0plus" torus.obj --core z80
refuse "no clock" "--mhz" torus.obj --mhz 0
refuse "half a pose" "--pose" torus.obj --pose 1,2
refuse "an unknown option" "--colr" torus.obj --colr 3
refuse "a bad turn" "--turn" torus.obj --turn -1
"$estimate" --help >help.txt 2>err.txt && [ ! -s err.txt ] && grep -q -- --turn help.txt && pass "--help: $(wc -l <help.txt) lines" || fail "--help"
exit $status
