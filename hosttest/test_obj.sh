#!/bin/sh
# SPDX-License-Identifier: MIT
# lmb-mesh from the outside: what it refuses and how, what it writes, and that the result compiles.
#
# usage: test_obj.sh LMB-MESH CC [INCLUDE]
#   INCLUDE  folder with lambent.h; firmware/ beside this file's folder if left out
# A build with -fsanitize=address,undefined may be given: faults are told from refusals by their exit status.

[ $# -ge 2 ] || { echo "usage: $0 LMB-MESH CC [INCLUDE]" >&2; exit 2; }
case $1 in */*) tool=$(cd "$(dirname "$1")" && pwd)/$(basename "$1") ;; *) tool=$1 ;; esac
cc=$2
include=$(cd "${3:-$(dirname "$0")/../firmware}" && pwd) || exit 2
LC_ALL=C
ASAN_OPTIONS=exitcode=99:detect_leaks=1
UBSAN_OPTIONS=exitcode=99:halt_on_error=1
export LC_ALL ASAN_OPTIONS UBSAN_OPTIONS

work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
cd "$work" || exit 2
failures=0

pass() { echo "pass $1: $2"; }
fail() { echo "FAIL $1: $2"; failures=$((failures + 1)); }
# check NAME GOT WANT
check() { if [ "$2" = "$3" ]; then pass "$1" "$2"; else fail "$1" "got '$2', want '$3'"; fi; }

# run OPTIONS...: lmb-mesh to out.c, its exit status in $status, its messages in err
run() {
    rm -f out.c
    "$tool" "$@" -o out.c >std 2>err
    status=$?
}

# refuses NAME LINE PATTERN [OPTION]: in.obj gives exit status 1, no output, and the one line 'in.obj:LINE: ...PATTERN...'
refuses() {
    run in.obj $4
    if [ "$status" -ne 1 ]; then fail "$1" "exit status $status, want 1"
    elif [ -s std ] || [ -n "$(ls out.c* 2>/dev/null)" ]; then fail "$1" "there is output"
    elif [ "$(wc -l <err)" -ne 1 ]; then fail "$1" "$(wc -l <err) lines on stderr, want 1"
    elif ! grep -q "^in\.obj:$2: .*$3" err; then fail "$1" "got '$(cat err)', want in.obj:$2: ...$3"
    else pass "$1" "$(cat err)"
    fi
}

# accepts NAME 'VERTICES TRIANGLES' [OPTION]: in.obj gives a mesh of that size
accepts() {
    run in.obj $3
    if [ "$status" -ne 0 ]; then fail "$1" "exit status $status: $(cat err)"; return; fi
    check "$1" "$(sizes)" "$2"
}
sizes() { awk '$2 == "vertices" { v = $3 } $2 == "triangles" { print v, $3; exit }' out.c; }

# normal N: the Nth normal in out.c, from 0
normal() { sed -n '/_normals\[/,/^};/p' out.c | grep -o '{-*[0-9][^}]*}' | sed -n "$(($1 + 1))p"; }

three='v 0 0 0
v 1 0 0
v 0 1 0'

# ------------------------------------------------------------------------------------------------------------ refused: statements

while IFS='|' read -r name line pattern text; do
    printf '%s\n'"$text"'\n' "$three" >in.obj
    refuses "refuses $name" "$line" "$pattern"
done <<'END'
a word for a number|4|'abc' is not a number|v 1 abc 2\nf 1 2 3
a number with a tail|4|'1.5x' is not a number|v 1 1.5x 2\nf 1 2 3
a decimal comma|4|'1,5' is not a number|v 1,5 1 2\nf 1 2 3
a hexadecimal number|4|'0x10' is not a number|v 0x10 1 2\nf 1 2 3
two coordinates|4|got 2 numbers|v 1 2\nf 1 2 3
no coordinates|4|got 0 numbers|v\nf 1 2 3
five numbers|4|got 5 numbers|v 1 2 3 4 5\nf 1 2 3
NaN|4|'nan' is not a finite number|v 1 nan 2\nf 1 2 3
minus NaN|4|'-NaN(1)' is not a finite number|v 1 -NaN(1) 2\nf 1 2 3
infinity|4|'inf' is not a finite number|v 1 2 inf\nf 1 2 3
a number that overflows|4|'1e999' is too large|v 1e999 0 0\nf 1 2 3
a number beyond the limit|4|'-1e31' is too large|v -1e31 0 0\nf 1 2 3
a bad colour|4|'red' is not a number|v 1 2 3 red\nf 1 2 3
vn of no length|4|vn has no length|vn 0 0 -0\nf 1 2 3
vn with NaN|4|'nan' is not a finite number|vn 0 0 nan\nf 1 2 3
vn with infinity|4|'-Infinity' is not a finite number|vn 0 0 -Infinity\nf 1 2 3
vn of two numbers|4|got 2 numbers|vn 0 1\nf 1 2 3
index 0|4|'0' has an index of 0|f 1 2 0
an index past the end|4|index out of range: v 4, of 3|f 1 2 4
a huge index|4|index out of range: '99999999999999999999'|f 1 2 99999999999999999999
an index before the start|4|index out of range: '-4', with 3 v|f 1 2 -4
a vn past the end|5|index out of range: vn 2, of 1|vn 0 0 1\nf 1//1 2//2 3//1
a vn before the start|5|index out of range: '2//-2', with 1 vn|vn 0 0 1\nf 1//1 2//-2 3//1
a fraction for an index|4|'1.5' is not a corner|f 1.5 2 3
a word for an index|4|'a' is not a corner|f a 2 3\nf b 2 3
four parts in a corner|4|'1/1/1/1' is not a corner|f 1/1/1/1 2 3
a corner that ends in a slash|4|'3//' is not a corner|f 1 2 3//
corners with and without vn|5|with and without a normal|vn 0 0 1\nf 1//1 2 3
a face of two corners|4|got 2|f 1 2
a face of no corners|4|got 0|f
a file without a face|4|without a face|o thing
END

: >in.obj
refuses "refuses an empty file" 1 "without a face"
printf '%s\nv 1 \\\n 2 \\\n x\nf 1 2 3\n' "$three" >in.obj
refuses "names the first line of a continued statement" 4 "'x' is not a number"
printf '%s\nv 1 2 3 # \000\nf 1 2 3\n' "$three" >in.obj
refuses "refuses a NUL byte" 4 "NUL byte"
printf '%s\nf 1 2 3\n\000' "$three" >in.obj
refuses "refuses a NUL byte in the last line" 5 "NUL byte"
printf 'v 0 0 \033[31m\nf 1 2 3\n' >in.obj
refuses "makes control bytes harmless" 1 "'?\[31m' is not a number"
awk 'BEGIN { printf "v 0 0 "; for (i = 0; i < 300000; i++) printf "x"; print "\nf 1 2 3" }' >in.obj
refuses "cuts a long word" 1 "'x*\.\.\.' is not a number"
awk 'BEGIN { s = "0 0 0 0 0 0 0 0 "; while (length(s) < 1048576) s = s s
             printf "v "; for (i = 0; i < 18; i++) printf "%s", s }' >in.obj
refuses "refuses a statement of 18 MB" 1 "longer than" -q

# -------------------------------------------------------------------------------------------------------------- refused: geometry

while IFS='|' read -r name line pattern text; do
    printf "$text"'\n' >in.obj
    refuses "refuses $name" "$line" "$pattern"
done <<'END'
a corner twice|4|two corners in one place.*--drop-degenerate|v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2
two v in one place|4|two corners in one place|v 0 0 0\nv 1 0 0\nv 1 0 0\nf 1 2 3
corners in line|4|corners in one line|v 0 0 0\nv 1 1 1\nv 3 3 3\nf 1 2 3
corners in line but for rounding|4|corners in one line|v 0.1 0.7 0.3\nv 0.2 1.4 0.6\nv 0.3 2.1 0.9\nf 1 2 3
area lost at 16 bits|6|no area left at 16 bits|v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1e-7 1e-7 0\nf 1 2 3\nf 1 4 2
a quadrangle with a corner twice|5|two corners in one place|v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 2 3
a quadrangle in line|5|face without area|v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4
an outline that crosses itself|6|crosses itself|v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 -1 0\nv 0 3 0\nf 1 2 3 4 5
coordinates beyond space|2|does not fit in space.*--fit|v 0 0 0\nv 40000 0 0\nv 0 1 0\nf 1 2 3
a speck|3|too small.*--fit|v 0 0 0\nv 1e-9 0 0\nv 0 1e-8 0\nf 1 2 3
END

printf '%s\nf 1 2 2\nf 1 1 3\n' "$three" >in.obj
refuses "refuses a model of nothing but dropped triangles" 4 "all triangles are degenerate" --drop-degenerate

# A height field of $1 by $2 vertices. Large enough for progress from about 200 by 200.
field() {
    awk -v w="$1" -v h="$2" 'BEGIN {
        for (y = 0; y < h; y++) for (x = 0; x < w; x++) printf "v %.5f %.5f %.5f\n", x / w, y / w, (x * 7 + y * 13) % 17 / 99
        for (y = 1; y < h; y++) for (x = 1; x < w; x++) {
            i = (y - 1) * w + x
            printf "f %d %d %d\nf %d %d %d\n", i, i + 1, i + w, i + 1, i + w + 1, i + w
        }
    }'
}
field 256 257 >in.obj
refuses "refuses 65792 vertices" "[0-9]*" "more than 65535 vertices.*the model has 65792" -q
line=$(sed 's/in.obj:\([0-9]*\):.*/\1/' err)
# Vertices come in order of use: 65536 have been seen when the face that needs the 65536th v in that order is read.
check "names the line where the limit is passed" "$(sed -n "${line}p" in.obj | cut -c1)" f
run in.obj
check "progress before an error leaves the error a line of its own" "$(grep -c '^in\.obj:[0-9]*: more than' err)" 1
field 255 257 >in.obj
accepts "accepts 65535 vertices" "65535 130048" -q

# -------------------------------------------------------------------------------------------------------- refused: files, options

run no-such.obj
check "missing file" "$status $(cat err)" "1 no-such.obj: cannot open: No such file or directory"
mkdir folder.obj
run folder.obj
check "folder for a file" "$status $(wc -l <err) $(grep -c 'cannot read: ' err)" "1 1 1"
printf '%s\nf 1 2 3\n' "$three" >in.obj
"$tool" in.obj -o no/such/out.c 2>err
check "no folder for the output" "$? $(cat err)" "1 no/such/out.c: cannot write: No such file or directory"
cp in.obj self.obj
"$tool" self.obj -o ./self.obj 2>err
check "output over the input" "$? $(wc -l <err) $(cmp in.obj self.obj && echo kept)" "1 1 kept"
if [ -w /dev/full ]; then
    "$tool" in.obj -o /dev/full 2>err
    check "full device" "$? $(cat err)" "1 /dev/full: cannot write: No space left on device"
fi
printf 'old\n' >kept.c
printf 'v 1\n' >bad.obj
"$tool" bad.obj -o kept.c 2>err
check "an error leaves the old output" "$? $(cat kept.c) $(ls kept.c*)" "1 old kept.c"
"$tool" in.obj -o kept.c 2>err
check "success replaces the old output" "$? $(grep -c 'const lmb_mesh in = ' kept.c) $(ls kept.c*)" "0 1 kept.c"
ln -s kept.c link.c
"$tool" in.obj -o link.c --name other 2>err
check "a link is followed" "$? $(test -h link.c && grep -c 'const lmb_mesh other = ' kept.c)" "0 1"

# usage_error NAME ARGUMENTS...
usage_error() {
    name=$1
    shift
    "$tool" "$@" >std 2>err
    check "usage: $name" "$? $(wc -l <err) $(wc -c <std)" "2 1 0"
}
usage_error "no arguments"
usage_error "no output" in.obj
usage_error "-o without a file" in.obj -o
usage_error "unknown option" in.obj -o out.c --smooth
usage_error "unknown weight" in.obj -o out.c --normals volume
usage_error "two inputs" in.obj in.obj -o out.c
usage_error "a number for a name" in.obj -o out.c --name 3d
usage_error "a keyword for a name" in.obj -o out.c --name int
usage_error "a blank in a name" in.obj -o out.c --name 'a b'
usage_error "an empty name" in.obj -o out.c --name=
"$tool" --help >std 2>err
check "--help" "$? $(grep -c '^  -' std) $(wc -c <err)" "0 9 0"

# --------------------------------------------------------------------------------------------------------------- accepted: syntax

while IFS='|' read -r name want text; do
    printf "$text" >in.obj
    accepts "accepts $name" "$want"
done <<'END'
a triangle|3 1|v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n
no newline at the end|3 1|v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3
CR LF|3 1|v 0 0 0\r\nv 1 0 0\r\n\r\nv 0 1 0\r\nf 1 2 3\r\n
blanks and tabs|3 1|  v\t0 0  0 \n\tv 1 0 0\n \t \nv 0 1 0\n  f  1\t2 3  
a byte order mark|3 1|\357\273\277v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n
comments|3 1|# v 1\nv 0 0 0 # one\nv 1 0 0#two\nv 0 1 0\nf 1 2 3 # 4 5\n
a comment that ends in a backslash|3 1|# C:\\\\models\\\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n
continued lines|3 1|v 0 \\\n 0 \\\n 0\nv 1 0 0\nv 0 1 0\nf 1 \\\n2 \\\n\\\n3\n
continued lines with CR LF|3 1|v 0 \\\r\n 0 \\\r\n 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 \\\r\n2 3\r\n
a backslash at the very end|3 1|v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 \\
weights and colours|3 1|v 0 0 0 1.0\nv 1 0 0 0.5 0.5 1\nv 0 1 0 1 0 0 1\nf 1 2 3\n
forms of numbers|3 1|v +0. -.0 0e5\nv 1.e0 0 0\nv 0 10E-1 1e-400\nf 1 2 3\n
a quadrangle|4 2|v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n
a hexagon|6 4|v 2 0 0\nv 1 2 0\nv -1 2 0\nv -2 0 0\nv -1 -2 0\nv 1 -2 0\nf 1 2 3 4 5 6\n
a corner in a straight edge|5 3|v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n
negative indices|3 1|v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\n
v/vt|3 1|v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n
v//vn|3 1|v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n
v/vt/vn|3 1|v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/-1 2/-1/1 3/1/1\n
faces before their vertices|3 1|f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n
a hard edge|6 2|v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 -1\nvn 0 -1 0\nf 1//1 3//1 2//1\nf 1//2 2//2 4//2\n
equal v with equal normals, merged|4 2|v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n
a sheet of two sides|6 2|v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n
a statement over many lines|3 1|v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng a \\\nb \\\nc \\\nd\n
END

{ printf '%s\nf 1 2 3\n# ' "$three"; awk 'BEGIN { for (i = 0; i < 1500000; i++) printf "x" }'; printf '\nv 9 9 9\n'; } >in.obj
accepts "accepts a comment of 1.5 MB" "3 1"
# A jagged fan: no ears are clipped, so that the number of corners has no limit.
awk 'BEGIN { n = 5000; print "v 0 0 0"
             for (i = 1; i < n; i++) { r = 1 - i % 2 / 2; printf "v %.9f %.9f 0\n", r * cos(i / n), r * sin(i / n) }
             printf "f"; for (i = 1; i <= n; i++) printf " %d", i; print "" }' >in.obj
