/* SPDX-License-Identifier: MIT */
/* Lobes, each alone: 64 evaluations less a loop with none. The library's own is called lobe, the others lobe-NAME.
 *
 *   lobe-NAME            for the exponent of the frames
 *   lobe-NAME/N          for exponent N, as pareto.csv has them: exact powers, libms and divisions take what their arguments take
 *   lobe-tuned-M/N       the library's own with at most M multiplications, in the code of W_m where it has that form
 */
#include "bench.h"

#if LMB_PROFILE_COMPARED

#include "mark.h"
#include "../pareto/exponents.h"

static char name[48];

static void append(const char *text)
{
    unsigned n = 0;
    while (name[n]) n++;
    while (*text && n + 1 < sizeof name) name[n++] = *text++;
    name[n] = 0;
}

static void append_number(unsigned value)
{
    static const uint16_t powers[] = {1000, 100, 10, 1};
    char digit[2] = {0, 0};
    bool any = false;
    unsigned i;
    for (i = 0; i < 4; i++) {
        for (digit[0] = '0'; value >= powers[i]; value -= powers[i]) digit[0]++;
        any = any || digit[0] != '0';
        if (any) append(digit);
    }
}

static bool is_empty(const char *kernel) { return kernel[5] == 'n'; } /* lobe-none */
/* lobe-lambent, and not lobe-lyon */
static bool is_ours(const char *kernel) { return kernel[5] == 'l' && kernel[6] == 'a'; }

/* What a kernel is called; n: its exponent, 0: that of frames; multiplications: at most so many, 0: as many as it likes. */
static void name_set(const char *kernel, unsigned n, unsigned multiplications)
{
    name[0] = 0;
    append(!is_ours(kernel) ? kernel : multiplications ? "lobe-tuned-" : "lobe");
    if (multiplications) append_number(multiplications);
    if (n) {
        append("/");
        append_number(n);
    }
}

static void say(void)
{
    profile_say("kernel ");
    profile_say(name);
    profile_say(" evaluation ");
    profile_say_number(COMPARE_ARGUMENTS);
    profile_say(" 1 -1");
    profile_say_end();
}

static void measure(struct profile_compared *c, const compare_lobe_kernel *k, const compare_lobe_kernel *empty)
{
    volatile uint32_t sum;
    unsigned i;
    k->arguments(&c->lobe, c->arguments, c->cosines, COMPARE_ARGUMENTS);
    say();
    for (i = 0; i < 2; i++) {
        uint32_t (*evaluate)(const compare_lobe *, const compare_argument *, unsigned) = i == 0 ? k->sum : empty->sum;
        profile_begin();
        sum = evaluate(&c->lobe, c->arguments, COMPARE_ARGUMENTS);
        profile_end();
    }
    (void)sum;
}

/* The loop with nothing in it. */
static const compare_lobe_kernel *empty_kernel(void)
{
    unsigned i = 0;
    while (i + 1 < compare_lobe_count && !is_empty(compare_lobes[i].name)) i++;
    return &compare_lobes[i];
}

/* named: for an exponent of its own, which the name says. */
static bool measure_all(struct profile_compared *c, unsigned n, bool named)
{
    const compare_lobe_kernel *empty = empty_kernel();
    unsigned i;
    bool any = false;
    if (compare_lobe_prepare(&c->lobe, n)) return false;
    compare_lobe_cosines(c->cosines, n);
    for (i = 0; i < compare_lobe_count; i++) {
        name_set(compare_lobes[i].name, named ? n : 0, 0);
        if (&compare_lobes[i] == empty || !profile_chosen(profile_model, name)) continue;
        measure(c, &compare_lobes[i], empty);
        any = true;
    }
    for (i = 1; named && i <= PARETO_MULTIPLICATIONS; i++) {
        name_set("lobe-lambent", n, i);
        if (!profile_chosen(profile_model, name)) continue;
        measure(c, pareto_tuned_kernel(&c->lobe, n, i), empty);
        any = true;
    }
    return any;
}

bool profile_lobe_kernels(void)
{
    struct profile_compared *c = &profile_memory.compared;
    bool any = measure_all(c, COMPARE_SHININESS, false);
    unsigned i;
    for (i = 0; i < PARETO_EXPONENTS; i++) any = measure_all(c, pareto_exponents[i], true) || any;
    return any;
}

#endif
