/* SPDX-License-Identifier: MIT */
/* AVR from reset to main: vectors, stack, interrupts that end the program with a code of their own.
 *
 * The sections .init0 to .init9 run one after another (linker/avr-sections.ld). libgcc puts what copies .data and clears .bss
 * into .init4, wherever a file has such data. */
#include "../board.h"

int main(void);
void lmb_fault(void);
void lmb_start(void);
void abort(void);

/* Reset, and more interrupts than any of these chips has. An interrupt that nobody expects is a fault. */
__asm__(".section .vectors, \"ax\", @progbits\n\t"
        "jmp lmb_reset\n\t"
        ".rept 34\n\t"
        "jmp lmb_fault\n\t"
        ".endr\n"
        ".section .init2, \"ax\", @progbits\n"
        ".global lmb_reset\n"
        "lmb_reset:\n\t"
        "clr r1\n\t"
        "out 0x3f, r1\n\t" /* SREG: interrupts off */
        "ldi r28, lo8(lmb_stack_top)\n\t"
        "ldi r29, hi8(lmb_stack_top)\n\t"
        "out 0x3e, r29\n\t" /* SPH */
        "out 0x3d, r28\n"   /* SPL */
        ".section .init9, \"ax\", @progbits\n\t"
        "jmp lmb_start\n\t"
        ".text");

__attribute__((used)) void lmb_start(void) { lmb_board_exit(main()); }

__attribute__((used)) void lmb_fault(void)
{
    __asm__ volatile("clr r1");
    lmb_board_print("\nfault\n");
    lmb_board_exit(64);
}

/* What avr-gcc makes of __builtin_trap: the core has no instruction that faults. */
void abort(void) { lmb_fault(); }
