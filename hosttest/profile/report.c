/* SPDX-License-Identifier: MIT */
/* What the profiler has written, as tables to read or as lines of CSV.
 *
 *   report table FILE [FUNCTION LISTING]   tables; with a function, its instructions with figures from the listing as well
 *   report cycles FILE                     core,scene,model,format,triangles,pixels,instructions_per_pixel,cycles_per_pixel,
 *                                          cycles_min,cycles_max: of a whole frame, cycles per pixel; empty where not known
 *   report kernels FILE                    core,kernel,unit,instructions,cycles: of one unit
 *   report frames FILE LISTING             core,scene,model,format,pixels,unit,cost,bytes: of a whole frame, cycles per pixel,
 *                                          or instructions where no cycles are known; bytes: of all functions that it
 *                                          executed, tables not among them, as the listing has their sizes
 *   report growth FILE                     core,axis,value,model,vertices,triangles,drawn,spans,pixels,strips,instructions,cycles: of
 *                                          a whole frame
 *   report stages FILE                     core,case,drawn,instructions,cycles,project,sort,begin,walk,shade,fill: of a whole frame,
 *                                          stages of port/host/costs.h, in cycles, or instructions where these are not known
 *
 * Fails if the file is not complete, if control went where it cannot go, or if an instruction was not in the cycle table.
 */
#include "program.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FUNCTIONS 2000
#define NAME 80
#define WEIGHTS 4

typedef struct figures {
    double instructions, least, nominal, most;
} figures;

typedef struct row {
    char name[NAME];
    double calls;
    figures self, inclusive;
} row;

typedef struct at {
    uint32_t address;
    double count, taken, cycles;
} at;

enum source { CYCLES_NONE, CYCLES_TABLE, CYCLES_TOLD };
enum output { TABLE, CYCLES, KERNELS, GROWTH, STAGES, FRAMES };

/* Functions that stages of a frame begin with. */
enum { PROJECT, SORT, DRAW, BEGIN, SHADE, FILL, STAGE_FUNCTIONS };
static const char *const stage_functions[] = {"lmb_mesh_project", "lmb_mesh_sort",   "lmb_draw_mesh",
                                              "lmb_mesh_begin",   "lmb_shade_begin", "lmb_fill_triangle"};

static struct state {
    enum output output;
    char core[32];
    enum source source;
    char scene[NAME], model[NAME], format[16], kernel[NAME], unit[NAME];
    double triangles, size, rows;
    double pixels, spans, drawn, vertices; /* counted by the program */
    figures total, kept;                   /* of the region; what a kernel or a frame in strips has come to so far */
    double stages[STAGE_FUNCTIONS];
    enum kernel { NO_KERNEL, WEIGHTED, MEAN, MOST } kind;
    double divisor, weight[WEIGHTS];
    int regions, weights;
    row rows_of[FUNCTIONS];
    size_t functions;
    at *ats;
    size_t at_count, at_room;
    bool any, ended, bad;
} s;

static const char *list_function, *list_path;

static bool exact(void) { return s.source == CYCLES_TOLD || !strncmp(s.core, "m0", 2); }

/* -------------------------------------------------------------------------------------------------------- tables to read */

static void line_of(char fill)
{
    int i;
    for (i = 0; i < 118; i++) putchar(fill);
    putchar('\n');
}

static void print_head(void)
{
    line_of('-');
    printf("%s, %s, %s, %s: ", s.core, s.scene, s.model, s.format);
    if (s.size == s.rows) {
        printf("%.0f x %.0f pixels in one surface\n", s.size, s.size);
    } else {
        printf("%.0f x %.0f pixels in strips of %.0f rows, triangles and spans counted in each\n", s.size, s.size, s.rows);
    }
    printf("%.0f pixels, %.0f spans, %.0f triangles (%.0f in the mesh), %.0f vertices\n\n", s.pixels, s.spans, s.drawn,
           s.triangles, s.vertices);
}

static void print_per(const char *name, double total)
{
    printf("%-16s %14.0f", name, total);
    printf(" %11.2f %11.1f %11.1f %11.1f\n", total / s.pixels, total / s.spans, total / s.drawn, total / s.vertices);
}

