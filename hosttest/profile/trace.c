/* SPDX-License-Identifier: MIT */
/* Counts, checks and the stack. What it writes, a line each:
 *
 *   core NAME none|table|told                  where cycles come from
 *   note TEXT                                  what the program says, in order
 *   region INSTRUCTIONS LEAST NOMINAL MOST VIOLATIONS
 *   function CALLS SELF... INCLUSIVE... NAME   four figures each: instructions, cycles least, nominal, most
 *   at ADDRESS COUNT TAKEN NOMINAL             with the option listing
 *   violation FROM TO: TEXT                    the first few of a region
 *   unknown ADDRESS MNEMONIC                   executed, but not in the cycle table
 *   end REGIONS VIOLATIONS UNKNOWN             the last line: without it the run is not complete
 */
#include "trace.h"

#include <stdlib.h>
#include <string.h>

#define HASH 65536u
#define DEPTH 1000
#define NOWHERE 0xffffffffu /* a return address that none has */

typedef struct figures {
    uint64_t instructions;
    cycles cycle;
} figures;

typedef struct tally {
    figures self, inclusive, entered;
    uint64_t calls;
    unsigned depth; /* how often it is on the stack */
} tally;

typedef struct frame {
    uint32_t function, back;
    bool tail; /* took the place of the one below: left together with it */
} frame;

struct trace {
    const program *program;
    const cycle_model *model;
    trace_options options;
    block *same[HASH], *all, *last;
    figures now;
    tally *tallies;
    frame stack[DEPTH];
    unsigned depth;
    enum { TRACE_IDLE, TRACE_WAITING, TRACE_OPEN } state;
    int64_t last_told;
    uint64_t *count, *takens; /* by instruction */
    cycles *cycle;
    unsigned regions, unknown, high;
    uint64_t violations, violations_all;
    bool half;
    char note[400], scene[100]; /* scene: what the last note announced, for progress */
    size_t note_length;
};

static cycles plus(cycles a, cycles b)
{
    a.least += b.least;
    a.nominal += b.nominal;
    a.most += b.most;
    return a;
}

static cycles times(cycles a, int64_t n)
{
    a.least *= n;
    a.nominal *= n;
    a.most *= n;
    return a;
}

static figures difference(figures a, figures b)
{
    a.instructions -= b.instructions;
    a.cycle = plus(a.cycle, times(b.cycle, -1));
    return a;
}

static figures sum(figures a, figures b)
{
    a.instructions += b.instructions;
    a.cycle = plus(a.cycle, b.cycle);
    return a;
}

static void *zeroed(size_t n, size_t bytes)
{
    void *p = calloc(n, bytes);
    if (!p) profile_fail("out of memory");
    return p;
}

trace *trace_new(const program *p, const trace_options *options)
{
    trace *t = zeroed(1, sizeof *t);
    t->program = p;
    t->options = *options;
    t->model = options->told ? NULL : cycle_model_find(options->core);
    t->tallies = zeroed(p->function_count, sizeof *t->tallies);
    t->count = zeroed(p->instructions, sizeof *t->count);
    t->takens = zeroed(p->instructions, sizeof *t->takens);
    t->cycle = zeroed(p->instructions, sizeof *t->cycle);
    fprintf(options->out, "core %s %s\n", options->core, options->told ? "told" : t->model ? "table" : "none");
    return t;
}

/* ----------------------------------------------------------------------------------------------------------------- blocks */

static uint8_t mark_of(const trace *t, const block *b)
{
    const function *f = &t->program->functions[b->first->function];
    return f->start == b->address ? f->mark : (uint8_t)MARK_NONE;
}

