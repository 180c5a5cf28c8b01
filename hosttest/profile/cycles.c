/* SPDX-License-Identifier: MIT */
/* Cycle tables of Cortex-M0, M0+, M3 and M4.
 *
 * Sources: ARM DDI 0432C (Cortex-M0), table 3-1; DDI 0484C (Cortex-M0+), table 3-1; ARM 100165_0201_02 (Cortex-M3), table 3-1
 * and section 3.3.2; DDI 0439D (Cortex-M4), tables 3-1 and 3-2 and section 3.3.2.
 *
 *                          M0        M0+       M3                       M4
 *   data processing        1         1         1                        1
 *   MULS                   1 (32)    1 (32)    1                        1
 *   MLA, MLS               -         -         2                        1
 *   UMULL, SMULL           -         -         3 to 5                   1
 *   UMLAL, SMLAL           -         -         4 to 7                   1
 *   SDIV, UDIV             -         -         2 to 12                  2 to 12
 *   LDR                    2         2         2, after an LDR 1        the same
 *   STR [r, #n]            2         2         1                        the same
 *   STR [r, r]             2         2         2, after an LDR 1        the same
 *   LDM, STM, PUSH, POP    1 + N     1 + N     1 + N                    1 + N
 *   POP {..., PC}          4 + N     3 + N     1 + N + P                1 + N + P
 *   branch, taken or not   3, 1      2, 1      1 + P, 1                 1 + P, 1
 *   BL                     4         3         1 + P                    1 + P
 *   BX, BLX, MOV PC        3         2         1 + P                    1 + P
 *   TBB, TBH               -         -         3 + P                    3 + P
 *   IT                     -         -         1, may be folded: 0      the same
 *
 * N counts all registers of the list, LR and PC among them (M3's manual says so; those of M0 and M0+ leave it open: at most one
 * cycle a push or pop). P, the refill of the pipeline, is 1 to 3, nominally 2. Nominal is the middle of other ranges, rounded up.
 * An LDR that follows an LDR takes one cycle less, unless its address is what that one loads. The most of a load or store adds a
 * cycle where its address comes from the data processing right before, and where it reads beside the program counter.
 * Instructions of an IT block are reported as executed even where they are skipped: their least is 1.
 */
#include "cycles.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum cost_class {
    COST_ALU = 1,
    COST_MUL,
    COST_MLA,
    COST_MUL_LONG,
    COST_MLA_LONG,
    COST_DIV,
    COST_LOAD,
    COST_STORE,
    COST_PAIR,
    COST_MULTI,
    COST_BRANCH,
    COST_CALL,
    COST_EXCHANGE,
    COST_TABLE,
    COST_IT
};

struct cycle_model {
    const char *core;
    bool v7, dsp;
    cycles mul, mla, mul_long, mla_long, div, branch, call, exchange, pop_pc;
};

#define ONE                                                                                                                      \
    {                                                                                                                            \
        1, 1, 1                                                                                                                  \
    }
#define SAME(n)                                                                                                                  \
    {                                                                                                                            \
        n, n, n                                                                                                                  \
    }
#define NONE                                                                                                                     \
    {                                                                                                                            \
        0, 0, 0                                                                                                                  \
    }

/* pop_pc: beyond N. branch: taken. */
static const cycle_model models[] = {
    {"m0plus", false, false, ONE, NONE, NONE, NONE, NONE, SAME(2), SAME(3), SAME(2), SAME(3)},
    {"m0plus-mul32", false, false, SAME(32), NONE, NONE, NONE, NONE, SAME(2), SAME(3), SAME(2), SAME(3)},
    {"m0", false, false, ONE, NONE, NONE, NONE, NONE, SAME(3), SAME(4), SAME(3), SAME(4)},
    {"m0-mul32", false, false, SAME(32), NONE, NONE, NONE, NONE, SAME(3), SAME(4), SAME(3), SAME(4)},
    {"m3", true, false, ONE, SAME(2), {3, 4, 5}, {4, 6, 7}, {2, 7, 12}, {2, 3, 4}, {2, 3, 4}, {2, 3, 4}, {2, 3, 4}},
    {"m4", true, true, ONE, ONE, ONE, ONE, {2, 7, 12}, {2, 3, 4}, {2, 3, 4}, {2, 3, 4}, {2, 3, 4}},
};