static void print_totals(void)
{
    printf("%-16s %14s %11s %11s %11s %11s\n", "", "total", "per pixel", "per span", "triangle", "vertex");
    print_per("instructions", s.total.instructions);
    if (s.source != CYCLES_NONE && exact()) print_per("cycles", s.total.nominal);
    if (s.source != CYCLES_NONE && !exact()) {
        print_per("cycles, least", s.total.least);
        print_per("cycles, nominal", s.total.nominal);
        print_per("cycles, most", s.total.most);
    }
    putchar('\n');
}

static int by_cost(const void *a, const void *b)
{
    const row *p = a, *q = b;
    double x = s.source == CYCLES_NONE ? p->self.instructions : p->self.nominal;
    double y = s.source == CYCLES_NONE ? q->self.instructions : q->self.nominal;
    return x < y ? 1 : x > y ? -1 : strcmp(p->name, q->name);
}

static double share(double part, double of) { return of > 0 ? 100 * part / of : 0; }

static void print_heads(bool cycles)
{
    printf(" %11s %6s", "instr.", "share");
    if (cycles) printf(" %11s %6s", "cycles", "share");
}

/* Instructions, and cycles where they are known, each with its share of the whole. */
static void print_shares(bool cycles, const figures *f)
{
    printf(" %11.0f %5.1f%%", f->instructions, share(f->instructions, s.total.instructions));
    if (cycles) printf(" %11.0f %5.1f%%", f->nominal, share(f->nominal, s.total.nominal));
}

static void print_functions(void)
{
    size_t i;
    bool cycles = s.source != CYCLES_NONE;
    qsort(s.rows_of, s.functions, sizeof s.rows_of[0], by_cost);
    printf("%-37s %-*s %s\n", "", cycles ? 47 : 28, "by itself", "with what it calls");
    printf("%-26s %9s ", "function", "calls");
    print_heads(cycles);
    printf(" %8s ", "a pixel");
    print_heads(cycles);
    putchar('\n');
    for (i = 0; i < s.functions; i++) {
        const row *r = &s.rows_of[i];
        printf("%-26.26s %9.0f ", r->name, r->calls);
        print_shares(cycles, &r->self);
        printf(" %8.2f ", (cycles ? r->self.nominal : r->self.instructions) / s.pixels);
        print_shares(cycles, &r->inclusive);
        putchar('\n');
    }
    putchar('\n');
}

/* The instructions of one function, each with how often it was executed and what that came to. */
static void print_listing(const program *p)
{
    uint32_t k;
    size_t i;
    bool found = false;
    for (k = 0; k < p->instructions; k++) {
        const instruction *x = &p->list[k];
        if (strcmp(p->functions[x->function].name, list_function)) continue;
        if (!found) printf("%-10s %10s %10s %12s %8s  %s\n", "address", "times", "taken", "cycles", "/pixel", list_function);
        found = true;
        printf("%-10" PRIx32, x->address);
        for (i = 0; i < s.at_count && s.ats[i].address != x->address; i++) {}
        if (i == s.at_count) {
            printf(" %10s %10s %12s %8s", "-", "", "", "");
        } else {
            double cost = s.source == CYCLES_NONE ? s.ats[i].count : s.ats[i].cycles;
            printf(" %10.0f", s.ats[i].count);
            if (s.ats[i].taken > 0) {
                printf(" %10.0f", s.ats[i].taken);
            } else {
                printf(" %10s", "");
            }
            printf(" %12.0f %8.2f", cost, cost / s.pixels);
        }
        printf("  %-8s %s\n", x->mnemonic, x->operands);
    }
    if (!found) profile_fail("there is no function %s in the image; names are in the table above", list_function);
    putchar('\n');
}

static void print_kernel_line(double instructions, double cycles)
{
    printf("%s, %s: %.2f instructions", s.core, s.kernel, instructions);
    if (s.source != CYCLES_NONE) printf(", %.2f cycles%s", cycles, exact() ? "" : " (nominal)");
    printf(" a %s\n", s.unit);
}

