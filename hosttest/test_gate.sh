#!/bin/sh
# SPDX-License-Identifier: MIT
# The gate itself must turn red: objects with each of the faults that it looks for.
set -u
cd "$(dirname "$0")/.." || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

# expect_fail NAME CODE: compiles CODE for host and Cortex-M0+ and wants the gate to refuse both.
expect_fail() {
    printf '%s\n' "$2" >"$work/fault.c"
    rm -f "$work"/*.a
    gcc -std=c99 -O1 -c "$work/fault.c" -o "$work/host.o" && ar rcs "$work/host.a" "$work/host.o" &&
        arm-none-eabi-gcc -mcpu=cortex-m0plus -mthumb -std=c99 -O1 -ffreestanding -c "$work/fault.c" -o "$work/m0plus.o" &&
        arm-none-eabi-ar rcs "$work/m0plus.a" "$work/m0plus.o" || { echo "FAIL gate test $1: does not compile"; status=1; return; }
    if hosttest/gate.sh host "" "$work/host.a" >/dev/null || hosttest/gate.sh m0plus arm-none-eabi- "$work/m0plus.a" >/dev/null; then
        echo "FAIL gate test: does not see $1"
        status=1
    else
        echo "pass gate test: sees $1 on host and Cortex-M0+"
    fi
}

expect_fail "a division" 'int lmb_f(int a, int b); int lmb_f(int a, int b) { return a / b; }'
expect_fail "a remainder" 'unsigned lmb_f(unsigned a, unsigned b); unsigned lmb_f(unsigned a, unsigned b) { return a % b; }'
expect_fail "a float product" 'float lmb_f(float a, float b); float lmb_f(float a, float b) { return a * b; }'
expect_fail "a double from an integer" 'int lmb_f(int a); int lmb_f(int a) { return (int)((double)a * 1.5); }'
expect_fail "a square root" 'double sqrt(double); int lmb_f(int a); int lmb_f(int a) { return (int)sqrt(a); }'
expect_fail "a heap" 'void *malloc(__SIZE_TYPE__); void *lmb_f(void); void *lmb_f(void) { return malloc(8); }'
expect_fail "a global that can be written" 'int lmb_count; int lmb_f(void); int lmb_f(void) { return lmb_count++; }'
expect_fail "a symbol without the prefix" 'int helper(int a); int helper(int a) { return a + 1; }'
exit $status
