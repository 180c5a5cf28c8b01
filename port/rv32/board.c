/* SPDX-License-Identifier: MIT */
/* RV32 under a debugger or an emulator: console, files and exit by semihosting, the counter is mcycle.
 *
 * Semihosting asks the debugger with EBREAK between two shifts of x0 that do nothing, so that it is told from a breakpoint:
 * operation in a0, its argument in a1, the answer in a0. A board that runs alone has a serial port in place of semihost().
 * Nothing here needs a register beyond x15, so it serves RV32E as well. */
#include "../board.h"

enum { SYS_OPEN = 0x01, SYS_CLOSE = 0x02, SYS_WRITE0 = 0x04, SYS_WRITE = 0x05, SYS_EXIT_EXTENDED = 0x20 };
enum { OPEN_WB = 5, APPLICATION_EXIT = 0x20026 };

static int file;

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

void lmb_board_print(const char *text) { semihost(SYS_WRITE0, text); }

int lmb_board_open(const char *name)
{
    uintptr_t argument[3] = {(uintptr_t)name, OPEN_WB, 0};
    while (name[argument[2]]) argument[2]++;
    file = semihost(SYS_OPEN, argument);
    return file == -1 ? -1 : 0;
}

/* SYS_WRITE answers with the bytes that it has not written. */
int lmb_board_write(const void *bytes, size_t n)
{
    const uintptr_t argument[3] = {(uintptr_t)file, (uintptr_t)bytes, n};
    return semihost(SYS_WRITE, argument) == 0 ? 0 : -1;
}

int lmb_board_close(void)
{
    const uintptr_t argument[1] = {(uintptr_t)file};
    return semihost(SYS_CLOSE, argument) == 0 ? 0 : -1;
}

void lmb_board_exit(int status)
{
    const uintptr_t argument[2] = {APPLICATION_EXIT, (uintptr_t)status};
    for (;;) semihost(SYS_EXIT_EXTENDED, argument);
}