/* What the figures leave out, once at the end. */
static void print_notes(void)
{
    line_of('-');
    if (!strncmp(s.core, "m0", 2)) {
        printf(
            "Cycles: sums of the manual's table over all executed instructions, exact for a core whose memory has no wait "
            "states,\n"
            "multiplier of %s. Left out: wait states and caches of flash, contention with DMA or\n"
            "a second core, interrupts. Whether LR and PC count among the registers of a push or pop the manual does not say: "
            "here\n"
            "they do (one cycle a push or pop less otherwise). RP2040's own divider is not used by anything here. The emulated\n"
            "machine is an MPS2 with a Cortex-M3, for its 4 MB of RAM: it runs the very Thumb-1 code that was built for %s.\n",
            strstr(s.core, "mul32") ? "32 cycles (MULS)" : "one cycle (MULS)", s.core);
    } else if (!strcmp(s.core, "m3") || !strcmp(s.core, "m4")) {
        printf("Cycles: from the manual's table. Least: refill P = 1, all loads and stores pipelined, conditional instructions "
               "skipped;\n"
               "nominal: P = 2, a load after a load one cycle less, stores buffered; most: P = 3, nothing pipelined. Left out: "
               "wait\n"
               "states and caches of flash, a full write buffer, contention with DMA, interrupts, folding of branches.\n");
    } else if (s.source == CYCLES_TOLD) {
        printf("Cycles: simavr's own, step by step; AVR has neither cache nor wait states. Left out: interrupts.\n");
    } else {
        printf("Instructions alone: for %s no table gives cycles that a sum could be made of (dual issue, caches, pipelines that "
               "differ\n"
               "from chip to chip).\n",
               s.core);
    }
}

/* ------------------------------------------------------------------------------------------------------------------- CSV */

static void csv_cycles(void)
{
    printf("%s,%s,%s,%s,%.0f,%.0f,%.3f", s.core, s.scene, s.model, s.format, s.triangles, s.pixels,
           s.total.instructions / s.pixels);
    if (s.source == CYCLES_NONE) {
        printf(",,,\n");
    } else {
        printf(",%.3f,%.3f,%.3f\n", s.total.nominal / s.pixels, s.total.least / s.pixels, s.total.most / s.pixels);
    }
}

/* A name that several functions of the image share counts with the largest. */
static double bytes_of(const program *listing, const char *name)
{
    uint32_t i, most = 0;
    for (i = 0; i < listing->function_count; i++) {
        const function *f = &listing->functions[i];
        if (f->size > most && !strcmp(f->name, name)) most = f->size;
    }
    return most;
}

static void csv_frames(const program *listing)
{
    const bool cycles = s.source != CYCLES_NONE;
    double bytes = 0;
    size_t i;
    for (i = 0; i < s.functions; i++) {
        if (strncmp(s.rows_of[i].name, "profile_", 8)) bytes += bytes_of(listing, s.rows_of[i].name);
    }
    printf("%s,%s,%s,%s,%.0f,%s,%.3f,%.0f\n", s.core, s.scene, s.model, s.format, s.pixels,
           cycles ? "cycles/pixel" : "instructions/pixel", (cycles ? s.total.nominal : s.total.instructions) / s.pixels, bytes);
}

/* Of a scene named AXIS-VALUE. */
static void csv_growth(void)
{
    const char *dash = strrchr(s.scene, '-');
    if (!dash) profile_fail("scene %s has no value", s.scene);
    printf("%s,%.*s,%s,%s,%.0f,%.0f,%.0f,%.0f,%.0f,%.0f,%.0f,", s.core, (int)(dash - s.scene), s.scene, dash + 1, s.model,
           s.vertices, s.triangles, s.drawn, s.spans, s.pixels, (double)(int)((s.size + s.rows - 1) / s.rows),
           s.total.instructions);
    if (s.source != CYCLES_NONE) printf("%.0f", s.total.nominal);
    putchar('\n');
}

/* What a function took in this region, with what it calls. */
static double taken_by(const char *name)
{
    size_t i;
    for (i = 0; i < s.functions && strcmp(s.rows_of[i].name, name); i++) {}
    if (i == s.functions) return 0;
    return s.source == CYCLES_NONE ? s.rows_of[i].inclusive.instructions : s.rows_of[i].inclusive.nominal;
}

/* One more strip of a frame. */
static void stages_add(void)
{
    int i;
    for (i = 0; i < STAGE_FUNCTIONS; i++) s.stages[i] += taken_by(stage_functions[i]);
    s.kept.instructions += s.total.instructions;
    s.kept.nominal += s.total.nominal;
}

