/* SPDX-License-Identifier: MIT */
/* Runs an image on a simulated AVR (simavr, exact to the cycle): its console on stdout, its files in the current folder, its exit
 * status as our own. Firmware talks to us as port/avr/harness.h says.
 *
 * usage: avr-run [-v] MCU IMAGE.elf       -v prints cycles and the deepest stack to stderr
 *
 * Ends with a message and a status of its own when the program cannot go on; 0 to 64 are the firmware's. */
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../port/avr/harness.h"

enum { RAM_BEGIN = 0x100 };
enum { STATUS_CRASHED = 65, STATUS_STACK = 66, STATUS_ORDER = 67, STATUS_USAGE = 125 };

typedef struct run {
    avr_t *avr;
    uint8_t order;
    unsigned taken; /* bytes since the order */
    uint8_t answer[4];
    unsigned given; /* answers since the order */
    uint16_t floor; /* of the stack */
    bool floor_known;
    uint16_t lowest;   /* that the stack pointer has been */
    uint16_t last;     /* stack pointer after the instruction before */
    uint8_t unsettled; /* for so many more instructions half of it is old */
    char name[256];
    FILE *file;
    bool file_good;
    int status;
    bool done;
} run;

static void stop(run *r, int status, const char *why)
{
    if (r->done) return;
    if (why) fprintf(stderr, "\navr-run: %s, at flash address 0x%05lx\n", why, (unsigned long)r->avr->pc);
    r->status = status;
    r->done = true;
}

static void file_open(run *r)
{
    if (r->file) fclose(r->file);
    r->file = fopen(r->name, "wb");
    r->file_good = r->file != NULL;
    r->answer[0] = r->file_good ? 0 : 255;
}

static void file_close(run *r)
{
    bool good = r->file && fclose(r->file) == 0 && r->file_good;
    r->file = NULL;
    r->answer[0] = good ? 0 : 255;
}

static void ordered(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *parameter)
{
    run *r = parameter;
    unsigned i;
    avr->data[address] = value;
    r->order = value;
    r->taken = r->given = 0;
    switch (value) {
    case LMB_ORDER_FLOOR:
        if (r->floor_known) stop(r, STATUS_CRASHED, "the program began a second time"); /* a jump to 0 */
        break;
    case LMB_ORDER_NAME:
        r->name[0] = '\0';
        break;
    case LMB_ORDER_OPEN:
        file_open(r);
        break;
    case LMB_ORDER_CLOSE:
        file_close(r);
        break;
    case LMB_ORDER_CYCLES:
        for (i = 0; i < 4; i++) r->answer[i] = (uint8_t)(avr->cycle >> (8 * i));
        break;
    case LMB_ORDER_CONSOLE:
    case LMB_ORDER_FILE:
    case LMB_ORDER_EXIT:
        break;
    default:
        stop(r, STATUS_ORDER, "an order that harness.h does not know");
    }
}

static void take(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *parameter)
{
    run *r = parameter;
    unsigned n = r->taken++;
    avr->data[address] = value;
    switch (r->order) {
    case LMB_ORDER_FLOOR:
        r->floor = (uint16_t)(n == 0 ? value : (unsigned)value << 8 | r->floor);
        r->floor_known = n == 1;
        break;
    case LMB_ORDER_CONSOLE:
        putchar(value);
        break;
    case LMB_ORDER_NAME:
        if (n + 1 < sizeof r->name) {
            r->name[n] = (char)value;
            r->name[n + 1] = '\0';
        } else {
            stop(r, STATUS_ORDER, "a file's name of more than 255 bytes");
        }
        break;
    case LMB_ORDER_FILE:
        if (!r->file || putc(value, r->file) == EOF) r->file_good = false;
        break;
    case LMB_ORDER_EXIT:
        stop(r, value, NULL);
        break;
    default:
        stop(r, STATUS_ORDER, "a byte that no order asked for");
    }
}

static uint8_t give(struct avr_t *avr, avr_io_addr_t address, void *parameter)
{
    run *r = parameter;
    avr->data[address] = r->answer[r->given++ & 3];
    return avr->data[address];
}

static void quiet(struct avr_t *avr, const int level, const char *format, va_list arguments)
{
    (void)avr;
    if (level <= LOG_ERROR) vfprintf(stderr, format, arguments);
}

/* The stack pointer after each instruction. Compilers move it in two halves, SPH first: no push or call changes SPH alone, so
 * after such a change it is not looked at until SPL has followed, two instructions later. */
static void watch_stack(run *r)
{
    const uint16_t sp = (uint16_t)(r->avr->data[R_SPL] | r->avr->data[R_SPH] << 8);
    if (r->unsettled > 0) {
        r->unsettled--;
    } else if ((sp ^ r->last) >> 8 && !((sp ^ r->last) & 0xff)) {
        r->unsettled = 1;
    } else if (sp < r->lowest && r->floor_known) {
        r->lowest = sp;
        if (sp + 1u < r->floor) stop(r, STATUS_STACK, "the stack has reached static data");
    }
    r->last = sp;
}

static void execute(run *r)
{
    while (!r->done) {
        int state = avr_run(r->avr);
        watch_stack(r);
        if (state == cpu_Crashed) stop(r, STATUS_CRASHED, "the core crashed");
        if (state == cpu_Done) stop(r, STATUS_CRASHED, "the core sleeps for ever");
    }
}

int main(int argc, char **argv)
{
    static elf_firmware_t firmware;
    static run r;
    bool verbose = argc == 4 && !strcmp(argv[1], "-v");
    if (argc != 3 + verbose) {
        fprintf(stderr, "usage: avr-run [-v] MCU IMAGE.elf\n");
        return STATUS_USAGE;
    }
    avr_global_logger_set(quiet);
    r.avr = avr_make_mcu_by_name(argv[1 + verbose]);
    if (!r.avr || elf_read_firmware(argv[2 + verbose], &firmware)) {
        fprintf(stderr, "avr-run: cannot simulate %s or read %s\n", argv[1 + verbose], argv[2 + verbose]);
        return STATUS_USAGE;
    }
    avr_init(r.avr);
    r.avr->frequency = 16000000;
    avr_load_firmware(r.avr, &firmware);
    memset(r.avr->data + RAM_BEGIN, 0xa5, r.avr->ramend + 1u - RAM_BEGIN); /* RAM holds anything after reset */
    avr_register_io_write(r.avr, LMB_HARNESS_ORDER, ordered, &r);
    avr_register_io_write(r.avr, LMB_HARNESS_BYTE, take, &r);
    avr_register_io_read(r.avr, LMB_HARNESS_ANSWER, give, &r);
    r.lowest = UINT16_MAX;
    execute(&r);
    if (r.file) fclose(r.file);
    if (verbose) {
        fprintf(stderr, "cycles %llu, stack %u bytes, %u left\n", (unsigned long long)r.avr->cycle, r.avr->ramend - r.lowest,
                r.lowest + 1u - r.floor);
    }
    if (fflush(stdout) != 0 && r.status == 0) r.status = STATUS_USAGE;
    return r.status;
}
