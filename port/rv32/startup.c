/* SPDX-License-Identifier: MIT */
/* RV32 from reset to main: stack, memory as C expects it, traps that end the program with a code of their own. */
#include "../board.h"

extern uint32_t lmb_data_load[], lmb_data_begin[], lmb_data_end[], lmb_bss_begin[], lmb_bss_end[];

int main(void);
void lmb_reset(void);
void lmb_start(void);
void lmb_trap(void);

/* The first instructions after reset: a stack first, C after that. mtvec takes where traps lead to, at a multiple of 4. */
__attribute__((naked, used, section(".start"))) void lmb_reset(void)
{
    __asm__ volatile("la sp, lmb_stack_top\n\t"
                     "la t0, lmb_trap\n\t"
                     "csrw mtvec, t0\n\t"
                     "j lmb_start");
}

__attribute__((used, noreturn)) void lmb_start(void)
{
    uint32_t *to = lmb_data_begin;
    const uint32_t *from = lmb_data_load;
    while (to < lmb_data_end) *to++ = *from++;
    for (to = lmb_bss_begin; to < lmb_bss_end; to++) *to = 0;
    lmb_board_exit(main());
    for (;;) {}
}

/* Any trap, and nobody expects one: 64 + its cause, so EBREAK exits with 67. */
__attribute__((used, aligned(4))) void lmb_trap(void)
{
    uint32_t cause;
    __asm__ volatile("csrr %0, mcause" : "=r"(cause));
    lmb_board_print("\nfault\n");
    lmb_board_exit((int)(64 + (cause & 63)));
}
