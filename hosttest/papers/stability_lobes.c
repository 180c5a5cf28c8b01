/* SPDX-License-Identifier: MIT */
/* Lobes over their whole domain: shininess 1 to 1000, angles 0 to a quarter turn. As lobes of different shininess have nearly one shape
 * in sqrt(n) times the angle, that is the second axis. Errors are absolute, against cos^n; relative ones are charted. */
#include "stability.h"

#include "../compare/compare.h"
#include "lobes.h"

#include <string.h>

#define ATTACKS 20000
#define MOST 64

static double angle_at(unsigned n, double y) { return fmin(y / sqrt(n), PAPER_QUARTER_TURN); }

/* A shininess and an angle near the grid's point, or the point itself. */
typedef struct lobe_point {
    unsigned n;
    double angle;
} lobe_point;

static lobe_point point_at(double x, double y)
{
    lobe_point p;
    p.n = (unsigned)fmin(fmax(floor(x + 0.5), 1), 1000);
    p.angle = angle_at(p.n, y);
    return p;
}

/* The largest of one value, or of eight below the grid's point, as errors cross zero. */
static double probe(const stability_subject *s, double x, double y, bool thorough,
                    double (*error)(const stability_subject *s, lobe_point p))
{
    double worst = 0;
    int k;
    for (k = 0; k < (thorough ? 8 : 1); k++) worst = fmax(worst, error(s, point_at(x, y * pow(0.85, k / 8.0))));
    return worst;
}

static double error_clamped(const stability_subject *s, lobe_point p)
{
    const paper_lobe *lobe = s->what;
    return fabs(lobe->at(p.n, p.angle) - paper_power(p.n, p.angle));
}

static double error_raw(const stability_subject *s, lobe_point p)
{
    const paper_lobe *lobe = s->what;
    const double error = fabs(lobe->raw(p.n, p.angle) - paper_power(p.n, p.angle));
    return error <= 1e30 ? error : 1e30;
}

/* Prepared once for each shininess. */
static const compare_lobe *prepared(unsigned n)
{
    static compare_lobe lobe[1001];
    static bool ready[1001];
    if (!ready[n] && compare_lobe_prepare(&lobe[n], n)) abort();
    ready[n] = true;
    return &lobe[n];
}

static double error_kernel(const stability_subject *s, lobe_point p)
{
    const compare_lobe_kernel *kernel = s->what;
    const int32_t cosine_q30 = (int32_t)lround(cos(p.angle) * 1073741824);
    compare_argument argument;
    uint32_t word;
    double value;
    float f;
    kernel->arguments(prepared(p.n), &argument, &cosine_q30, 1);
    word = kernel->sum(prepared(p.n), &argument, 1);
    memcpy(&f, &word, sizeof f);
    value = kernel->is_float ? (double)f : word / 32768.0;
    return fabs(value - paper_power(p.n, p.angle));
}

static double probe_clamped(const stability_subject *s, double x, double y, bool thorough, test_random *r)
{
    (void)r;
    return probe(s, x, y, thorough, error_clamped);
}

static double probe_raw(const stability_subject *s, double x, double y, bool thorough, test_random *r)
{
    (void)r;
    return probe(s, x, y, thorough, error_raw);
}

static double probe_kernel(const stability_subject *s, double x, double y, bool thorough, test_random *r)
{
    (void)r;
    return probe(s, x, y, thorough, error_kernel);
}

const stability_axes *stability_lobe_axes(void)
{
    static stability_axes axes = {.x_name = "n", .x_unit = "", .y_name = "sqrt(n) angle", .y_unit = "", .x_whole = true};
    if (axes.columns) return &axes;
    axes.columns = stability_spread(axes.x, STABILITY_COLUMNS, 1, 1000, true);
    axes.rows = stability_spread(axes.y, 40, 0.02, 50, false);
    return &axes;
}

int stability_lobe_subjects(const stability_subject **out)
{
    static stability_subject subject[MOST];
    static int count;
    unsigned i;
    *out = subject;
    if (count) return count;
    for (i = 0; i < paper_lobe_count && count + 2 < MOST; i++) {
        const stability_subject raw = {paper_lobes[i].name, "double before its clamp", &paper_lobes[i], probe_raw};
        const stability_subject clamped = {paper_lobes[i].name, "double", &paper_lobes[i], probe_clamped};
        subject[count++] = raw;
        subject[count++] = clamped;
    }
    for (i = 0; i < compare_lobe_count && count < MOST; i++) {
        const compare_lobe_kernel *kernel = &compare_lobes[i];
        const stability_subject s = {kernel->name + strlen("lobe-"), kernel->is_float ? "float" : "integer", kernel,
                                     probe_kernel};
        if (strcmp(s.method, "none")) subject[count++] = s;
    }
    return count;
}

int stability_of_lobes(stability_row *out, int room)
{
    const stability_subject *subject;
    const int count = stability_lobe_subjects(&subject);
    int i, n = 0;
    for (i = 0; i < count && n + 2 <= room; i++)
        n += stability_report(out + n, "lobe", stability_lobe_axes(), &subject[i], ATTACKS);
    return n;
}