accepts "accepts a face of 5000 corners" "5000 4998"
# The same fan with its tip in the middle of the list is concave, seen from the first corner.
awk 'BEGIN { n = 5000
             for (i = 1; i < n; i++) { r = 1 - i % 2 / 2; printf "v %.9f %.9f 0\n", r * cos(i / n), r * sin(i / n) }
             print "v 0 0 0"; printf "f"; for (i = 1; i <= n; i++) printf " %d", i; print "" }' >in.obj
refuses "refuses a concave face of 5000 corners" 5001 "too many corners"

# An arrow head whose fan from the first corner would leave the outline: corners 4 1 2 and 2 3 4, numbered as they come.
printf 'v -2 -1 0\nv 0 0 0\nv 2 -1 0\nv 0 3 0\nf 1 2 3 4\n' >in.obj
accepts "cuts a concave quadrangle" "4 2"
check "... from the corner that is bent inwards" "$(sed -n '/_indices\[/,/^};/p' out.c | sed -n 2p)" "    0, 1, 2, 2, 3, 0,"

printf 'mtllib m\no a\ng b\ns 1\nusemtl c\nusemtl d\nl 1 2\np 1\ncurv2 1\n%s\nf 1 2 3\nv 7 7 7\n' "$three" >in.obj
run in.obj
check "one note for each skipped keyword" "$(grep -c 'note: skipped' err)" 8
check "... with the number of lines" "$(grep "'usemtl'" err)" "in.obj: note: skipped 2 'usemtl' lines"
check "a note on unused v" "$(grep -c 'note: 1 v not used' err)" 1
run in.obj --quiet
check "--quiet has no notes" "$status $(wc -c <err)" "0 0"
awk 'BEGIN { for (i = 0; i < 500; i++) print "word" i; print "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3" }' >in.obj
run in.obj
check "notes have an end" "$(wc -l <err) $(tail -n 1 err)" "33 in.obj: note: skipped 468 lines of other keywords"