typedef struct cost_name {
    const char *name;
    enum cost_class cost;
} cost_name;

/* ARMv6-M: all that Cortex-M0 and M0+ have, but for what touches system registers. */
static const cost_name names_v6[] = {
    {"adcs", COST_ALU},   {"add", COST_ALU},     {"adds", COST_ALU},  {"adr", COST_ALU},     {"ands", COST_ALU},
    {"asrs", COST_ALU},   {"bics", COST_ALU},    {"cmn", COST_ALU},   {"cmp", COST_ALU},     {"eors", COST_ALU},
    {"lsls", COST_ALU},   {"lsrs", COST_ALU},    {"mov", COST_ALU},   {"movs", COST_ALU},    {"mvns", COST_ALU},
    {"negs", COST_ALU},   {"nop", COST_ALU},     {"orrs", COST_ALU},  {"rev", COST_ALU},     {"rev16", COST_ALU},
    {"revsh", COST_ALU},  {"rors", COST_ALU},    {"rsbs", COST_ALU},  {"sbcs", COST_ALU},    {"sub", COST_ALU},
    {"subs", COST_ALU},   {"sxtb", COST_ALU},    {"sxth", COST_ALU},  {"tst", COST_ALU},     {"uxtb", COST_ALU},
    {"uxth", COST_ALU},   {"muls", COST_MUL},    {"ldr", COST_LOAD},  {"ldrb", COST_LOAD},   {"ldrh", COST_LOAD},
    {"ldrsb", COST_LOAD}, {"ldrsh", COST_LOAD},  {"str", COST_STORE}, {"strb", COST_STORE},  {"strh", COST_STORE},
    {"ldm", COST_MULTI},  {"ldmia", COST_MULTI}, {"stm", COST_MULTI}, {"stmia", COST_MULTI}, {"push", COST_MULTI},
    {"pop", COST_MULTI},  {"b", COST_BRANCH},    {"bl", COST_CALL},   {"bx", COST_EXCHANGE}, {"blx", COST_EXCHANGE},
};

/* What ARMv7-M adds. */
static const cost_name names_v7[] = {
    {"adc", COST_ALU},        {"addw", COST_ALU},       {"and", COST_ALU},     {"asr", COST_ALU},        {"bfc", COST_ALU},
    {"bfi", COST_ALU},        {"bic", COST_ALU},        {"clz", COST_ALU},     {"eor", COST_ALU},        {"lsl", COST_ALU},
    {"lsr", COST_ALU},        {"movt", COST_ALU},       {"movw", COST_ALU},    {"mvn", COST_ALU},        {"orn", COST_ALU},
    {"orns", COST_ALU},       {"orr", COST_ALU},        {"rbit", COST_ALU},    {"ror", COST_ALU},        {"rrx", COST_ALU},
    {"rrxs", COST_ALU},       {"rsb", COST_ALU},        {"sbc", COST_ALU},     {"sbfx", COST_ALU},       {"ssat", COST_ALU},
    {"subw", COST_ALU},       {"teq", COST_ALU},        {"ubfx", COST_ALU},    {"usat", COST_ALU},       {"neg", COST_ALU},
    {"mul", COST_MUL},        {"mla", COST_MLA},        {"mls", COST_MLA},     {"umull", COST_MUL_LONG}, {"smull", COST_MUL_LONG},
    {"umlal", COST_MLA_LONG}, {"smlal", COST_MLA_LONG}, {"udiv", COST_DIV},    {"sdiv", COST_DIV},       {"ldrd", COST_PAIR},
    {"strd", COST_PAIR},      {"ldmdb", COST_MULTI},    {"stmdb", COST_MULTI}, {"cbz", COST_BRANCH},     {"cbnz", COST_BRANCH},
    {"tbb", COST_TABLE},      {"tbh", COST_TABLE},
};

