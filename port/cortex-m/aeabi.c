/* SPDX-License-Identifier: MIT */
/* The names by which the ABI of Arm knows copying and filling: clang calls for these, gcc for the usual ones. */
#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t n);
void *memmove(void *to, const void *from, size_t n);
void *memset(void *to, int value, size_t n);

/* Plain, and for what is aligned to 4 or 8 bytes; the order of memset's arguments is the ABI's own. */
#define BLOCKS(suffix)                                                                                                           \
    void __aeabi_memcpy##suffix(void *restrict to, const void *restrict from, size_t n);                                         \
    void __aeabi_memmove##suffix(void *to, const void *from, size_t n);                                                          \
    void __aeabi_memset##suffix(void *to, size_t n, int value);                                                                  \
    void __aeabi_memclr##suffix(void *to, size_t n);                                                                             \
    void __aeabi_memcpy##suffix(void *restrict to, const void *restrict from, size_t n) { memcpy(to, from, n); }                 \
    void __aeabi_memmove##suffix(void *to, const void *from, size_t n) { memmove(to, from, n); }                                 \
    void __aeabi_memset##suffix(void *to, size_t n, int value) { memset(to, value, n); }                                         \
    void __aeabi_memclr##suffix(void *to, size_t n) { memset(to, 0, n); }

BLOCKS()
BLOCKS(4)
BLOCKS(8)
