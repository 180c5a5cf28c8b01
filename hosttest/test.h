/* SPDX-License-Identifier: MIT */
/* What every test program shares: one line a property, a seeded generator, and the end that counts.
 *
 * A property prints exactly one line, "pass <name>: <worst figure and where>" or "FAIL <name>: <inputs, got, want>"; `make check`
 * counts those lines. test_end gives main's return value.
 */
#ifndef LMB_TEST_H
#define LMB_TEST_H

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static int test_failures;

/* Prints the verdict of one property; returns ok. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static inline int
test_verdict(int ok, const char *name, const char *format, ...)
{
    va_list arguments;
    printf("%s %s: ", ok ? "pass" : "FAIL", name);
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    printf("\n");
    fflush(stdout);
    if (!ok) test_failures++;
    return ok;
}

static inline int test_end(void) { return test_failures ? EXIT_FAILURE : EXIT_SUCCESS; }

/* xorshift64*: the same numbers on every machine for one seed. */
typedef struct test_random {
    uint64_t state;
} test_random;

/* The seed is argv[1] (decimal or 0x...), or 1; it is printed so that a failure can be repeated. */
static inline test_random test_seed(int argc, char **argv)
{
    uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 0) : 1;
    test_random r = {(seed * 2 + 1) * 0x9E3779B97F4A7C15u};
    printf("seed %" PRIu64 "\n", seed);
    return r;
}
static inline uint64_t test_next(test_random *r)
{
    r->state ^= r->state >> 12;
    r->state ^= r->state << 25;
    r->state ^= r->state >> 27;
    return r->state * 0x2545F4914F6CDD1Du;
}
/* Uniform in [low, high], both ends included. */
static inline int64_t test_integer(test_random *r, int64_t low, int64_t high)
{
    return low + (int64_t)(test_next(r) % (uint64_t)(high - low + 1));
}
/* Uniform in [low, high). */
static inline double test_real(test_random *r, double low, double high)
{
    return low + (high - low) * ((double)(test_next(r) >> 11) / 9007199254740992.0);
}

#endif