/* What the DSP extension of Cortex-M4 adds: one cycle each (DDI 0439D, table 3-2). */
static const char *const names_dsp[] = {
    "pkhbt",  "pkhtb",  "qadd",    "qdadd",   "qdsub",   "qsub",    "sadd16",  "sadd8",   "sel",     "shadd16", "smlabb",
    "smlabt", "smlad",  "smladx",  "smlalbb", "smlalbt", "smlaltb", "smlaltt", "smlatb",  "smlatt",  "smlawb",  "smlawt",
    "smlsd",  "smmla",  "smmlar",  "smmls",   "smmul",   "smmulr",  "smuad",   "smuadx",  "smulbb",  "smulbt",  "smultb",
    "smultt", "smulwb", "smulwt",  "smusd",   "ssat16",  "ssub16",  "ssub8",   "sxtab",   "sxtab16", "sxtah",   "sxtb16",
    "uadd16", "uadd8",  "uhadd16", "uhadd8",  "umaal",   "uqadd16", "uqadd8",  "uqsub16", "uqsub8",  "usad8",   "usada8",
    "usat16", "usub16", "usub8",   "uxtab",   "uxtab16", "uxtah",   "uxtb16",
};

const cycle_model *cycle_model_find(const char *core)
{
    size_t k;
    for (k = 0; k < sizeof models / sizeof models[0]; k++) {
        if (!strcmp(models[k].core, core)) return &models[k];
    }
    return NULL;
}

static enum cost_class look_up(const cost_name *names, size_t n, const char *name)
{
    while (n-- > 0) {
        if (!strcmp(names[n].name, name)) return names[n].cost;
    }
    return (enum cost_class)0;
}

/* 0 for what the core does not have. */
static enum cost_class class_of(const cycle_model *model, const instruction *i)
{
    enum cost_class c = look_up(names_v6, sizeof names_v6 / sizeof names_v6[0], i->mnemonic);
    size_t k;
    if (!c && i->flow == FLOW_BRANCH && i->mnemonic[0] == 'b') return COST_BRANCH; /* bne and its like */
    if (c || !model->v7) return c;
    if (i->mnemonic[0] == 'i' && i->mnemonic[1] == 't') return COST_IT;
    c = look_up(names_v7, sizeof names_v7 / sizeof names_v7[0], i->mnemonic);
    for (k = 0; !c && model->dsp && k < sizeof names_dsp / sizeof names_dsp[0]; k++) {
        if (!strcmp(names_dsp[k], i->mnemonic)) c = COST_ALU;
    }
    return c;
}

/* Registers in {r0, r4-r7, lr}. */
static int list_length(const char *operands)
{
    const char *p = strchr(operands, '{');
    int n = 0;
    if (!p) return 0;
    for (p++; *p && *p != '}';) {
        if (*p == 'r' && isdigit((unsigned char)p[1])) {
            char *end;
            long first = strtol(p + 1, &end, 10);
            n += *end == '-' ? (int)(strtol(end + 2, &end, 10) - first + 1) : 1;
            p = end;
        } else if (isalpha((unsigned char)*p)) { /* lr, pc, ip, sl, fp */
            n++;
            while (isalpha((unsigned char)*p)) p++;
        } else {
            p++;
        }
    }
    return n;
}

/* Whether a register stands in the address [...] of an instruction. */
static bool in_address(const instruction *i, const char *name, size_t n)
{
    const char *p = strchr(i->operands, '['), *end = p ? strchr(p, ']') : NULL;
    for (; p && p < end; p++) {
        if (!strncmp(p, name, n) && !isalnum((unsigned char)p[n]) && !isalnum((unsigned char)p[-1])) return true;
    }
    return false;
}

