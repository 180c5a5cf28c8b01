/* SPDX-License-Identifier: MIT */
/* Charts of speed against accuracy: one of each scope and core, and one for the README, from pareto.csv beside the folder of
 * data. */
#include "charts.h"
#include "panels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS_MAX = 6000, FIELDS = 11, PANELS_MAX = 12, POINTS_MAX = 200, WORD = 40 };

typedef struct row {
    char core[WORD], scope[WORD], scene[WORD], method[WORD], unit[WORD];
    double cost, error;
    bool on_front;
} row;

static row rows[ROWS_MAX];
static unsigned count;

static void fail(const char *path, const char *what)
{
    fprintf(stderr, "chart_data: %s %s; make pareto writes it\n", path, what);
    exit(EXIT_FAILURE);
}

static void row_add(const char *path, char *line)
{
    row *r = &rows[count];
    double figure[5];
    int front;
    if (sscanf(line, "%39[^,],%39[^,],%39[^,],%39[^,],%lf,%39[^,],%lf,%lf,%lf,%lf,%d", r->core, r->scope, r->scene, r->method,
               &r->cost, r->unit, &figure[0], &figure[1], &figure[2], &figure[3], &front) != FIELDS ||
        count == ROWS_MAX - 1)
        fail(path, "cannot be read");
    r->error = figure[0];
    r->on_front = front;
    count++;
}

static void rows_read(const char *folder)
{
    char path[512], line[400];
    FILE *file;
    snprintf(path, sizeof path, "%s/../report/pareto.csv", folder);
    file = fopen(path, "r");
    if (!file) fail(path, "is missing");
    count = 0;
    if (!fgets(line, sizeof line, file)) fail(path, "is empty");
    while (fgets(line, sizeof line, file)) row_add(path, line);
    fclose(file);
}

/* -------------------------------------------------------------------------------------------------------------------- classes */

static bool begins(const char *name, const char *with) { return !strncmp(name, with, strlen(with)); }

static bool is_fixed(const char *method)
{
    return begins(method, "linear") || begins(method, "quadratic") || begins(method, "arc") || !strcmp(method, "flat") ||
           !strcmp(method, "gouraud");
}

static enum panel_class class_of(const row *r)
{
    if (strcmp(r->scope, "frame")) return begins(r->method, "lambent") || begins(r->method, "tuned") ? PANEL_OURS : PANEL_OTHERS;
    if (begins(r->method, "planned")) return PANEL_OURS;
    if (!is_fixed(r->method)) return PANEL_OTHERS;
    return strchr(r->method, '/') ? PANEL_SWEPT : PANEL_FIXED;
}

/* The line of a fixed choice at several tolerances: they follow one another in the file. */
static unsigned line_of(const panel *p, const char *const *method, const char *name)
{
    const size_t length = strcspn(name, "/");
    unsigned i, last = 0;
    for (i = 0; i < p->points; i++) {
        if (!p->point[i].line) continue;
        last = p->point[i].line > last ? p->point[i].line : last;
        if (strcspn(method[i], "/") == length && !strncmp(method[i], name, length)) return p->point[i].line;
    }
    return last + 1;
}

/* The planner's points are named by what they tolerate, fixed choices by themselves. */
static const char *label_of(const row *r, enum panel_class kind)
{
    const char *slash = strchr(r->method, '/');
    if (kind == PANEL_SWEPT) return NULL;
    return slash && kind == PANEL_OURS ? slash : r->method;
}

/* --------------------------------------------------------------------------------------------------------------------- panels */

/* Errors below these are drawn there: an exact power's, and those that are nothing but rounding. */
static void panel_range(panel *p, const char *scope)
{
    p->y_low = !strcmp(scope, "frame") ? 3e-4 : !strcmp(scope, "span") ? 1e-6 : 1e-5;
    p->y_high = !strcmp(scope, "span") ? 10 : 1;
}

