/* SPDX-License-Identifier: MIT */
/* Names of the classes of work. */
#include "costs.h"

#include <stdio.h>
#include <string.h>

const char *const cost_stage_names[COST_STAGES] = {"project", "sort", "begin", "walk", "shade", "fill"};
const char *const cost_part_names[COST_PARTS] = {"frame", "vertex", "triangle", "span", "pixel"};

static const cost_kind kinds[] = {
#define COST(name, stage, part, text) {#name, text, COST_##stage, PART_##part},
#define COST_LOOP(name, text)
#include "costs.def"
#undef COST
#undef COST_LOOP
};
static const cost_kind loops[] = {
#define COST(name, stage, part, text)
#define COST_LOOP(name, text) {#name, text, COST_FILL, PART_PIXEL},
#include "costs.def"
#undef COST
#undef COST_LOOP
};

cost_kind cost_kind_of(int class)
{
    static const struct {
        const char *name;
        enum cost_part part;
    } of[COST_OF_LOOP] = {{"triangle", PART_TRIANGLE}, {"row", PART_SPAN},   {"run", PART_SPAN},    {"pixel", PART_PIXEL},
                          {"gleam", PART_PIXEL},       {"more", PART_PIXEL}, {"hidden", PART_PIXEL}};
    const int loop = (class - COST_OTHERS) / COST_OF_LOOP, what = (class - COST_OTHERS) % COST_OF_LOOP;
    cost_kind kind;
    if (class < COST_OTHERS) return kinds[class];
    kind = loops[loop];
    kind.part = of[what].part;
    snprintf(kind.name, sizeof kind.name, "%s.%s", loops[loop].name, of[what].name);
    return kind;
}
