/* SPDX-License-Identifier: MIT */
/* Writes the accuracy of every lobe for every shininess as CSV: W_m of paper 000 and the tuned lobe, in real and in integer
 * arithmetic, against cos^n over the quarter turn.
 *
 * multiplications and additions are those of one evaluation once s = alpha - slope * (1 - cos) is there. Real W_m has its
 * argument clamped at zero; integer arithmetic adds its lift to W_m as well (lobe.h). at_degrees is where the largest error is;
 * the mean square is taken evenly over the angle.
 */
#include "../firmware/lambent.h"

#include <math.h>
#include <stdio.h>

enum { GRID = 4096, CANDIDATES = 6, FINE = 48 };

static const double quarter = 1.57079632679489661923;

static double power(double x, unsigned n)
{
    double r = 1;
    for (; n; n >>= 1, x *= x) {
        if (n & 1) r *= x;
    }
    return r;
}

/* The lobe in real arithmetic, with the struct's constants; the one between the squarings makes the centre one. */
static double real_lobe(const lmb_lobe *lobe, double v)
{
    double a = lobe->alpha_q30 / 1073741824.0, s = a - ldexp(lobe->slope, lobe->slope_shift - 15) * v;
    double floor = a > 1 ? sqrt(a * a - 1) : 0;
    if (s <= floor) return 0;
    if (s >= a) return 1;
    if (lobe->multiplications == 0) return s;
    if (!lobe->crossed) return power(s * s + 1 - a * a, 1u << (lobe->multiplications - 1));
    if (lobe->multiplications == 2) return (s * s + 1 / a - a * a) * s;
    return power((s * s * s * s + 1 / (a * a) - a * a * a * a) * s * s, lobe->multiplications - 2u);
}

static double value_at(const lmb_lobe *lobe, int real, double v)
{
    return real ? real_lobe(lobe, v) : lmb_lobe_eval(lobe, (int32_t)lrint(v * 1073741824.0)) / 32768.0;
}

typedef struct figures {
    double error, angle, rms;
    int monotone;
} figures;

static double error_at(const lmb_lobe *lobe, int real, double angle)
{
    double half = sin(angle / 2), v = 2 * half * half;
    return fabs(value_at(lobe, real, v) - power(1 - v, lobe->shininess));
}

/* Looks around an angle, then around the best found, each time in FINE steps to either side. */
static void refine(const lmb_lobe *lobe, int real, double angle, double reach, figures *f)
{
    for (int pass = 0; pass < 2; pass++) {
        double found = angle, largest = 0;
        for (int i = -FINE; i <= FINE; i++) {
            double x = angle + i * reach / FINE, e;
            if (x < 0 || x > quarter) continue;
            e = error_at(lobe, real, x);
            if (e > largest) largest = e, found = x;
        }
        if (largest > f->error) f->error = largest, f->angle = found;
        angle = found;
        reach /= FINE;
    }
}

/* v and truth: 1 - cos and cos^n on the grid. */
static figures measure(const lmb_lobe *lobe, int real, const double *v, const double *truth)
{
    figures f = {0, 0, 0, 1};
    double e[GRID + 1], last = 1, sum = 0;
    for (int i = 0; i <= GRID; i++) {
        double value = value_at(lobe, real, v[i]);
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
        refine(lobe, real, best * quarter / GRID, quarter / GRID, &f);
        for (int i = best - 8 < 0 ? 0 : best - 8; i <= GRID && i <= best + 8; i++) e[i] = 0;
    }
    return f;
}

static void print_line(const char *name, const lmb_lobe *lobe, int real, const double *v, const double *truth)
{
    figures f = measure(lobe, real, v, truth);
    int additions = lobe->multiplications > 0;
    if (real && lobe->alpha_q30 == 1 << 30) additions = 0; /* the constant that makes the centre one is then 0, in both forms */
    printf("%s,%u,%s,%d,%d,%.7f,%.4f,%.7f,%d\n", name, (unsigned)lobe->shininess, real ? "real" : "integer",
           lobe->multiplications, additions, f.error, f.angle * 90 / quarter, f.rms, f.monotone);
}

int main(void)
{
    static const struct {
        const char *name;
        enum lmb_lobe_kind kind;
    } lobes[] = {
        {"w2", LMB_LOBE_W2}, {"w4", LMB_LOBE_W4}, {"w8", LMB_LOBE_W8}, {"w16", LMB_LOBE_W16}, {"lambent", LMB_LOBE_TUNED}};
    static double v[GRID + 1], truth[GRID + 1];
    printf("lobe,n,arithmetic,multiplications,additions,max_abs_error,at_degrees,rms_error,monotone\n");
    for (int i = 0; i <= GRID; i++) {
        double half = sin(i * quarter / GRID / 2);
        v[i] = 2 * half * half;
    }
    for (unsigned n = 1; n <= LMB_SHININESS_MAX; n++) {
        for (int i = 0; i <= GRID; i++) truth[i] = power(1 - v[i], n);
        for (int k = 0; k < 5; k++) {
            lmb_lobe lobe;
            if (lmb_lobe_prepare(&lobe, lobes[k].kind, n, 0) != LMB_OK) return 1;
            print_line(lobes[k].name, &lobe, 1, v, truth);
            print_line(lobes[k].name, &lobe, 0, v, truth);
        }
    }
    return 0;
}
