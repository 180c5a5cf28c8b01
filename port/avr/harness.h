/* SPDX-License-Identifier: MIT */
/* How firmware on a simulated AVR talks to the program that runs it, hosttest/avr_run.c: through three registers that have no
 * other use and lie at the same place on every ATmega of this size. Addresses are those of the data space.
 *
 * The firmware writes an order, and then bytes, if the order takes any; it reads answers. On silicon the registers are three
 * bytes of memory and nobody answers. */
#ifndef LMB_AVR_HARNESS_H
#define LMB_AVR_HARNESS_H

#define LMB_HARNESS_ANSWER 0x3e /* GPIOR0 */
#define LMB_HARNESS_ORDER 0x4a  /* GPIOR1 */
#define LMB_HARNESS_BYTE 0x4b   /* GPIOR2 */

enum lmb_harness_order {
    LMB_ORDER_FLOOR = 1, /* two bytes, low first: the address behind static data, which the stack must not reach */
    LMB_ORDER_CONSOLE,   /* bytes go to the console */
    LMB_ORDER_NAME,      /* bytes are a file's name, which begins anew */
    LMB_ORDER_OPEN,      /* opens the file of that name for writing, emptied. Answer: 0, or 255 if that failed */
    LMB_ORDER_FILE,      /* bytes go to the file */
    LMB_ORDER_CLOSE,     /* Answer: 0, or 255 if the file was not written whole */
    LMB_ORDER_CYCLES,    /* takes a cycle stamp; the next four answers are its bytes, low first */
    LMB_ORDER_EXIT       /* one byte: the program's exit status; nothing after that */
};

#endif
