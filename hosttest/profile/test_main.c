/* SPDX-License-Identifier: MIT */
/* Programs whose figures are known by hand, for hosttest/profile/test_profile.sh: loops and a tree of calls in assembler
 * (test_thumb.S, test_avr.S), and a tree of calls in C for every core. Each region is announced by a line "test NAME". */
#include "../../port/board.h"
#include "mark.h"

#if defined(__GNUC__)
#define APART __attribute__((noinline, noclone))
#else
#define APART
#endif

/* In assembler: each measures a region of its own. */
void test_loop(const int16_t *a, const int16_t *b);
void test_loop_wide(const int16_t *a, const int16_t *b);
void test_timing(int16_t *a, int16_t *b);
void test_tree(void);

#if defined(__arm__) || defined(__AVR__)
static union {
    int16_t value[64];
    uint32_t word[32]; /* aligned for whole words */
} first, second;
#endif

static void announce(const char *name)
{
    profile_say("test ");
    profile_say(name);
    profile_say_end();
}

/* ------------------------------------------------------------------------------------------------------------- calls in C */

static volatile uint32_t sink;

void tree_leaf(void);
void tree_tail(void);
void tree_calls(unsigned n);
uint32_t tree_depth(uint32_t n);
void (*volatile tree_pointer)(void) = tree_leaf;

APART void tree_leaf(void) { sink = sink + 1; }

/* Compilers make the last call a jump. */
APART void tree_tail(void)
{
    sink = sink + 2;
    tree_leaf();
}

APART uint32_t tree_depth(uint32_t n)
{
    uint32_t below;
    if (n == 0) return sink;
    below = tree_depth(n - 1);
    return below + sink; /* so that this is no jump */
}

APART void tree_calls(unsigned n)
{
    for (; n > 0; n--) {
        tree_leaf();
        tree_tail();
        tree_pointer();
    }
    sink = tree_depth(7);
}

/* RV32 counts instructions by itself, with -icount: from before one region to after it, so between two regions its counts differ
 * by as much as the regions do. */
static void counted(const char *name, unsigned n)
{
    uint32_t before, after;
    announce(name);
    before = lmb_board_cycles();
    profile_begin();
    tree_calls(n);
    profile_end();
    after = lmb_board_cycles();
#ifdef __riscv
    profile_say("counter ");
    profile_say_number(after - before);
    profile_say_end();
#else
    (void)before;
    (void)after;
#endif
}

int main(void)
{
#if defined(__arm__) || defined(__AVR__)
    announce("loop");
    test_loop(first.value, second.value);
    announce("tree");
    test_tree();
#endif
#if defined(__ARM_ARCH) && __ARM_ARCH >= 7
    announce("loop-wide");
    test_loop_wide(first.value, second.value);
    announce("timing");
    test_timing(first.value, second.value);
#endif
    counted("calls-10", 10);
    counted("calls-13", 13);
    return 0;
}