static void csv_stages(void)
{
    const double *t = s.stages, all = s.source == CYCLES_NONE ? s.kept.instructions : s.kept.nominal;
    const double walk = t[DRAW] - t[BEGIN] - t[SHADE] - t[FILL];
    printf("%s,%s,%.0f,%.0f,", s.core, s.scene, s.drawn, s.kept.instructions);
    if (s.source != CYCLES_NONE) printf("%.0f", s.kept.nominal);
    printf(",%.0f,%.0f,%.0f,%.0f,%.0f,%.0f\n", t[PROJECT], t[SORT], all - t[PROJECT] - t[SORT] - walk - t[SHADE] - t[FILL], walk,
           t[SHADE], t[FILL]);
    memset(&s.kept, 0, sizeof s.kept);
    memset(s.stages, 0, sizeof s.stages);
    s.any = true;
}

static void csv_kernel(double instructions, double cycles)
{
    printf("%s,%s,%s,%.3f,", s.core, s.kernel, s.unit, instructions);
    if (s.source != CYCLES_NONE) printf("%.3f", cycles);
    putchar('\n');
}

/* --------------------------------------------------------------------------------------------------------------- reading */

static const char *read_figures(const char *p, figures *f)
{
    char *end;
    f->instructions = strtod(p, &end);
    f->least = strtod(end, &end);
    f->nominal = strtod(end, &end);
    f->most = strtod(end, &end);
    return end;
}

static void read_function(const char *p)
{
    row *r = &s.rows_of[s.functions];
    char *end;
    if (s.functions == FUNCTIONS) profile_fail("more than %d functions", FUNCTIONS);
    s.functions++;
    r->calls = strtod(p, &end);
    p = read_figures(read_figures(end, &r->self), &r->inclusive);
    snprintf(r->name, sizeof r->name, "%.*s", (int)strcspn(p + 1, "\n"), p + 1);
}

static void read_at(const char *p)
{
    at *a;
    if (s.at_count == s.at_room) {
        s.at_room = s.at_room * 2 + 4096;
        s.ats = realloc(s.ats, s.at_room * sizeof *s.ats);
        if (!s.ats) profile_fail("out of memory");
    }
    a = &s.ats[s.at_count++];
    if (sscanf(p, "%" SCNx32 " %lf %lf %lf", &a->address, &a->count, &a->taken, &a->cycles) != 4)
        profile_fail("cannot read: at%s", p);
}

static void kernel_end(void)
{
    double by = s.kind == WEIGHTED ? s.divisor : s.kind == MEAN ? s.regions : 1;
    if (s.kind == NO_KERNEL) return;
    if (s.regions == 0 || (s.kind == WEIGHTED && s.regions != s.weights))
        profile_fail("kernel %s has %d regions", s.kernel, s.regions);
    if (s.output == KERNELS) csv_kernel(s.kept.instructions / by, s.kept.nominal / by);
    if (s.output == TABLE) print_kernel_line(s.kept.instructions / by, s.kept.nominal / by);
    s.kind = NO_KERNEL;
    s.any = true;
}

static void kernel_begin(enum kernel kind)
{
    s.kind = kind;
    s.regions = 0;
    memset(&s.kept, 0, sizeof s.kept);
}

/* One more region of a kernel. */
static void kernel_add(void)
{
    double weight = s.kind == WEIGHTED && s.regions < s.weights ? s.weight[s.regions] : 1;
    s.regions++;
    if (s.kind != MOST) {
        s.kept.instructions += weight * s.total.instructions;
        s.kept.nominal += weight * s.total.nominal;
    } else if (s.total.nominal > s.kept.nominal || (s.source == CYCLES_NONE && s.total.instructions > s.kept.instructions)) {
        s.kept = s.total;
    }
}

static bool read_kernel(const char *text)
{
    char *end;
    int taken = 0;
    if (sscanf(text, "mean %79s %79s", s.kernel, s.unit) == 2) {
        kernel_begin(MEAN);
    } else if (sscanf(text, "most %79s %79s", s.kernel, s.unit) == 2) {
        kernel_begin(MOST);
    } else if (sscanf(text, "kernel %79s %79s %lf%n", s.kernel, s.unit, &s.divisor, &taken) == 3) {
        kernel_begin(WEIGHTED);
        text += taken;
        for (s.weights = 0; s.weights < WEIGHTS; s.weights++) {
            s.weight[s.weights] = strtod(text, &end);
            if (end == text) break;
            text = end;
        }
    }
    return s.kind != NO_KERNEL;
}

