/* SPDX-License-Identifier: MIT */
/* The specular lobe: every lobe, every shininess, every argument, against powers of the cosine. */
#include "../firmware/lambent.h"
#include "../firmware/power.h"
#include "test.h"

#ifdef LMB_CHECKED
enum { STRIDE = 16 }; /* of n, in the sweeps: the twin is slow */
#else
enum { STRIDE = 1 };
#endif

enum { MOST_LOBES = 6, ALL_N = LMB_SHININESS_MAX };

/* Every lobe that lmb_lobe_prepare ever returns for one n: whatever the tolerance, one of these. From the cheapest to the most
 * accurate. */
static int tuned_lobes(unsigned n, lmb_lobe *lobes)
{
    int count = 0;
    uint16_t tolerance = UINT16_MAX;
    for (;;) {
        if (lmb_lobe_prepare(&lobes[count], LMB_LOBE_TUNED, n, tolerance) != LMB_OK || count == MOST_LOBES - 1) return 0;
        if (lobes[count].error_uq16 > tolerance) return count; /* the one before, once more */
        tolerance = (uint16_t)(lobes[count++].error_uq16 - 1);
    }
}

static double power(double x, unsigned n)
{
    double r = 1;
    for (; n; n >>= 1, x *= x) {
        if (n & 1) r *= x;
    }
    return r;
}

static double slope_of(const lmb_lobe *lobe) { return ldexp(lobe->slope, lobe->slope_shift - 15); }

/* The lobe's polynomial in real arithmetic, from the definition of its form and the centre being one. */
static double real_at(const lmb_lobe *lobe, double s)
{
    double a = lobe->alpha_q30 / 1073741824.0, zero = a > 1 ? sqrt(a * a - 1) : 0;
    if (s <= zero) return 0;
    if (s >= a) return 1;
    if (lobe->multiplications == 0) return s;
    if (!lobe->crossed) return power(s * s + 1 - a * a, 1u << (lobe->multiplications - 1));
    if (lobe->multiplications == 2) return (s * s + 1 / a - a * a) * s;
    return power((s * s * s * s + 1 / (a * a) - a * a * a * a) * s * s, lobe->multiplications - 2u);
}

typedef struct sweep {
    double truth, rounding; /* largest differences from cos^n and from the real polynomial */
    int32_t truth_at, rounding_at;
    int monotone, ends, top;
} sweep;

static void widen(double difference, int32_t s, double *worst, int32_t *at)
{
    if (difference < 0) difference = -difference;
    if (difference > *worst) *worst = difference, *at = s;
}

/* Every s that differs: from below the floor to above alpha. An s stands for all arguments in [s, s + 1), so that both ends are
 * compared. cos^n of one end is that of the next s. Where the polynomial ends above zero, the step at which it is cut off
 * belongs to the error, but is no rounding. */
static sweep sweep_lobe(const lmb_lobe *lobe)
{
    int32_t top = lobe->alpha_q30 >> 14, floor = lobe->floor_q15 * 2, last = 0;
    double per_s = 1 / (65536 * slope_of(lobe));
    sweep r = {0, 0, 0, 0, 1, 1, top};
    double v = top * per_s, truth = v < 1 ? power(1 - v, lobe->shininess) : 0, real = real_at(lobe, 0);
    for (int32_t s = 0; s <= top; s++) {
        int32_t value = lmb_lobe_at(lobe, s);
        double got = value / 32768.0;
        widen(got - truth, s, &r.truth, &r.truth_at);
        if (s > floor) widen(got - real, s, &r.rounding, &r.rounding_at);
        if (value < last || value > 32768) r.monotone = 0;
        last = value;
        if (s == top) break;
        v = (top - s - 1) * per_s;
        truth = v < 1 ? power(1 - v, lobe->shininess) : 0;
        real = real_at(lobe, (s + 1) / 65536.0);
        widen(got - truth, s, &r.truth, &r.truth_at);
        if (s > floor) widen(got - real, s, &r.rounding, &r.rounding_at);
    }
    static const int32_t beyond[] = {INT32_MIN, INT32_MIN + 1, -65536 * 160,  -65536,  -1,
                                     0,         INT32_MAX,     INT32_MAX - 1, 1 << 30, 131072};
    for (int i = 0; i < 10; i++) {
        if (lmb_lobe_at(lobe, beyond[i]) != (i < 6 ? 0 : 32768)) r.ends = 0;
    }
    if (lmb_lobe_at(lobe, floor) != 0 || lmb_lobe_at(lobe, top) != 32768 || lmb_lobe_at(lobe, top + 1) != 32768) r.ends = 0;
    return r;
}

