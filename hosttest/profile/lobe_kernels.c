/* SPDX-License-Identifier: MIT */
/* Lobes, each alone: 64 evaluations less a loop with none. The library's own is called lobe, the others lobe-NAME. */
#include "bench.h"

#if LMB_PROFILE_COMPARED

#include "mark.h"

static bool is_empty(const char *name) { return name[5] == 'n'; } /* lobe-none */
/* lobe-lambent, and not lobe-lyon */
static const char *short_name(const char *name) { return name[5] == 'l' && name[6] == 'a' ? "lobe" : name; }

static void say(const char *name)
{
    profile_say("kernel ");
    profile_say(name);
    profile_say(" evaluation ");
    profile_say_number(COMPARE_ARGUMENTS);
    profile_say(" 1 -1");
    profile_say_end();
}

bool profile_lobe_kernels(void)
{
    struct profile_compared *c = &profile_memory.compared;
    volatile uint32_t sum;
    unsigned i, n, none = 0;
    bool any = false;
    if (compare_lobe_prepare(&c->lobe, COMPARE_SHININESS)) return false;
    compare_lobe_cosines(c->cosines, COMPARE_SHININESS);
    while (none + 1 < compare_lobe_count && !is_empty(compare_lobes[none].name)) none++;
    for (i = 0; i < compare_lobe_count; i++) {
        const compare_lobe_kernel *k = &compare_lobes[i], *empty = &compare_lobes[none];
        if (i == none || !profile_chosen(profile_model, short_name(k->name))) continue;
        any = true;
        k->arguments(&c->lobe, c->arguments, c->cosines, COMPARE_ARGUMENTS);
        say(short_name(k->name));
        for (n = 0; n < 2; n++) {
            uint32_t (*evaluate)(const compare_lobe *, const compare_argument *, unsigned) = n == 0 ? k->sum : empty->sum;
            profile_begin();
            sum = evaluate(&c->lobe, c->arguments, COMPARE_ARGUMENTS);
            profile_end();
        }
    }
    (void)sum;
    return any;
}

#endif