static void panel_points(panel *p, const char *core, const char *scope, const char *scene)
{
    static panel_point points[POINTS_MAX];
    static const char *method[POINTS_MAX];
    unsigned i;
    p->point = points;
    p->points = 0;
    panel_range(p, scope);
    for (i = 0; i < count; i++) {
        const row *r = &rows[i];
        panel_point *q = &points[p->points];
        if (strcmp(r->core, core) || strcmp(r->scope, scope) || strcmp(r->scene, scene) || p->points == POINTS_MAX) continue;
        memset(q, 0, sizeof *q);
        q->x = r->cost;
        q->y = fmin(fmax(r->error, p->y_low * 1.3), p->y_high / 1.3);
        q->kind = class_of(r);
        q->on_front = r->on_front;
        q->in_curve = q->kind == PANEL_OURS && strchr(r->method, '/') && !strcmp(scope, "frame");
        q->label = label_of(r, q->kind);
        if (q->kind == PANEL_SWEPT) q->line = line_of(p, method, r->method);
        method[p->points++] = r->method;
    }
}

/* Cycles a pixel, or what the core has. */
static const char *x_label(const char *core, const char *scope)
{
    static char text[WORD + 8];
    unsigned i;
    for (i = 0; i < count; i++) {
        const char *slash = strchr(rows[i].unit, '/');
        if (strcmp(rows[i].core, core) || strcmp(rows[i].scope, scope) || !slash) continue;
        snprintf(text, sizeof text, "%.*s per %s", (int)(slash - rows[i].unit), rows[i].unit, slash + 1);
        return text;
    }
    return "";
}

/* n-20 is n = 20; psi-10-m-16 is 10 degrees over 16 pixels. */
static const char *title_of(const char *scene)
{
    static char text[2 * WORD];
    unsigned a, b;
    if (!strcmp(scene, "n-1-1000")) return "n = 1 to 1000, the worst; cost of the five";
    if (sscanf(scene, "n-%u", &a) == 1) {
        snprintf(text, sizeof text, "n = %u", a);
    } else if (sscanf(scene, "psi-%u-m-%u", &a, &b) == 2) {
        snprintf(text, sizeof text, "normals turn by %u° over %u pixels", a, b);
    } else {
        snprintf(text, sizeof text, "%s", scene);
    }
    return text;
}

/* Scenes of a core in the order of the file. */
static unsigned scenes_of(const char *core, const char *scope, const char *scene[PANELS_MAX])
{
    unsigned i, found = 0;
    for (i = 0; i < count; i++) {
        const row *r = &rows[i];
        if (strcmp(r->core, core) || strcmp(r->scope, scope) || (found && !strcmp(scene[found - 1], r->scene))) continue;
        if (found < PANELS_MAX) scene[found++] = r->scene;
    }
    return found;
}

/* Two panels a row. Their places are those that hosttest/charts/panels.gp has a title and a key around. */
static void chart(const char *folder, const char *scope, const char *core)
{
    const char *scene[PANELS_MAX];
    const unsigned panels = scenes_of(core, scope, scene);
    char name[2 * WORD];
    unsigned i;
    FILE *file;
    snprintf(name, sizeof name, "pareto-%s-%s", scope, core);
    file = chart_open(folder, name);
    for (i = 0; i < panels; i++) {
        panel p;
        memset(&p, 0, sizeof p);
        p.title = title_of(scene[i]);
        p.first = i % 2 == 0;
        p.last = !p.first;
        p.x_label = i + 2 >= panels ? x_label(core, scope) : NULL;
        p.left = p.first ? 66 : 414;
        p.top = 70 + 340 * (i / 2);
        p.width = 332;
        p.height = 280;
        panel_points(&p, core, scope, scene[i]);
        panel_write(file, &p, i);
    }
    chart_close(file);
}

/* One panel for all. */
static void summary(const char *folder)
{
    FILE *file = chart_open(folder, "pareto-summary");
    panel p;
    memset(&p, 0, sizeof p);
    p.title = "";
    p.first = p.last = true;
    p.x_label = x_label("m0plus", "frame");
    p.left = 66;
    p.top = 70;
    p.width = 680;
    p.height = 320;
    panel_points(&p, "m0plus", "frame", "icosphere-1280-rgb565");
    p.y_low = 3e-3;
    p.y_high = 0.3;
    panel_write(file, &p, 0);
    chart_close(file);
}

void charts_pareto(const char *folder)
{
    static const char *const scopes[] = {"lobe", "span", "frame"}, *const cores[] = {"m0plus", "m4", "rv32imc", "atmega1284p"};
    unsigned i, k;
    rows_read(folder);
    for (i = 0; i < 3; i++)
        for (k = 0; k < 4; k++) chart(folder, scopes[i], cores[k]);
    summary(folder);
}