static void block_cost(trace *t, block *b)
{
    const instruction *i;
    cycles c;
    for (i = b->first; i <= b->last; i++) {
        if (!cycle_cost(t->model, i, i > b->first ? i - 1 : NULL, &c)) b->unknown = true;
        b->cost = plus(b->cost, c);
    }
    b->taken = cycle_taken(t->model, b->last);
    if (b->last->flow == FLOW_BRANCH && b->last->target == b->end)
        profile_fail("%x: whether this branch is taken cannot be told", b->last->address);
    if (b->first > t->program->list && b->first[-1].address + b->first[-1].length == b->address &&
        b->first[-1].flow == FLOW_NEXT) {
        cycles alone;
        cycle_cost(t->model, b->first, NULL, &alone);
        cycle_cost(t->model, b->first, b->first - 1, &c);
        b->joined = plus(c, times(alone, -1));
    }
}

block *trace_block(trace *t, const instruction *first, uint32_t n)
{
    block **head = &t->same[(first->address * 2654435761u + n) % HASH], *b;
    const instruction *i;
    for (b = *head; b; b = b->next_same) {
        if (b->first == first && b->instructions == n) return b;
    }
    b = zeroed(1, sizeof *b);
    b->first = first;
    b->last = first + n - 1;
    b->address = first->address;
    b->end = b->last->address + b->last->length;
    b->instructions = n;
    for (i = first; i < b->last; i++) {
        if (i[1].address != i->address + i->length) profile_fail("%x: not followed by %x", i->address, i[1].address);
    }
    b->marked = mark_of(t, b) != MARK_NONE && mark_of(t, b) != MARK_SWITCH;
    if (t->model) block_cost(t, b);
    b->next_same = *head;
    *head = b;
    b->next = t->all;
    t->all = b;
    return b;
}

/* -------------------------------------------------------------------------------------------------------------- the stack */

static void violation(trace *t, uint32_t from, uint32_t to, const char *text)
{
    if (t->violations++ < 10) fprintf(t->options.out, "violation %x %x: %s\n", from, to, text);
}

/* TAIL: by a jump, in place of the one that jumps. INNER: into the middle of itself, no new call of it. */
enum manner { CALL, TAIL, INNER };

static void enter(trace *t, uint32_t f, uint32_t back, enum manner manner)
{
    tally *y = &t->tallies[f];
    if (t->depth == DEPTH) profile_fail("calls nest deeper than %d in %s", DEPTH, t->program->functions[f].name);
    t->stack[t->depth].function = f;
    t->stack[t->depth].back = back;
    t->stack[t->depth++].tail = manner == TAIL;
    if (manner != INNER) y->calls++;
    if (y->depth++ == 0) y->entered = t->now;
}

static void leave(trace *t)
{
    tally *y = &t->tallies[t->stack[--t->depth].function];
    if (--y->depth == 0) y->inclusive = sum(y->inclusive, difference(t->now, y->entered));
}

/* Control goes to b by a jump or by going on. If that is another function it takes the place of this one, unless it is one that
 * this one has taken the place of: then control is back there. */
static void transfer(trace *t, const block *b)
{
    uint32_t f = b->first->function;
    unsigned k = t->depth - 1;
    if (t->stack[k].function == f) return;
    while (t->stack[k].tail && t->stack[k].function != f) k--;
    if (t->stack[k].function == f) {
        while (t->depth > k + 1) leave(t);
    } else {
        enter(t, f, t->stack[t->depth - 1].back, TAIL);
    }
}

static void come_back(trace *t, const block *from, const block *b)
{
    unsigned k = t->depth;
    bool from_switch = t->program->functions[from->last->function].mark == MARK_SWITCH;
    while (k > 0 && t->stack[k - 1].tail) k--;
    if (k <= 1) {
        violation(t, from->last->address, b->address, "return out of the function that called profile_begin");
        return;
    }
    if (t->stack[k - 1].back != b->address && !from_switch)
        violation(t, from->last->address, b->address, "return to where no call was");
    while (t->depth >= k) leave(t);
    if (t->stack[t->depth - 1].function != b->first->function)
        violation(t, from->last->address, b->address, "return into another function");
}

