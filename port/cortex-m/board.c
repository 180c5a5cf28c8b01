/* SPDX-License-Identifier: MIT */
/* Cortex-M under a debugger or an emulator: console, files and exit by semihosting, the counter by SysTick.
 *
 * Semihosting asks the debugger with BKPT 0xAB: operation in r0, its argument in r1, the answer in r0. Without a debugger that
 * is a fault; on a board that runs alone a serial port takes the place of semihost() here. */
#include "../semihosting.h"
#include "cortex-m.h"

static volatile uint32_t wraps;

static int semihost(int operation, const void *argument)
{
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

/* SysTick counts processor cycles down through 24 bits and interrupts when it starts over. */
void lmb_board_begin(void)
{
    SYSTICK_RELOAD = 0xffffff;
    SYSTICK_VALUE = 0;
    SYSTICK_CONTROL = 7; /* processor clock, interrupt, on */
}

void lmb_tick_wraps(void) { wraps++; }

/* Processor cycles since lmb_board_begin; wants interrupts on. A wrap counts from the moment that SysTick shows 0: until its
 * interrupt has run, and if it ran in between, the reading is taken again. Emulators count time instead of cycles. */
uint32_t lmb_board_cycles(void)
{
    uint32_t above, below;
    do {
        above = wraps;
        below = SYSTICK_VALUE;
    } while (above != wraps || (ICSR & ICSR_TICK_PENDING));
    return above * 0x1000000 - below + (below ? 0x1000000 : 0);
}
