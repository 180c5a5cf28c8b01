/* SPDX-License-Identifier: MIT */
/* What a board gives a program: the same few functions on each family, written in port/<family>/. docs/PORTING.md is the guide
 * for a board of your own.
 *
 * A program has an ordinary main(void). The board's start-up sets memory up, calls it, and hands what it returns to
 * lmb_board_exit.
 */
#ifndef LMB_BOARD_H
#define LMB_BOARD_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Whatever the other calls need: clocks, a serial port, the counter. First thing in main. */
void lmb_board_begin(void);

/* Writes text, up to its zero byte, to the console. Lines end in \n. */
void lmb_board_print(const char *text);

/* One file at a time, or whatever stands for it on a board (a card, a serial line, a panel). Opens it for writing, emptied;
 * appends n bytes, any alignment; closes it. Return 0, or -1 if that failed: a file that was not written whole is an error. */
int lmb_board_open(const char *name);
int lmb_board_write(const void *bytes, size_t n);
int lmb_board_close(void);

/* A free-running counter that wraps at 2^32, in the board's own unit (processor cycles where there is such a counter; its
 * board.c says). 0 where there is none. */
uint32_t lmb_board_cycles(void);

/* Ends the program; does not return. status: 0 for success, 1 to 63 for the program's own failures; from 64 on the board's own:
 * faults. */
void lmb_board_exit(int status);

#ifdef __cplusplus
}
#endif

#endif