# ----------------------------------------------------------------------------------------------------- accepted: numbers, normals

# The corner of a box: three right angles, areas 1, 1/2, 1. By angle (1, 1, 1)/sqrt(3), by area (1, 2, 2)/3; in Q2.14.
printf 'v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 4 3\nf 1 2 4\n' >in.obj
run in.obj
check "normals by angle are the default" "$(normal 0)" "{-9459, -9459, -9459}"
run in.obj --normals angle
check "normals by angle" "$(normal 0)" "{-9459, -9459, -9459}"
run in.obj --normals area
check "normals by area" "$(normal 0)" "{-5461, -10923, -10923}"
# A square of area 1 counts twice a triangle of 1/2, not four times, though it is cut in two: (1, 1, 2)/sqrt(6).
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 0\nf 1 3 5 2\nf 1 4 3\nf 1 2 4\n' >in.obj
run in.obj --normals area
check "normals by area of whole faces" "$(normal 0)" "{-6689, -6689, -13377}"

cube='v 0 0 0
v 2 0 0
v 2 2 0
v 0 2 0
v 0 0 2
v 2 0 2
v 2 2 2
v 0 2 2'
printf '%s\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n' "$cube" >in.obj
# components NAME: how many of the 24 components of a cube's normals are +-9459
components() { sed -n '/_normals\[/,/^};/p' out.c | grep -o '[{ ]-*9459' | wc -l | tr -d ' '; }
run in.obj --normals angle
check "cube of quadrangles, by angle: all towards the corners" "$(sizes) $(components)" "8 12 24"
run in.obj --normals area
check "cube of quadrangles, by area: all towards the corners" "$(sizes) $(components)" "8 12 24"
cp in.obj cube.obj
awk '$1 == "f" { print "f", $2, $3, $4; print "f", $4, $5, $2; next } { print }' cube.obj >in.obj
run in.obj --normals angle
check "cube of triangles, by angle: all towards the corners" "$(sizes) $(components)" "8 12 24"
run in.obj --normals area
check "cube of triangles, by area: depends on the cut" "$(sizes) $(components)" "8 12 0"
cp cube.obj in.obj
run in.obj --centre
check "--centre" "$(grep -c ' -1 to 1$' out.c) $(grep -c 'scale     -14:' out.c)" "3 1"
run in.obj --fit
check "--fit: corners at 1/sqrt(3)" "$(grep -c ' -0\.577[0-9]* to 0\.577' out.c) $(grep -c 'scale     -15:' out.c)" "3 1"
{ cat cube.obj; echo 'v 99 99 99'; } >in.obj
run in.obj --fit
check "--fit: v that no face uses do not count" "$(grep -c ' -0\.577[0-9]* to 0\.577' out.c)" 3
run cube.obj
check "flash is stated" "$(grep -c 'flash     168 bytes: positions 48, normals 48, indices 72;' out.c)" 1

