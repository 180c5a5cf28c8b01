/* SPDX-License-Identifier: MIT */
/* Thumb programs whose instructions and cycles are counted by hand, here: M0+, M0, M3 least/nominal/most, M4 the same. */
    .syntax unified
    .thumb
    .text

/* Sum of 64 products. 515 instructions.
 *                      M0+   M0    M3 and M4
 *   three movs          3     3     3 / 3 / 3
 *   ldrsh, ldrsh        4     4     2 / 3 / 4      nominal: the second follows a load
 *   muls ... cmp        5     5     5 / 5 / 5
 *   bne taken, not      2, 1  3, 1  2, 1 / 3, 1 / 4, 1
 *   an iteration       11    12     9 / 11 / 13
 *   all               706   769     578 / 705 / 832 */
    .global test_loop
    .type test_loop, %function
    .thumb_func
test_loop:
    push {r4, r5, r6, r7, lr}
    movs r4, r0
    movs r5, r1
    bl profile_begin
    movs r6, #0
    movs r7, #0
    movs r2, #128
1:  ldrsh r0, [r4, r6]
    ldrsh r1, [r5, r6]
    muls r0, r1
    asrs r0, r0, #8
    adds r7, r7, r0
    adds r6, #2
    cmp r6, r2
    bne 1b
    bl profile_end
    pop {r4, r5, r6, r7, pc}
    .size test_loop, . - test_loop

/* Calls: a recursion three deep, a function that calls one and jumps to another that ends in a jump to the first, a call by
 * address, and one that falls through into the first. M0+ cycles.
 *              calls   of it             with what it calls
 *   asm_leaf     4     5 x 4, 6 x 4       20, 24
 *   asm_fall     1     1, 1               6, 7
 *   asm_tail     1     3, 4               8, 10
 *   asm_calls    1     4, 14              17, 30
 *   asm_depth    3     5 5 4, 13 13 11    14, 37
 *   test_tree    1     6, 14              48, 94 but for the call of profile_end */
    .global test_tree
    .type test_tree, %function
    .thumb_func
test_tree:
    push {r4, lr}
    bl profile_begin
    movs r0, #3         /* 1 */
    bl asm_depth        /* 3 */
    bl asm_calls        /* 3 */
    ldr r3, =asm_leaf   /* 2 */
    blx r3              /* 2 */
    bl asm_fall         /* 3 */
    bl profile_end
    pop {r4, pc}
    .size test_tree, . - test_tree
    .ltorg

    .global asm_depth
    .type asm_depth, %function
    .thumb_func
asm_depth:
    push {r4, lr}       /* 3 */
    subs r0, #1         /* 1 */
    beq 1f              /* 1, taken 2 */
    bl asm_depth        /* 3 */
1:  pop {r4, pc}        /* 5 */
    .size asm_depth, . - asm_depth

    .global asm_calls
    .type asm_calls, %function
    .thumb_func
asm_calls:
    push {r4, lr}       /* 3 */
    bl asm_leaf         /* 3 */
    bl asm_tail         /* 3 */
    pop {r4, pc}        /* 5 */
    .size asm_calls, . - asm_calls

    .global asm_tail
    .type asm_tail, %function
    .thumb_func
asm_tail:
    nop                 /* 1 */
    nop                 /* 1 */
    b asm_leaf          /* 2 */
    .size asm_tail, . - asm_tail

    .global asm_fall
    .type asm_fall, %function
    .thumb_func
asm_fall:
    nop                 /* 1 */
    .size asm_fall, . - asm_fall

    .global asm_leaf
    .type asm_leaf, %function
    .thumb_func
asm_leaf:
    nop
    nop
    nop
    nop                 /* 4 */
    bx lr               /* 2 */
    .size asm_leaf, . - asm_leaf

