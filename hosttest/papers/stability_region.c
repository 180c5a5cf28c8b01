/* SPDX-License-Identifier: MIT */
/* Sweeps and the safe regions in them: see stability.h. */
#include "stability.h"

int stability_spread(double *out, int count, double low, double high, bool whole)
{
    int i, n = 0;
    for (i = 0; i < count; i++) {
        const double x = low * pow(high / low, (double)i / (count - 1));
        const double value = whole ? floor(x + 0.5) : x;
        if (n == 0 || value > out[n - 1]) out[n++] = value;
    }
    return n;
}

static double finite(double error) { return error < 1e30 ? error : 1e30; } /* not a number as well */

void stability_sweep(stability_map *map, const stability_axes *axes, const stability_subject *s)
{
    test_random r = {0x9E3779B97F4A7C15u};
    int i, j;
    for (j = 0; j < axes->rows; j++)
        for (i = 0; i < axes->columns; i++) map->error[j][i] = finite(s->probe(s, axes->x[i], axes->y[j], true, &r));
}

/* How much of the plane a rectangle covers, in logarithms: a single value of an axis counts as a tenth of an octave. */
static double area_of(const stability_axes *axes, int left, int right, int bottom, int top)
{
    return (log2(axes->x[right] / axes->x[left]) + 0.1) * (log2(axes->y[top] / axes->y[bottom]) + 0.1);
}

static stability_region largest(const stability_map *map, const stability_axes *axes)
{
    stability_region best = {0, -1, 0, -1, 0};
    double most = 0;
    int left, right, bottom, top, i;
    for (left = 0; left < axes->columns; left++) {
        for (bottom = 0; bottom < axes->rows; bottom++) {
            right = axes->columns - 1;
            for (top = bottom; top < axes->rows; top++) { /* row by row upwards, as far right as all of them are safe */
                for (i = left; i <= right && map->error[top][i] <= STABILITY_LEVEL; i++) continue;
                right = i - 1;
                if (right < left) break;
                if (area_of(axes, left, right, bottom, top) > most) {
                    const stability_region found = {left, right, bottom, top, 0};
                    most = area_of(axes, left, right, bottom, top);
                    best = found;
                }
            }
        }
    }
    return best;
}

/* A value between two of an axis, even in its logarithm. */
static double between(test_random *r, double low, double high, bool whole)
{
    const double x = low * pow(high / low, test_real(r, 0, 1));
    return whole ? fmin(floor(x + 0.5), high) : x;
}

/* The largest error of random inputs in a region; the first that is no longer safe ends the attack and condemns its grid point. */
static bool attack(stability_map *map, const stability_axes *axes, const stability_subject *s, stability_region *at, int attacks,
                   test_random *r)
{
    int k, i, j;
    for (k = 0; k < attacks; k++) {
        const double x = between(r, axes->x[at->left], axes->x[at->right], axes->x_whole);
        const double y = between(r, axes->y[at->bottom], axes->y[at->top], axes->y_whole);
        const double error = finite(s->probe(s, x, y, false, r));
        at->max = fmax(at->max, error);
        if (error <= STABILITY_LEVEL) continue;
        for (i = at->left; i < at->right && axes->x[i + 1] < x; i++) continue;
        for (j = at->bottom; j < at->top && axes->y[j + 1] < y; j++) continue;
        if (i < at->right && axes->x[i + 1] / x < x / axes->x[i]) i++;
        if (j < at->top && axes->y[j + 1] / y < y / axes->y[j]) j++;
        map->error[j][i] = error;
        return false;
    }
    return true;
}

stability_region stability_find(stability_map *map, const stability_axes *axes, const stability_subject *s, int attacks)
{
    test_random r = {0xD1B54A32D192ED03u};
    stability_region found;
    int i, j;
    do {
        found = largest(map, axes);
        if (found.right < found.left) return found;
    } while (!attack(map, axes, s, &found, attacks, &r));
    for (j = found.bottom; j <= found.top; j++)
        for (i = found.left; i <= found.right; i++) found.max = fmax(found.max, map->error[j][i]);
    return found;
}

/* "0.01 <= psi <= 12 deg": an end that is the domain's own is left out. */
static int side_text(char *out, size_t room, const char *name, const char *unit, const double *values, int low, int high,
                     int count)
{
    const bool from = low > 0, to = high < count - 1;
    if (from && to) return snprintf(out, room, "%.4g <= %s <= %.4g%s", values[low], name, values[high], unit);
    if (from) return snprintf(out, room, "%s >= %.4g%s", name, values[low], unit);
    if (to) return snprintf(out, room, "%s <= %.4g%s", name, values[high], unit);
    return snprintf(out, room, "any %s", name);
}

static void region_text(char *out, size_t room, const stability_axes *axes, const stability_region *at)
{
    int n;
    if (at->right < at->left) {
        snprintf(out, room, "none");
        return;
    }
    n = side_text(out, room, axes->x_name, axes->x_unit, axes->x, at->left, at->right, axes->columns);
    n += snprintf(out + n, room - (size_t)n, "; ");
    side_text(out + n, room - (size_t)n, axes->y_name, axes->y_unit, axes->y, at->bottom, at->top, axes->rows);
}

static double worst_of(const stability_map *map, const stability_axes *axes)
{
    double worst = 0;
    int i, j;
    for (j = 0; j < axes->rows; j++)
        for (i = 0; i < axes->columns; i++) worst = fmax(worst, map->error[j][i]);
    return worst;
}

int stability_report(stability_row out[2], const char *kind, const stability_axes *axes, const stability_subject *s, int attacks)
{
    static stability_map map;
    stability_region region;
    int i;
    for (i = 0; i < 2; i++) {
        out[i].kind = kind;
        out[i].method = s->method;
        out[i].arithmetic = s->arithmetic;
    }
    stability_sweep(&map, axes, s);
    out[1].max_abs_error = worst_of(&map, axes);
    out[1].safe = out[1].max_abs_error <= STABILITY_LEVEL;
    snprintf(out[1].region, sizeof out[1].region, "everywhere: %s %.4g to %.4g%s; %s %.4g to %.4g%s", axes->x_name, axes->x[0],
             axes->x[axes->columns - 1], axes->x_unit, axes->y_name, axes->y[0], axes->y[axes->rows - 1], axes->y_unit);
    region = stability_find(&map, axes, s, attacks);
    region_text(out[0].region, sizeof out[0].region, axes, &region);
    out[0].max_abs_error = region.max;
    out[0].safe = region.right >= region.left && region.max <= STABILITY_LEVEL;
    return 2;
}