printf 'v 0 0 0\nv 8191.75 0 0\nv 0 -8191.75 0\nf 3 2 1\n' >in.obj
run in.obj
check "the largest coordinate of all" "$(grep -c 'scale     -2:' out.c) $(grep -c '{0, -32767, 0}.*{32767, 0, 0}' out.c)" "1 1"
printf 'v 0 0 0\nv 0.99998 0 0\nv 0 0.3 0\nf 1 2 3\n' >in.obj
run in.obj
check "just below one: 32767 and not 32768" "$(grep -c 'scale     -15:' out.c) $(grep -c '{32767, 0, 0}' out.c)" "1 1"
printf 'v 0 0 0\nv 0.99999 0 0\nv 0 0.3 0\nf 1 2 3\n' >in.obj
run in.obj
check "would round to 32768: one bit less" "$(grep -c 'scale     -14:' out.c) $(grep -c '{16384, 0, 0}' out.c)" "1 1"
printf 'v 1e9 0 0\nv 3e9 0 0\nv 1e9 1e9 0\nf 1 2 3\n' >in.obj
accepts "--fit takes any size" "3 1" --fit
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n' >in.obj
run in.obj
check "a note on winding against vn" "$(grep -c '1 triangles wind clockwise' err)" 1
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 2 3\nf 1 3 4\nf 1 1 2\n' >in.obj
accepts "--drop-degenerate keeps the rest" "4 2" --drop-degenerate
check "... and says how many" "$(grep -c 'note: 2 degenerate' err)" 1
# A square with a spike of no width on one corner: out along corners 5 and 6 and back.
printf 'v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 2 3 0\nv 2 4 0\nf 1 2 3 5 6 5 3 4\n' >in.obj
refuses "refuses a spike" 7 "degenerate triangle"
accepts "--drop-degenerate cuts a spike off" "4 2" --drop-degenerate