/* The same sum in Thumb-2.
 *                      M3                          M4
 *   movs, movs         2                           2
 *   ldrsh, ldrsh       2 / 3 / 4                   2 / 3 / 4
 *   mul, add           2                           smlabb 1
 *   cmp                1                           1
 *   bne taken, not     2, 1 / 3, 1 / 4, 1          the same
 *   an iteration       7 / 9 / 11                  6 / 8 / 10
 *   all                449 / 576 / 703             385 / 512 / 639
 * M3: 2 + 64 x 6 = 386 instructions, M4: 2 + 64 x 5 = 322. */
#if __ARM_ARCH >= 7
    .global test_loop_wide
    .type test_loop_wide, %function
    .thumb_func
test_loop_wide:
    push {r4, r5, r6, r7, lr}
    movs r4, r0
    movs r5, r1
    bl profile_begin
    movs r7, #0
    add.w r6, r4, #128
1:  ldrsh.w r0, [r4], #2
    ldrsh.w r1, [r5], #2
#ifdef __ARM_FEATURE_DSP
    smlabb r7, r0, r1, r7
#else
    mul r0, r0, r1
    add.w r7, r7, r0, asr #8
#endif
    cmp r4, r6
    bne 1b
    bl profile_end
    pop {r4, r5, r6, r7, pc}
    .size test_loop_wide, . - test_loop_wide

/* One of each that takes more than a cycle or a number that depends: 33 instructions, but for the nop. Least, nominal, most; M4
 * where it differs. 55, 75, 92; M4 49, 66, 81. */
    .global test_timing
    .type test_timing, %function
    .thumb_func
test_timing:
    push {r4, r5, r6, lr}
    movs r4, r0
    movs r5, r1
    bl profile_begin
    movs r0, #4             /* 1 1 1 */
    str r4, [r4]            /* 1 1 2   buffered */
    ldr r1, [r4]            /* 1 2 2   nothing goes along with a store before it */
    ldr r2, [r1]            /* 1 2 2   waits for its address */
    ldr r3, [r4, r0]        /* 1 1 2 */
    str r3, [r4, r0]        /* 1 1 2   after a load */
    str r3, [r5, r0]        /* 1 2 2   after a store */
    adds r6, r4, #4         /* 1 1 1 */
    ldr r1, [r6]            /* 1 2 3   address from the addition */
    ldr r1, =0x12345678     /* 1 1 3   beside the program counter */
    ldrd r2, r3, [r4]       /* 3 3 3 */
    umull r2, r3, r0, r0    /* 3 4 5   M4 1 1 1 */
    umlal r2, r3, r0, r0    /* 4 6 7   M4 1 1 1 */
    mla r2, r0, r0, r0      /* 2 2 2   M4 1 1 1 */
    udiv r2, r3, r0         /* 2 7 12 */
    cmp r0, #4              /* 1 1 1 */
    ite eq                  /* 0 1 1 */
    addeq r0, r0, #0        /* 1 1 1 */
    ldrne r0, [r4]          /* 1 2 2   skipped, which nobody sees */
    it ne                   /* 0 1 1 */
    bxne lr                 /* 1 1 1   skipped, which shows */
    cbz r0, 1f              /* 1 1 1 */
    cbnz r0, 1f             /* 2 3 4 */
    nop
1:  push {r0, r1, r2, r3}   /* 5 5 5 */
    pop {r0, r1, r2, r3}    /* 5 5 5 */
    stmia r5!, {r0, r1}     /* 3 3 3 */
    movs r0, #0             /* 1 1 1 */
    tbb [pc, r0]            /* 4 5 6 */
2:  .byte (3f - 2b) / 2, 0
3:  movs r0, #3             /* 1 1 1 */
    bl asm_if               /* 2 3 4 */
    bl profile_end
    pop {r4, r5, r6, pc}
    .ltorg
    .size test_timing, . - test_timing

    .type asm_if, %function
    .thumb_func
asm_if:
    cmp r0, #3              /* 1 1 1 */
    it eq                   /* 0 1 1 */
    bxeq lr                 /* 2 3 4 */
    nop
    bx lr
    .size asm_if, . - asm_if
#endif
