/* SPDX-License-Identifier: MIT */
/* Does a board keep what port/board.h promises? The first program to run on a new one. Prints one line a property; ends with
 * status 42 if all hold, 1 otherwise, so that a status that gets lost shows. hosttest/boards.sh judges what arrives. */
#include "../board.h"

#include <stdbool.h>

void *memcpy(void *restrict to, const void *restrict from, size_t n);
void *memmove(void *to, const void *from, size_t n);
void *memset(void *to, int value, size_t n);
int memcmp(const void *a, const void *b, size_t n);

static volatile uint32_t preset[3] = {0x12345678, 0x9abcdef0, 42};
static volatile uint32_t zeroed[3];
static volatile int16_t odd_one = -2; /* so that .data need not end on a word */
static uint8_t block[48], pattern[257];

static bool verdict(bool ok, const char *name)
{
    lmb_board_print(ok ? "ok   " : "FAULT ");
    lmb_board_print(name);
    lmb_board_print("\n");
    return ok;
}

static bool memory_is_set_up(void)
{
    return preset[0] == 0x12345678 && preset[1] == 0x9abcdef0 && preset[2] == 42 && odd_one == -2 &&
           (zeroed[0] | zeroed[1] | zeroed[2]) == 0;
}

/* Locals of eight bytes lie where the core wants them. The address goes through memory, or the compiler knows the answer. */
static bool stack_is_aligned(void)
{
    struct wanted {
        char first;
        uint64_t second;
    };
    volatile uint64_t local = 0;
    volatile uintptr_t address = (uintptr_t)&local;
    return (address & (offsetof(struct wanted, second) - 1)) == 0 && local == 0;
}

static void number_block(void)
{
    uint8_t i;
    for (i = 0; i < sizeof block; i++) block[i] = i;
}

/* Whether block holds its numbers except for n bytes from at on, which hold those from value on, step apart. */
static bool block_holds(size_t at, size_t n, size_t value, size_t step)
{
    size_t i;
    for (i = 0; i < sizeof block; i++) {
        if (block[i] != (i >= at && i < at + n ? (uint8_t)(value + (i - at) * step) : i)) return false;
    }
    return true;
}

/* memcpy, memmove (both ways) and memset of every small size at every alignment; memcmp's three answers. */
static bool blocks_move(void)
{
    size_t to, from, n;
    for (n = 0; n <= 12; n++) {
        for (to = 0; to < 4; to++) {
            for (from = 0; from < 4; from++) {
                number_block();
                if (memcpy(block + to, block + 20 + from, n) != block + to || !block_holds(to, n, 20 + from, 1)) return false;
                number_block();
                if (memmove(block + 8 + to, block + 8 + from, n) != block + 8 + to || !block_holds(8 + to, n, 8 + from, 1)) {
                    return false;
                }
            }
            number_block();
            if (memset(block + to, 0x1a5, n) != block + to || !block_holds(to, n, 0xa5, 0)) return false;
        }
    }
    return memcmp("abcd", "abce", 3) == 0 && memcmp("abcd", "abce", 4) < 0 && memcmp("ab\377", "ab\1", 3) > 0;
}

/* Byte i of selftest.bin is 7 i: written in pieces of all sorts. */
static bool file_is_written(void)
{
    static const uint16_t pieces[] = {1, 7, 0, 256, 255, 1};
    uint16_t at = 0, i, k;
    if (lmb_board_open("selftest.bin")) return false;
    for (k = 0; k < sizeof pieces / sizeof pieces[0]; at = (uint16_t)(at + pieces[k++])) {
        for (i = 0; i < pieces[k]; i++) pattern[i + 1] = (uint8_t)((at + i) * 7u);
        if (lmb_board_write(pattern + 1, pieces[k])) return false;
    }
    return lmb_board_close() == 0;
}

static bool missing_folder_is_an_error(void) { return lmb_board_open("no/such/folder/file") == -1; }

/* Many readings, each a little after the one before, also where a part of the counter starts over. */
static bool counter_moves_on(void)
{
    uint32_t first = lmb_board_cycles(), before = first;
    uint32_t i;
    for (i = 0; i < 200000; i++) {
        uint32_t now = lmb_board_cycles();
        if (now - before >= 0x1000000 / 4) return false;
        before = now;
    }
    return before != first;
}

int main(void)
{
    bool ok = memory_is_set_up(); /* before anything else has used it */
    lmb_board_begin();
    ok = verdict(ok, "memory is set up") && ok;
    ok = verdict(stack_is_aligned(), "stack is aligned") && ok;
    ok = verdict(blocks_move(), "blocks move") && ok;
    ok = verdict(file_is_written(), "file is written") && ok;
    ok = verdict(missing_folder_is_an_error(), "missing folder is an error") && ok;
    if (lmb_board_cycles() | lmb_board_cycles()) {
        ok = verdict(counter_moves_on(), "counter moves on") && ok;
    } else {
        ok = verdict(true, "there is no counter") && ok;
    }
    return ok ? 42 : 1;
}
