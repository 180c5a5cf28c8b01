/* SPDX-License-Identifier: MIT */
/* What the profiler has measured of a list of frames, beside what the host counts of it. */
#include "measured.h"

#include <stdlib.h>
#include <string.h>

static void fail(const char *path, const char *what)
{
    fprintf(stderr, "estimate: %s: %s\n", path, what);
    exit(EXIT_FAILURE);
}

/* A line: a frame, or the pixels of one cleared. */
static void take(measurements *m, const char *path, const char *line, unsigned cases)
{
    char scene[40];
    measured one;
    unsigned i;
    double cycles = 0;
    int n = 0;
    if (sscanf(line, "%31[^,],%39[^,],%lf,%lf,%n", m->core, scene, &one.drawn, &one.instructions, &n) != 4 || !n)
        fail(path, "cannot be read");
    line += n;
    m->cycles = *line != ',';
    if (m->cycles && sscanf(line, "%lf", &cycles) != 1) fail(path, "cannot be read");
    one.all = m->cycles ? cycles : one.instructions;
    line = strchr(line, ',');
    if (!line || sscanf(line, ",%lf,%lf,%lf,%lf,%lf,%lf", &one.stages[COST_PROJECT], &one.stages[COST_SORT],
                        &one.stages[COST_BEGIN], &one.stages[COST_WALK], &one.stages[COST_SHADE], &one.stages[COST_FILL]) != 6)
        fail(path, "cannot be read");
    if (sscanf(scene, "case-%u", &i) == 1 && i < cases) {
        m->frames[i] = one;
    } else if (sscanf(scene, "clear-%u", &i) == 1 && i < 4) {
        m->clear[i & 1][i >> 1] = one.all / one.drawn;
    } else {
        fail(path, "is of another list");
    }
}

void measured_read(measurements *m, const char *path, unsigned cases)
{
    FILE *f = fopen(path, "r");
    char line[400];
    unsigned i;
    memset(m, 0, sizeof *m);
    m->frames = calloc(cases, sizeof *m->frames);
    if (!f || !m->frames || !fgets(line, sizeof line, f)) fail(path, "cannot be read");
    while (fgets(line, sizeof line, f)) take(m, path, line, cases);
    fclose(f);
    for (i = 0; i < cases; i++)
        if (m->frames[i].all <= 0) fail(path, "lacks frames of the list");
}

cost_counts *list_count(const list *l)
{
    cost_counts *counts = calloc(l->count, sizeof *counts);
    unsigned i;
    if (!counts) fail("list", "out of memory");
    for (i = 0; i < l->count; i++) {
        if (i % 50 == 0) fprintf(stderr, "  counted %u of %u frames\n", i, l->count);
        if (estimate_count(&l->cases[i].view, &l->meshes[l->cases[i].model], &counts[i])) exit(EXIT_FAILURE);
    }
    return counts;
}

void measured_check(const measurements *m, const list *l, const cost_counts *counts)
{
    unsigned i;
    for (i = 0; i < l->count; i++) {
        if (m->frames[i].drawn == counts[i].drawn) continue;
        fprintf(stderr, "estimate: %s: the host draws %u triangles, %s %.0f\n", l->cases[i].text, counts[i].drawn, m->core,
                m->frames[i].drawn);
        exit(EXIT_FAILURE);
    }
}