/* One sweep answers for errors, order and ends of all tuned lobes. */
static void test_tuned_exhaustively(void)
{
    double best = 0, worst_rounding = 0, excess = -1, slack = 0;
    unsigned best_n = 0, rounding_n = 0, excess_n = 0, slack_n = 0, unordered = 0, bad_ends = 0, missing = 0;
    int32_t best_s = 0;
    for (unsigned n = 1; n <= ALL_N; n += STRIDE) {
        lmb_lobe lobes[MOST_LOBES];
        int count = tuned_lobes(n, lobes);
        if (count == 0) missing = n;
        for (int i = 0; i < count; i++) {
            sweep r = sweep_lobe(&lobes[i]);
            double promised = lobes[i].error_uq16 / 65536.0;
            if (i == count - 1 && r.truth > best) best = r.truth, best_n = n, best_s = r.truth_at;
            if (r.rounding > worst_rounding) worst_rounding = r.rounding, rounding_n = n;
            if (r.truth - promised > excess) excess = r.truth - promised, excess_n = n;
            if (promised - r.truth * 1.125 > slack) slack = promised - r.truth * 1.125, slack_n = n;
            if (!r.monotone) unordered = n;
            if (!r.ends) bad_ends = n;
        }
    }
    test_verdict(!missing, "lobe: served", "every n, at most %d lobes each (last n without: %u)", MOST_LOBES - 1, missing);
    test_verdict(best <= LMB_LOBE_MAX_ERROR, "lobe: most accurate, every n, every s",
                 "max error %.6f (1/%.0f) at n = %u, s = %" PRId32, best, 1 / best, best_n, best_s);
    test_verdict(worst_rounding <= LMB_LOBE_ROUNDING, "lobe: integer against real polynomial", "max difference %.6f at n = %u",
                 worst_rounding, rounding_n);
    test_verdict(excess <= 0, "lobe: promised error holds", "closest is %.6f under, at n = %u", -excess, excess_n);
    test_verdict(slack <= 1.0 / 1000, "lobe: promised error is tight", "at most %.6f beyond 9/8 of the true error, at n = %u",
                 slack, slack_n);
    test_verdict(!unordered, "lobe: never decreases with s", "all tuned lobes (last n that does: %u)", unordered);
    test_verdict(!bad_ends, "lobe: ends", "0 up to the floor, 1 from alpha on, any int32 (last n that fails: %u)", bad_ends);
}

/* By angle, with powers from the C library: 4096 to the quarter turn and 1024 over the highlight. */
static void test_angles(void)
{
    double worst = 0, lit = 0, worst_angle = 0, pi = acos(-1.0);
    unsigned worst_n = 0, lit_n = 0, unordered = 0, centre = 0;
    for (unsigned n = 1; n <= ALL_N; n += STRIDE) {
        lmb_lobe lobe;
        int32_t last = 32768;
        double step[2] = {pi / 8192, 6 / sqrt(n) / 1024 < pi / 2048 ? 6 / sqrt(n) / 1024 : pi / 2048};
        lmb_lobe_prepare(&lobe, LMB_LOBE_TUNED, n, 0);
        if (lmb_lobe_eval(&lobe, 0) != 32768) centre = n;
        for (int pass = 0; pass < 2; pass++) {
            last = 32768;
            for (int i = 0; i <= (pass ? 1024 : 8192); i++) {
                double angle = i * step[pass], u = sin(angle / 2), v = 2 * u * u;
                double c = (double)cosl(angle), truth = i < 4096 && c > 0 ? (double)powl(c, n) : 0;
                int32_t value = lmb_lobe_eval(&lobe, (int32_t)lrint(fmin(v * 1073741824.0, 2147483647.0)));
                double error = fabs(value / 32768.0 - truth);
                if (error > worst) worst = error, worst_n = n, worst_angle = angle;
                if (!pass && i >= 4096 && value > lit) lit = value, lit_n = n;
                if (value > last) unordered = n;
                last = value;
            }
        }
    }
    test_verdict(worst <= LMB_LOBE_MAX_ERROR, "lobe: by angle, 0 to 180 degrees",
                 "max error %.6f (1/%.0f) at n = %u, %.4f degrees", worst, 1 / worst, worst_n, worst_angle * 180 / pi);
    test_verdict(lit == 0, "lobe: dark beyond a quarter turn", "largest value %.0f at n = %u", lit, lit_n);
    test_verdict(!unordered, "lobe: never grows with the angle", "last n that does: %u", unordered);
    test_verdict(!centre, "lobe: one at the centre", "32768 for every n (last n that is not: %u)", centre);
}

