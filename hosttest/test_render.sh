#!/bin/sh
# SPDX-License-Identifier: MIT
# lmb-render as its user meets it: pictures, errors, the same bytes by strips. usage: test_render.sh LMB_RENDER
set -u
render=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2
status=0

pass() { echo "pass $1"; }
fail() { echo "FAIL $1"; status=1; }

# torus N M: a torus of N x M quads, without normals.
torus() { awk -v n="$1" -v m="$2" 'BEGIN {
    turn = 8 * atan2(1, 1)
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
        r = 7 + 3 * cos(turn * j / m)
        printf "v %.6f %.6f %.6f\n", 5 + r * cos(turn * i / n), r * sin(turn * i / n), 3 * sin(turn * j / m)
    }
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
        a = (i + 1) % n; b = (j + 1) % m
        printf "f %d %d %d %d\n", i * m + j + 1, a * m + j + 1, a * m + b + 1, i * m + b + 1
    }
}'; }
torus 24 12 >torus.obj
torus 64 32 >fine.obj

# draw NAME OPTION...: NAME.bmp, or a failure.
obj=torus.obj
draw() {
    name=$1
    shift
    "$render" "$obj" -q -o "$name.bmp" "$@" 2>"$name.err" || { fail "draws $name: $* says $(cat "$name.err")"; return 1; }
}
# pixels_of FILE: its pixel bytes, one line each, unsigned.
pixels_of() { tail -c +55 "$1" | od -An -v -tu1 -w3; }

draw whole --pose 50,20,0 --size 97x61 -n 40
expected=$((54 + (97 * 3 + 1) * 61))
[ "$(wc -c <whole.bmp)" = "$expected" ] && [ "$(head -c 2 whole.bmp)" = BM ] &&
    pass "writes a BMP: 97x61, 24 bits, $expected bytes" || fail "writes a BMP: $(wc -c <whole.bmp) bytes, want $expected"

draw lit --pose 50,20,0 --size 128x128 -n 40
bright=$(pixels_of lit.bmp | awk '$1 > 200 && $2 > 150 && $3 > 120' | wc -l)
dark=$(pixels_of lit.bmp | awk '$1 < 40 && $2 < 40 && $3 < 40' | wc -l)
[ "$bright" -gt 5 ] && [ "$dark" -gt 3000 ] && pass "shows a highlight: $bright bright pixels, $dark dark ones" ||
    fail "shows a highlight: $bright bright pixels, $dark dark ones"

same=0
for model in flat gouraud diffuse gloss; do
    for step in linear quadratic arc planned; do
        for format in rgb565 rgb888; do
            for order in depth painter; do
                set -- --model $model --step $step --format $format --order $order --camera perspective --pose 40,30,20 --size 64x64
                draw a "$@" && draw b "$@" --strip 7 && cmp -s a.bmp b.bmp && same=$((same + 1))
            done
        done
    done
done
[ $same = 64 ] && pass "strips: 64 combinations of model, step, format and order give the picture that the whole frame gives" ||
    fail "strips: only $same of 64 combinations give the picture that the whole frame gives"

draw depth --order depth --camera perspective --pose 60,10,0
draw painter --order painter --camera perspective --pose 60,10,0
differing=$(cmp -l depth.bmp painter.bmp | wc -l)
[ "$differing" -lt 600 ] && pass "painter's order: differs from the depth buffer in $differing bytes of 172854" ||
    fail "painter's order: differs from the depth buffer in $differing bytes of 172854"

# apart A B: the largest difference of two pictures, in levels of 255.
apart() { { pixels_of "$1" | tr -s ' ' '\n'; echo next; pixels_of "$2" | tr -s ' ' '\n'; } | awk '
    /next/ { second = 1; next } NF && !second { first[++n] = $1 } NF && second { d = $1 - first[++m]; if (d < 0) d = -d; if (d > most) most = d }
    END { print n == m && n ? most + 0 : 999 }'; }
obj=fine.obj
for step in linear arc planned; do draw $step --pose 50,20,0 --size 97x61 -n 40 --format rgb888 --step $step; done
obj=torus.obj
from_arc=$(apart arc.bmp planned.bmp)
from_linear=$(apart linear.bmp planned.bmp)
[ "$from_arc" -ge 1 ] && [ "$from_arc" -le 2 ] && [ "$from_linear" -gt 8 ] &&
    pass "--step planned: at most $from_arc levels of 255 from arcs, $from_linear from linear" ||
    fail "--step planned: $from_arc levels of 255 from arcs, $from_linear from linear"

for option in "--model flat" "--model gouraud" "--model diffuse" "--step linear" "--step arc" "--lobe w2" "--lobe w4" "--lobe w8" "-n 200" "--colour #ff2010" "--light 0,0,1,#40ff40" \
    "--ambient 0.5" "--specular 0" "--zoom 0.5" "--background #ffffff" "--format rgb888" "--pose 51,20,0"; do
    # shellcheck disable=SC2086
    draw other --pose 50,20,0 --size 97x61 -n 40 $option
    cmp -s whole.bmp other.bmp && fail "option $option: changes nothing" || pass "option $option: changes the picture"
done

# refuse NAME PATTERN ARGUMENT...: one line on stderr that matches, no output file.
refuse() {
    name=$1 pattern=$2
    shift 2
    rm -f out.bmp
    "$render" "$@" >out.txt 2>err.txt
    code=$?
    if [ $code != 0 ] && [ "$(wc -l <err.txt)" = 1 ] && grep -q -- "$pattern" err.txt && [ ! -e out.bmp ]; then
        pass "refuses $name: $(cat err.txt)"
    else
        fail "refuses $name: exit status $code, says '$(cat err.txt)'"
    fi
}
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >bad.obj
refuse "a missing file" "nothere.obj" nothere.obj -o out.bmp
refuse "a bad index" "bad.obj:4:" bad.obj -o out.bmp
refuse "no model" "MODEL.obj" -o out.bmp
refuse "no output" "-o" torus.obj
refuse "an unknown option" "--colr" torus.obj -o out.bmp --colr 3
refuse "n = 0" "-n" torus.obj -o out.bmp -n 0
refuse "n = 1001" "-n" torus.obj -o out.bmp -n 1001
refuse "n = 1.5" "-n" torus.obj -o out.bmp -n 1.5
refuse "a bad size" "--size" torus.obj -o out.bmp --size 240
refuse "an empty size" "--size" torus.obj -o out.bmp --size 0x10
refuse "a bad model" "phong" torus.obj -o out.bmp --model phong
refuse "a bad step" "planned" torus.obj -o out.bmp --step exact
refuse "a bad lobe" "w16" torus.obj -o out.bmp --lobe w32
refuse "a bad colour" "--colour" torus.obj -o out.bmp --colour red
refuse "a light of no direction" "--light" torus.obj -o out.bmp --light 0,0,0
refuse "five lights" "--light" torus.obj -o out.bmp --light 1,0,1 --light 0,1,1 --light 0,0,1 --light 1,1,1 --light 2,1,1
refuse "a value that is missing" "missing" torus.obj -o out.bmp --pose
refuse "a folder that is not there" "cannot write" torus.obj -q -o nowhere/out.bmp

"$render" --help >help.txt 2>err.txt && [ ! -s err.txt ] && grep -q -- --strip help.txt && pass "--help: $(wc -l <help.txt) lines" ||
    fail "--help"
"$render" torus.obj -q -o - --size 10x10 2>/dev/null | cmp -s - "$(draw tiny --size 10x10; echo tiny.bmp)" &&
    pass "-o -: the picture on the standard output" || fail "-o -: differs from the file"
exit $status
