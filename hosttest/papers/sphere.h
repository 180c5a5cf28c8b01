/* SPDX-License-Identifier: MIT */
/* A lit sphere by a lobe and by the exact power, 240 x 240 pixels of 8 bits: what the difference comes to on a display. */
#ifndef PAPERS_SPHERE_H
#define PAPERS_SPHERE_H

#include "lobes.h"

enum { SPHERE_SIZE = 240, SPHERE_RADIUS = 110 };

typedef struct sphere_difference {
    int levels;     /* the largest, of 255 */
    double psnr_db; /* over the sphere's pixels; 99 if they are identical */
    double over_1;  /* share of the sphere's pixels that differ by more than one level */
    double seen;    /* share whose lightness L* differs by more than one, which is about what an eye tells in large fields */
    double delta_l; /* the largest difference of L* */
} sphere_difference;

/* Light 0.05 + 0.45 N.L + 0.5 lobe, rounded to levels, that stand for sRGB greys when L* (CIE 1976) is taken. */
sphere_difference sphere_compare(const paper_lobe *lobe, unsigned n);

/* A row of it as real numbers: light at a pixel by a lobe, or -1 beside the sphere. */
double sphere_light(const paper_lobe *lobe, unsigned n, int x, int y);

#endif
