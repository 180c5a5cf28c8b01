#!/bin/sh
# SPDX-License-Identifier: MIT
# What follows the stack must turn red: programs with each of the faults that it looks for, from each compiler, and stacks that are
# known. usage: test_stack.sh [PREFIX...]
set -u
cd "$(dirname "$0")/.." || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

verdict() { # verdict STATUS NAME WHY
    if [ "$1" = 0 ]; then echo "pass stack test $prefix $2"; else echo "FAIL stack test $prefix $2: $3"; status=1; fi
}

# image FILE...: an image of the sources $work/FILE.c, as size_image.sh leaves them, in $work/image.
image() {
    rm -rf "$work/image"
    mkdir "$work/image" || exit 1
    # shellcheck disable=SC2086
    (cd "$work/image" && for f in "$@"; do
        ${prefix}gcc $flags -std=gnu99 -Os -ffreestanding -ffunction-sections $frames -c "../$f.c" || exit 1
    done && ${prefix}gcc $flags -nostartfiles -nostdlib -Wl,-e,lmb_f \
        -T "$root/hosttest/size.ld" ./*.o -lgcc -o whole.elf) >"$work/log" 2>&1 ||
        { cat "$work/log"; return 1; }
}
root=$(pwd)
cat >"$work/entry.h" <<'END'
int lmb_f(int);
int lmb_g(int);
int lmb_h(int);
END

# follow ENTRY: its figure.
figure() { hosttest/stack.sh figure "$prefix" "$work/image" "$1" "$work/entry.h"; }

# expect_fail NAME WORD CODE: the chains of CODE must fail, with WORD for a figure.
expect_fail() {
    printf '%s\n' "$3" >"$work/one.c"
    image one || { verdict 1 "$1" "does not compile"; return; }
    got=$(hosttest/stack.sh chains "$prefix" "$work/image" test "$work/entry.h")
    [ $? = 1 ] && echo "$got" | grep -q "^FAIL stack test: .*$2"
    verdict $? "sees $1" "$got"
}

# between NAME LOW ENTRY HIGH: bytes from an entry point of the image that is there.
between() {
    got=$(figure "$3")
    [ "$got" -ge "$2" ] 2>/dev/null && [ "$got" -le "$4" ]
    verdict $? "$1" "$got bytes, expected $2 to $4"
}

declarations='int lmb_f(int); int lmb_g(int); static int (*volatile lmb_pointer)(int);
    static int (*const volatile lmb_table[2])(int);'
# shellcheck disable=SC2048
for prefix in ${*:-arm-none-eabi- riscv64-unknown-elf- xtensa-lx106-elf- avr-}; do
    case $prefix in
    arm-*) flags="-mcpu=cortex-m3 -mthumb" ;;
    riscv*) flags="-march=rv32ec -mabi=ilp32e -misa-spec=2.2 -mcmodel=medany" ;;
    avr-) flags="-mmcu=atmega1284p" ;;
    *) flags= ;;
    esac
    frames=-fstack-usage
    ${prefix}gcc -fcallgraph-info=su -E -x c /dev/null >/dev/null 2>&1 && frames=-fcallgraph-info=su

    expect_fail "a function that calls itself" infinite "$declarations
        int lmb_f(int n) { volatile char room[8]; room[0] = 1; return n ? lmb_f(n - 1) + room[0] : 0; }"
    expect_fail "two functions that call each other" infinite "$declarations
        int lmb_g(int n) { volatile char room[8]; room[0] = 1; return lmb_f(n - 1) + room[0]; }
        int lmb_f(int n) { return n ? lmb_g(n - 1) + n : 0; }"
    expect_fail "a call through a pointer" unknown "$declarations
        int lmb_f(int n) { return lmb_pointer(n) + 1; }"
    expect_fail "a jump through a pointer" unknown "$declarations
        int lmb_f(int n) { return lmb_pointer(n); }"
    expect_fail "a call through a table, two calls down" unknown "$declarations
        static __attribute__((noinline)) int inner(int n) { return lmb_table[n](n) + 1; }
        int lmb_f(int n) { return inner(n + 1) + n; }"
    expect_fail "a frame of variable size" unknown "$declarations
        int lmb_f(int n) { volatile char room[n]; room[n - 1] = 2; return room[n / 2]; }"
    expect_fail "an image without entry points" "no entry point" "int lmb_i(int); int lmb_i(int n) { return n; } int lmb_f;"

    for size in 40 400; do
        echo "$declarations
            static __attribute__((noinline)) int same(int n) { volatile char room[$size]; room[n] = 1; return room[n / 2]; }
            int lmb_$([ $size = 40 ] && echo f || echo g)(int n) { return same(n) + n; }" >"$work/room_$size.c"
    done
    image room_40 room_400
    between "40 bytes in a static function" 44 lmb_f 84
    between "400 bytes in one of the same name in another file" 404 lmb_g 444

    echo "$declarations
        int lmb_h(int); __attribute__((noinline)) int lmb_h(int n) { volatile char room[400]; room[n] = 1; return room[n / 2]; }
        static __attribute__((noinline)) int leaf(int n) { __asm__ volatile(\"\"); return n; }
        int lmb_f(int n) { int a = leaf(n), b = leaf(a); return lmb_h(leaf(a + b) + a + b); }
        int lmb_g(int n) { int a = leaf(n), b = leaf(a); return lmb_h(leaf(a + b) + a) + b; }" >"$work/one.c"
    image one
    last=$(hosttest/stack.sh figure "$prefix" "$work/image" lmb_h "$work/entry.h")
    case $prefix in
    xtensa-*) between "a frame that stays" $((last + 6)) lmb_f $((last + 48)) ;; # no last call is a jump there
    *) between "a frame that is gone before the last call" "$last" lmb_f "$last" ;;
    esac
    between "a frame that stays" $((last + 6)) lmb_g $((last + 48))

    if [ "$prefix" != xtensa-lx106-elf- ]; then # its libgcc has no 64-bit product
        echo "$declarations
            int lmb_f(int n) { return (int)((long long)lmb_g(n) * lmb_g(n + 1) / 3 >> 5); }
            int lmb_g(int n) { return n; }" >"$work/one.c"
        image one
        hosttest/stack.sh chains "$prefix" "$work/image" test "$work/entry.h" | grep -q 'lmb_f [0-9]* > __[a-z0-9_]* [0-9]*\*'
        verdict $? "counts helpers of libgcc" "no helper in the chain"
    fi
done

# Arguments that arrive half in registers: gcc 12 states 8 bytes less than its code takes.
prefix=arm-none-eabi- flags="-mcpu=cortex-m0plus -mthumb" frames=-fcallgraph-info=su
echo "struct three { int a, b, c; }; int lmb_g(const int *); int lmb_f(int, int, struct three);
    int lmb_g(const int *p) { return *p; } int lmb_f(int a, int b, struct three s) { return lmb_g(&s.b) + a + b; }" >"$work/one.c"
image one
stated=$(sed -n 's/.*title: "lmb_f".*n\([0-9]*\) bytes.*/\1/p' "$work/image/one.ci")
between "what its code pushes where the compiler states less ($stated)" $((stated + 8)) lmb_f $((stated + 8))

# The watermark, with a command in place of a target.
echo "int lmb_draw_mesh(int); int lmb_draw_mesh(int n) { volatile char room[100]; room[n] = 1; return room[n / 2]; } int lmb_f;" >"$work/one.c"
image one
echo "lmb_draw_mesh(" >"$work/entry.h"
bytes=$(figure lmb_draw_mesh)
mark() { hosttest/stack.sh watermark "$prefix" "$work/image" test "$@" >"$work/log"; }
mark echo "deepest $bytes"
verdict $? "watermark as predicted" "$(cat "$work/log")"
! mark echo "deepest $((bytes + 1))"
verdict $? "watermark a byte deeper than predicted fails" "$(cat "$work/log")"
! mark echo "deepest $((bytes / 2))"
verdict $? "watermark far from what is predicted fails" "$(cat "$work/log")"
! mark echo "nothing"
verdict $? "an image that measures nothing fails" "$(cat "$work/log")"
! mark sh -c "echo deepest $bytes; exit 3"
verdict $? "an image that ends with a failure fails" "$(cat "$work/log")"
exit $status