static bool begins_function(const trace *t, const block *b)
{
    return t->program->functions[b->first->function].start == b->address;
}

/* A call into the middle of the function that it is made in: in Thumb-1 a far jump, which it has no other instruction for; else a
 * piece of assembler that is called from several places. One to the next instruction makes room on the stack (AVR). */
static void call(trace *t, const block *from, const block *b)
{
    bool inner = b->first->function == from->last->function && !begins_function(t, b);
    if (b->address == from->end || (inner && t->program->machine == MACHINE_ARM)) return;
    enter(t, b->first->function, from->end, inner ? INNER : CALL);
}

static void jump_to(trace *t, const block *from, const block *b)
{
    unsigned k = t->depth - 1;
    while (k > 0 && t->stack[k].tail) k--;
    if (k > 0 && t->stack[k].back == b->address) {
        come_back(t, from, b);
    } else if (b->first->function == from->last->function || begins_function(t, b)) {
        transfer(t, b);
    } else {
        violation(t, from->last->address, b->address, "jump into the middle of another function");
    }
}

/* From the end of one block to the start of another: may that be, and what does it do to the stack? */
static void follow(trace *t, const block *from, const block *b)
{
    const instruction *i = from->last;
    bool on = b->address == from->end;
    switch (i->flow) {
    case FLOW_NEXT:
    case FLOW_STOP:
        if (!on && !(i->repeats && b->address == i->address)) violation(t, i->address, b->address, "does not go on");
        transfer(t, b);
        break;
    case FLOW_SKIP:
        if (!on && !(i[1].address == from->end && b->address == i[1].address + i[1].length))
            violation(t, i->address, b->address, "skips more than one instruction");
        transfer(t, b);
        break;
    case FLOW_JUMP:
    case FLOW_BRANCH:
        if (b->address != i->target && !(on && i->flow == FLOW_BRANCH))
            violation(t, i->address, b->address, "branch to another address than its target");
        transfer(t, b);
        break;
    case FLOW_CALL:
        if (b->address != i->target) violation(t, i->address, b->address, "call of another address than its target");
        call(t, from, b);
        break;
    case FLOW_CALL_TO:
        if (!begins_function(t, b)) violation(t, i->address, b->address, "call of no function");
        call(t, from, b);
        break;
    case FLOW_RETURN:
        if (!(on && i->conditional)) come_back(t, from, b);
        break;
    case FLOW_JUMP_TO:
        if (!(on && i->conditional)) jump_to(t, from, b);
        break;
    default:
        violation(t, i->address, b->address, "unknown flow");
        break;
    }
}

/* ---------------------------------------------------------------------------------------------------------------- regions */

static void region_open(trace *t, const block *b)
{
    uint32_t f;
    block *k;
    for (k = t->all; k; k = k->next) {
        k->count = k->takens = k->joins = 0;
        k->told = 0;
    }
    for (f = 0; f < t->program->function_count; f++) memset(&t->tallies[f], 0, sizeof t->tallies[f]);
    memset(&t->now, 0, sizeof t->now);
    t->violations = 0;
    t->depth = 0;
    t->state = TRACE_OPEN;
    enter(t, b->first->function, NOWHERE, CALL);
}

