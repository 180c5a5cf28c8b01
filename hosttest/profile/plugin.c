/* SPDX-License-Identifier: MIT */
/* A plugin for QEMU 7.2 that feeds the profiler. Options: core=NAME listing=FILE (of objdump) out=FILE, and on request
 * each=on (every instruction by itself, which must give the same figures) at=on progress=on stream=FILE (addresses).
 *
 * Debian's QEMU loads plugins and ships no header for them: the few functions are declared here. The emulator is asked for
 * addresses only; lengths and opcodes come from the listing.
 */
#include "trace.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

struct qemu_plugin_tb;
struct qemu_plugin_insn;
typedef uint64_t qemu_plugin_id_t;
typedef void (*tb_translated)(qemu_plugin_id_t, struct qemu_plugin_tb *);
typedef void (*instruction_executed)(unsigned cpu, void *user);
typedef void (*emulator_exits)(qemu_plugin_id_t, void *user);

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, tb_translated cb);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *tb);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *tb, size_t i);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *i);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *i, instruction_executed cb, int flags, void *user);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, emulator_exits cb, void *user);

#define EXPORT __attribute__((visibility("default")))
EXPORT extern int qemu_plugin_version;
EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int argc, char **argv);
int qemu_plugin_version = 1;

static program image;
static trace *profile;
static FILE *stream;
static bool each;

static void executed(unsigned cpu, void *user)
{
    (void)cpu;
    if (stream) fprintf(stream, "%x\n", user ? ((const block *)user)->address : 0);
    trace_run(profile, user, 0);
}

/* Cuts what was translated into blocks that lie within one function; each tells when its first instruction is executed. */
static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *tb)
{
    size_t n = qemu_plugin_tb_n_insns(tb), k = 0;
    (void)id;
    while (k < n) {
        struct qemu_plugin_insn *head = qemu_plugin_tb_get_insn(tb, k);
        const instruction *first = program_at(&image, (uint32_t)qemu_plugin_insn_vaddr(head)), *i = first;
        size_t start = k++;
        while (first && !each && k < n) {
            const instruction *next = program_at(&image, (uint32_t)qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(tb, k)));
            if (next != i + 1 || next->address != i->address + i->length || next->function != first->function) break;
            i = next;
            k++;
        }
        qemu_plugin_register_vcpu_insn_exec_cb(head, executed, 0,
                                               first ? trace_block(profile, first, (uint32_t)(k - start)) : NULL);
    }
}

static void exits(qemu_plugin_id_t id, void *user)
{
    (void)id;
    (void)user;
    trace_end(profile);
    if (stream) fclose(stream);
}

EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int argc, char **argv)
{
    trace_options o = {NULL, NULL, false, false, false};
    const char *listing = NULL;
    int k;
    (void)info;
    for (k = 0; k < argc; k++) {
        char *value = strchr(argv[k], '=');
        if (!value) profile_fail("plugin option %s without a value", argv[k]);
        *value++ = 0;
        if (!strcmp(argv[k], "core")) {
            o.core = value;
        } else if (!strcmp(argv[k], "listing")) {
            listing = value;
        } else if (!strcmp(argv[k], "out")) {
            if (!(o.out = fopen(value, "w"))) profile_fail("cannot write %s", value);
        } else if (!strcmp(argv[k], "stream")) {
            if (!(stream = fopen(value, "w"))) profile_fail("cannot write %s", value);
        } else if (!strcmp(argv[k], "each")) {
            each = !strcmp(value, "on") || !strcmp(value, "true");
        } else if (!strcmp(argv[k], "at")) {
            o.listing = true;
        } else if (!strcmp(argv[k], "progress")) {
            o.progress = true;
        } else {
            profile_fail("unknown plugin option %s", argv[k]);
        }
    }
    if (!o.core || !listing || !o.out) profile_fail("the plugin needs core=, listing= and out=");
    each = each || stream;
    program_read(&image, listing);
    profile = trace_new(&image, &o);
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_atexit_cb(id, exits, NULL);
    return 0;
}
