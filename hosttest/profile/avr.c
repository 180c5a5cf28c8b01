/* SPDX-License-Identifier: MIT */
/* Runs an AVR image in simavr, one instruction at a time, and feeds the profiler with each and its cycles.
 *
 *   avr MCU IMAGE LISTING OUT [at=on] [progress=on] [stream=FILE]
 *
 * The program ends where it reaches lmb_board_exit. simavr counts cycles as the chip does; what an instruction took is
 * known once it has been executed.
 */
#include "trace.h"

#include <stdlib.h>
#include <string.h>

#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

static uint32_t exit_function(const program *p)
{
    uint32_t k;
    for (k = 0; k < p->function_count; k++) {
        if (!strcmp(p->functions[k].name, "lmb_board_exit")) return k;
    }
    profile_fail("there is no lmb_board_exit in the image");
    return 0;
}

static void quiet(struct avr_t *avr, const int level, const char *format, va_list arguments)
{
    (void)avr;
    if (level <= LOG_ERROR) vfprintf(stderr, format, arguments);
}

/* floor: the address behind static data. */
static avr_t *chip(const char *mcu, const char *image, uint32_t *floor)
{
    static elf_firmware_t firmware;
    avr_t *avr;
    avr_global_logger_set(quiet);
    avr = avr_make_mcu_by_name(mcu);
    if (!avr) profile_fail("simavr does not know %s", mcu);
    if (elf_read_firmware(image, &firmware)) profile_fail("cannot read %s", image);
    avr_init(avr);
    avr->frequency = 16000000;
    avr_load_firmware(avr, &firmware);
    avr->run_cycle_limit = 1; /* returns after each instruction */
    *floor = 0x100 + firmware.datasize + firmware.bsssize;
    return avr;
}

/* The stack must not reach static data, or the program is not the one that was meant. Its pointer is written in two halves with
 * an instruction between, so only what lasts longer counts. */
static void watch_stack(const avr_t *avr, uint32_t floor)
{
    static unsigned below;
    const uint32_t sp = avr->data[R_SPL] | (uint32_t)avr->data[R_SPH] << 8;
    below = sp < floor && sp >= 0x100 ? below + 1 : 0;
    if (below > 4) profile_fail("the stack has reached static data, at %x", avr->pc);
}

static void run(avr_t *avr, const program *image, trace *profile, FILE *stream, uint32_t floor)
{
    const uint32_t end = exit_function(image);
    block **blocks = calloc(image->instructions, sizeof *blocks);
    if (!blocks) profile_fail("out of memory");
    for (;;) {
        const instruction *i = program_at(image, avr->pc);
        avr_cycle_count_t before = avr->cycle;
        block **b = i ? &blocks[i - image->list] : NULL;
        int state;
        if (i && i->function == end) break;
        state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed) profile_fail("the program stopped at %x", avr->pc);
        if (b && !*b) *b = trace_block(profile, i, 1);
        if (stream && i) fprintf(stream, "%x %d\n", i->address, (int)(avr->cycle - before));
        trace_run(profile, b ? *b : NULL, (int64_t)(avr->cycle - before));
        watch_stack(avr, floor);
    }
    free(blocks);
}

int main(int argc, char **argv)
{
    static program image;
    trace_options o = {"", NULL, true, false, false};
    trace *profile;
    FILE *stream = NULL;
    uint32_t floor;
    avr_t *avr;
    int k;
    if (argc < 5) profile_fail("usage: avr MCU IMAGE LISTING OUT [at=on] [progress=on] [stream=FILE]");
    o.core = argv[1];
    if (!(o.out = fopen(argv[4], "w"))) profile_fail("cannot write %s", argv[4]);
    for (k = 5; k < argc; k++) {
        o.listing = o.listing || !strcmp(argv[k], "at=on");
        o.progress = o.progress || !strcmp(argv[k], "progress=on");
        if (!strncmp(argv[k], "stream=", 7) && !(stream = fopen(argv[k] + 7, "w"))) profile_fail("cannot write %s", argv[k] + 7);
    }
    program_read(&image, argv[3]);
    profile = trace_new(&image, &o);
    avr = chip(argv[1], argv[2], &floor);
    run(avr, &image, profile, stream, floor);
    if (stream) fclose(stream);
    return trace_end(profile) ? 0 : 1;
}
