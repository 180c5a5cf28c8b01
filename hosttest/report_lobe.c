/* SPDX-License-Identifier: MIT */
/* Writes the accuracy of every lobe of hosttest/papers/lobes.h for every shininess as CSV, in real arithmetic and, where it has a
 * kernel of integers (hosttest/compare/), in integer arithmetic, against cos^n over the quarter turn.
 *
 * multiplications and additions are those of one evaluation from the argument that runs along a row; products of an exact power
 * are those of squaring and multiplying, in integers three of 16 bits each; powf, expf, divisions and reads are not counted.
 * at_degrees is where the largest error is; the mean square is taken evenly over the angle; monotone: never rises with the angle,
 * on a grid of 4096.
 */
#include "compare/compare.h"
#include "papers/lobes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { GRID = 4096, CANDIDATES = 6, FINE = 48 };

static const double quarter = PAPER_QUARTER_TURN;

/* What is measured: a lobe in double, or its kernel. */
typedef struct subject {
    const paper_lobe *lobe;
    const compare_lobe_kernel *kernel; /* NULL: in double */
    const compare_lobe *prepared;
    unsigned n;
} subject;

static const compare_lobe_kernel *kernel_of(const paper_lobe *lobe)
{
    unsigned i;
    for (i = 0; i < compare_lobe_count; i++) {
        const compare_lobe_kernel *k = &compare_lobes[i];
        if (!k->is_float && !strcmp(k->name + strlen("lobe-"), lobe->name)) return k;
    }
    return NULL;
}

static double value_at(const subject *s, double angle)
{
    const double half = sin(angle / 2);
    const int32_t cosine_q30 = (int32_t)(1073741824 - lrint(2 * half * half * 1073741824));
    compare_argument argument;
    if (!s->kernel) return s->lobe->at(s->n, angle);
    s->kernel->arguments(s->prepared, &argument, &cosine_q30, 1);
    return s->kernel->sum(s->prepared, &argument, 1) / 32768.0;
}

typedef struct figures {
    double error, angle, rms;
    int monotone;
} figures;

static double error_at(const subject *s, double angle) { return fabs(value_at(s, angle) - paper_power(s->n, angle)); }

/* Looks around an angle, then around the best found, each time in FINE steps to either side. */
static void refine(const subject *s, double angle, double reach, figures *f)
{
    for (int pass = 0; pass < 2; pass++) {
        double found = angle, largest = 0;
        for (int i = -FINE; i <= FINE; i++) {
            double x = angle + i * reach / FINE, e;
            if (x < 0 || x > quarter) continue;
            e = error_at(s, x);
            if (e > largest) largest = e, found = x;
        }
        if (largest > f->error) f->error = largest, f->angle = found;
        angle = found;
        reach /= FINE;
    }
}

/* truth: cos^n on the grid. */
static figures measure(const subject *s, const double *truth)
{
    figures f = {0, 0, 0, 1};
    double e[GRID + 1], last = 1, sum = 0;
    for (int i = 0; i <= GRID; i++) {
        double value = value_at(s, i * quarter / GRID);
        if (value > last) f.monotone = 0;
        last = value;
        e[i] = fabs(value - truth[i]);
        sum += i == 0 || i == GRID ? e[i] * e[i] / 2 : e[i] * e[i];
    }
    f.rms = sqrt(sum / GRID);
    for (int c = 0; c < CANDIDATES; c++) { /* the largest left, and its neighbours no more */
        int best = 0;
        for (int i = 1; i <= GRID; i++) {
            if (e[i] > e[best]) best = i;
        }
        refine(s, best * quarter / GRID, quarter / GRID, &f);
        for (int i = best - 8 < 0 ? 0 : best - 8; i <= GRID && i <= best + 8; i++) e[i] = 0;
    }
    return f;
}

static void print_line(const subject *s, const double *truth)
{
    const figures f = measure(s, truth);
    const lobe_cost cost = paper_lobe_cost(s->lobe, s->n, s->kernel ? LOBE_INTEGER : LOBE_CARRIED);
    printf("%s,%u,%s,%d,%d,%.7f,%.4f,%.7f,%d\n", s->lobe->name, s->n, s->kernel ? "integer" : "real", cost.multiplications,
           cost.additions, f.error, f.angle * 90 / quarter, f.rms, f.monotone);
}

int main(void)
{
    static double truth[GRID + 1];
    static compare_lobe prepared;
    printf("lobe,n,arithmetic,multiplications,additions,max_abs_error,at_degrees,rms_error,monotone\n");
    for (unsigned n = 1; n <= LMB_SHININESS_MAX; n++) {
        if (compare_lobe_prepare(&prepared, n) != LMB_OK) return 1;
        for (int i = 0; i <= GRID; i++) truth[i] = paper_power(n, i * quarter / GRID);
        for (unsigned k = 0; k < paper_lobe_count; k++) {
            subject s = {&paper_lobes[k], NULL, &prepared, n};
            print_line(&s, truth);
            s.kernel = kernel_of(s.lobe);
            if (s.kernel) print_line(&s, truth);
        }
    }
    return 0;
}
