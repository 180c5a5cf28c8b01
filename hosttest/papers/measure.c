/* SPDX-License-Identifier: MIT */
/* Sweeps over angles and exponents. */
#include "measure.h"
#include "claim.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { STEPS = 200, LEVELS = 200, N_LAST = 250, N_FAR = 16 };

double measure_relative(const paper_lobe *lobe, unsigned n, double from, double to)
{
    double largest = 0;
    int i;
    for (i = 0; i <= STEPS; i++) {
        const double x = from + (to - from) * i / STEPS;
        const double truth = paper_power(n, x), value = lobe->at(n, x);
        if (truth < 1e-12 && value > 1e-12) return INFINITY;
        if (truth >= 1e-12) largest = fmax(largest, fabs(value / truth - 1));
    }
    return largest;
}

double measure_absolute(const paper_lobe *lobe, unsigned n, double from, double to)
{
    double largest = 0;
    int i;
    for (i = 0; i <= STEPS; i++) {
        const double x = from + (to - from) * i / STEPS;
        largest = fmax(largest, fabs(lobe->at(n, x) - paper_power(n, x)));
    }
    return largest;
}

double measure_own_inflection(const paper_lobe *lobe, unsigned n)
{
    const double d = 0.002 / sqrt(n);
    double x;
    for (x = d; x + d < PAPER_QUARTER_TURN; x += d) {
        if (lobe->at(n, x - d) + lobe->at(n, x + d) > 2 * lobe->at(n, x)) return x;
    }
    return PAPER_QUARTER_TURN;
}

/* -------------------------------------------------------------------------------------------------------------------- table 1 */

const char *const table1_rows[TABLE1_ROWS] = {"w4", "w8", "w16", "schlick"};
const double table1_stated[2][TABLE1_ROWS] = {{8.0, 3.8, 1.0, 22.4}, {35.2, 16.2, 7.6, 98.2}};

enum measure { RELATIVE, RELATIVE_TO_LOBE, ABSOLUTE, MEASURES };
enum edge { OF_POWER, OF_LOBE, EDGES };
enum range { FROM_1, FROM_16, AT_250, RANGES };

static const char *const measure_text[MEASURES] = {"relative error", "error over the lobe", "absolute error"};
static const char *const edge_text[EDGES] = {"cos^n", "the lobe"};
static const char *const range_text[RANGES] = {"1 to 250", "16 to 250", "250"};

/* Per cent, the largest over n: [row][measure][edge][range][level], the level being index / LEVELS. */
static double largest[TABLE1_ROWS][MEASURES][EDGES][RANGES][LEVELS + 1];

static void keep(int row, int measure, int edge, unsigned n, int level, double error)
{
    double(*of)[LEVELS + 1] = largest[row][measure][edge];
    of[FROM_1][level] = fmax(of[FROM_1][level], error);
    if (n >= N_FAR) of[FROM_16][level] = fmax(of[FROM_16][level], error);
    if (n == N_LAST) of[AT_250][level] = fmax(of[AT_250][level], error);
}

/* Outwards from the centre: the largest errors so far, noted at each level that cos^n or the lobe falls below. */
static void sweep(int row, unsigned n)
{
    const paper_lobe *lobe = paper_lobe_named(table1_rows[row]);
    int next[EDGES] = {LEVELS, LEVELS}, i, k, m;
    double most[MEASURES] = {0, 0, 0};
    for (i = 0; next[OF_POWER] > 0 || next[OF_LOBE] > 0; i++) {
        const double x = i * 0.005 / sqrt(n), truth = paper_power(n, x), value = lobe->at(n, x),
                     error = 100 * fabs(value - truth);
        if (x > PAPER_QUARTER_TURN) break;
        for (k = 0; k < EDGES; k++) {
            for (; next[k] > 0 && (k == OF_POWER ? truth : value) < (double)next[k] / LEVELS; next[k]--) {
                for (m = 0; m < MEASURES; m++) keep(row, m, k, n, next[k], most[m]);
            }
        }
        most[RELATIVE] = fmax(most[RELATIVE], error / truth);
        most[RELATIVE_TO_LOBE] = fmax(most[RELATIVE_TO_LOBE], error / value);
        most[ABSOLUTE] = fmax(most[ABSOLUTE], error);
    }
}

static void sweep_all(void)
{
    static bool done;
    unsigned n;
    int row;
    if (done) return;
    done = true;
    for (row = 0; row < TABLE1_ROWS; row++) {
        for (n = 1; n <= N_LAST; n++) sweep(row, n);
    }
}

static void consider(table1_reading *best, int column, int m, int k, int r, int level)
{
    static char text[2][CLAIM_TEXT];
    double off = 0;
    int row, met = 0;
    for (row = 0; row < TABLE1_ROWS; row++) {
        const double apart = fabs(largest[row][m][k][r][level] / table1_stated[column][row] - 1);
        if (apart <= 0.05) met++, off += apart;
    }
    if (met < best->met || (met == best->met && off >= best->off)) return;
    best->met = met;
    best->off = off;
    for (row = 0; row < TABLE1_ROWS; row++) best->percent[row] = largest[row][m][k][r][level];
    snprintf(text[column], sizeof text[column], "%s while %s is at least %.3f; n = %s", measure_text[m], edge_text[k],
             (double)level / LEVELS, range_text[r]);
    best->text = text[column];
}

const table1_reading *table1_best(int column)
{
    static table1_reading best[2];
    int m, k, r, level;
    if (best[column].text) return &best[column];
    sweep_all();
    for (m = 0; m < MEASURES; m++) {
        for (k = 0; k < EDGES; k++) {
            for (r = 0; r < RANGES; r++) {
                for (level = 1; level < LEVELS; level++) consider(&best[column], column, m, k, r, level);
            }
        }
    }
    return &best[column];
}
