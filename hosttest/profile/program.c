/* SPDX-License-Identifier: MIT */
/* Reads a listing of objdump: symbols first, instructions after them. */
#include "program.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void profile_fail(const char *format, ...)
{
    va_list list;
    fflush(stdout);
    fputs("profile: ", stderr);
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    fputc('\n', stderr);
    exit(2);
}

static void *resize(void *old, size_t bytes)
{
    void *p = realloc(old, bytes);
    if (!p) profile_fail("out of memory");
    return p;
}

static char *read_whole(const char *path)
{
    FILE *f = fopen(path, "rb");
    char *text;
    long n = 0;
    if (!f) profile_fail("cannot read %s", path);
    if (fseek(f, 0, SEEK_END) || (n = ftell(f)) < 0 || fseek(f, 0, SEEK_SET)) profile_fail("cannot read %s", path);
    text = resize(NULL, (size_t)n + 1);
    if (fread(text, 1, (size_t)n, f) != (size_t)n) profile_fail("cannot read %s", path);
    text[n] = 0;
    fclose(f);
    return text;
}

static bool begins(const char *s, const char *with) { return !strncmp(s, with, strlen(with)); }

static bool any_of(const char *s, const char *const *list)
{
    for (; *list; list++) {
        if (!strcmp(s, *list)) return true;
    }
    return false;
}

/* ---------------------------------------------------------------------------------------------------------------- symbols */

static uint8_t mark_of(const char *name)
{
    if (!strcmp(name, "profile_begin")) return MARK_BEGIN;
    if (!strcmp(name, "profile_end")) return MARK_END;
    if (begins(name, "__gnu_thumb1_case_")) return MARK_SWITCH;
    if (begins(name, "profile_nibble_") && isxdigit((unsigned char)name[15]) && !name[16])
        return (uint8_t)(MARK_NIBBLE + strtol(name + 15, NULL, 16));
    return MARK_NONE;
}

typedef struct symbol {
    uint32_t start, size;
    const char *name;
    bool global, function;
} symbol;

/* By address; of those at one address the one to be called by comes first: functions, then globals, then by name. */
static int by_address(const void *a, const void *b)
{
    const symbol *p = a, *q = b;
    if (p->start != q->start) return p->start < q->start ? -1 : 1;
    if (p->function != q->function) return p->function ? -1 : 1;
    if (p->global != q->global) return p->global ? -1 : 1;
    return strcmp(p->name, q->name);
}

/* "00000040 g     F .text<tab>00000024 main": functions, and global labels without a type (assembler). Cuts the line up. */
static bool symbol_read(symbol *s, char *line, enum machine machine)
{
    char *flags, *section, *size, *name, *end;
    s->start = (uint32_t)strtoul(line, &end, 16);
    if (end == line || *end != ' ' || strlen(end) < 10) return false;
    flags = end + 1;
    section = flags + 8;
    if (strchr(flags, '\t') == NULL || strchr(flags, '\t') < section) return false;
    size = strchr(section, '\t');
    *size++ = 0;
    s->size = (uint32_t)strtoul(size, &name, 16);
    while (*name == ' ') name++;
    if (begins(name, ".hidden ")) name += 8;
    s->name = name;
    s->global = flags[0] == 'g' || flags[1] == 'w';
    s->function = flags[6] == 'F';
    if (machine == MACHINE_ARM) s->start &= ~1u;
    return (s->function || (flags[6] == ' ' && flags[5] == ' ' && s->global)) && section[0] != '*';
}

/* Keeps one symbol per address; a label inside a sized function is part of it. */
static void functions_set(program *p, symbol *s, uint32_t n)
{
    uint32_t i, end = 0;
    qsort(s, n, sizeof *s, by_address);
    p->functions = resize(NULL, (n + 1) * sizeof *p->functions);
    for (i = 0; i < n; i++) {
        function *f = &p->functions[p->function_count];
        if (p->function_count && f[-1].start == s[i].start) continue;
        if (!s[i].function && s[i].start < end) continue;
        f->name = s[i].name;
        f->start = s[i].start;
        f->size = s[i].size;
        f->mark = mark_of(s[i].name);
        p->function_count++;
        if (s[i].start + s[i].size > end) end = s[i].start + s[i].size;
    }
    if (!p->function_count) profile_fail("no functions in the listing");
}

