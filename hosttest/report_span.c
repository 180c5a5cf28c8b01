/* SPDX-License-Identifier: MIT */
/* span.csv: what a span between two Q2.14 normals errs by, diffuse and in highlights, over angles, lengths and exponents; the
 * power is exact, so that the figures are the arc's alone. */
#include "arc_reference.h"

static const int exponents[ARC_POWERS] = {1, 2, 4, 8, 16, 32, 64, 100, 256, 1000};

/* So many pixels are measured for each angle and length, at least eight spans of them. */
#define PIXELS 12000

int main(void)
{
    static const double psi[] = {0, 0.1, 0.5, 1, 2, 5, 10, 15, 20, 30, 45, 60, 75, 90, 105, 119.9};
    static const uint32_t pixels[] = {1, 2, 3, 4, 6, 8, 12, 16, 32, 64, 128, 240, 512, 1024};
    test_random r = {0x9E3779B97F4A7C15u};
    unsigned i, j, k;
    printf("term,n,psi_degrees,pixels,max_abs_error\n");
    for (i = 0; i < sizeof psi / sizeof *psi; i++) {
        for (j = 0; j < sizeof pixels / sizeof *pixels; j++) {
            arc_errors e = {0, {0}};
            for (k = 0; k < 8 + PIXELS / pixels[j]; k++) {
                uint32_t part = pixels[j] > 1 ? (uint32_t)test_integer(&r, 0, LMB_ARC_PIXEL - 1) : 0;
                arc_case c = arc_random_case(&r, psi[i] * ARC_PI / 180, pixels[j] * LMB_ARC_PIXEL - part);
                arc_measure(&e, &c, exponents, ARC_POWERS);
            }
            printf("diffuse,1,%g,%u,%.3g\n", psi[i], (unsigned)pixels[j], e.f);
            for (k = 0; k < ARC_POWERS; k++)
                printf("specular,%d,%g,%u,%.3g\n", exponents[k], psi[i], (unsigned)pixels[j], e.power[k]);
        }
    }
    return 0;
}
