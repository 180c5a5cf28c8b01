/* SPDX-License-Identifier: MIT */
/* Cycles of an instruction by the tables of the cores' manuals, memory without wait states. */
#ifndef LMB_PROFILE_CYCLES_H
#define LMB_PROFILE_CYCLES_H

#include "program.h"

/* Cycles: least, nominal, most. Equal where a core's manual gives one number. */
typedef struct cycles {
    int64_t least, nominal, most;
} cycles;

typedef struct cycle_model cycle_model;

/* The model of a core by its name: m0plus, m0, m3, m4; also m0plus-mul32 and m0-mul32, with the multiplier of 32 cycles. NULL
 * for a core of which instructions alone are counted. */
const cycle_model *cycle_model_find(const char *core);

/* What one instruction takes when it goes on, or is not conditional.
 *   before  the one that was executed right before and lies right before it; NULL where it is reached by a jump
 *   return  false if the table does not know it */
bool cycle_cost(const cycle_model *model, const instruction *i, const instruction *before, cycles *out);

/* What a conditional branch takes beyond that when it is taken. */
cycles cycle_taken(const cycle_model *model, const instruction *i);

#endif
