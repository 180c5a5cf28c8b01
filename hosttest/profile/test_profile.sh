#!/bin/sh
# SPDX-License-Identifier: MIT
# Tests the profiler: figures that are known by hand, calls, the check of where control goes, that runs repeat.
# usage: test_profile.sh BUILD-FOLDER; CC, CFLAGS and MAKE from the environment
set -u
cd "$(dirname "$0")/../.." || exit 2
B=$1
MAKE=${MAKE:-make}
CC=${CC:-cc}
profile=$B/profile
work=$profile/tested
targets="m0plus m0 m3 m4 m33 m55 rv32imc rv32i rv32ec lx106 atmega1284p host"
rm -rf "$work"
mkdir -p "$work"

make_quietly() { $MAKE -s B="$B" CC="$CC" CFLAGS="${CFLAGS:-}" SCENE=none "$@"; }

# verdict STATUS NAME TEXT
verdict() {
    if [ "$1" = 0 ]; then echo "pass $2: $3"; else echo "FAIL $2: $3"; fi
}

# same NAME TEXT GOT WANT
same() {
    if [ -n "$4" ] && [ "$3" = "$4" ]; then echo "pass $1: $2"; else echo "FAIL $1: $2; got $3, want $4"; fi
}

# run TARGET NAME [OPTIONS]: the test program of a target under the profiler, into $work/TARGET-NAME.out
run() {
    rm -f "$profile/$1/test.out"
    if make_quietly PROFILE_EXTRA="${3:-}" "$profile/$1/test.out" >"$work/log" 2>&1; then
        mv "$profile/$1/test.out" "$work/$1-$2.out"
    else
        verdict 1 "$1" "the test program does not run"
        tail -n 5 "$work/log"
        return 1
    fi
}

# region FILE TEST: instructions and cycles of the region that was announced by "test TEST"
region() { awk -v test="$2" '$1 == "note" { now = $3 } $1 == "region" && now == test { print $2, $3, $4, $5 }' "$1"; }

# tally FILE TEST FUNCTION: calls, instructions and nominal cycles of it, and with what it calls
tally() {
    awk -v test="$2" -v name="$3" '
        $1 == "note" { now = $3 }
        $1 == "function" && now == test && $11 == name { print $2, $3, $5, $7, $9 }' "$1"
}

# last FILE: regions, steps that cannot be, unknown instructions
last() { awk '$1 == "end" { print $2, $3, $4 }' "$1"; }

for t in $targets; do run "$t" once; done

# ------------------------------------------------------------------------------------------- programs that were counted by hand

# hand TARGET LOOP TREE [WIDE TIMING]: what regions must come to; test_thumb.S and test_avr.S say why
hand() {
    same "$1" "loop of 64 iterations as counted by hand: $2" "$(region "$work/$1-once.out" loop)" "$2"
    same "$1" "tree of calls as counted by hand: $3" "$(region "$work/$1-once.out" tree)" "$3"
    if [ -n "${4:-}" ]; then
        same "$1" "loop in Thumb-2 as counted by hand: $4" "$(region "$work/$1-once.out" loop-wide)" "$4"
        same "$1" "one of each instruction as counted by hand: $5" "$(region "$work/$1-once.out" timing)" "$5"
    fi
}
hand m0plus "515 706 706 706" "48 94 94 94"
hand m0 "515 769 769 769" "48 112 112 112"
hand m3 "515 578 705 832" "48 82 101 120" "386 449 576 703" "33 55 75 92"
hand m4 "515 578 705 832" "48 82 101 120" "322 385 512 639" "33 49 66 81"
hand atmega1284p "452 707 707 707" "39 83 83 83"

rm -f "$profile/m0plus/test.out"
make_quietly MULTIPLIER=32 "$profile/m0plus/test.out" >"$work/log" 2>&1
want="515 2690 2690 2690"
same m0plus "loop with the multiplier of 32 cycles, 706 + 64 x 31: $want" "$(region "$profile/m0plus/test.out" loop)" "$want"
rm -f "$profile/m0plus/test.out"

# ------------------------------------------------------------------------------------------------------------------------ calls

# calls TARGET FUNCTION CALLS SELF... INCLUSIVE...
calls() { same "$1" "$2: calls, by itself, with what it calls: $3" "$(tally "$work/$1-once.out" tree "$2")" "$3"; }
calls m0plus asm_leaf "4 20 24 20 24"
calls m0plus asm_fall "1 1 1 6 7"
calls m0plus asm_tail "1 3 4 8 10"
calls m0plus asm_calls "1 4 14 17 30"
calls m0plus asm_depth "3 14 37 14 37"
calls m0plus test_tree "1 6 14 48 94"
calls atmega1284p asm_leaf "3 9 18 9 18"
calls atmega1284p asm_tail "1 2 3 5 9"
calls atmega1284p asm_calls "1 3 10 11 25"
calls atmega1284p asm_depth "3 11 25 11 25"
calls atmega1284p test_tree "1 14 27 39 83"

