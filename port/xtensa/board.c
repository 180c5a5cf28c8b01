/* SPDX-License-Identifier: MIT */
/* Xtensa LX106 (ESP8266) under a simulator: console, files and exit by SIMCALL, the counter is CCOUNT.
 *
 * SIMCALL asks the simulator: operation in a2, its arguments in a3 to a5, the answer in a2. On silicon it does nothing; a board
 * that runs alone has a serial port in place of simcall(). */
#include "../board.h"

enum { SYS_EXIT = 1, SYS_WRITE = 4, SYS_OPEN = 5, SYS_CLOSE = 6 };
enum { OPEN_WRITE = 1, OPEN_CREATE = 0x40, OPEN_TRUNCATE = 0x200 }; /* as Linux numbers them: QEMU hands them on */
enum { CONSOLE = 1 };

static int file;

static int simcall(int operation, uintptr_t first, uintptr_t second, uintptr_t third)
{
    register int a2 __asm__("a2") = operation;
    register uintptr_t a3 __asm__("a3") = first, a4 __asm__("a4") = second, a5 __asm__("a5") = third;
    __asm__ volatile("simcall" : "+r"(a2), "+r"(a3) : "r"(a4), "r"(a5) : "memory");
    return a2;
}

void lmb_board_begin(void) {}

/* Processor cycles since reset, modulo 2^32. Emulators count time instead. */
uint32_t lmb_board_cycles(void)
{
    uint32_t cycles;
    __asm__ volatile("rsr %0, ccount" : "=r"(cycles));
    return cycles;
}

/* SYS_WRITE may write less than it was given. */
static int write_all(int to, const void *bytes, size_t n)
{
    const char *next = bytes;
    while (n > 0) {
        int written = simcall(SYS_WRITE, (uintptr_t)to, (uintptr_t)next, n);
        if (written <= 0) return -1;
        next += written;
        n -= (size_t)written;
    }
    return 0;
}

void lmb_board_print(const char *text)
{
    size_t n = 0;
    while (text[n]) n++;
    write_all(CONSOLE, text, n);
}

int lmb_board_open(const char *name)
{
    file = simcall(SYS_OPEN, (uintptr_t)name, OPEN_WRITE | OPEN_CREATE | OPEN_TRUNCATE, 0644);
    return file < 0 ? -1 : 0;
}

int lmb_board_write(const void *bytes, size_t n) { return write_all(file, bytes, n); }

int lmb_board_close(void) { return simcall(SYS_CLOSE, (uintptr_t)file, 0, 0) < 0 ? -1 : 0; }

void lmb_board_exit(int status)
{
    for (;;) simcall(SYS_EXIT, (uintptr_t)status, 0, 0);
}
