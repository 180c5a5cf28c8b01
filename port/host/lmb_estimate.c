/* SPDX-License-Identifier: MIT */
/* lmb-estimate: what drawing a Wavefront OBJ file will cost on a core: cycles, frames per second, flash and RAM, at poses and over a
 * turn. */
#include "estimate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "flash.h"

#define POSES 64

typedef struct job {
    estimate_view e; /* first: options that lists of frames know are read into it */
    const char *core;
    double mhz, pose[POSES][3];
    unsigned poses;
    int turn;
    bool csv, classes;
} job;

static const char help[] =
    "usage: lmb-estimate MODEL.obj [options]\n"
    "\n"
    "Says what drawing a model will cost on a core: cycles and frames per second at a pose and over a turn, flash, RAM. The "
    "library\n"
    "draws the frames here and counts; costs were fitted to profiled frames of the core, memory without wait states, gcc -O2.\n"
    "lmb-render takes the same options, with the same defaults, and shows the picture.\n"
    "\n"
    "  --core C              m0plus (default), or one of --core list\n"
    "  --mhz F               its clock in MHz (48)\n" VIEW_HELP_FRAME ESTIMATE_HELP "\n" VIEW_HELP_PLACE
    "  --depth               the same as --order depth\n"
    "  --turn N              and over a turn about y in so many poses from the first; 0: not (64)\n"
    "\n" VIEW_HELP_LOOK "\n" VIEW_HELP_INPUT "  --csv                 a line for each pose, for machines\n"
    "  --classes             each class of work at the first pose: how often, and what it costs\n"
    "\n"
    "--pose may be given up to 64 times.\n";

static int option(void *own, const char *name, const char *value)
{
    job *j = own;
    if (!strcmp(name, "--core")) return (j->core = value)[0] != 0;
    if (!strcmp(name, "--mhz")) return view_number(&j->mhz, value, 0.001, 10000);
    if (!strcmp(name, "--turn")) return view_whole(&j->turn, value, 0, 4096);
    if (!strcmp(name, "--pose")) return j->poses < POSES && view_numbers(j->pose[j->poses], value, 3) && ++j->poses;
    return estimate_option(own, name, value);
}

static bool flag(void *own, const char *name)
{
    job *j = own;
    if (!strcmp(name, "--csv")) return j->csv = true;
    if (!strcmp(name, "--classes")) return j->classes = true;
    if (!strcmp(name, "--depth")) {
        j->e.view.order = VIEW_DEPTH;
        return true;
    }
    return false;
}

static int list_cores(void)
{
    unsigned i;
    for (i = 0; i < cost_core_count; i++)
        printf("%-10s %-12s %s\n", cost_cores[i].name, cost_cores[i].title,
               !strcmp(cost_cores[i].unit, "cycles") ? "cycles by its manual" : "instructions: no manual gives cycles");
    return EXIT_SUCCESS;
}

static const cost_core *find_core(const char *name)
{
    unsigned i;
    if (!strncmp(name, "cortex-", 7)) name += 7;
    for (i = 0; i < cost_core_count; i++)
        if (!strcmp(cost_cores[i].name, name)) return &cost_cores[i];
    fprintf(stderr, "lmb-estimate: there are no costs of %s; known:", name);
    for (i = 0; i < cost_core_count; i++) fprintf(stderr, " %s", cost_cores[i].name);
    fprintf(stderr, "\n");
    return NULL;
}

/* -------------------------------------------------------------------------------------------------------------------- poses */

typedef struct estimate {
    double pose[3], cycles, clear, parts[COST_PARTS];
    cost_counts counts;
} estimate;

static int estimate_at(const job *j, const cost_core *core, const lmb_mesh *mesh, const double pose[3], estimate *out)
{
    estimate_view e = j->e;
    memcpy(e.view.pose, pose, sizeof e.view.pose);
    memcpy(out->pose, pose, sizeof out->pose);
    if (estimate_count(&e, mesh, &out->counts)) return -1;
    out->cycles = cost_sum(core, &out->counts, out->parts);
    out->clear = core->clear[e.view.format == LMB_RGB888][e.view.order == VIEW_DEPTH] * e.view.width * e.view.height;
    return 0;
}

static double per_second(const job *j, double cycles) { return cycles > 0 ? j->mhz * 1e6 / cycles : 0; }

static void print_csv_head(void)
{
    int p;
    printf("model,core,mhz,of,x,y,z,%s", "cycles,clear_cycles,frames_per_second,frames_per_second_cleared,drawn,spans,pixels");
    for (p = 0; p < COST_PARTS; p++) printf(",%s", cost_part_names[p]);
    printf("\n");
}

