/* SPDX-License-Identifier: MIT */
/* Panels as gnuplot draws them. */
#include "panels.h"
#include "panel_names.h"

#include <math.h>

/* ---------------------------------------------------------------------------------------------------------------------- ranges
 */

typedef struct range {
    double low, high;
} range;

/* All costs, and a tenth of the way between them more to either side. */
static range range_of(const panel *p)
{
    range r = {1e300, 0};
    double margin;
    unsigned i;
    for (i = 0; i < p->points; i++) {
        r.low = fmin(r.low, p->point[i].x);
        r.high = fmax(r.high, p->point[i].x);
    }
    margin = pow(r.high / r.low, 0.09) * 1.02;
    r.low /= margin;
    r.high *= margin;
    return r;
}

/* Round numbers: the coarsest that are three or more. */
static void write_tics(FILE *file, range r)
{
    static const double digits[5][14] = {
        {1}, {1, 3}, {1, 2, 5}, {1, 1.5, 2, 3, 5, 7}, {1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8}};
    static const unsigned counts[5] = {1, 2, 3, 6, 14};
    unsigned set, i, found = 0;
    int decade;
    for (set = 0; set < 5 && found < 3; set++) {
        found = 0;
        for (decade = -1; decade < 6; decade++)
            for (i = 0; i < counts[set]; i++)
                found += digits[set][i] * pow(10, decade) >= r.low && digits[set][i] * pow(10, decade) <= r.high;
    }
    fprintf(file, "set xtics (");
    for (decade = -1, found = 0; decade < 6; decade++) {
        for (i = 0; i < counts[set - 1]; i++) {
            const double x = digits[set - 1][i] * pow(10, decade);
            if (x >= r.low && x <= r.high) fprintf(file, "%s\"%g\" %g", found++ ? ", " : "", x, x);
        }
    }
    fprintf(file, ")\n");
}

/* ---------------------------------------------------------------------------------------------------------------------- points
 */

static const char *const colours[PANEL_CLASSES] = {"#0072B2", "#009E73", "#009E73", "#D55E00"};
static const int shapes[PANEL_CLASSES] = {7, 9, 7, 5};
static const double sizes[PANEL_CLASSES] = {0.6, 0.8, 0.25, 0.75};

static void write_points(FILE *file, const panel *p, unsigned number, enum panel_class kind)
{
    unsigned i;
    fprintf(file, "$points_%u_%u << END\n", number, (unsigned)kind);
    for (i = 0; i < p->points; i++)
        if (p->point[i].kind == kind) fprintf(file, "%.6g %.6g\n", p->point[i].x, p->point[i].y);
    fprintf(file, "NaN NaN\nEND\n");
}

/* The front by steps: what can be had for so much, from the cheapest on. */
static void write_front(FILE *file, const panel *p, unsigned number, double right)
{
    double last = 0, y = p->y_high;
    unsigned i;
    fprintf(file, "$front_%u << END\n", number);
    for (;;) {
        const panel_point *next = NULL;
        for (i = 0; i < p->points; i++) {
            const panel_point *q = &p->point[i];
            if (q->on_front && q->x > last && (!next || q->x < next->x)) next = q;
        }
        if (!next) break;
        fprintf(file, "%.6g %.6g\n", next->x, y);
        y = next->y;
        fprintf(file, "%.6g %.6g\n", next->x, y);
        last = next->x;
    }
    fprintf(file, "%.6g %.6g\nEND\n", right, y);
}

/* The planner's curve in the order of its points, and a line for each choice that is swept. */
static void write_lines(FILE *file, const panel *p, unsigned number)
{
    unsigned i, line, found = 1;
    fprintf(file, "$curve_%u << END\n", number);
    for (i = 0; i < p->points; i++)
        if (p->point[i].in_curve) fprintf(file, "%.6g %.6g\n", p->point[i].x, p->point[i].y);
    fprintf(file, "NaN NaN\nEND\n$swept_%u << END\n", number);
    for (line = 1; found; line++) {
        found = 0;
        for (i = 0; i < p->points; i++) {
            if (p->point[i].line != line) continue;
            fprintf(file, "%.6g %.6g\n", p->point[i].x, p->point[i].y);
            found++;
        }
        fprintf(file, "\n");
    }
    fprintf(file, "NaN NaN\nEND\n");
}

/* ----------------------------------------------------------------------------------------------------------------------- names
 */

static double x_px(const panel *p, range r, double x) { return log(x / r.low) / log(r.high / r.low) * p->width; }
static double y_px(const panel *p, double y) { return log(p->y_high / y) / log(p->y_high / p->y_low) * p->height; }
static double x_at(const panel *p, range r, double px) { return r.low * pow(r.high / r.low, px / p->width); }
static double y_at(const panel *p, double px) { return p->y_high * pow(p->y_low / p->y_high, px / p->height); }

