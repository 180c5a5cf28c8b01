/* SPDX-License-Identifier: MIT */
/* RV32 under a debugger or an emulator: console, files and exit by semihosting, the counter is mcycle.
 *
 * Semihosting asks the debugger with EBREAK between two shifts of x0 that do nothing, so that it is told from a breakpoint:
 * operation in a0, its argument in a1, the answer in a0. A board that runs alone has a serial port in place of semihost().
 * Nothing here needs a register beyond x15, so it serves RV32E as well. */
#include "../semihosting.h"

/* The three instructions are never compressed and lie in one page, as the debugger expects. */
static int semihost(int operation, const void *argument)
{
    register int a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = argument;
    __asm__ volatile(".balign 16\n\t.option push\n\t.option norvc\n\t"
                     "slli x0, x0, 0x1f\n\tebreak\n\tsrai x0, x0, 7\n\t.option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return a0;
}

void lmb_board_begin(void) {}

/* Processor cycles since reset, modulo 2^32. Emulators count instructions instead. */
uint32_t lmb_board_cycles(void)
{
    uint32_t cycles;
    __asm__ volatile("csrr %0, mcycle" : "=r"(cycles));
    return cycles;
}