static void print_csv(const job *j, const cost_core *core, const char *of, const estimate *e)
{
    int p;
    printf("%s,%s,%g,%s,%g,%g,%g,%.0f,%.0f,%.2f,%.2f,%lu,%lu,%lu", j->e.view.input, core->name, j->mhz, of, e->pose[0],
           e->pose[1], e->pose[2], e->cycles, e->clear, per_second(j, e->cycles), per_second(j, e->cycles + e->clear),
           (unsigned long)e->counts.drawn, (unsigned long)e->counts.spans, (unsigned long)e->counts.pixels);
    for (p = 0; p < COST_PARTS; p++) printf(",%.0f", e->parts[p]);
    printf("\n");
}

static void print_line(const job *j, const char *name, const estimate *e)
{
    char pose[64];
    int p;
    snprintf(pose, sizeof pose, "%g,%g,%g", e->pose[0], e->pose[1], e->pose[2]);
    printf("%-6s %-16s %12.0f %9.1f %9.1f  ", name, pose, e->cycles, per_second(j, e->cycles),
           per_second(j, e->cycles + e->clear));
    for (p = 0; p < COST_PARTS; p++) printf(" %7.1f%%", e->cycles > 0 ? 100 * e->parts[p] / e->cycles : 0);
    printf("\n");
}

static void print_head(const cost_core *core)
{
    int p;
    printf("\n%-23s %12s %9s %9s  ", "pose", core->unit, "frames/s", "cleared");
    for (p = 0; p < COST_PARTS; p++) printf(" %8s", cost_part_names[p]);
    printf("\n");
}

static int by_cost(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return x[1] < y[1] ? 1 : x[1] > y[1] ? -1 : x[0] < y[0] ? -1 : 1;
}

static void print_classes(const cost_core *core, const estimate *e)
{
    double of[COST_CLASSES][2];
    int i, c;
    for (c = 0; c < COST_CLASSES; c++) {
        of[c][0] = c;
        of[c][1] = e->counts.of[c] * cost_each(core, c);
    }
    qsort(of, COST_CLASSES, sizeof of[0], by_cost);
    printf("\n%-24s %12s %10s %12s %7s  %s\n", "class", "times", "each", core->unit, "share", "what");
    for (i = 0; i < COST_CLASSES && of[i][1] > 0; i++) {
        cost_kind kind;
        c = (int)of[i][0];
        kind = cost_kind_of(c);
        printf("%-24s %12.0f %10.2f %12.0f %6.1f%%  %s\n", kind.name, e->counts.of[c], cost_each(core, c), of[i][1],
               100 * of[i][1] / e->cycles, kind.text);
    }
}

static void print_ways(const char *term, const uint32_t of[LMB_WAYS])
{
    printf(" %s %lu constant, %lu linear, %lu quadratic, %lu arcs, %lu dark", term, (unsigned long)of[LMB_WAY_CONSTANT],
           (unsigned long)of[LMB_WAY_LINEAR], (unsigned long)of[LMB_WAY_QUADRATIC], (unsigned long)of[LMB_WAY_ARC],
           (unsigned long)of[LMB_WAY_NONE]);
}

/* What was chosen for the terms of triangles that are seen, where there is something to choose. */
static void print_chosen(const job *j, const lmb_statistics *chosen)
{
    if (j->e.view.model < LMB_MODEL_DIFFUSE) return;
    printf("chosen:");
    print_ways("N.L", chosen->diffuse);
    if (j->e.view.model == LMB_MODEL_GLOSS) {
        printf(";");
        print_ways("highlight", chosen->specular);
    }
    printf("\n");
}

/* Over a turn about y: mean, least and worst. Returns 0, or -1 after one line. */
static int print_turn(const job *j, const cost_core *core, const lmb_mesh *mesh)
{
    static estimate now, worst, least;
    const clock_t begin = clock();
    double sum = 0, pose[3];
    int i;
    for (i = 0; i < j->turn; i++) {
        memcpy(pose, j->pose[0], sizeof pose);
        pose[1] += 360.0 * i / j->turn;
        if (pose[1] >= 360) pose[1] -= 360;
        if (estimate_at(j, core, mesh, pose, &now)) return -1;
        if (j->csv) print_csv(j, core, "turn", &now);
        sum += now.cycles;
        if (i == 0 || now.cycles > worst.cycles) worst = now;
        if (i == 0 || now.cycles < least.cycles) least = now;
        if (!j->e.view.quiet && (i + 1) % 16 == 0 && clock() - begin > 3 * CLOCKS_PER_SEC)
            fprintf(stderr, "lmb-estimate: %d of %d poses\n", i + 1, j->turn);
    }
    if (j->csv || !j->turn) return 0;
    printf("turn of %d poses about y:\n", j->turn);
    print_line(j, "least", &least);
    print_line(j, "worst", &worst);
    printf("%-6s %-16s %12.0f %9.1f %9.1f\n", "mean", "", sum / j->turn, per_second(j, sum / j->turn),
           per_second(j, sum / j->turn + worst.clear));
    return 0;
}

