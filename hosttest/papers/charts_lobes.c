/* SPDX-License-Identifier: MIT */
/* Data of figures 3 to 9 of paper 000 and 1 to 7 of paper 003, from our own lobes. Angles in degrees, errors in per cent. */
#include "charts.h"
#include "chebyshev.h"
#include "measure.h"
#include "sphere.h"

#include <math.h>

enum { POINTS = 200, SECTION_N = 32 };

static const double degree = PAPER_QUARTER_TURN / 90;

/* Lobes over the angle, up to an angle in degrees; ends with NULL. */
static void curves(const char *folder, const char *name, unsigned n, double degrees, const char *const lobes[])
{
    FILE *file = chart_open(folder, name);
    int i, k;
    fprintf(file, "# degrees cos^%u", n);
    for (k = 0; lobes[k]; k++) fprintf(file, " %s", lobes[k]);
    for (i = 0; i <= POINTS; i++) {
        const double x = degrees * i / POINTS;
        fprintf(file, "\n%.4f %.6f", x, paper_power(n, x * degree));
        for (k = 0; lobes[k]; k++) fprintf(file, " %.6f", paper_lobe_named(lobes[k])->at(n, x * degree));
    }
    fprintf(file, "\n");
    chart_close(file);
}

/* About as many n as there are points, evenly by their logarithm. */
static unsigned next_n(unsigned n) { return n < 30 ? n + 1 : n + n / 30; }

/* The largest relative errors over a region, over n. */
typedef double edge_of(unsigned n);

static double centre(unsigned n) { return n ? 0 : 0; }
static double where_fifth(unsigned n) { return paper_angle_of(n, 0.2); }

static void errors(const char *folder, const char *name, edge_of *from, edge_of *to, unsigned last, const char *const lobes[])
{
    FILE *file = chart_open(folder, name);
    unsigned n;
    int k;
    fprintf(file, "# n");
    for (k = 0; lobes[k]; k++) fprintf(file, " %s", lobes[k]);
    for (n = 2; n <= last; n = next_n(n)) {
        fprintf(file, "\n%u", n);
        for (k = 0; lobes[k]; k++) fprintf(file, " %.5f", 100 * measure_relative(paper_lobe_named(lobes[k]), n, from(n), to(n)));
    }
    fprintf(file, "\n");
    chart_close(file);
}

static void paper_000(const char *folder)
{
    static const char *const epicentre[] = {"w2", "schlick", "lambent", NULL}, *const zones[] = {"w4", "w8", "w16", "lambent",
                                                                                                 NULL};
    static const char *const bloom[] = {"w4", "w8", "w16", "lambent", "schlick", NULL};
    static const char *const w[3][3] = {{"w4", "lambent", NULL}, {"w8", "lambent", NULL}, {"w16", "lambent", NULL}};
    static const char *const name[3] = {"paper-000-figure-5", "paper-000-figure-6", "paper-000-figure-7"};
    int k;
    curves(folder, "paper-000-figure-3", 100, 30, epicentre);
    errors(folder, "paper-000-figure-4", centre, paper_inflection, 1000, epicentre);
    for (k = 0; k < 3; k++) curves(folder, name[k], 35, 45, w[k]);
    errors(folder, "paper-000-figure-8", centre, paper_inflection, 250, zones);
    errors(folder, "paper-000-figure-9", paper_inflection, where_fifth, 250, bloom);
}

/* ------------------------------------------------------------------------------------------------------------------ paper 003 */

/* cos^n for several n, and Lambent's lobe for the same, to both sides. */
static void powers(const char *folder)
{
    static const unsigned n[3] = {2, 8, 32};
    FILE *file = chart_open(folder, "paper-003-figure-1");
    int i, k;
    fprintf(file, "# degrees cos^2 cos^8 cos^32 lambent lambent lambent");
    for (i = -POINTS / 2; i <= POINTS / 2; i++) {
        const double x = 90.0 * i / (POINTS / 2);
        fprintf(file, "\n%.3f", x);
        for (k = 0; k < 3; k++) fprintf(file, " %.6f", paper_power(n[k], fabs(x) * degree));
        for (k = 0; k < 3; k++) fprintf(file, " %.6f", paper_lobe_named("lambent")->at(n[k], fabs(x) * degree));
    }
    fprintf(file, "\n");
    chart_close(file);
}