/* The last function that begins at or before an address. */
static uint32_t function_at(const program *p, uint32_t address)
{
    uint32_t low = 0, high = p->function_count;
    while (high - low > 1) {
        uint32_t middle = (low + high) / 2;
        if (p->functions[middle].start <= address) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

/* ----------------------------------------------------------------------------------------------------------- instructions */

/* The address in "... 1c <main+0x4>" or "... ; 0x1c <main+0x4>"; the last word where there is no <. */
static uint32_t target_of(const char *operands)
{
    const char *at = strchr(operands, '<'), *word;
    if (!at) at = operands + strlen(operands);
    while (at > operands && isspace((unsigned char)at[-1])) at--;
    for (word = at; word > operands && !strchr(" \t,;", word[-1]);) word--;
    return (uint32_t)strtoul(word, NULL, 16);
}

static const char *const conditions[] = {"eq", "ne", "cs", "cc", "mi", "pl", "vs", "vc", "hi",
                                         "ls", "ge", "lt", "gt", "le", "hs", "lo", NULL};

static void set_direct(instruction *i, enum flow flow)
{
    i->flow = (uint8_t)flow;
    i->target = target_of(i->operands);
}

/* Thumb. In an IT block the mnemonic loses its condition. */
static void flow_arm(instruction *i, unsigned it)
{
    static const char *const plain_b[] = {"b", "wls", "le", "cbz", "cbnz", NULL};
    static const char *const loads[] = {"pop", "ldmia", "ldm", "ldmdb", "ldmfd", NULL};
    char *m = i->mnemonic, *dot = strchr(m, '.');
    size_t n;
    if (dot && (!strcmp(dot, ".n") || !strcmp(dot, ".w"))) *dot = 0;
    n = strlen(m);
    i->conditional = it > 0;
    if (it && n > 2 && any_of(m + n - 2, conditions)) m[n - 2] = 0;
    if (any_of(m, plain_b)) {
        set_direct(i, strcmp(m, "b") || it ? FLOW_BRANCH : FLOW_JUMP);
    } else if (n == 3 && m[0] == 'b' && any_of(m + 1, conditions)) {
        set_direct(i, FLOW_BRANCH);
    } else if (!strcmp(m, "bl")) {
        set_direct(i, FLOW_CALL);
    } else if (!strcmp(m, "bx")) {
        i->flow = begins(i->operands, "lr") ? FLOW_RETURN : FLOW_JUMP_TO;
    } else if (!strcmp(m, "blx")) {
        i->flow = FLOW_CALL_TO;
    } else if (any_of(m, loads) && strstr(i->operands, "pc}")) {
        i->flow = FLOW_RETURN;
    } else if (begins(i->operands, "pc, ") && strcmp(m, "cmp")) {
        i->flow = !strcmp(m, "ldr") && strstr(i->operands, "[sp]") ? FLOW_RETURN : FLOW_JUMP_TO;
    } else if (!strcmp(m, "tbb") || !strcmp(m, "tbh")) {
        i->flow = FLOW_JUMP_TO;
    } else if (!strcmp(m, "bkpt") || !strcmp(m, "udf") || !strcmp(m, "svc")) {
        i->flow = FLOW_STOP;
    }
}

static void flow_riscv(instruction *i)
{
    const char *m = i->mnemonic;
    if (!strcmp(m, "ret")) {
        i->flow = FLOW_RETURN;
    } else if (!strcmp(m, "j")) {
        set_direct(i, FLOW_JUMP);
    } else if (!strcmp(m, "jal")) {
        set_direct(i, begins(i->operands, "zero,") ? FLOW_JUMP : FLOW_CALL);
    } else if (!strcmp(m, "jr")) {
        i->flow = FLOW_JUMP_TO;
    } else if (!strcmp(m, "jalr")) {
        i->flow = begins(i->operands, "zero,") ? FLOW_JUMP_TO : FLOW_CALL_TO;
    } else if (!strcmp(m, "ebreak") || !strcmp(m, "ecall") || !strcmp(m, "mret")) {
        i->flow = FLOW_STOP;
    } else if (m[0] == 'b') {
        set_direct(i, FLOW_BRANCH);
    }
}

static void flow_avr(instruction *i)
{
    static const char *const skips[] = {"cpse", "sbrc", "sbrs", "sbic", "sbis", NULL};
    const char *m = i->mnemonic;
    if (!strcmp(m, "ret") || !strcmp(m, "reti")) {
        i->flow = FLOW_RETURN;
    } else if (!strcmp(m, "jmp") || !strcmp(m, "rjmp")) {
        set_direct(i, FLOW_JUMP);
    } else if (!strcmp(m, "call") || !strcmp(m, "rcall")) {
        set_direct(i, FLOW_CALL);
    } else if (!strcmp(m, "ijmp") || !strcmp(m, "eijmp")) {
        i->flow = FLOW_JUMP_TO;
    } else if (!strcmp(m, "icall") || !strcmp(m, "eicall")) {
        i->flow = FLOW_CALL_TO;
    } else if (any_of(m, skips)) {
        i->flow = FLOW_SKIP;
    } else if (begins(m, "br") && strcmp(m, "break")) {
        set_direct(i, FLOW_BRANCH);
    } else if (!strcmp(m, "sleep") || !strcmp(m, "break")) {
        i->flow = FLOW_STOP;
    }
}

static void flow_xtensa(instruction *i)
{
    char *m = i->mnemonic, *dot = strstr(m, ".n");
    if (dot && !dot[2]) *dot = 0;
    if (!strcmp(m, "ret")) {
        i->flow = FLOW_RETURN;
    } else if (!strcmp(m, "j")) {
        set_direct(i, FLOW_JUMP);
    } else if (!strcmp(m, "call0")) {
        set_direct(i, FLOW_CALL);
    } else if (!strcmp(m, "jx")) {
        i->flow = FLOW_JUMP_TO;
    } else if (!strcmp(m, "callx0")) {
        i->flow = FLOW_CALL_TO;
    } else if (begins(m, "break") || !strcmp(m, "simcall")) {
        i->flow = FLOW_STOP;
    } else if (m[0] == 'b') {
        set_direct(i, FLOW_BRANCH);
    }
}

static void flow_x86(instruction *i)
{
    const char *m = i->mnemonic;
    bool indirect = i->operands[0] == '*';
    if (begins(m, "ret")) {
        i->flow = FLOW_RETURN;
    } else if (begins(m, "rep")) {
        i->repeats = true;
    } else if (begins(m, "call")) {
        if (indirect) {
            i->flow = FLOW_CALL_TO;
        } else {
            set_direct(i, FLOW_CALL);
        }
    } else if (begins(m, "jmp")) {
        if (indirect) {
            i->flow = FLOW_JUMP_TO;
        } else {
            set_direct(i, FLOW_JUMP);
        }
    } else if (m[0] == 'j') {
        set_direct(i, FLOW_BRANCH);
    } else if (!strcmp(m, "syscall") || !strcmp(m, "hlt") || !strcmp(m, "ud2")) {
        i->flow = FLOW_STOP;
    }
}

/* Thumb states a length in its first halfword; the listing must agree. */
static void check_length(const instruction *i, const char *hex)
{
    unsigned first = (unsigned)strtoul(hex, NULL, 16), want = (first >> 8) >= 0xe8 && (first >> 11) != 0x1c ? 4 : 2;
    if (want != i->length)
        profile_fail("%x: %s of %u bytes, but its first halfword says %u", i->address, i->mnemonic, i->length, want);
}

/* "    414c:<tab>b510      <tab>push<tab>{r4, lr}". False for anything else, data among it. */
static bool instruction_read(const program *p, instruction *i, char *line)
{
    char *end, *hex, *word, *operands;
    unsigned digits = 0;
    i->address = (uint32_t)strtoul(line, &end, 16);
    if (end == line || *end != ':' || end[1] != '\t') return false;
    for (hex = word = end + 2; *word && *word != '\t'; word++) digits += isxdigit((unsigned char)*word) ? 1 : 0;
    if (*word != '\t' || digits == 0) return false;
    *word++ = 0;
    i->length = (uint8_t)(digits / 2);
    operands = word + strcspn(word, " \t");
    if (*operands) *operands++ = 0;
    while (isspace((unsigned char)*operands)) operands++;
    if (word[0] == '.' || word[0] == '(' || word[0] == '<') return false;
    if (strlen(word) >= sizeof i->mnemonic) profile_fail("%x: no room for the mnemonic %s", i->address, word);
    strcpy(i->mnemonic, word);
    i->operands = operands;
    i->flow = FLOW_NEXT;
    i->function = function_at(p, i->address);
    if (p->machine == MACHINE_ARM) check_length(i, hex);
    return true;
}

static void instruction_flow(const program *p, instruction *i, unsigned *it)
{
    switch (p->machine) {
    case MACHINE_ARM:
        flow_arm(i, *it);
        if (*it) --*it;
        if (i->mnemonic[0] == 'i' && i->mnemonic[1] == 't') *it = (unsigned)strlen(i->mnemonic) - 1;
        break;
    case MACHINE_RISCV:
        flow_riscv(i);
        break;
    case MACHINE_AVR:
        flow_avr(i);
        break;
    case MACHINE_XTENSA:
        flow_xtensa(i);
        break;
    case MACHINE_X86:
        flow_x86(i);
        break;
    }
}

/* ------------------------------------------------------------------------------------------------------------ the listing */

static enum machine machine_of(const char *line)
{
    static const struct {
        const char *name;
        enum machine machine;
    } known[] = {{"littlearm", MACHINE_ARM},
                 {"littleriscv", MACHINE_RISCV},
                 {"elf32-avr", MACHINE_AVR},
                 {"elf32-xtensa-le", MACHINE_XTENSA},
                 {"elf64-x86-64", MACHINE_X86}};
    size_t k;
    for (k = 0; k < sizeof known / sizeof known[0]; k++) {
        if (strstr(line, known[k].name)) return known[k].machine;
    }
    profile_fail("unknown kind of image:%s", line);
    return MACHINE_ARM;
}

static void index_set(program *p)
{
    uint32_t i, last;
    if (!p->instructions) profile_fail("no instructions in the listing");
    p->base = last = p->list[0].address;
    for (i = 0; i < p->instructions; i++) {
        if (p->list[i].address < p->base) p->base = p->list[i].address;
        if (p->list[i].address > last) last = p->list[i].address;
    }
    p->extent = last - p->base + 1;
    if (p->extent > 1u << 27) profile_fail("code reaches over %u bytes: more than this program can index", p->extent);
    p->at = calloc(p->extent, sizeof *p->at);
    if (!p->at) profile_fail("out of memory");
    for (i = 0; i < p->instructions; i++) p->at[p->list[i].address - p->base] = i + 1;
}

void program_read(program *p, const char *path)
{
    symbol *symbols = NULL;
    uint32_t symbol_count = 0, room = 0;
    bool known = false, table = false;
    unsigned it = 0;
    char *line, *next;
    memset(p, 0, sizeof *p);
    p->text = read_whole(path);
    for (line = p->text; *line; line = next) {
        next = line + strcspn(line, "\n");
        if (*next) *next++ = 0;
        if (!known && strstr(line, "file format ")) {
            p->machine = machine_of(strstr(line, "file format ") + 11);
            known = true;
        } else if (!strcmp(line, "SYMBOL TABLE:")) {
            table = true;
        } else if (begins(line, "Disassembly of section") && table) {
            functions_set(p, symbols, symbol_count);
            table = false;
        } else if (table) {
            if (symbol_count % 1024 == 0) symbols = resize(symbols, (symbol_count + 1024) * sizeof *symbols);
            if (symbol_read(&symbols[symbol_count], line, p->machine)) symbol_count++;
        } else if (known && p->function_count) {
            if (p->instructions == room) p->list = resize(p->list, (room = room * 2 + 4096) * sizeof *p->list);
            memset(&p->list[p->instructions], 0, sizeof *p->list);
            if (instruction_read(p, &p->list[p->instructions], line)) instruction_flow(p, &p->list[p->instructions++], &it);
        }
    }
    free(symbols);
    if (!known) profile_fail("%s is not a listing of objdump", path);
    index_set(p);
}

const instruction *program_at(const program *p, uint32_t address)
{
    uint32_t i = address - p->base;
    return i < p->extent && p->at[i] ? &p->list[p->at[i] - 1] : 0;
}
