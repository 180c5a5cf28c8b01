/* SPDX-License-Identifier: MIT */
/* Meets an instruction that no core has: a board must end with its fault status, not hang and not report success. */
#include "../board.h"

int main(void)
{
    lmb_board_begin();
    lmb_board_print("going to fault\n");
    __builtin_trap();
}
