/* SPDX-License-Identifier: MIT */
/* Ways along a span, each alone: what a pixel costs and what a span costs before its first.
 *
 *   step-NAME         the loop over 73 and over 13 pixels of a span that turns by 30 degrees: the difference over 60, which blocks of
 *                     two, three and four divide. step-flat is a loop that stores what it has: take it off the others
 *   step-NAME-setup   begin: the mean of the spans below, which turn by 2 to 40 degrees
 */
#include "bench.h"

#if LMB_PROFILE_STEPS

#include "mark.h"

#define LONG 73
#define SHORT 13

static char name[40];
static bool any;

/* step-, the kernel's name and an ending: true if that is wanted. */
static bool wanted(const char *kernel, const char *ending)
{
    static const char start[] = "step-";
    const char *const part[3] = {start, kernel, ending};
    unsigned i, n = 0;
    for (i = 0; i < 3; i++) {
        const char *from = part[i];
        while (*from && n + 1 < sizeof name) name[n++] = *from++;
    }
    name[n] = 0;
    return profile_chosen(profile_model, name);
}

static void say(const char *what, const char *unit)
{
    profile_say(what);
    profile_say(" ");
    profile_say(name);
    profile_say(unit);
    profile_say_end();
    any = true;
}

/* Up to 45 degrees off the viewer, the second normal turned by so many degrees towards any side; a ray by the first of them. */
static void normals(lmb_vec out[3], unsigned degrees, unsigned i)
{
    const uint16_t lean = (uint16_t)(i * 1100u), turn = (uint16_t)(degrees * 46603ul >> 8), about = (uint16_t)(i * 9973u);
    const lmb_matrix leant = lmb_rotation(lean & 8191u, 0, about), turned = lmb_rotation(0, turn, (uint16_t)(3u * about));
    const lmb_vec towards = {0, 0, 16384}, ray = {3000, 4000, 15600};
    out[0] = lmb_rotate(&leant, towards);
    out[1] = lmb_rotate(&leant, lmb_rotate(&turned, towards));
    out[2] = lmb_normalise(ray.x, ray.y, ray.z);
}

static void pixels(const compare_step_kernel *k, struct profile_compared *c)
{
    lmb_vec n[3];
    unsigned count;
    normals(n, 30, 3);
    say("kernel", " pixel 60 1 -1");
    for (count = LONG; count != 0; count = count == LONG ? SHORT : 0) {
        k->begin(&c->state, n[0], n[1], n[2], LONG);
        profile_begin();
        k->run(&c->state, c->out, count);
        profile_end();
    }
}

static void setup(const compare_step_kernel *k, struct profile_compared *c)
{
    static const uint8_t degrees[] = {2, 4, 6, 9, 13, 17, 22, 29, 40}, length[] = {13, 40, 8, 27, 64, 19, 51, 33, 100};
    unsigned i;
    say("mean", " span");
    for (i = 0; i < sizeof degrees; i++) {
        lmb_vec n[3];
        normals(n, degrees[i], i);
        profile_begin();
        k->begin(&c->state, n[0], n[1], n[2], length[i]);
        profile_end();
    }
}

bool profile_step_kernels(void)
{
    struct profile_compared *c = &profile_memory.compared;
    unsigned i;
#if COMPARE_WITH_MAP
    lmb_vec n[3];
    normals(n, 30, 3);
    compare_step_light(&c->map, n[2]);
    c->state.map = &c->map;
#endif
    for (i = 0; i < compare_step_count; i++) {
        if (wanted(compare_steps[i].name, "")) pixels(&compare_steps[i], c);
        if (wanted(compare_steps[i].name, "-setup")) setup(&compare_steps[i], c);
    }
    return any;
}

#endif