/* -------------------------------------------------------------------------------------------------------------------- memory */

static void print_memory(const job *j, const cost_core *core, const lmb_mesh *mesh)
{
    const view *v = &j->e.view;
    const unsigned long bytes = lmb_format_bytes((enum lmb_format)v->format),
                        pixels = (unsigned long)v->width * (unsigned long)v->strip;
    const unsigned long depth = v->order == VIEW_DEPTH ? pixels * 2 : 0,
                        order = v->order == VIEW_PAINTER ? mesh->triangles * 4ul : 0;
    const unsigned long vertices = j->e.vertices ? 0 : mesh->vertices * 16ul, mesh_flash = mesh_bytes(mesh) + 24;
    const unsigned long paint = sizeof(lmb_paint); /* no pointers, so the same everywhere */
    flash_need need;
    printf("\n");
    if (flash_find(&need, core->name, v)) {
        printf("flash  code %lu (gcc -O2, as drawn above) or %lu (-Os, slower), mesh %lu: %lu bytes\n", need.fast, need.small,
               mesh_flash, need.fast + mesh_flash);
    } else {
        printf("flash  mesh %lu bytes; code: make size TARGET=%s\n", mesh_flash, core->name);
        need.stack = 0;
    }
    printf("RAM    %s %lu", v->strip < v->height ? "strip" : "frame", pixels * bytes);
    if (depth) printf(", depth %lu", depth);
    if (order) printf(", painter's order %lu", order);
    if (vertices) printf(", vertices %lu", vertices);
    printf(", paint %lu, stack %lu: %lu bytes\n", paint, need.stack,
           pixels * bytes + depth + order + vertices + paint + need.stack);
}

static void print_scene(const job *j, const cost_core *core, const lmb_mesh *mesh)
{
    const view *v = &j->e.view;
    printf("%s: %u vertices, %lu triangles\n", v->input, mesh->vertices, (unsigned long)mesh->triangles);
    printf("%s at %g MHz, %d x %d pixels of %s", core->title, j->mhz, v->width, v->height, view_formats[v->format]);
    if (v->strip < v->height) printf(" in strips of %d rows", v->strip);
    printf(", %s", view_models[v->model]);
    if (v->model >= LMB_MODEL_DIFFUSE) printf(" %s", view_steps[v->step]);
    if (v->model != LMB_MODEL_DIFFUSE) printf(", n %ld", v->shininess);
    printf(", %s\n", v->order == VIEW_DEPTH     ? "depth buffer"
                     : v->order == VIEW_PAINTER ? "painter's order"
                                                : "no hidden surfaces removed");
}

static int run(const job *j, const cost_core *core, const lmb_mesh *mesh)
{
    static estimate first, now;
    unsigned i;
    if (!j->csv) print_scene(j, core, mesh);
    if (j->csv) {
        print_csv_head();
    } else {
        print_head(core);
    }
    for (i = 0; i < j->poses; i++) {
        if (estimate_at(j, core, mesh, j->pose[i], &now)) return -1;
        if (i == 0) first = now;
        if (j->csv) {
            print_csv(j, core, "pose", &now);
        } else {
            print_line(j, "pose", &now);
            print_chosen(j, &now.counts.chosen);
        }
    }
    if (print_turn(j, core, mesh)) return -1;
    if (j->csv) return 0;
    if (j->classes) print_classes(core, &first);
    print_memory(j, core, mesh);
    printf("cleared: with lmb_clear before, %.0f more. Left out: preparing the paint (once a material), sending to the panel, "
           "interrupts, "
           "wait states of flash.\n",
           first.clear);
    return 0;
}

int main(int argc, char **argv)
{
    static job j;
    const view_program program = {"lmb-estimate", help, option, flag, &j};
    const cost_core *core;
    lmb_mesh mesh;
    int result;
    if (argc == 3 && !strcmp(argv[1], "--core") && !strcmp(argv[2], "list")) return list_cores();
    j.core = "m0plus";
    j.mhz = 48;
    j.turn = 64;
    result = view_parse(&j.e.view, &program, argc, argv);
    if (result >= 0) return result;
    if (!strcmp(j.core, "list")) return list_cores();
    if (!j.poses) j.poses = 1; /* 0,0,0 */
    core = find_core(j.core);
    if (!core) return VIEW_USAGE;
    if (view_read(&j.e.view, &mesh)) return EXIT_FAILURE;
    result = run(&j, core, &mesh) ? EXIT_FAILURE : EXIT_SUCCESS;
    mesh_free(&mesh);
    return result;
}
