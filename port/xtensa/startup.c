/* SPDX-License-Identifier: MIT */
/* Xtensa LX106 from reset to main: vectors, stack, memory as C expects it, exceptions that end the program with a code of their
 * own. */
#include "../board.h"

extern uint32_t lmb_data_load[], lmb_data_begin[], lmb_data_end[], lmb_bss_begin[], lmb_bss_end[];

int main(void);
void lmb_start(void);
void lmb_fault(void);

/* Reset is the first instruction; exceptions go to fixed places behind VECBASE. Debug, NMI, kernel, user and double exceptions
 * are all the same to us. l32r reaches back only, so the addresses that are loaded stand before the code. */
__asm__(".section .start, \"ax\"\n"
        ".global lmb_reset\n"
        ".align 256\n"
        "lmb_reset:\n\t"
        "j lmb_setup\n"
        ".org lmb_reset + 0x10\n\tj lmb_caught\n"
        ".org lmb_reset + 0x20\n\tj lmb_caught\n"
        ".org lmb_reset + 0x30\n\tj lmb_caught\n"
        ".org lmb_reset + 0x50\n\tj lmb_caught\n"
        ".org lmb_reset + 0x70\n\tj lmb_caught\n"
        ".org lmb_reset + 0x80\n"
        ".literal_position\n"
        "lmb_setup:\n\t"
        "movi a0, lmb_reset\n\t"
        "wsr a0, vecbase\n\t"
        "movi sp, lmb_stack_top\n\t"
        "movi a0, lmb_start\n\t"
        "jx a0\n"
        "lmb_caught:\n\t"
        "movi sp, lmb_stack_top\n\t"
        "movi a0, lmb_fault\n\t"
        "jx a0\n"
        ".previous");

__attribute__((used)) void lmb_start(void)
{
    uint32_t *to = lmb_data_begin;
    const uint32_t *from = lmb_data_load;
    while (to < lmb_data_end) *to++ = *from++;
    for (to = lmb_bss_begin; to < lmb_bss_end; to++) *to = 0;
    lmb_board_exit(main());
}

/* Any exception, and nobody expects one: 64 + its cause, so an illegal instruction exits with 64. */
__attribute__((used)) void lmb_fault(void)
{
    uint32_t cause;
    __asm__ volatile("rsr %0, exccause" : "=r"(cause));
    lmb_board_print("\nfault\n");
    lmb_board_exit((int)(64 + (cause & 63)));
}