# ------------------------------------------------------------------------------------------------------------------- the C source

cat >main.c <<'END'
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "lambent.h"
extern const lmb_mesh MESH;
int main(void)
{
    const lmb_mesh *m = &MESH;
    unsigned char *used = (unsigned char *)calloc(m->vertices, 1);
    double worst = 0;
    unsigned long i, bad = 0, unused = 0;
    for (i = 0; i < 3 * (unsigned long)m->triangles; i++) {
        if (m->indices[i] >= m->vertices) bad++;
        else used[m->indices[i]] = 1;
    }
    for (i = 0; i < m->vertices; i++) {
        const lmb_vec n = m->normals[i];
        const double length = sqrt((double)n.x * n.x + (double)n.y * n.y + (double)n.z * n.z);
        if (fabs(length - 16384) > worst) worst = fabs(length - 16384);
        if (!used[i]) unused++;
    }
    printf("%u %lu bad %lu unused %lu normals %s\n", (unsigned)m->vertices, (unsigned long)m->triangles, bad, unused,
           worst <= 0.8661 ? "unit" : "off"); /* sqrt(3)/2: half a unit in each component */
    free(used);
    return 0;
}
END

# compiles NAME WANT COMPILER...: out.c with its mesh called $mesh
compiles() {
    name=$1 want=$2
    shift 2
    if "$@" -Wall -Wextra -Wpedantic -Werror -I"$include" -DMESH="$mesh" main.c out.c -o main -lm 2>err; then
        check "$name" "$(./main)" "$want"
    else
        fail "$name" "$(head -n 1 err)"
    fi
}
mesh=cube
run cube.obj
compiles "C99 without a warning" "8 12 bad 0 unused 0 normals unit" "$cc" -std=c99
if command -v c++ >/dev/null 2>&1; then
    compiles "C++11 without a warning" "8 12 bad 0 unused 0 normals unit" c++ -x c++ -std=c++11
