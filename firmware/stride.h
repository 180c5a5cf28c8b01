/* SPDX-License-Identifier: MIT */
/* Triangle edges as one number a row, for loops where each instruction of a row counts. Inside the library only. */
#ifndef LMB_STRIDE_H
#define LMB_STRIDE_H

#include "lambent.h"

/* For loops that walk the rows of a triangle themselves (step.h), if its corners are less than LMB_STRIDE_MAX apart: begins its sides
 * at the next row, y, with columns that count from triangle->column, which becomes that of its planes; and goes on when y has
 * reached y_turn. */
void lmb_strides_begin(lmb_triangle *triangle);
void lmb_strides_turn(lmb_triangle *triangle);

#endif
