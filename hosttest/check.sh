#!/bin/sh
# SPDX-License-Identifier: MIT
# Everything that must hold, in about the order in which it would break; ends with "N passed, N failed". Called by make check.
# Each property is one line that begins with pass or FAIL; this script prints and counts them.
set -u
cd "$(dirname "$0")/.." || exit 2
MAKE=${MAKE:-make}
CC=${CC:-cc}
build=build/check
log=$build/log
rm -rf "$build/failed" "$log"
mkdir -p "$log"
: >"$log/verdicts"
strict="-Werror"
started=$(date +%s)

say() { printf '== %s (%s s)\n' "$1" "$(($(date +%s) - started))"; }

# verdict STATUS NAME TEXT [LOG]: one property of our own.
verdict() {
    if [ "$1" = 0 ]; then
        echo "pass $2: $3"
    else
        echo "FAIL $2: $3"
        [ -n "${4:-}" ] && tail -n 15 "$4"
    fi | tee -a "$log/verdicts"
}

# build VARIANT CC CFLAGS LDFLAGS TARGET...: quiet; a warning is an error.
build() {
    variant=$1 cc=$2 cflags=$3 ldflags=$4
    shift 4
    $MAKE -s -j2 B="$build/$variant" CC="$cc" CFLAGS="$strict $cflags" LDFLAGS="$ldflags" "$@" >"$log/build-$variant" 2>&1
    status=$?
    verdict $status "build $variant" "$cc $cflags, warnings as errors" "$log/build-$variant"
    return $status
}

# run NAME COMMAND...: a test program whose own lines count; a crash counts as a failure.
run() {
    name=$1
    shift
    "$@" >"$log/$name" 2>&1
    status=$?
    grep -aE '^(pass|FAIL) ' "$log/$name" | sed "s/^\(pass\|FAIL\) /\1 $name, /" >"$log/$name.verdicts"
    if ! grep -q . "$log/$name.verdicts"; then
        { echo "FAIL $name: no verdict, exit status $status"; tail -n 5 "$log/$name"; } >>"$log/$name.verdicts"
    elif [ $status != 0 ] && ! grep -aq "^FAIL" "$log/$name.verdicts"; then
        { echo "FAIL $name: exit status $status after the last verdict"; tail -n 15 "$log/$name"; } >>"$log/$name.verdicts"
    fi
}

# show NAME...: the verdicts that run has found.
show() {
    for name in "$@"; do cat "$log/$name.verdicts"; done | tee -a "$log/verdicts"
}

# suite VARIANT: all test programs of a variant, two at a time, printed in order.
suite() {
    variant=$1
    tests=$(cd hosttest && ls test_*.c | sed 's/\.c$//')
    waiting=
    for t in $tests; do
        run "$variant-$t" "$build/$variant/bin/$t" &
        if [ -n "$waiting" ]; then wait "$waiting"; fi
        waiting=$!
    done
    wait
    # shellcheck disable=SC2046
    show $(for t in $tests; do echo "$variant-$t"; done)
}

lines() { grep -aE '^(pass|FAIL) ' | tee -a "$log/verdicts"; }

say "public headers alone"
for h in firmware/lambent.h port/fill.h port/board.h; do
    for std in c99 c11 c++11; do
        case $std in c++*) lang=c++ ;; *) lang=c ;; esac
        echo "#include \"$h\"" | $CC -x $lang -std=$std -Wall -Wextra -Wpedantic -Werror -I. -fsyntax-only - 2>"$log/header"
        verdict $? "header" "$h as $std" "$log/header"
    done
done

say "gcc -O2"
build gcc gcc "" "" tests tools models demo report_tools && suite gcc
build gcc gcc "" "" "$build/gcc/bin/replicate" "$build/gcc/bin/chart_data" "$build/gcc/bin/stability"
run lmb-mesh hosttest/test_obj.sh "$build/gcc/bin/lmb-mesh" gcc
show lmb-mesh
run lmb-render hosttest/test_render.sh "$build/gcc/bin/lmb-render"
show lmb-render
build gcc gcc "" "" models "$build/gcc/bin/estimate_judge"
run lmb-estimate hosttest/test_estimate.sh "$build/gcc/bin/lmb-estimate" "$build/gcc/models/torus.obj"
show lmb-estimate