/* The row of the sphere (sphere.h) that runs through the brightest pixel. */
static void section(const char *folder)
{
    static const char *const lobes[] = {"blinn", "chebyshev_published", "w16", "lambent"};
    FILE *file = chart_open(folder, "paper-003-figure-2");
    int x, y, brightest = 0, k;
    double most = 0;
    for (y = 0; y < SPHERE_SIZE; y++) {
        for (x = 0; x < SPHERE_SIZE; x++) {
            const double value = sphere_light(paper_lobe_named("blinn"), SECTION_N, x, y);
            if (value > most) most = value, brightest = y;
        }
    }
    fprintf(file, "# pixel exact chebyshev_published w16 lambent; row %d", brightest);
    for (x = 0; x < SPHERE_SIZE; x++) {
        if (sphere_light(paper_lobe_named("blinn"), SECTION_N, x, brightest) < 0) continue;
        fprintf(file, "\n%d", x);
        for (k = 0; k < 4; k++)
            fprintf(file, " %.3f", 255 * fmin(1, sphere_light(paper_lobe_named(lobes[k]), SECTION_N, x, brightest)));
    }
    fprintf(file, "\n");
    chart_close(file);
}

/* A, B and C: printed, refitted in two ways, and by our laws. */
static void coefficients(const char *folder)
{
    static const char *const name[3] = {"paper-003-figure-3", "paper-003-figure-4", "paper-003-figure-5"};
    FILE *file[3];
    unsigned n;
    int k;
    for (k = 0; k < 3; k++) {
        file[k] = chart_open(folder, name[k]);
        fprintf(file[k], "# n printed integrals nodes law\n");
    }
    for (n = 1; n <= CHEBYSHEV_N_MAX; n += n < 100 ? 1 : 10) {
        const quadratic of[4] = {chebyshev_published(n), chebyshev_refit(CHEBYSHEV_SERIES, n)->p,
                                 chebyshev_refit(CHEBYSHEV_NODES, n)->p, chebyshev_by_law(n)};
        fprintf(file[0], "%u %.6f %.6f %.6f %.6f\n", n, of[0].a, of[1].a, of[2].a, of[3].a);
        fprintf(file[1], "%u %.6f %.6f %.6f %.6f\n", n, of[0].b, of[1].b, of[2].b, of[3].b);
        fprintf(file[2], "%u %.6f %.6f %.6f %.6f\n", n, of[0].c, of[1].c, of[2].c, of[3].c);
    }
    for (k = 0; k < 3; k++) chart_close(file[k]);
}

/* Relative errors over y = n^1/2 x, printed coefficients for three n, the refit and two others. */
static void relative_errors(const char *folder)
{
    static const struct {
        const char *name;
        unsigned n;
    } of[] = {{"chebyshev_published", 8},
              {"chebyshev_published", 31},
              {"chebyshev_published", 255},
              {"chebyshev_refit", 255},
              {"w16", 255},
              {"lambent", 255}};
    FILE *file = chart_open(folder, "paper-003-figure-7");
    int i;
    unsigned k;
    fprintf(file, "# y published-8 published-31 published-255 refit w16 lambent");
    for (i = 0; i <= 160; i++) {
        const double y = 1.6 * i / 160;
        fprintf(file, "\n%.4f", y);
        for (k = 0; k < sizeof of / sizeof of[0]; k++) {
            const double x = y / sqrt(of[k].n);
            fprintf(file, " %.5f", 100 * (paper_lobe_named(of[k].name)->at(of[k].n, x) / paper_power(of[k].n, x) - 1));
        }
    }
    fprintf(file, "\n");
    chart_close(file);
}

static void paper_003(const char *folder)
{
    static const char *const compared[] = {"chebyshev_published", "chebyshev_refit", "lambent", NULL};
    powers(folder);
    section(folder);
    coefficients(folder);
    curves(folder, "paper-003-figure-6", SECTION_N, 40, compared);
    relative_errors(folder);
}

void charts_lobes(const char *folder)
{
    paper_000(folder);
    paper_003(folder);
}
