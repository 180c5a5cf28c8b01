/* SPDX-License-Identifier: MIT */
/* Cortex-M from reset to main: the vector table, memory as C expects it, faults that end the program with a code of their own. */
#include "../board.h"
#include "cortex-m.h"

extern uint32_t lmb_stack_top[], lmb_data_load[], lmb_data_begin[], lmb_data_end[], lmb_bss_begin[], lmb_bss_end[];

int main(void);
void lmb_reset(void);
void lmb_fault(void);

/* The first 16 entries are the same on every Cortex-M; those that are missing are reserved. A board that uses interrupts appends
 * its own. */
typedef union vector {
    uint32_t *stack;
    void (*handler)(void);
} vector;

__attribute__((section(".start"), used)) static const vector vectors[16] = {
    [0] = {.stack = lmb_stack_top},    /* from the top down */
    [1] = {.handler = lmb_reset},      /* where the core begins */
    [2] = {.handler = lmb_fault},      /* NMI */
    [3] = {.handler = lmb_fault},      /* hard fault: all faults, unless those below are enabled */
    [4] = {.handler = lmb_fault},      /* memory protection */
    [5] = {.handler = lmb_fault},      /* bus */
    [6] = {.handler = lmb_fault},      /* undefined instructions and the like */
    [7] = {.handler = lmb_fault},      /* security */
    [11] = {.handler = lmb_fault},     /* SVC */
    [12] = {.handler = lmb_fault},     /* debug monitor */
    [14] = {.handler = lmb_fault},     /* PendSV */
    [15] = {.handler = lmb_tick_wraps} /* SysTick */
};

/* Apart from lmb_reset, so that nothing of it can run before the coprocessor is on: compilers use Helium for loops like these. */
__attribute__((noinline)) static void start(void)
{
    uint32_t *to = lmb_data_begin;
    const uint32_t *from = lmb_data_load;
    while (to < lmb_data_end) *to++ = *from++;
    for (to = lmb_bss_begin; to < lmb_bss_end; to++) *to = 0;
    lmb_board_exit(main());
}

/* Reset: the core has loaded the stack pointer from the table. */
void lmb_reset(void)
{
#if defined(__ARM_FP) || defined(__ARM_FEATURE_MVE)
    CPACR |= 0xfu << 20; /* full access to coprocessors 10 and 11: FPU and Helium */
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
    start();
}

/* Any exception that nobody expects: 64 + its number, so a hard fault exits with 67. */
void lmb_fault(void)
{
    uint32_t number;
    __asm__ volatile("mrs %0, ipsr" : "=r"(number));
    lmb_board_print("\nfault\n");
    lmb_board_exit((int)(64 + (number & 63)));
}
