/* SPDX-License-Identifier: MIT */
/* What a measured program says to the profiler, by the addresses that it executes: no console, no registers, no memory. */
#ifndef LMB_PROFILE_MARK_H
#define LMB_PROFILE_MARK_H

#include <stdint.h>

/* What is executed between the return of the one and the call of the other is measured. Both from one function. */
void profile_begin(void);
void profile_end(void);

/* Text; figures; the end of a line. */
void profile_say(const char *text);
void profile_say_number(uint32_t value);
void profile_say_end(void);

#endif
