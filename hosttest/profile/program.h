/* SPDX-License-Identifier: MIT */
/* A program as its own image states it: every instruction, where control can go from there, and which function it is of.
 *
 * Read from what objdump -t -d -w -z prints of the image, so lengths and opcodes come from the file and not from the emulator
 * (QEMU 7.2 gives wrong lengths at the ends of pages).
 */
#ifndef LMB_PROFILE_PROGRAM_H
#define LMB_PROFILE_PROGRAM_H

#include <stdbool.h>
#include <stdint.h>

enum machine { MACHINE_ARM, MACHINE_RISCV, MACHINE_AVR, MACHINE_XTENSA, MACHINE_X86 };

/* Where control goes after an instruction. */
enum flow {
    FLOW_NEXT,    /* on to the next one */
    FLOW_JUMP,    /* to target */
    FLOW_BRANCH,  /* to target or on */
    FLOW_CALL,    /* to target, and back here later */
    FLOW_JUMP_TO, /* to where a register or a table says */
    FLOW_CALL_TO, /* the same, and back here later */
    FLOW_RETURN,  /* back to where the function was called */
    FLOW_SKIP,    /* on, or over the next one */
    FLOW_STOP     /* into the debugger or the emulator; on from there, if at all */
};

/* What a function is to the profiler, by its name. */
enum mark {
    MARK_NONE,
    MARK_BEGIN,      /* profile_begin: measuring starts when it returns */
    MARK_END,        /* profile_end: measuring ends with the instruction before the call of it */
    MARK_SWITCH,     /* a helper that returns into a table of jumps behind its call */
    MARK_NIBBLE = 16 /* profile_nibble_0 to _f: the program says four bits, in the low four bits here */
};

typedef struct instruction {
    uint32_t address, target; /* target: of a direct jump, branch or call */
    uint32_t function;        /* index */
    uint8_t length;
    uint8_t flow;     /* enum flow */
    bool conditional; /* within an IT block: may be skipped, and is reported as executed all the same */
    bool repeats;     /* may follow itself: x86 string instructions */
    char mnemonic[14];
    const char *operands;
} instruction;

typedef struct function {
    const char *name;
    uint32_t start, size; /* size: as the symbol says; 0 of labels */
    uint8_t mark;         /* enum mark */
} function;

typedef struct program {
    enum machine machine;
    char *text; /* what everything points into */
    instruction *list;
    uint32_t instructions;
    function *functions;
    uint32_t function_count;
    uint32_t *at; /* index + 1 of the instruction at base + i, 0: none */
    uint32_t base, extent;
} program;

/* Reads a listing. Ends the process with a message if there is something in it that it does not understand. */
void program_read(program *p, const char *path);

/* The instruction at an address; NULL if none begins there. */
const instruction *program_at(const program *p, uint32_t address);

/* Prints a message and ends the process. */
void profile_fail(const char *format, ...);

#endif
