/* SPDX-License-Identifier: MIT */
/* Console, files and exit of a board whose debugger or emulator serves semihosting (Arm's, which RISC-V has taken over). To be included
 * once, by the board.c that defines semihost: it asks the debugger for an operation and returns its answer. */
#ifndef LMB_SEMIHOSTING_H
#define LMB_SEMIHOSTING_H

#include "board.h"

static int semihost(int operation, const void *argument);

enum { SYS_OPEN = 0x01, SYS_CLOSE = 0x02, SYS_WRITE0 = 0x04, SYS_WRITE = 0x05, SYS_EXIT_EXTENDED = 0x20 };
enum { OPEN_WB = 5, APPLICATION_EXIT = 0x20026 };

static int file;

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

#endif
