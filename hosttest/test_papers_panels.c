/* SPDX-License-Identifier: MIT */
/* Names of points in charts overlap neither each other nor other points, and lie within their panel.
 *
 *   test_papers_panels [SEED]
 */
#include "papers/panel_names.h"
#include "test.h"

#include <string.h>

enum { POINTS = 22, PANELS = 60, WIDTH = 332, HEIGHT = 280 };

/* As wide and as high as charts draw them. */
static double half_width(const panel_name *n) { return 3.0 * (double)strlen(n->text); }
static const double half_height = 5;

static bool overlap(const panel_name *a, const panel_name *b)
{
    return fabs(a->label_x - b->label_x) < half_width(a) + half_width(b) && fabs(a->label_y - b->label_y) < 2 * half_height;
}

static bool covers(const panel_name *a, const panel_name *point)
{
    return fabs(a->label_x - point->x) < half_width(a) && fabs(a->label_y - point->y) < half_height;
}

/* Half of the points anywhere, half of them in a cluster. */
static void points_set(panel_name name[POINTS], test_random *r)
{
    static const char *const texts[] = {"w2", "tuned-4", "quadratic", "power-table", "integer-gouraud", "normalise_multiply"};
    const double x = test_real(r, 30, WIDTH - 30), y = test_real(r, 30, HEIGHT - 30);
    int i;
    memset(name, 0, POINTS * sizeof *name);
    for (i = 0; i < POINTS; i++) {
        name[i].x = i % 2 ? test_real(r, 5, WIDTH - 5) : fmin(fmax(x + test_real(r, -40, 40), 5), WIDTH - 5);
        name[i].y = i % 2 ? test_real(r, 5, HEIGHT - 5) : fmin(fmax(y + test_real(r, -40, 40), 5), HEIGHT - 5);
        name[i].text = texts[test_integer(r, 0, 5)];
    }
}

int main(int argc, char **argv)
{
    test_random r = test_seed(argc, argv);
    static panel_name name[POINTS], again[POINTS];
    int panel, i, k, overlaps = 0, covered = 0, outside = 0, other = 0, moved = 0;
    for (panel = 0; panel < PANELS; panel++) {
        points_set(name, &r);
        memcpy(again, name, sizeof name);
        panel_names_place(name, POINTS, WIDTH, HEIGHT);
        panel_names_place(again, POINTS, WIDTH, HEIGHT);
        for (i = 0; i < POINTS; i++) {
            other += name[i].label_x != again[i].label_x || name[i].label_y != again[i].label_y;
            outside += name[i].label_x - half_width(&name[i]) < 0 || name[i].label_x + half_width(&name[i]) > WIDTH ||
                       name[i].label_y - half_height < 0 || name[i].label_y + half_height > HEIGHT;
            moved += name[i].has_leader;
            for (k = 0; k < POINTS; k++) {
                covered += covers(&name[i], &name[k]);
                overlaps += k < i && overlap(&name[i], &name[k]);
            }
        }
    }
    test_verdict(overlaps == 0 && outside == 0 && other == 0, "names",
                 "%d panels of %d: %d overlaps, %d outside, %d elsewhere the next time", PANELS, POINTS, overlaps, outside,
                 other);
    test_verdict(covered * 1000 <= PANELS * POINTS && moved > 0, "points", "%d of %d covered by a name; %d names have a line",
                 covered, PANELS * POINTS, moved);
    return test_end();
}
