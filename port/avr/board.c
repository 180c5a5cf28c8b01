/* SPDX-License-Identifier: MIT */
/* AVR under a simulator: console, files, cycle stamps and exit through harness.h. A board that runs alone has a serial port in
 * place of give(), and a timer in place of the cycle stamp. */
#include "../board.h"
#include "harness.h"

#define REGISTER(address) (*(volatile uint8_t *)(address))

extern uint8_t lmb_bss_end[];

static void order(enum lmb_harness_order what) { REGISTER(LMB_HARNESS_ORDER) = (uint8_t)what; }
static void give(uint8_t byte) { REGISTER(LMB_HARNESS_BYTE) = byte; }
static uint8_t answer(void) { return REGISTER(LMB_HARNESS_ANSWER); }

static void give_text(const char *text)
{
    while (*text) give((uint8_t)*text++);
}

void lmb_board_begin(void)
{
    uintptr_t end = (uintptr_t)lmb_bss_end;
    order(LMB_ORDER_FLOOR);
    give((uint8_t)end);
    give((uint8_t)(end >> 8));
}

/* Processor cycles since reset, modulo 2^32, exact. */
uint32_t lmb_board_cycles(void)
{
    uint32_t cycles;
    order(LMB_ORDER_CYCLES);
    cycles = answer();
    cycles |= (uint32_t)answer() << 8;
    cycles |= (uint32_t)answer() << 16;
    return cycles | (uint32_t)answer() << 24;
}

void lmb_board_print(const char *text)
{
    order(LMB_ORDER_CONSOLE);
    give_text(text);
}

int lmb_board_open(const char *name)
{
    order(LMB_ORDER_NAME);
    give_text(name);
    order(LMB_ORDER_OPEN);
    return answer() ? -1 : 0;
}

/* What could not be written shows when the file is closed. */
int lmb_board_write(const void *bytes, size_t n)
{
    const uint8_t *next = bytes;
    order(LMB_ORDER_FILE);
    while (n-- > 0) give(*next++);
    return 0;
}

int lmb_board_close(void)
{
    order(LMB_ORDER_CLOSE);
    return answer() ? -1 : 0;
}

void lmb_board_exit(int status)
{
    order(LMB_ORDER_EXIT);
    give((uint8_t)status);
    for (;;) {}
}