say "plans of a million triangles"
run million "$build/gcc/bin/test_plan" 2 1000000
show million

say "README example"
run readme hosttest/test_readme.sh "$build/gcc" gcc
show readme
run flow hosttest/test_flow.sh
show flow

say "documents"
hosttest/test_docs.sh 2>&1 | lines

say "configurations"
run configurations hosttest/test_configs.sh "$build/gcc" gcc
show configurations

say "tables"
$MAKE -s B="$build/gcc" CC=gcc check-tables 2>&1 | lines

say "clang, and identical frames at every optimisation"
build clang clang "" "" tests demo
run clang-test_arc "$build/clang/bin/test_arc"
run clang-test_beam "$build/clang/bin/test_beam"
run clang-test_raster "$build/clang/bin/test_raster" 2
run clang-test_terms "$build/clang/bin/test_terms" 2
show clang-test_arc clang-test_beam clang-test_raster clang-test_terms
for o in O0 Os O3; do build gcc-$o gcc "-$o" "" demo; done
build clang-O3 clang "-O3" "" demo
build halves gcc "-DLMB_LONG_PRODUCTS=0" "" demo "$build/halves/bin/test_raster" "$build/halves/bin/test_mesh"
for v in clang gcc-O0 gcc-Os gcc-O3 clang-O3 halves; do
    different=$(for f in "$build"/gcc/demo/*.bmp; do cmp -s "$f" "$build/$v/demo/$(basename "$f")" || basename "$f"; done)
    verdict "$([ -z "$different" ]; echo $?)" "frames $v" "byte for byte those of gcc -O2${different:+; but not $(echo $different)}"
done

run halves-test_raster "$build/halves/bin/test_raster" 3
run halves-test_mesh "$build/halves/bin/test_mesh" 3
show halves-test_raster halves-test_mesh

say "checked arithmetic"
build checked gcc "-DLMB_CHECKED" "" tests && suite checked

say "AddressSanitizer and UndefinedBehaviorSanitizer"
if build sanitized gcc "-O1 -fsanitize=address,undefined -fno-sanitize-recover=all" "-fsanitize=address,undefined" tests tools; then
    suite sanitized
    run sanitized-lmb-mesh hosttest/test_obj.sh "$build/sanitized/bin/lmb-mesh" gcc
    run sanitized-lmb-render hosttest/test_render.sh "$build/sanitized/bin/lmb-render"
    build sanitized gcc "-O1 -fsanitize=address,undefined -fno-sanitize-recover=all" "-fsanitize=address,undefined" models
    run sanitized-lmb-estimate hosttest/test_estimate.sh "$build/sanitized/bin/lmb-estimate" "$build/sanitized/models/torus.obj"
    show sanitized-lmb-mesh sanitized-lmb-render sanitized-lmb-estimate
fi

say "no division, no square root, no float"
hosttest/gate.sh library-gcc "" "" "$build/gcc/liblambent.a" 2>&1 | lines
hosttest/gate.sh library-clang "" "" "$build/clang/liblambent.a" 2>&1 | lines
hosttest/test_gate.sh 2>&1 | lines

# on_targets WHAT: make WHAT for all targets. Its lines count; so does an end without any that says why.
on_targets() {
    $MAKE -k -s -j2 B="$build/targets" CC=gcc CFLAGS="$strict" "$1" >"$log/$1" 2>&1
    status=$?
    lines <"$log/$1"
    if [ $status != 0 ] && ! grep -aq "^FAIL" "$log/$1"; then verdict $status "$1" "make $1 for all targets" "$log/$1"; fi
}

say "firmware for all targets"
$MAKE -k -s -j2 B="$build/targets" CC=gcc CFLAGS="$strict" firmware >"$log/firmware" 2>&1
verdict $? "build firmware" "warnings as errors" "$log/firmware"
grep -a ' rodata ' "$log/firmware"
say "boards"
on_targets boards
say "frames of all targets, byte for byte those of the host"
on_targets frames
hosttest/test_frames.sh "$build/targets" 2>&1 | lines
MAKE="$MAKE" hosttest/test_porting.sh "$build/targets" 2>&1 | lines
say "mathematics, lobes, arcs and every model on all targets, as on the host"
on_targets digests
hosttest/test_avr_run.sh "$build/targets/bin/avr-run" 2>&1 | lines
say "no division, no square root, no float on any target"
on_targets gate

say "sizes"
$MAKE -k -s -j2 B="$build/targets" size >"$log/size" 2>&1
verdict $? "size" "flat, diffuse, gloss and everything on all targets" "$log/size"
cat "$log/size"
say "stacks"
hosttest/test_stack.sh 2>&1 | lines
on_targets stack

say "the profiler"
MAKE="$MAKE" CC=gcc CFLAGS="$strict" run profiler hosttest/profile/test_profile.sh "$build/targets"
show profiler

say "reports and the README's figures"
mkdir -p "$build/report"
for t in lobe arc span image plan; do
    "$build/gcc/bin/report_$t" >"$build/report/$t.csv" 2>"$log/report"
    verdict $? "report" "$t.csv, $(wc -l <"$build/report/$t.csv") lines" "$log/report"
done
for t in size cycles kernel_cycles growth growth_model estimate pareto; do
    $MAKE -s -j2 B="$build/targets" CC=gcc CFLAGS="$strict" "$build/targets/report/$t.csv" >"$log/report" 2>&1 &&
        cp "$build/targets/report/$t.csv" "$build/report"
    verdict $? "report" "$t.csv, $(grep -c , "$build/report/$t.csv") lines" "$log/report"
done
hosttest/figures.sh "$build/report" --check 2>&1 | lines
"$build/gcc/bin/replicate" --csv "$build/report" >"$build/report/papers.csv" 2>"$log/report"
verdict $? "report" "papers.csv, $(grep -c , "$build/report/papers.csv") lines" "$log/report"
"$build/gcc/bin/stability" --csv >"$build/report/stability.csv" 2>"$log/report"
verdict $? "report" "stability.csv, $(grep -c , "$build/report/stability.csv") lines" "$log/report"
hosttest/replicate.sh "$build/gcc/bin" "$build/report" --check 2>&1 | lines
hosttest/choosing.sh "$build/report" --check 2>&1 | lines
hosttest/test_choosing.sh "$build/gcc" gcc 2>&1 | lines
hosttest/test_pareto.sh "$build/report/pareto.csv" >"$log/pareto" 2>&1
lines <"$log/pareto"
grep -a '^  missed' "$log/pareto"
hosttest/pareto/page.sh "$build/report/pareto.csv" --check 2>&1 | lines
hosttest/test_charts.sh "$build/gcc/bin/chart_data" "$build/charts" 2>&1 | lines
say "estimates beside the profiler, and the bytes that go with them"
on_targets estimate
hosttest/estimate/growth.sh "$build/gcc/bin/estimate_judge" "$build/report" --check 2>&1 | lines
on_targets estimate_flash

say "budgets"
hosttest/test_budgets.sh 2>&1 | lines
hosttest/budgets.sh "$build/report" hosttest/budgets.txt 2>&1 | lines

passed=$(grep -ac '^pass ' "$log/verdicts")
failed=$(grep -ac '^FAIL ' "$log/verdicts")
say "done"
if [ "$failed" != 0 ]; then grep -a '^FAIL ' "$log/verdicts"; fi
echo "$passed passed, $failed failed"
[ "$failed" = 0 ] && [ "$passed" != 0 ]
