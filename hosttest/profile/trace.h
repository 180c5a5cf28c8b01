/* SPDX-License-Identifier: MIT */
/* The profiler itself: takes what a program executes, in order, and counts it by instruction and by function.
 *
 * It is fed with blocks, runs of instructions that are executed one after the other, by whoever can see them: the plugin in
 * QEMU, the AVR harness, or a list of addresses (which is how it is tested). For each pair of neighbouring blocks it checks that
 * the second can follow the first, and from calls and returns it keeps a stack, so that each function's inclusive figures are
 * known: what is executed from when it is entered until it is left, by it and by all that it calls; a function that calls itself
 * is counted once. A jump into another function is taken as a call in its place (a tail call): both are left by one return.
 *
 * The program says what is measured by calling profile_begin and profile_end, and says what it is by profile_nibble_0 to _f, two
 * for a character, so that no console is needed. What is counted is what lies between the two calls, exactly.
 */
#ifndef LMB_PROFILE_TRACE_H
#define LMB_PROFILE_TRACE_H

#include <stdio.h>

#include "cycles.h"

/* A run of instructions. Fields belong to trace.c. */
typedef struct block {
    const instruction *first, *last;
    uint32_t address, end;          /* of the first; behind the last */
    uint64_t instructions;          /* in it */
    cycles cost, taken, joined;     /* of all; more when its branch is taken; more when it is entered by going on */
    uint64_t count, takens, joins;  /* how often, in this region */
    int64_t told;                   /* cycles that the feeder told */
    struct block *on, *jump;        /* known followers within the function, already checked */
    struct block *next_same, *next; /* with the same hash; of all */
    bool unknown;                   /* has an instruction that the cycle table does not know */
    bool marked;                    /* begins a function that has a meaning here */
} block;

typedef struct trace trace;

typedef struct trace_options {
    const char *core;
    FILE *out;     /* figures, line by line: see trace.c */
    bool told;     /* cycles come from the feeder */
    bool listing;  /* figures of each instruction as well */
    bool progress; /* a line to stderr for each region */
} trace_options;

trace *trace_new(const program *p, const trace_options *options);

/* The block of n instructions from first on. One struct for the same run, however often it is asked for. */
block *trace_block(trace *t, const instruction *first, uint32_t n);

/* A block has been executed; cost: its cycles where the feeder tells them. NULL: something that is not in the listing. */
void trace_run(trace *t, block *b, int64_t cost);

/* The program has ended. Returns false if something was wrong. */
bool trace_end(trace *t);

#endif