/* Blocks into instructions, instructions into functions. minus: the call of profile_end, which is not counted. */
static void spread(trace *t, const block *minus)
{
    const instruction *list = t->program->list;
    const block *b;
    memset(t->count, 0, t->program->instructions * sizeof *t->count);
    memset(t->takens, 0, t->program->instructions * sizeof *t->takens);
    memset(t->cycle, 0, t->program->instructions * sizeof *t->cycle);
    for (b = t->all; b; b = b->next) {
        const instruction *i;
        if (!b->count) continue;
        if (b->unknown) t->unknown++;
        for (i = b->first; i <= b->last; i++) {
            size_t k = (size_t)(i - list);
            uint64_t n = b->count - (b == minus && i == b->last ? 1 : 0);
            cycles c = {0, 0, 0};
            if (t->model && !cycle_cost(t->model, i, i > b->first ? i - 1 : NULL, &c))
                fprintf(t->options.out, "unknown %x %s\n", i->address, i->mnemonic);
            t->count[k] += n;
            t->cycle[k] = plus(t->cycle[k], times(c, (int64_t)n));
        }
        t->takens[b->last - list] += b->takens;
        t->cycle[b->last - list] = plus(t->cycle[b->last - list], times(b->taken, (int64_t)b->takens));
        t->cycle[b->first - list] = plus(t->cycle[b->first - list], times(b->joined, (int64_t)b->joins));
        t->cycle[b->first - list] = plus(t->cycle[b->first - list], (cycles){b->told, b->told, b->told});
    }
}

static void print_figures(FILE *out, figures f)
{
    fprintf(out, " %llu %lld %lld %lld", (unsigned long long)f.instructions, (long long)f.cycle.least, (long long)f.cycle.nominal,
            (long long)f.cycle.most);
}

static bool equal(figures a, figures b)
{
    return a.instructions == b.instructions && a.cycle.least == b.cycle.least && a.cycle.nominal == b.cycle.nominal &&
           a.cycle.most == b.cycle.most;
}

/* The figures of a region; the sum over instructions must be what was counted as they went by. */
static void region_print(trace *t)
{
    FILE *out = t->options.out;
    figures total = {0, {0, 0, 0}};
    uint32_t k;
    for (k = 0; k < t->program->instructions; k++) {
        const instruction *i = &t->program->list[k];
        figures f = {t->count[k], t->cycle[k]};
        if (!t->count[k]) continue;
        t->tallies[i->function].self = sum(t->tallies[i->function].self, f);
        total = sum(total, f);
        if (t->options.listing)
            fprintf(out, "at %x %llu %llu %lld\n", i->address, (unsigned long long)t->count[k], (unsigned long long)t->takens[k],
                    (long long)t->cycle[k].nominal);
    }
    if (!equal(total, t->now)) profile_fail("the sum over instructions is not what was counted as they were executed");
    for (k = 0; k < t->program->function_count; k++) {
        const tally *y = &t->tallies[k];
        if (!y->calls && !y->self.instructions) continue;
        fprintf(out, "function %llu", (unsigned long long)y->calls);
        print_figures(out, y->self);
        print_figures(out, y->inclusive);
        fprintf(out, " %s\n", t->program->functions[k].name);
    }
    fprintf(out, "region");
    print_figures(out, t->now);
    fprintf(out, " %llu\n", (unsigned long long)t->violations);
    fflush(out);
}

/* At the first instruction of profile_end, called by from. */
static void region_close(trace *t, const block *from, const block *b)
{
    cycles told = {t->last_told, t->last_told, t->last_told};
    figures call_of_end = {1, told};
    if (!t->options.told && t->model) cycle_cost(t->model, from->last, NULL, &call_of_end.cycle);
    if (from->last->target != b->address) violation(t, from->last->address, b->address, "profile_end reached without a call");
    while (t->depth > 1 && t->stack[t->depth - 1].tail) leave(t);
    if (t->depth != 1) violation(t, from->last->address, b->address, "profile_end called by another function than profile_begin");
    t->now = difference(t->now, call_of_end);
    while (t->depth > 0) leave(t);
    if (t->options.told) t->last->told -= t->last_told;
    spread(t, from);
    region_print(t);
    t->state = TRACE_IDLE;
    t->regions++;
    t->violations_all += t->violations;
    if (t->options.progress && t->scene[0])
        fprintf(stderr, "  %s %s: %.1f million instructions\n", t->options.core, t->scene, (double)t->now.instructions / 1e6);
}

