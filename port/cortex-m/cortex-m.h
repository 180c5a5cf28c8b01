/* SPDX-License-Identifier: MIT */
/* The few registers of Cortex-M that every chip has at the same place, and what start-up and board share. */
#ifndef LMB_CORTEX_M_H
#define LMB_CORTEX_M_H

#include <stdint.h>

#define SYSTICK_CONTROL (*(volatile uint32_t *)0xe000e010)
#define SYSTICK_RELOAD (*(volatile uint32_t *)0xe000e014)
#define SYSTICK_VALUE (*(volatile uint32_t *)0xe000e018)
#define ICSR (*(volatile uint32_t *)0xe000ed04)
#define ICSR_TICK_PENDING (1uL << 26)
#define CPACR (*(volatile uint32_t *)0xe000ed88)

/* SysTick has counted 2^24 cycles. */
void lmb_tick_wraps(void);

#endif