/* Whether what was executed right before writes a register of this one's address: its first operand. */
static bool address_from(const instruction *i, const instruction *before)
{
    return before && in_address(i, before->operands, strcspn(before->operands, ", \t"));
}

static cycles same(int64_t n)
{
    cycles c = {n, n, n};
    return c;
}

static cycles single_access(const cycle_model *model, const instruction *i, const instruction *before, enum cost_class c)
{
    cycles out = {2, 2, 2};
    enum cost_class last = before ? class_of(model, before) : (enum cost_class)0;
    const char *comma = strchr(i->operands, '[');
    bool by_register = comma && (comma = strchr(comma, ',')) && comma[1] == ' ' && comma[2] != '#' && strchr(comma, ']');
    if (!model->v7) return out;
    out.least = 1;
    if (c == COST_STORE && !by_register) {
        out.nominal = 1;
    } else if (last == COST_LOAD && !before->conditional && before->flow == FLOW_NEXT && !address_from(i, before)) {
        out.nominal = 1;
    }
    if (last == COST_ALU && address_from(i, before)) out.most++;
    if (in_address(i, "pc", 2)) out.most++;
    return out;
}

static cycles cost_of(const cycle_model *model, const instruction *i, const instruction *before, enum cost_class c)
{
    int n = list_length(i->operands);
    cycles out;
    switch (c) {
    case COST_MUL:
        return model->mul;
    case COST_MLA:
        return model->mla;
    case COST_MUL_LONG:
        return model->mul_long;
    case COST_MLA_LONG:
        return model->mla_long;
    case COST_DIV:
        return model->div;
    case COST_PAIR:
        return same(3);
    case COST_CALL:
        return model->call;
    case COST_EXCHANGE:
        return model->exchange;
    case COST_LOAD:
    case COST_STORE:
        out = single_access(model, i, before, c);
        break;
    case COST_MULTI:
        out = same(1 + n);
        break;
    default:
        out = same(1);
        break;
    }
    if (c == COST_BRANCH && i->flow == FLOW_JUMP) return model->branch;
    if (c == COST_ALU && i->flow == FLOW_JUMP_TO) return model->exchange; /* mov pc, add pc */
    if (c == COST_IT) out.least = 0;
    if (c == COST_TABLE || (c == COST_LOAD && i->flow != FLOW_NEXT)) {
        out.least = (c == COST_TABLE ? 2 : 1) + model->branch.least;
        out.nominal = (c == COST_TABLE ? 2 : 1) + model->branch.nominal;
        out.most = (c == COST_TABLE ? 2 : 1) + model->branch.most;
    }
    if (c == COST_MULTI && i->flow == FLOW_RETURN) {
        out.least = n + model->pop_pc.least;
        out.nominal = n + model->pop_pc.nominal;
        out.most = n + model->pop_pc.most;
    }
    return out;
}

/* A jump of an IT block shows by where control goes whether it was skipped. */
static bool skips_show(const instruction *i) { return i->conditional && i->flow != FLOW_NEXT && i->flow != FLOW_BRANCH; }

bool cycle_cost(const cycle_model *model, const instruction *i, const instruction *before, cycles *out)
{
    enum cost_class c = class_of(model, i);
    *out = same(0);
    if (!c) return false;
    *out = skips_show(i) ? same(1) : cost_of(model, i, before, c);
    if (i->conditional && i->flow == FLOW_NEXT) out->least = 1;
    return true;
}

cycles cycle_taken(const cycle_model *model, const instruction *i)
{
    cycles out = same(0);
    if (i->flow == FLOW_BRANCH) out = model->branch;
    if (skips_show(i)) out = cost_of(model, i, NULL, class_of(model, i));
    if (i->flow == FLOW_BRANCH || skips_show(i)) {
        out.least--;
        out.nominal--;
        out.most--;
    }
    return out;
}