static void say(trace *t, unsigned nibble)
{
    char scene[49], model[49];
    if (!t->half) {
        t->high = nibble;
        t->half = true;
        return;
    }
    t->half = false;
    nibble |= t->high << 4;
    if (nibble == '\n') {
        t->note[t->note_length] = 0;
        t->note_length = 0;
        fprintf(t->options.out, "note %s\n", t->note);
        if (sscanf(t->note, "scene %48s %48s", scene, model) == 2) {
            snprintf(t->scene, sizeof t->scene, "%s %s", scene, model);
        } else {
            t->scene[0] = 0;
        }
    } else if (t->note_length + 1 < sizeof t->note) {
        t->note[t->note_length++] = (char)nibble;
    }
}

/* A block at the start of a function with a meaning. */
static void marked(trace *t, block *b)
{
    uint8_t mark = mark_of(t, b);
    if (mark == MARK_END) {
        if (t->state != TRACE_OPEN) profile_fail("profile_end without profile_begin");
        region_close(t, t->last, b);
    } else if (t->state == TRACE_OPEN) {
        profile_fail("%s between profile_begin and profile_end", t->program->functions[b->first->function].name);
    } else if (mark == MARK_BEGIN) {
        t->state = TRACE_WAITING;
    } else {
        say(t, mark & 15u);
    }
}

/* From one block to the next, which goes on from it or is where it jumps to. */
static void go_on(trace *t, const block *from, block *b)
{
    if (from->last->flow != FLOW_NEXT) return;
    b->joins++;
    t->now.cycle = plus(t->now.cycle, b->joined);
}

static void go_to(trace *t, block *from)
{
    from->takens++;
    t->now.cycle = plus(t->now.cycle, from->taken);
}

/* The first time that b follows on from, and every time that the stack is concerned. */
static void go(trace *t, block *from, block *b)
{
    const enum flow flow = (enum flow)from->last->flow;
    const bool on = b->address == from->end, inside = b->first->function == from->last->function;
    const uint64_t before = t->violations;
    if (on) {
        go_on(t, from, b);
    } else {
        go_to(t, from);
    }
    follow(t, from, b);
    if (inside && t->violations == before && (flow == FLOW_NEXT || flow == FLOW_JUMP || flow == FLOW_BRANCH))
        *(on ? &from->on : &from->jump) = b;
}

static void count(trace *t, block *b, int64_t cost)
{
    const cycles told = {cost, cost, cost};
    b->count++;
    b->told += cost;
    t->last_told = cost;
    t->now.instructions += b->instructions;
    t->now.cycle = plus(t->now.cycle, t->options.told ? told : b->cost);
}

void trace_run(trace *t, block *b, int64_t cost)
{
    block *from = t->last;
    if (!b) {
        if (t->state == TRACE_OPEN) profile_fail("%x: goes on to code that is not in the listing", from->last->address);
        return;
    }
    if (b->marked) marked(t, b);
    t->last = b;
    if (b->marked) return;
    if (t->state == TRACE_IDLE) return;
    if (t->state == TRACE_WAITING) {
        if (t->program->functions[b->first->function].mark == MARK_BEGIN) return;
        region_open(t, b);
    } else if (b == from->on) {
        go_on(t, from, b);
    } else if (b == from->jump) {
        go_to(t, from);
    } else {
        go(t, from, b);
    }
    count(t, b, cost);
}

bool trace_end(trace *t)
{
    bool good = t->state == TRACE_IDLE && t->violations_all == 0 && t->unknown == 0;
    if (t->state != TRACE_IDLE) fprintf(t->options.out, "violation 0 0: the program ended before profile_end\n");
    fprintf(t->options.out, "end %u %llu %u\n", t->regions,
            (unsigned long long)(t->violations_all + (t->state != TRACE_IDLE ? 1 : 0)), t->unknown);
    fflush(t->options.out);
    return good;
}
