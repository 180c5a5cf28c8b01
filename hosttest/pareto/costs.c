/* SPDX-License-Identifier: MIT */
/* What was measured on the cores: cycles of kernels, of frames, bytes. */
#include "table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FIELDS = 8, KERNELS_MAX = 8000, FRAMES_MAX = 8000, BYTES_MAX = 1000, CORES_MAX = 8 };

/* Of a kernel: cycles with their unit, or bytes without. */
typedef struct figure {
    char core[PARETO_WORD], kernel[PARETO_WORD], unit[PARETO_WORD];
    double value;
} figure;

static figure kernels[KERNELS_MAX], bytes[BYTES_MAX];
static pareto_frame frames[FRAMES_MAX];
static char cores[CORES_MAX][PARETO_WORD];
static unsigned kernel_count, byte_count, frame_count, core_count;

static void fail(const char *path, const char *what)
{
    fprintf(stderr, "pareto: %s: %s\n", path, what);
    exit(EXIT_FAILURE);
}

static void copy(char to[PARETO_WORD], const char *from) { snprintf(to, PARETO_WORD, "%s", from); }

static void core_add(const char *core)
{
    unsigned i;
    for (i = 0; i < core_count; i++)
        if (!strcmp(cores[i], core)) return;
    if (core_count < CORES_MAX - 1) copy(cores[core_count++], core);
}

/* core,kernel,bytes */
static void bytes_add(char *const field[FIELDS])
{
    figure *f = &bytes[byte_count++];
    copy(f->core, field[0]);
    copy(f->kernel, field[1]);
    f->value = strtod(field[2], NULL);
    core_add(field[0]);
}

/* core,kernel,unit,instructions,cycles */
static void kernel_add(char *const field[FIELDS])
{
    figure *f = &kernels[kernel_count++];
    copy(f->core, field[0]);
    copy(f->kernel, field[1]);
    snprintf(f->unit, sizeof f->unit, "%s/%.20s", *field[4] ? "cycles" : "instructions", field[2]);
    f->value = strtod(*field[4] ? field[4] : field[3], NULL);
}

/* core,scene,model,format,pixels,unit,cost,bytes. What two images have drawn counts as the first has it. */
static void frame_add(char *const field[FIELDS])
{
    pareto_frame *f = &frames[frame_count];
    unsigned i;
    for (i = 0; i < frame_count; i++) {
        const pareto_frame *g = &frames[i];
        if (!strcmp(g->method, field[2]) && !strcmp(g->scene, field[1]) && !strcmp(g->core, field[0]) &&
            !strcmp(g->format, field[3]))
            return;
    }
    frame_count++;
    copy(f->core, field[0]);
    copy(f->scene, field[1]);
    copy(f->method, field[2]);
    copy(f->format, field[3]);
    copy(f->unit, field[5]);
    f->cost = strtod(field[6], NULL);
    f->bytes = strtod(field[7], NULL);
}

/* Cuts a line up; how many fields it has. */
static int split(char *line, char *field[FIELDS])
{
    int n = 0;
    line[strcspn(line, "\n")] = 0;
    for (;;) {
        char *comma = strchr(line, ',');
        if (n < FIELDS) field[n] = line;
        n++;
        if (!comma) return n;
        *comma = 0;
        line = comma + 1;
    }
}

void pareto_costs_read(const char *path)
{
    FILE *file = fopen(path, "r");
    char line[400], *field[FIELDS];
    if (!file) fail(path, "cannot be read; make pareto makes it");
    while (fgets(line, sizeof line, file)) {
        const int n = split(line, field);
        if (kernel_count == KERNELS_MAX || frame_count == FRAMES_MAX || byte_count == BYTES_MAX) fail(path, "too many lines");
        if (n == 3) {
            bytes_add(field);
        } else if (n == 5) {
            kernel_add(field);
        } else if (n == 8) {
            frame_add(field);
        } else {
            fail(path, "is none of the files that this reads");
        }
    }
    fclose(file);
}

const char *pareto_core(unsigned i) { return i < core_count ? cores[i] : NULL; }

const pareto_frame *pareto_frame_at(unsigned i) { return i < frame_count ? &frames[i] : NULL; }

static const figure *find(const figure *list, unsigned count, const char *core, const char *kernel)
{
    for (; count > 0; count--, list++)
        if (!strcmp(list->core, core) && !strcmp(list->kernel, kernel)) return list;
    return NULL;
}

double pareto_kernel_cost(const char *core, const char *kernel, const char **unit)
{
    const figure *f = find(kernels, kernel_count, core, kernel);
    if (f && unit) *unit = f->unit;
    return f ? f->value : NAN;
}

double pareto_kernel_bytes(const char *core, const char *kernel)
{
    const figure *f = find(bytes, byte_count, core, kernel);
    return f ? f->value : NAN;
}
