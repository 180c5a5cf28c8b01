/* SPDX-License-Identifier: MIT */
/* Functions that do nothing but be executed. The operand of each makes it unlike the others, or compilers merge them. */
#include "mark.h"

#define APART(n) __asm__ volatile("" : : "i"(n) : "memory")
#define NIBBLE(digit, n)                                                                                                         \
    void profile_nibble_##digit(void);                                                                                           \
    __attribute__((noinline)) void profile_nibble_##digit(void) { APART(n); }

NIBBLE(0, 0)
NIBBLE(1, 1)
NIBBLE(2, 2)
NIBBLE(3, 3)
NIBBLE(4, 4)
NIBBLE(5, 5)
NIBBLE(6, 6)
NIBBLE(7, 7)
NIBBLE(8, 8)
NIBBLE(9, 9)
NIBBLE(a, 10)
NIBBLE(b, 11)
NIBBLE(c, 12)
NIBBLE(d, 13)
NIBBLE(e, 14)
NIBBLE(f, 15)

__attribute__((noinline)) void profile_begin(void) { APART(16); }
__attribute__((noinline)) void profile_end(void) { APART(17); }

static void say_nibble(unsigned n)
{
    switch (n) {
    case 0:
        profile_nibble_0();
        break;
    case 1:
        profile_nibble_1();
        break;
    case 2:
        profile_nibble_2();
        break;
    case 3:
        profile_nibble_3();
        break;
    case 4:
        profile_nibble_4();
        break;
    case 5:
        profile_nibble_5();
        break;
    case 6:
        profile_nibble_6();
        break;
    case 7:
        profile_nibble_7();
        break;
    case 8:
        profile_nibble_8();
        break;
    case 9:
        profile_nibble_9();
        break;
    case 10:
        profile_nibble_a();
        break;
    case 11:
        profile_nibble_b();
        break;
    case 12:
        profile_nibble_c();
        break;
    case 13:
        profile_nibble_d();
        break;
    case 14:
        profile_nibble_e();
        break;
    default:
        profile_nibble_f();
        break;
    }
}

static void say_character(char c)
{
    say_nibble((unsigned char)c >> 4);
    say_nibble((unsigned char)c & 15);
}

void profile_say(const char *text)
{
    while (*text) say_character(*text++);
}

/* By subtraction: cores without a divider have no business with one here. */
void profile_say_number(uint32_t value)
{
    static const uint32_t powers[] = {1000000000, 100000000, 10000000, 1000000, 100000, 10000, 1000, 100, 10, 1};
    int digits;
    char any = 0;
    for (digits = 0; digits < 10; digits++) {
        char digit = '0';
        for (; value >= powers[digits]; value -= powers[digits]) digit++;
        any = (char)(any | (digit != '0') | (digits == 9));
        if (any) say_character(digit);
    }
}

void profile_say_end(void) { say_character('\n'); }