/* What the polynomial degrees and their integer forms give where cos^n is one of them. */
static void test_exact(void)
{
    static const unsigned exact[] = {1, 2, 3, 4, 6, 8, 12, 16};
    double worst = 0;
    unsigned worst_n = 0;
    for (int i = 0; i < 8; i++) {
        lmb_lobe lobe;
        lmb_lobe_prepare(&lobe, LMB_LOBE_TUNED, exact[i], 0);
        for (int k = 0; k <= 1000; k++) {
            double c = 1 - k / 1000.0, s = lobe.alpha_q30 / 1073741824.0 - slope_of(&lobe) * (1 - c);
            double error = fabs(real_at(&lobe, s) - pow(c, exact[i]));
            if (error > worst) worst = error, worst_n = exact[i];
        }
    }
    test_verdict(worst < 1.0 / 65536, "lobe: n = 1, 2, 3, 4, 6, 8, 12, 16 are exact", "real arithmetic, %.7f at n = %u", worst,
                 worst_n);
}

/* W_m from paper 000, past its zero 0. */
static void test_published(void)
{
    double worst = 0, horizon = 0;
    unsigned worst_n = 0, worst_m = 0, ends = 0, unordered = 0;
    for (unsigned kind = LMB_LOBE_W2; kind <= LMB_LOBE_W16; kind++) {
        unsigned m = 1u << kind;
        for (unsigned n = 1; n <= ALL_N; n += STRIDE) {
            lmb_lobe lobe;
            int32_t last = 32768;
            if (lmb_lobe_prepare(&lobe, (enum lmb_lobe_kind)kind, n, 1000) != LMB_OK || lobe.multiplications != kind) ends = n;
            if (n == 1) { /* s alone decides, so that one n answers for all */
                sweep r = sweep_lobe(&lobe);
                if (r.rounding > worst) worst = r.rounding, worst_n = n, worst_m = m;
                if (!r.ends) ends = n;
                if (!r.monotone) unordered = n;
            }
            for (int i = 0; i <= 2048; i++) { /* v over [0, 2], and finely over the highlight */
                double v = i <= 1024 ? i / 512.0 : (i - 1024) / 1024.0 * m / n, s = 1 - v * n / m;
                int32_t value;
                if (v > 2) break;
                if (i == 1025) last = 32768;
                value = lmb_lobe_eval(&lobe, (int32_t)lrint(fmin(v * 1073741824.0, 2147483647.0)));
                double error = fabs(value / 32768.0 - (s > 0 ? pow(s, m) : 0));
                if (error > worst) worst = error, worst_n = n, worst_m = m;
                if (value > last) unordered = n;
                last = value;
            }
            if (n >= m && lmb_lobe_eval(&lobe, 1 << 30) > horizon) horizon = lmb_lobe_eval(&lobe, 1 << 30);
        }
    }
    test_verdict(worst <= LMB_LOBE_ROUNDING, "lobe: W_m against its formula, clamped", "max difference %.6f at n = %u, m = %u",
                 worst, worst_n, worst_m);
    test_verdict(!ends && !unordered, "lobe: W_m never wraps or grows", "ends %u, order %u", ends, unordered);
    test_verdict(horizon == 0, "lobe: W_m is 0 at the horizon for n >= m", "largest value %.0f", horizon);
}

