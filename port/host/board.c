/* SPDX-License-Identifier: MIT */
/* The host as a board. */
#include "../board.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static FILE *file;

void lmb_board_begin(void) {}
void lmb_board_print(const char *text) { fputs(text, stdout); }

int lmb_board_open(const char *name)
{
    file = fopen(name, "wb");
    return file ? 0 : -1;
}

int lmb_board_write(const void *bytes, size_t n) { return fwrite(bytes, 1, n, file) == n ? 0 : -1; }
int lmb_board_close(void) { return fclose(file) ? -1 : 0; }

/* Processor time in units of CLOCKS_PER_SEC: the host has no counter of cycles that every compiler knows. */
uint32_t lmb_board_cycles(void) { return (uint32_t)clock(); }

void lmb_board_exit(int status) { exit(status); }
