#!/bin/sh
# SPDX-License-Identifier: MIT
# The simulated AVR must end with a message and a status of its own wherever real firmware would go astray without a word.
# usage: test_avr_run.sh AVR_RUN
set -u
cd "$(dirname "$0")/.." || exit 2
run=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

# expect NAME STATUS MESSAGE BODY: a program whose main is BODY, after lmb_board_begin, ends with STATUS and a message that matches.
expect() {
    printf '%s\n' '#include "port/board.h"' '#include "port/avr/harness.h"' '#define REGISTER(a) (*(volatile uint8_t *)(a))' \
        'static uint8_t used[64];' 'uint16_t deep(uint16_t n);' \
        'uint16_t deep(uint16_t n) { volatile uint8_t here[40]; here[n & 31] = 1; return n ? (uint16_t)(deep(n - 1) + here[0]) : 0; }' \
        "int main(void) { lmb_board_begin(); used[1] = 1; $4 return used[0]; }" >"$work/main.c"
    if ! avr-gcc -std=gnu99 -mmcu=atmega328p -Os -Wall -Wextra -Werror -ffreestanding -I. -nostartfiles -nostdlib -L linker \
        -T linker/atmega328p.ld "$work/main.c" port/avr/*.c port/demo/memory.c -lgcc -o "$work/main.elf" >"$work/log" 2>&1; then
        echo "FAIL avr-run $1: does not build: $(head -n 1 "$work/log")"
        status=1
        return
    fi
    (cd "$work" && timeout 20 "$run" -v atmega328p main.elf >out 2>log)
    got=$?
    if [ $got = "$2" ] && grep -q "$3" "$work/log"; then
        echo "pass avr-run $1: status $got"
    else
        echo "FAIL avr-run $1: status $got instead of $2; $(tr '\n' ' ' <"$work/log")"
        status=1
    fi
}

expect "sound program" 0 'stack [0-9]* bytes, [0-9]* left' 'deep(3);'
expect "stack in static data" 66 'the stack has reached static data' 'deep(60);'
expect "jump to zero" 65 'began a second time' '((void (*)(void))0)();'
expect "load beyond RAM" 65 'the core crashed' 'used[0] = REGISTER(0x4000);'
expect "sleep for ever" 65 'sleeps for ever' '__asm__ volatile("ldi r24, 5\n\tout 0x33, r24\n\tcli\n\tsleep" ::: "r24");'
expect "interrupt nobody expects" 64 'cycles' 'REGISTER(0x6e) = 1; REGISTER(0x45) = 1; __asm__ volatile("sei"); for (;;) {}'
expect "unknown order" 67 'harness.h does not know' 'REGISTER(LMB_HARNESS_ORDER) = 99;'
expect "byte without an order" 67 'no order asked' 'REGISTER(LMB_HARNESS_ORDER) = LMB_ORDER_CLOSE; REGISTER(LMB_HARNESS_BYTE) = 1;'
expect "write to no file" 1 'cycles' 'lmb_board_write(used, 4); if (lmb_board_close()) return 1;'
expect "full disk" 1 'cycles' 'lmb_board_open("/dev/full"); lmb_board_write(used, 64); if (lmb_board_close()) return 1;'
exit $status
