#!/bin/sh
# SPDX-License-Identifier: MIT
# The budgets themselves must turn red: past a budget, and wherever a figure is missing or no number.
set -u
cd "$(dirname "$0")/.." || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

cat >"$work/size.csv" <<'END'
core,configuration,text,rodata,data,bss,stack
m0plus,gloss,3000,400,20,8,500
m0plus,everything,9000,700,0,0,infinite
m3,gloss,3000,400,,0,
END
cat >"$work/cycles.csv" <<'END'
core,scene,model,format,triangles,pixels,instructions_per_pixel,cycles_per_pixel,cycles_min,cycles_max
m0plus,icosphere-320,gloss,rgb565,320,37361,33.5,45.25,,
m0plus,icosphere-320,gloss,rgb888,320,37361,50,60,,
m33,icosphere-320,gloss,rgb565,320,37361,22.5,,,
m0plus,torus,gloss,rgb565,320,37361,33.5,45.25,,
m0plus,torus,gloss,rgb565,320,37361,33.5,46.25,,
END
cat >"$work/kernel_cycles.csv" <<'END'
core,kernel,unit,instructions,cycles
m0plus,span-quadratic,span,70,88
END

# expect WORD NAME LINE...: budgets of these lines; the last verdict must begin with WORD, and the exit status agree.
expect() {
    word=$1 name=$2
    shift 2
    printf '%s\n' "$@" >"$work/budgets.txt"
    got=$(hosttest/budgets.sh "$work" "$work/budgets.txt")
    code=$?
    case $word$code in
    pass0 | FAIL1) right=1 ;;
    *) right=0 ;;
    esac
    if [ $right = 1 ] && echo "$got" | tail -n 1 | grep -q "^$word budget"; then
        echo "pass budgets test: $name"
    else
        echo "FAIL budgets test: $name: exit status $code, $got"
        status=1
    fi
}

expect pass "figures of each kind at their budgets" "m0plus gloss flash 3420" "m0plus gloss ram 28  # comment" "m0plus gloss code 3000" \
    "m0plus gloss tables 400" "m0plus gloss stack 500" "m0plus icosphere-320 gloss cycles_per_pixel 45.25" \
    "m33 icosphere-320 gloss instructions_per_pixel 22.5" "m0plus span-quadratic cycles 88" "m0plus span-quadratic instructions 70"
expect FAIL "flash a byte past its budget" "m0plus gloss flash 3419"
expect FAIL "static RAM a byte past its budget" "m0plus gloss ram 27"
expect FAIL "stack past its budget" "m0plus gloss stack 499"
expect FAIL "cycles per pixel past their budget" "m0plus icosphere-320 gloss cycles_per_pixel 45.2"
expect FAIL "cycles of a span past their budget" "m0plus span-quadratic cycles 87.9"
expect FAIL "infinite stack" "m0plus everything stack 100000"
expect FAIL "a stack that is missing" "m3 gloss stack 100000"
expect FAIL "a sum of which a part is missing" "m3 gloss flash 100000"
expect FAIL "cycles where only instructions are known" "m33 icosphere-320 gloss cycles_per_pixel 1000"
expect FAIL "a core that is missing" "m4 gloss flash 100000"
expect FAIL "a kernel that is missing" "m0plus span-arc cycles 100000"
expect FAIL "two figures of one name" "m0plus torus gloss cycles_per_pixel 1000"
expect FAIL "a budget that is no number" "m0plus gloss flash many"
expect FAIL "no budgets at all" "# none"
rm "$work/kernel_cycles.csv"
got=$(hosttest/budgets.sh "$work" "$work/budgets.txt") && echo "FAIL budgets test: a missing table: $got" && exit 1
echo "pass budgets test: a missing table"
exit $status