fi
run cube.obj --name=dice
check "--name" "$(grep -c 'const lmb_mesh dice = {' out.c)" 1
long=a23456789_123456789_123456789_123456789_123456789_123456789_123
mesh=$long
run cube.obj --name "$long"
compiles "a name of 63 characters" "8 12 bad 0 unused 0 normals unit" "$cc" -std=c99
mesh=mesh_3d_
cp cube.obj '3d*.obj'
run '3d*.obj'
compiles "a file name that is no C name" "8 12 bad 0 unused 0 normals unit" "$cc" -std=c99
cp cube.obj int.obj
mesh=mesh_int
run int.obj
compiles "a file name that is a keyword" "8 12 bad 0 unused 0 normals unit" "$cc" -std=c99
cp cube.obj "$(printf 'a??\\')"
run "$(printf 'a??\\')" --name a
mesh=a
check "a file name made harmless for a comment" "$(head -n 1 out.c)" "/* Generated by lmb-mesh from a___; do not edit."
compiles "a file name with a trigraph and a backslash" "8 12 bad 0 unused 0 normals unit" "$cc" -std=c99 -trigraphs

field 250 250 >large.obj
rm -f out.c
"$tool" large.obj -o out.c 2>err
check "progress at each quarter" "$(tr '\n' ' ' <err)" "large.obj: 25 % large.obj: 50 % large.obj: 75 % large.obj: 100 % "
check "no line over 130 columns" "$(awk 'length > 130' out.c | wc -l | tr -d ' ')" 0
mesh=large
compiles "a mesh of 62500 vertices" "62500 124002 bad 0 unused 0 normals unit" "$cc" -std=c99
mkdir -p elsewhere
cp large.obj elsewhere/
"$tool" elsewhere/large.obj -o elsewhere/out.c -q 2>err
check "the same bytes from another folder" "$(cmp out.c elsewhere/out.c && echo same)" same
"$tool" -q -o - large.obj 2>err | cmp - out.c >/dev/null
check "the same bytes on the standard output" "$?" 0

