#!/bin/sh
# SPDX-License-Identifier: MIT
# The gate itself must turn red: objects and images with each of the faults that it looks for, for nine instruction sets; and it
# must let pass what is in order.
set -u
cd "$(dirname "$0")/.." || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

# core NAME PREFIX FLAGS: sets what one core is compiled and linked with.
cores="host m0plus m3 m4f rv32imc rv32imfc rv32i avr xtensa"
core() {
    libs=-lgcc
    case $1 in
    host) prefix= flags= ;;
    m0plus) prefix=arm-none-eabi- flags="-mcpu=cortex-m0plus -mthumb" ;;
    m3) prefix=arm-none-eabi- flags="-mcpu=cortex-m3 -mthumb" ;;
    m4f) prefix=arm-none-eabi- flags="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard" ;;
    rv32imc) prefix=riscv64-unknown-elf- flags="-march=rv32imc -mabi=ilp32 -misa-spec=2.2" ;;
    rv32imfc) prefix=riscv64-unknown-elf- flags="-march=rv32imfc -mabi=ilp32f -misa-spec=2.2" ;;
    rv32i) prefix=riscv64-unknown-elf- flags="-march=rv32i -mabi=ilp32 -misa-spec=2.2" ;;
    avr) prefix=avr- flags="-mmcu=atmega1284p" libs="-lm -lgcc" ;;
    xtensa) prefix=xtensa-lx106-elf- flags= ;;
    esac
}

# compile CORE CODE: CODE into object.o and object.a.
compile() {
    core "$1"
    printf '%s\n' "$2" >"$work/object.c"
    rm -f "$work/object.a"
    "${prefix}gcc" $flags -std=c99 -Os -ffreestanding -c "$work/object.c" -o "$work/object.o" &&
        "${prefix}ar" rcs "$work/object.a" "$work/object.o"
}

# judge CORE [IMAGE]: what the gate says of object.a.
judge() { hosttest/gate.sh "$1" "$prefix" "$calls" "$work/object.a" ${2:+"$2"}; }

verdict() { # verdict NAME FAULTS
    if [ -z "$2" ]; then echo "pass gate test: $1"; else echo "FAIL gate test: $1, but not:$2"; status=1; fi
}

# expect NAME COMPLAINT CODE: on every core, the gate must refuse CODE and say why in words that match COMPLAINT.
expect() {
    missed=
    calls=
    for c in $cores; do
        compile "$c" "$3" || missed="$missed $c (does not compile)"
        judge "$c" | grep -qE "^FAIL gate $c: ($2)" || missed="$missed $c"
    done
    verdict "sees $1 on $cores" "$missed"
}

# expect_image NAME CODE: CODE in the part of an image that is not the library; the compiler's helpers come with it.
expect_image() {
    missed=
    calls=
    for c in m0plus m3 rv32imc rv32i avr; do
        compile "$c" 'int lmb_f(int a); int lmb_f(int a) { return a + 1; }'
        printf '%s\n' "$2" >"$work/board.c"
        "${prefix}gcc" $flags -std=c99 -Os -ffreestanding -nostdlib -nostartfiles -Wl,-e,main "$work/board.c" "$work/object.o" \
            $libs -o "$work/image.elf" 2>"$work/link" || missed="$missed $c (does not link: $(head -n 1 "$work/link"))"
        judge "$c" "$work/image.elf" 2>/dev/null |
            grep -qE "^FAIL gate $c: (the image holds|instructions in the image: )" || missed="$missed $c"
    done
    verdict "sees $1 in an image for m0plus m3 rv32imc rv32i avr" "$missed"
}

calls= missed=
for c in $cores; do
    compile "$c" 'int lmb_f(int a); int lmb_f(int a) { return a - (a << 1); }'
    judge "$c" >"$work/said" || missed="$missed $c ($(grep ^FAIL "$work/said"))"
done
verdict "lets pass what is in order on $cores" "$missed"

calls="__aeabi_lmul __muldi3 __mulsi3" missed=
for c in m0plus rv32i xtensa; do
    compile "$c" 'long long lmb_f(long long a, long long b); long long lmb_f(long long a, long long b) { return a * b; }'
    judge "$c" >"$work/said" || missed="$missed $c ($(grep ^FAIL "$work/said"))"
    calls_before=$calls calls="__aeabi_lmulx __muldi __mul*si3x"
    judge "$c" | grep -q "^FAIL gate $c: calls __" || missed="$missed $c (not allowed)"
    calls=$calls_before
done
calls="__*"
compile rv32i 'float lmb_f(float a); float lmb_f(float a) { return a * a; }'
judge rv32i | grep -q "^FAIL gate rv32i: calls __mulsf3" || missed="$missed float products under a wide name"
verdict "allows the calls that it is told, and no others" "$missed"

divides='calls __|instructions: '
expect "a division" "$divides" 'int lmb_f(int a, int b); int lmb_f(int a, int b) { return a / b; }'
expect "a remainder" "$divides" 'unsigned lmb_f(unsigned a, unsigned b); unsigned lmb_f(unsigned a, unsigned b) { return a % b; }'
expect "a long division" "$divides" \
    'long long lmb_f(long long a, long long b); long long lmb_f(long long a, long long b) { return a / b; }'
expect "a float product" "$divides" 'float lmb_f(float a, float b); float lmb_f(float a, float b) { return a * b; }'
expect "a double from an integer" "$divides" 'int lmb_f(int a); int lmb_f(int a) { return (int)((double)a * 1.5); }'
expect "a square root" 'calls .*sqrt' 'double sqrt(double); int lmb_f(int a); int lmb_f(int a) { return (int)sqrt(a); }'
expect "a heap" 'calls malloc' 'void *malloc(__SIZE_TYPE__); void *lmb_f(void); void *lmb_f(void) { return malloc(8); }'
expect "a global that can be written" 'static data' 'int lmb_count; int lmb_f(void); int lmb_f(void) { return lmb_count++; }'
expect "a symbol without the prefix" 'external symbols' 'int helper(int a); int helper(int a) { return a + 1; }'
everywhere=$cores
cores=avr
expect "a table that AVR copies to RAM" 'static data: .rodata' \
    'int lmb_f(int i); int lmb_f(int i) { static const char t[9] = "abcdefgh"; return t[i]; }'
cores=$everywhere

main='int main(void); int lmb_f(int a);'
expect_image "a division" "$main volatile int a; int main(void) { return lmb_f(a) / a; }"
expect_image "a division by ten" "$main volatile int a; int main(void) { return lmb_f(a) / 10 + lmb_f(a) % 7; }"
expect_image "a float sum" "$main volatile float a; int main(void) { return lmb_f((int)(a + 0.5f)); }"
expect_image "a double product" "$main volatile double a; int main(void) { a = a * a; return lmb_f(1); }"
exit $status