# calls_in_c TARGET: direct calls, calls by address, a last call and a recursion; the shape is the same on every core.
calls_in_c() {
    out=$work/$1-once.out
    shape=$(for f in calls leaf tail depth; do tally "$out" calls-10 tree_$f | cut -d ' ' -f 1; done | xargs)
    same "$1" "tree in C: root called once, leaf 30 times, its tail call 10, recursion 8" "$shape" "1 30 10 8"
    root=$(tally "$out" calls-10 main | cut -d ' ' -f 4)
    root=${root:-$(tally "$out" calls-10 counted | cut -d ' ' -f 4)}
    same "$1" "all that is executed is the root's" "$root" "$(region "$out" calls-10 | cut -d ' ' -f 1)"
    last "$out" | grep -q '^[2-6] 0 0$'
    verdict $? "$1" "each address follows from the one before, each opcode is known"
}
for t in $targets; do calls_in_c "$t"; done

# The core's own counter of instructions, which QEMU keeps without the plugin.
counted=$(awk '$2 == "counter" { print $3 - before; before = $3 }' "$work/rv32imc-once.out" | tail -n 1)
profiled=$(awk '$1 == "region" { print $2 - before; before = $2 }' "$work/rv32imc-once.out" | tail -n 1)
same rv32imc "as many instructions as mcycle counts: $counted" "$profiled" "${counted:-none}"

# --------------------------------------------------------------------------------------------------------------- runs that repeat

for t in m0plus m4 atmega1284p; do
    run $t second && run $t third || continue
    cmp -s "$work/$t-once.out" "$work/$t-second.out" && cmp -s "$work/$t-once.out" "$work/$t-third.out"
    verdict $? $t "three runs identical"
done
for t in m0plus m0 m3 m4 m33 m55 rv32imc rv32i rv32ec lx106; do
    run $t each each=on || continue
    cmp -s "$work/$t-once.out" "$work/$t-each.out"
    verdict $? $t "counted block by block and instruction by instruction: the same"
done

# ---------------------------------------------------------------------------------- what is wrong must be noticed: doctored input

make_quietly "$profile/feed" "$profile/report" || verdict 1 feed "cannot be built"

# feed TARGET STREAM LISTING [told]: into $work/fed.out
feed() { "$profile/feed" "$1" "$3" "$2" "$work/fed.out" ${4:-} 2>"$work/log"; }

for t in m0plus atmega1284p; do
    run $t streamed "stream=$work/$t.stream"
    feed $t "$work/$t.stream" "$profile/$t/test.lst" "$([ $t = atmega1284p ] && echo told)"
    cmp -s "$work/$t-once.out" "$work/fed.out"
    verdict $? stream "$t fed to the profiler by a list of addresses: the same"
done
stream=$work/m0plus.stream
listing=$profile/m0plus/test.lst

# doctored TEXT AWK-PROGRAM: the stream, changed, must not pass
doctored() {
    awk "$2" "$stream" >"$work/doctored"
    if cmp -s "$stream" "$work/doctored"; then
        verdict 1 doctored "$1: nothing was changed"
    elif feed m0plus "$work/doctored" "$listing" || last "$work/fed.out" | grep -q ' 0 0$'; then
        verdict 1 doctored "$1 is not noticed"
    else
        verdict 0 doctored "$1 is noticed"
    fi
}

# at FUNCTION N: the address of its Nth instruction, from 0 on
at() {
    awk -v name="<$1>:" -v n="$2" '
        $2 == name { k = n + 1 }
        k && /^ / && --k == 0 { sub(":", "", $1); print $1; exit }' "$listing"
}
load=$(at test_loop 9)
branch=$(at test_loop 14)
leaf=$(at asm_leaf 0)
final=$(at asm_calls 3)
fifth="\$1 == \"$load\" && ++n == 5"
doctored "an instruction left out" "!($fifth)"
doctored "an instruction executed twice" "{ print } $fifth"
doctored "a branch to another address than its target" "!hit { print } { hit = 0 } \$1 == \"$branch\" && ++n == 5 { hit = 1 }"
doctored "a call into the middle of a function" "!(\$1 == \"$leaf\" && ++n == 1)"
doctored "a call by address into the middle of a function" "!(\$1 == \"$leaf\" && ++n == 3)"
doctored "a return behind where the call was" "!hit { print } { hit = 0 } \$1 == \"$final\" && ++n == 1 { hit = 1 }"
doctored "a return into another function" "hit { hit = 0; \$1 = \"$leaf\" } { print } \$1 == \"$final\" && ++n == 1 { hit = 1 }"
doctored "an address that is not in the program" "$fifth { \$1 = \"fffffff0\" } { print }"
doctored "an end before profile_end" "{ print } $fifth { exit }"

sed 's/\tmuls\t/\tmulx\t/' "$listing" >"$work/unknown.lst"
! feed m0plus "$stream" "$work/unknown.lst" && grep -q '^unknown .* mulx' "$work/fed.out"
verdict $? doctored "an opcode that the table lacks is noticed"
! "$profile/report" kernels "$work/fed.out" >"$work/log" 2>&1 &&
    grep -q 'cycle table of m0plus does not know' "$work/log"
verdict $? report "an opcode that the table lacks is an error"
sed 's/:\tf7ff \(....\) \tbl\t/:\tf7ff      \tbl\t/' "$listing" >"$work/short.lst"
! feed m0plus "$stream" "$work/short.lst" && grep -q 'first halfword' "$work/log"
verdict $? doctored "a length that the first halfword denies is an error"
sed '/^end/d' "$work/m0plus-once.out" >"$work/cut.out"
! "$profile/report" table "$work/cut.out" >"$work/log" 2>&1 && grep -q 'not complete' "$work/log"
verdict $? report "a run that was cut short is an error"
