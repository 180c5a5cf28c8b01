/* SPDX-License-Identifier: MIT */
/* What the checked twin of arith.h calls: counts, and the end of a program whose arithmetic left its range. */
#include "../firmware/lambent.h"

#ifdef LMB_CHECKED

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

lmb_counts lmb_count;

void lmb_check_failed(const char *file, int line, const char *operation, int64_t a, int64_t b, int64_t result)
{
    printf("FAIL arithmetic range: %s:%d: %s of %" PRId64 " (0x%" PRIx64 ") and %" PRId64 " (0x%" PRIx64 ") gives %" PRId64 "\n",
           file, line, operation, a, (uint64_t)a, b, (uint64_t)b, result);
    fflush(stdout);
    abort();
}

#else
typedef int lmb_checked_is_not_built; /* ISO C forbids an empty translation unit */
#endif
