/* SPDX-License-Identifier: MIT */
/* Every way to a highlight that papers 000 and 003 propose or compare, in real arithmetic, under one name each. Tables, charts,
 * kernels (hosttest/compare/, lobe-NAME) and reports use these names.
 *
 * All of them stand for max(0, cos)^n of an angle between N and H, Blinn's. Phong's takes the angle between R and V, which is
 * twice as large where L, V and N lie in one plane, and so the exponent n / 4: cos^(n/4) 2x and cos^n x both begin as 1 - n x^2 /
 * 2. Off that plane R.V and N.H differ in shape, not by a power, and no exponent makes one the other.
 */
#ifndef PAPERS_LOBES_H
#define PAPERS_LOBES_H

#include <stdbool.h>

#define PAPER_QUARTER_TURN 1.57079632679489661923

/* Operations of one evaluation. Shifts, clamps and what is prepared once a material are free. */
typedef struct lobe_cost {
    int multiplications, additions, divisions, roots, reads, calls; /* calls: of powf, expf or acosf */
} lobe_cost;

typedef struct paper_lobe {
    const char *name;
    const char *source;                      /* paper and equation */
    const char *formula;                     /* c: the cosine; x: the angle; v: 1 - c; [s]: s, or 0 where s is below it */
    const char *argument;                    /* what runs along a row, so that an evaluation begins with it */
    double (*raw)(unsigned n, double angle); /* the formula without its cut-offs; NaN where it has no value */
    double (*at)(unsigned n, double angle);  /* cut off: what a renderer shows. angle: 0 to a quarter turn; n: 1 to 1000 */
    lobe_cost carried;                       /* from its argument */
    lobe_cost whole;                         /* from N.H; phong: R.V; lyon: D.D */
    lobe_cost integer;                       /* of the kernel, from its argument; all 0 where there is none */
} paper_lobe;

extern const paper_lobe paper_lobes[];
extern const unsigned paper_lobe_count;

/* By name; ends the program if there is none. */
const paper_lobe *paper_lobe_named(const char *name);

/* Products of x^n by squaring and multiplying over the bits of n. */
int paper_power_products(unsigned n);

/* The exponent that the integer kernel of phong takes for n: whole, n / 4 to nearest, at least 1. */
unsigned paper_phong_exponent(unsigned n);

/* What a lobe costs for n, the products of powers included. */
enum lobe_form { LOBE_CARRIED, LOBE_WHOLE, LOBE_INTEGER };
lobe_cost paper_lobe_cost(const paper_lobe *lobe, unsigned n, enum lobe_form form);

/* cos^n by definition. */
double paper_power(unsigned n, double angle);

/* max(0, 1 - n v / m)^m, m a power of two: W_m of paper 000 with v = 1 - c, and Lyon's shape with v = D.D / 2. */
double paper_w(unsigned m, unsigned n, double v);

/* The angle in (0, a quarter turn] where cos^n turns from bending down to bending up: tan^2 = 1 / (n - 1). */
double paper_inflection(unsigned n);

/* The angle where cos^n is level. */
double paper_angle_of(unsigned n, double level);

#endif
