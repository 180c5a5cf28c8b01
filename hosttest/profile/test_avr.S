/* SPDX-License-Identifier: MIT */
/* AVR programs whose instructions and cycles are counted by hand, here (ATmega1284P: a program counter of 16 bits). */
    .text

/* Sum of 64 products of bytes:
 *   ldi, clr, clr, movw    4
 *   ld, ld                 4
 *   mul                    2
 *   add, adc               2
 *   dec                    1
 *   brne taken, not        2, 1
 * 4 + 64 x 7 = 452 instructions, 4 + 64 x 11 - 1 = 707 cycles */
    .global test_loop
    .type test_loop, @function
test_loop:
    push r16
    push r17
    movw r26, r24
    movw r30, r22
    call profile_begin
    ldi r20, 64
    clr r18
    clr r19
    movw r16, r18
1:  ld r24, X+
    ld r25, Z+
    mul r24, r25
    add r16, r0
    adc r17, r1
    dec r20
    brne 1b
    call profile_end
    clr r1
    pop r17
    pop r16
    ret
    .size test_loop, . - test_loop

/* Calls, and what else moves the program counter.
 *              calls   of it               with what it calls
 *   asm_leaf     3     3 x 3, 6 x 3         9, 18
 *   asm_tail     1     2, 3                 5, 9
 *   asm_calls    1     3, 10                11, 25
 *   asm_depth    3     4 4 3, 9 9 7         11, 25       rcall 3, ret 4
 *   test_tree    1     14, 27               39, 83 but for the call of profile_end */
    .global test_tree
    .type test_tree, @function
test_tree:
    call profile_begin
    ldi r24, 3          /* 1 */
    rcall asm_depth     /* 3 */
    rcall asm_calls     /* 3 */
    ldi r30, lo8(gs(asm_leaf))  /* 1 */
    ldi r31, hi8(gs(asm_leaf))  /* 1 */
    icall               /* 3 */
    rcall .+0           /* 3: room for two bytes */
    pop r0              /* 2 */
    pop r0              /* 2 */
    ldi r24, 1          /* 1 */
    sbrc r24, 0         /* 1: not skipped */
    nop                 /* 1 */
    sbrs r24, 0         /* 2: one word skipped */
    nop
    sbrs r24, 0         /* 3: two words skipped */
    jmp asm_leaf
    call profile_end
    ret
    .size test_tree, . - test_tree

    .global asm_depth
    .type asm_depth, @function
asm_depth:
    dec r24             /* 1 */
    breq 1f             /* 1, taken 2 */
    rcall asm_depth     /* 3 */
1:  ret                 /* 4 */
    .size asm_depth, . - asm_depth

    .global asm_calls
    .type asm_calls, @function
asm_calls:
    rcall asm_leaf      /* 3 */
    rcall asm_tail      /* 3 */
    ret                 /* 4 */
    .size asm_calls, . - asm_calls

    .global asm_tail
    .type asm_tail, @function
asm_tail:
    nop                 /* 1 */
    rjmp asm_leaf       /* 2 */
    .size asm_tail, . - asm_tail

    .global asm_leaf
    .type asm_leaf, @function
asm_leaf:
    nop
    nop                 /* 2 */
    ret                 /* 4 */
    .size asm_leaf, . - asm_leaf