/* No W_m is nearer than the tuned lobe of as many multiplications or fewer, but for a rounding. */
static void test_tuned_against_published(void)
{
    double worst = -1;
    unsigned worst_n = 0, worst_m = 0;
    for (unsigned n = 1; n <= ALL_N; n += n < 32 ? 1 : 11) {
        lmb_lobe lobes[MOST_LOBES], published;
        double error[MOST_LOBES];
        int count = tuned_lobes(n, lobes);
        for (int i = 0; i < count; i++) error[i] = sweep_lobe(&lobes[i]).truth;
        for (unsigned k = 1; k <= 4; k++) {
            double best = 1, than;
            if (lmb_lobe_prepare(&published, (enum lmb_lobe_kind)k, n, 0)) abort();
            for (int i = 0; i < count; i++) {
                if (lobes[i].multiplications <= k) best = fmin(best, error[i]);
            }
            than = best - sweep_lobe(&published).truth;
            if (than > worst) worst = than, worst_n = n, worst_m = 1u << k;
        }
    }
    test_verdict(worst <= 1.0 / 32768, "lobe: no W_m is nearer than a tuned one of no more multiplications",
                 "at most by %.7f, at n = %u, m = %u", worst, worst_n, worst_m);
}

/* alpha - slope * v, for any v. */
static void test_argument(test_random *random)
{
    static const int32_t edge[] = {INT32_MIN, -(1 << 18), -1, 0, 1, 1 << 30, INT32_MAX};
    double worst = 0, largest = 0;
    int centre = 1, fields = 1, far = 1;
    for (unsigned n = 1; n <= ALL_N; n++) {
        for (unsigned kind = LMB_LOBE_TUNED; kind <= LMB_LOBE_W16; kind++) {
            lmb_lobe lobe;
            lmb_lobe_prepare(&lobe, (enum lmb_lobe_kind)kind, n, (uint16_t)test_integer(random, 0, 9999));
            for (int i = 0; i < 7 + 64; i++) {
                int32_t v = i < 7 ? edge[i] : (int32_t)(test_integer(random, INT32_MIN, INT32_MAX) >> (i % 24));
                int32_t s = lmb_lobe_argument(&lobe, v);
                double want = (lobe.alpha_q30 - slope_of(&lobe) * v) / 16384, value = lmb_lobe_at(&lobe, s);
                /* s is rounded down: what is over is the product's rounding before the shift. */
                double off = s > want ? (s - want) * 16 : want - s;
                if (off > worst) worst = off;
                if (fabs((double)s) > largest) largest = fabs((double)s);
                if (v <= 0 && value != 32768) centre = 0;
                if (v >= 1 << 30 && kind == LMB_LOBE_TUNED && value != 0) far = 0;
            }
            if (lobe.slope < 32768 || lobe.slope_shift < -4 || lobe.slope_shift > 8 || lobe.alpha_q30 & 0x3fff ||
                lobe.multiplications > 4 || lobe.shininess != n) {
                fields = 0;
            }
        }
    }
    test_verdict(worst <= 1, "lobe: argument", "below alpha - slope v by less than one step, above by less than 1/16: %.6f",
                 worst);
    test_verdict(largest <= (double)LMB_LOBE_ARGUMENT_MAX, "lobe: argument never wraps", "|s| at most %.0f", largest);
    test_verdict(centre && far, "lobe: cosines rounded beyond 1 and below 0", "give 32768 and 0");
    test_verdict(fields, "lobe: fields in their ranges", "every n, every kind");
}

