/* SPDX-License-Identifier: MIT */
/* A lit sphere by any lobe. */
#include "sphere.h"

#include <math.h>
#include <stdlib.h>

/* The README's lamp; the viewer is on the z axis and far away. */
static const double light[3] = {9488 / 16384.0, 3795 / 16384.0, 12803 / 16384.0};

double sphere_light(const paper_lobe *lobe, unsigned n, int px, int py)
{
    const double x = (px + 0.5 - SPHERE_SIZE / 2.0) / SPHERE_RADIUS, y = (SPHERE_SIZE / 2.0 - py - 0.5) / SPHERE_RADIUS;
    const double to = sqrt(light[0] * light[0] + light[1] * light[1] + light[2] * light[2]), below = 1 - x * x - y * y;
    double z, h[3], length, away, angle;
    if (below <= 0) return -1;
    z = sqrt(below);
    h[0] = light[0] / to;
    h[1] = light[1] / to;
    h[2] = light[2] / to + 1;
    length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    away = sqrt(pow(x - h[0] / length, 2) + pow(y - h[1] / length, 2) + pow(z - h[2] / length, 2));
    angle = 2 * asin(fmin(1, away / 2));
    return 0.05 + 0.45 * fmax(0, (x * light[0] + y * light[1] + z * light[2]) / to) +
           0.5 * (angle < PAPER_QUARTER_TURN ? lobe->at(n, angle) : 0);
}

static int level(double value) { return (int)floor(255 * fmin(1, value) + 0.5); }

/* L* of a grey level of sRGB: IEC 61966-2-1 and CIE 1976. */
static double lightness(int grey)
{
    const double v = grey / 255.0, linear = v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
    return linear > 216.0 / 24389 ? 116 * cbrt(linear) - 16 : linear * 24389 / 27;
}

sphere_difference sphere_compare(const paper_lobe *lobe, unsigned n)
{
    const paper_lobe *exact = paper_lobe_named("blinn");
    sphere_difference d = {0, 99, 0, 0, 0};
    double squares = 0, pixels = 0;
    int x, y;
    for (y = 0; y < SPHERE_SIZE; y++) {
        for (x = 0; x < SPHERE_SIZE; x++) {
            const double want = sphere_light(exact, n, x, y);
            const int a = level(want), b = level(sphere_light(lobe, n, x, y)), apart = abs(a - b);
            const double apart_l = fabs(lightness(a) - lightness(b));
            if (want < 0) continue;
            pixels++;
            squares += apart * apart;
            d.over_1 += apart > 1;
            d.seen += apart_l > 1;
            if (apart > d.levels) d.levels = apart;
            d.delta_l = fmax(d.delta_l, apart_l);
        }
    }
    d.over_1 /= pixels;
    d.seen /= pixels;
    if (squares > 0) d.psnr_db = 10 * log10(255.0 * 255 * pixels / squares);
    return d;
}