# -------------------------------------------------------------------------------------------------------------- broken on purpose

{
    printf '# \\\nv 0 0 0\r\nv 1 0 0 1\nv 1 1e0 0\nv 0 1 \\\n0\nvn 0 0 1\nvt 0 0\no x\n'
    printf 'f 1//1 2//1 3//-1 4//1\nf -4/1 -3/1 3/1\nf 4 3 1'
} >seed.obj
size=$(wc -c <seed.obj)

# sane WHAT: after a run of in.obj: success with output, or exit status 1 with one line
broken=
sane() {
    if [ "$status" -eq 0 ] && [ -s out.c ]; then good=$((good + 1)); return; fi
    [ "$status" -eq 1 ] && [ ! -e out.c ] && [ "$(wc -l <err)" -eq 1 ] && grep -q '^in\.obj:[0-9][0-9]*: .' err && return
    broken="$broken $1 (exit status $status)"
}
good=0 at=0
while [ "$at" -le "$size" ]; do
    dd if=seed.obj of=in.obj bs=1 count="$at" 2>/dev/null
    run -q in.obj
    sane "$at"
    at=$((at + 1))
done
verdict() { if [ "$broken" ]; then fail "$1" "$broken"; else pass "$1" "$2"; fi; }
verdict "cut off after any byte" "$at files, $good still good"

good=0 broken=
for byte in '\000' '\n' '\\' '/' '-' '9' 'e' '\377' ' '; do
    at=0
    while [ "$at" -lt "$size" ]; do
        { dd if=seed.obj bs=1 count="$at"; printf "$byte"; dd if=seed.obj bs=1 skip=$((at + 1)); } >in.obj 2>/dev/null
        run -q in.obj
        sane "$byte at $at"
        at=$((at + 1))
    done
done
verdict "any byte replaced" "$((9 * size)) files, $good still good"

[ "$failures" -eq 0 ]
