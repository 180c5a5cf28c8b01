/* SPDX-License-Identifier: MIT */
/* Reading what LMB_FLASH has put into flash. Files that do include this before all else. Inside the library only. */
#ifndef LMB_FLASH_H
#define LMB_FLASH_H

/* avr-gcc forgets that a struct lies in flash when it makes induction variables of its members' addresses, and loads from RAM
 * (seen with 5.4 at -O2, in plain loops over lobe_rows). Without such variables AVR code is 3 % longer. */
#ifdef __AVR__
#pragma GCC optimize("no-ivopts")
#endif

#include "lambent.h"

/* A vector of a mesh, by address: where it lies, or, where plain pointers do not reach it, a copy in room. */
static inline const lmb_vec *lmb_vec_read(const LMB_FLASH lmb_vec *from, lmb_vec *room)
{
#ifdef __AVR__
    room->x = from->x;
    room->y = from->y;
    room->z = from->z;
    return room;
#else
    (void)room;
    return from;
#endif
}

#endif