static void scene_done(const program *listing)
{
    if (s.output == CYCLES) csv_cycles();
    if (s.output == GROWTH) csv_growth();
    if (s.output == FRAMES) csv_frames(listing);
    if (s.output == TABLE) {
        print_head();
        print_totals();
        print_functions();
        if (list_function) print_listing(listing);
    }
    s.any = true;
}

static void read_note(const char *text, const program *listing)
{
    kernel_end();
    if (sscanf(text, "scene %79s %79s %15s %lf size %lf rows %lf", s.scene, s.model, s.format, &s.triangles, &s.size, &s.rows) ==
        6) {
        s.kernel[0] = 0;
    } else if (sscanf(text, "counts pixels %lf spans %lf triangles %lf vertices %lf", &s.pixels, &s.spans, &s.drawn,
                      &s.vertices) == 4) {
        scene_done(listing);
    } else if (s.output == STAGES && sscanf(text, "drawn %lf", &s.drawn) == 1) {
        csv_stages();
    } else if (!read_kernel(text)) {
        fprintf(stderr, "profile: the program says: %s\n", text);
        s.bad = true;
    }
}

static void read_line(char *line, const program *listing)
{
    char *p = strchr(line, ' ');
    double regions, violations, unknown;
    line[strcspn(line, "\n")] = 0;
    if (!p) profile_fail("cannot read: %s", line);
    *p++ = 0;
    if (!strcmp(line, "core")) {
        char source[16];
        if (sscanf(p, "%31s %15s", s.core, source) != 2) profile_fail("cannot read: core %s", p);
        s.source = !strcmp(source, "table") ? CYCLES_TABLE : !strcmp(source, "told") ? CYCLES_TOLD : CYCLES_NONE;
    } else if (!strcmp(line, "note")) {
        read_note(p, listing);
        s.functions = s.at_count = 0;
    } else if (!strcmp(line, "function")) {
        read_function(p);
    } else if (!strcmp(line, "at")) {
        read_at(p);
    } else if (!strcmp(line, "region")) {
        read_figures(p, &s.total);
        if (s.output == STAGES) stages_add();
        if (s.kind != NO_KERNEL) kernel_add();
        if (s.output == STAGES || s.kind != NO_KERNEL) { s.functions = s.at_count = 0; }
    } else if (!strcmp(line, "end")) {
        kernel_end();
        if (sscanf(p, "%lf %lf %lf", &regions, &violations, &unknown) != 3) profile_fail("cannot read: end %s", p);
        s.ended = true;
        if (violations > 0) fprintf(stderr, "profile: %.0f steps to where control cannot go\n", violations);
        if (unknown > 0)
            fprintf(stderr, "profile: instructions were executed that the cycle table of %s does not know\n", s.core);
        s.bad = s.bad || violations > 0 || unknown > 0;
    } else {
        fprintf(stderr, "profile: %s %s\n", line, p); /* violation, unknown */
    }
}

int main(int argc, char **argv)
{
    static const char *const outputs[] = {"table", "cycles", "kernels", "growth", "stages", "frames"};
    static char line[1000];
    int i;
    static program listing;
    FILE *f;
    for (i = 0; i < 6 && argc > 1; i++)
        if (!strcmp(argv[1], outputs[i])) s.output = (enum output)i;
    if (argc != (s.output == FRAMES ? 4 : 3) && (argc != 5 || s.output == FRAMES))
        profile_fail("usage: report table|cycles|kernels|growth|stages FILE [FUNCTION LISTING], or report frames FILE LISTING");
    if (argc == 5) list_function = argv[3];
    if (argc > 3) {
        list_path = argv[argc - 1];
        program_read(&listing, list_path);
    }
    if (!(f = fopen(argv[2], "r"))) profile_fail("cannot read %s", argv[2]);
    while (fgets(line, sizeof line, f)) read_line(line, &listing);
    fclose(f);
    if (!s.ended) profile_fail("the run was not complete: %s has no end", argv[2]);
    if (!s.any && !s.bad) profile_fail("nothing was measured: no such scene or model for %s?", s.core);
    if (s.output == TABLE && s.any) print_notes();
    return s.bad ? 1 : 0;
}
