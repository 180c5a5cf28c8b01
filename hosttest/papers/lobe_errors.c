/* SPDX-License-Identifier: MIT */
/* Errors of lobes: on a grid, and around its worst points in finer steps. */
#include "lobe_errors.h"

#include <math.h>
#include <string.h>

enum { CANDIDATES = 6, FINE = 48 };

static const double quarter = PAPER_QUARTER_TURN;

static double value_at(const lobe_subject *s, double angle)
{
    const double half = sin(angle / 2);
    const int32_t cosine_q30 = (int32_t)(1073741824 - lrint(2 * half * half * 1073741824));
    compare_argument argument;
    uint32_t word;
    float f;
    if (!s->kernel) return s->lobe->at(s->n, angle);
    s->kernel->arguments(s->prepared, &argument, &cosine_q30, 1);
    word = s->kernel->sum(s->prepared, &argument, 1);
    memcpy(&f, &word, sizeof f);
    return s->kernel->is_float ? (double)f : word / 32768.0;
}

static double error_at(const lobe_subject *s, double angle) { return fabs(value_at(s, angle) - paper_power(s->n, angle)); }

/* Looks around an angle, then around the best found, each time in FINE steps to either side. */
static void refine(const lobe_subject *s, double angle, double reach, lobe_errors *f)
{
    for (int pass = 0; pass < 2; pass++) {
        double found = angle, largest = 0;
        for (int i = -FINE; i <= FINE; i++) {
            double x = angle + i * reach / FINE, e;
            if (x < 0 || x > quarter) continue;
            e = error_at(s, x);
            if (e > largest) largest = e, found = x;
        }
        if (largest > f->most) f->most = largest, f->angle = found;
        angle = found;
        reach /= FINE;
    }
}

void lobe_truth(double truth[LOBE_GRID + 1], unsigned n)
{
    for (int i = 0; i <= LOBE_GRID; i++) truth[i] = paper_power(n, i * quarter / LOBE_GRID);
}

lobe_errors lobe_measure(const lobe_subject *s, const double truth[LOBE_GRID + 1])
{
    lobe_errors f = {0, 0, 0, 1};
    double e[LOBE_GRID + 1], last = 1, sum = 0;
    for (int i = 0; i <= LOBE_GRID; i++) {
        double value = value_at(s, i * quarter / LOBE_GRID);
        if (value > last) f.monotone = 0;
        last = value;
        e[i] = fabs(value - truth[i]);
        sum += i == 0 || i == LOBE_GRID ? e[i] * e[i] / 2 : e[i] * e[i];
    }
    f.rms = sqrt(sum / LOBE_GRID);
    for (int c = 0; c < CANDIDATES; c++) { /* the largest left, and its neighbours no more */
        int best = 0;
        for (int i = 1; i <= LOBE_GRID; i++) {
            if (e[i] > e[best]) best = i;
        }
        refine(s, best * quarter / LOBE_GRID, quarter / LOBE_GRID, &f);
        for (int i = best - 8 < 0 ? 0 : best - 8; i <= LOBE_GRID && i <= best + 8; i++) e[i] = 0;
    }
    return f;
}