/* For any tolerance: no lobe with fewer multiplications would have done; and what each number of them costs in accuracy. */
static void test_choice(void)
{
    static const double bar[5] = {0, 0.0702, 0.0222, 0.0060, 0.0011};
    double worst[5] = {0};
    unsigned wrong = 0, over = 0;
    for (unsigned n = 1; n <= ALL_N; n++) {
        lmb_lobe lobes[MOST_LOBES], got;
        int count = tuned_lobes(n, lobes);
        for (int i = 0; i < count; i++) {
            double e = lobes[i].error_uq16 / 65536.0;
            if (i > 0 && lobes[i].multiplications <= lobes[i - 1].multiplications) wrong = n;
            if (n >= 1u << lobes[i].multiplications && e > worst[lobes[i].multiplications]) worst[lobes[i].multiplications] = e;
        }
        for (unsigned tolerance = 0; tolerance < 6000; tolerance += tolerance < 200 ? 1 : 13) {
            int first = 0;
            while (first < count - 1 && lobes[first].error_uq16 > tolerance) first++;
            lmb_lobe_prepare(&got, LMB_LOBE_TUNED, n, (uint16_t)tolerance);
            if (got.multiplications != lobes[first].multiplications || got.error_uq16 != lobes[first].error_uq16) wrong = n;
        }
    }
    for (unsigned m = 1; m <= 4; m++) {
        if (worst[m] > bar[m]) over = m;
    }
    test_verdict(!wrong, "lobe: fewest multiplications within the tolerance",
                 "every n, tolerances to 6000/65536 (last wrong n: %u)", wrong);
    test_verdict(!over, "lobe: error by multiplications, every n >= 2^m", "1: %.5f, 2: %.5f, 3: %.5f, 4: %.5f", worst[1],
                 worst[2], worst[3], worst[4]);
}

/* The exact power, for ramps: every n, from the centre to beyond the quarter turn. */
static void test_power(test_random *random)
{
    double worst = 0;
    unsigned worst_n = 0, unordered = 0, centre = 0, dark = 0;
    for (unsigned n = 1; n <= ALL_N; n++) {
        int32_t last = 32768;
        for (int i = 0; i <= 1200; i++) {
            const double most = i < 600 ? fmin(2, 12.0 / n) : 2, v = (i % 600 + test_real(random, 0, 1)) * most / 600;
            const int32_t v_q30 = (int32_t)fmin(v * 1073741824.0, 2147483647.0), value = lmb_power_q15(n, v_q30);
            const double c = 1 - ldexp(v_q30, -30), error = fabs(value / 32768.0 - (c > 0 ? pow(c, n) : 0));
            if (error > worst) worst = error, worst_n = n;
            if (i % 600 == 0) last = 32768;
            if (value > last) unordered = n;
            last = value;
        }
        if (lmb_power_q15(n, 0) != 32768) centre = n;
        if (lmb_power_q15(n, 1 << 30) != 0 || lmb_power_q15(n, INT32_MAX) != 0) dark = n;
    }
    test_verdict(worst <= 0.5 / 32768 + 3e-6 && !unordered && !centre && !dark, "lobe: the exact power",
                 "every n: max error %.7f at n = %u, 2^-16 of it rounding; order %u, centre %u, dark %u", worst, worst_n,
                 unordered, centre, dark);
}

static void test_refusals(void)
{
    lmb_lobe lobe;
    int ok = lmb_lobe_prepare(&lobe, LMB_LOBE_TUNED, 0, 0) == LMB_ERROR_VALUE &&
             lmb_lobe_prepare(&lobe, LMB_LOBE_TUNED, LMB_SHININESS_MAX + 1, 0) == LMB_ERROR_VALUE &&
             lmb_lobe_prepare(&lobe, LMB_LOBE_W4, 0, 0) == LMB_ERROR_VALUE &&
             lmb_lobe_prepare(&lobe, LMB_LOBE_TUNED, UINT16_MAX + 2u, 0) == LMB_ERROR_VALUE &&
             lmb_lobe_prepare(&lobe, (enum lmb_lobe_kind)(LMB_LOBE_W16 + 1), 16, 0) == LMB_ERROR_VALUE;
    test_verdict(ok, "lobe: refusals", "n = 0, n = %d, no such kind", LMB_SHININESS_MAX + 1);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_tuned_exhaustively();
    test_angles();
    test_exact();
    test_published();
    test_tuned_against_published();
    test_argument(&random);
    test_choice();
    test_power(&random);
    test_refusals();
    return test_end();
}