/* Points of one class that lie on one another share a name. */
static void names_join(panel_name *name, const panel *p, unsigned count)
{
    static char joined[PANEL_NAMES_MAX][120];
    unsigned i, k;
    for (i = 0; i < count; i++) {
        for (k = i + 1; k < count && name[i].text; k++) {
            if (!name[k].text || p->point[i].kind != p->point[k].kind) continue;
            if (fabs(name[i].x - name[k].x) > 2 || fabs(name[i].y - name[k].y) > 2) continue;
            snprintf(joined[k], sizeof joined[k], "%.58s, %.58s", name[i].text, name[k].text);
            name[i].text = joined[k];
            name[k].text = NULL;
        }
    }
}

static void write_names(FILE *file, panel *p, range r)
{
    static panel_name name[PANEL_NAMES_MAX];
    unsigned i;
    for (i = 0; i < p->points && i < PANEL_NAMES_MAX; i++) {
        name[i].x = x_px(p, r, p->point[i].x);
        name[i].y = y_px(p, p->point[i].y);
        name[i].text = p->point[i].label;
        name[i].is_small = p->point[i].kind == PANEL_SWEPT;
    }
    names_join(name, p, i);
    panel_names_place(name, i, p->width, p->height);
    for (i = 0; i < p->points && i < PANEL_NAMES_MAX; i++) {
        const panel_name *n = &name[i];
        if (!n->text) continue;
        fprintf(file, "set label \"%s\" at first %.6g,%.6g center font \",9\" tc rgb \"%s\" noenhanced front\n", n->text,
                x_at(p, r, n->label_x), y_at(p, n->label_y + 0.5),
                p->point[i].kind == PANEL_OTHERS ? "#222222" : colours[p->point[i].kind]);
        if (!n->has_leader) continue;
        fprintf(file, "set arrow from first %.6g,%.6g to first %.6g,%.6g nohead lw 0.6 dt 1 lc rgb \"#999999\" back\n",
                p->point[i].x, p->point[i].y, x_at(p, r, n->leader_x), y_at(p, n->leader_y));
    }
}

/* What a display's level comes to. */
static void write_levels(FILE *file, const panel *p)
{
    static const unsigned bits[3] = {5, 6, 8};
    unsigned i;
    for (i = 0; i < 3; i++) {
        const double level = 1.0 / ((1u << bits[i]) - 1);
        if (level < p->y_low || level > p->y_high) continue;
        fprintf(file, "set arrow from graph 0,first %.6g to graph 1,first %.6g nohead lw 1 dt (4,4) lc rgb \"#777777\" back\n",
                level, level);
        if (p->last)
            fprintf(file, "set label \"%u bits\" at graph 1,first %.6g left offset 0.4,0 font \",9\" tc rgb \"#555555\"\n",
                    bits[i], level);
    }
}

/* ----------------------------------------------------------------------------------------------------------------------- panel
 */

static void write_frame(FILE *file, const panel *p, range r)
{
    fprintf(file, "unset label\nunset arrow\nunset key\n");
    fprintf(file, "set lmargin at screen %.1f/800\nset rmargin at screen %.1f/800\n", p->left, p->left + p->width);
    fprintf(file, "set tmargin at screen 1-%.1f/height\nset bmargin at screen 1-%.1f/height\n", p->top, p->top + p->height);
    fprintf(file, "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\nset logscale xy\n", r.low, r.high, p->y_low, p->y_high);
    fprintf(file, "set title \"%s\" offset 0,-0.6 font \",11\" noenhanced\n", p->title);
    write_tics(file, r);
    fprintf(file, "set ytics 1e-9,10\nset mytics 10\nset format y \"%s\"\n", p->first ? "10^{%L}" : "");
    fprintf(file, p->first ? "set ylabel \"largest error\" offset 1.2,0\n" : "unset ylabel\n");
    fprintf(file, p->x_label ? "set xlabel \"%s\" offset 0,0.3\n" : "unset xlabel\n", p->x_label);
}

void panel_write(FILE *file, panel *p, unsigned number)
{
    const range r = range_of(p);
    unsigned kind;
    for (kind = 0; kind < PANEL_CLASSES; kind++) write_points(file, p, number, (enum panel_class)kind);
    write_front(file, p, number, r.high);
    write_lines(file, p, number);
    write_frame(file, p, r);
    write_levels(file, p);
    write_names(file, p, r);
    fprintf(file, "plot $front_%u with lines lw 4 dt 1 lc rgb \"#DDCCBB\", $swept_%u with lines lw 0.7 dt 1 lc rgb \"#99D5C5\"",
            number, number);
    fprintf(file, ", $curve_%u with lines lw 1.6 dt 1 lc rgb \"%s\"", number, colours[PANEL_OURS]);
    for (kind = 0; kind < PANEL_CLASSES; kind++)
        fprintf(file, ", $points_%u_%u with points pt %d ps %g lc rgb \"%s\"", number, kind, shapes[kind], sizes[kind],
                colours[kind]);
    fprintf(file, "\n");
}
