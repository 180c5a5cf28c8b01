/* SPDX-License-Identifier: MIT */
/* A triangle turned on the screen with its light: what keeps its shading, what does not, and by how much. */
#include "papers/rotation.h"

#define LEVEL (1.0 / 255)

/* The largest spread over the three shapes. */
static double spread_at(enum rotation_way way, double degrees, unsigned power)
{
    double worst = 0;
    unsigned shape;
    for (shape = 0; shape < 3; shape++) {
        const rotation_case c = rotation_make(degrees, shape);
        worst = fmax(worst, rotation_spread(&c, way, power));
    }
    return worst;
}

static void test_make(void)
{
    double degrees, worst = 0;
    int i;
    for (degrees = 5; degrees <= 80; degrees *= 2) {
        const rotation_case c = rotation_make(degrees, 0);
        for (i = 0; i < 3; i++) worst = fmax(worst, fabs(arc_angle(c.normal[i], c.normal[(i + 1) % 3]) * 180 / ARC_PI - degrees));
    }
    test_verdict(worst < 1e-9, "rotation_normals", "corners' normals are as far apart as asked, within %.2g degrees", worst);
}

/* Functions of the place in the triangle cannot turn. */
static void test_over_triangle(void)
{
    static const enum rotation_way ways[] = {ROTATION_LINEAR, ROTATION_NORMALISE, ROTATION_QUADRATIC};
    double worst = 0, own = 0, highlight = 0;
    unsigned i;
    for (i = 0; i < 3; i++) worst = fmax(worst, spread_at(ways[i], 80, 100));
    test_verdict(worst < 1e-9, "rotation_over_triangle", "linear, normalise, quadratic in double: %.2g at 80 degrees, n = 100",
                 worst);
    for (i = 0; i < 2; i++) {
        own = fmax(own, fmax(spread_at(ROTATION_OWN_QUADRATIC, i ? 80 : 20, 1), spread_at(ROTATION_OWN_LINEAR, i ? 80 : 20, 1)));
        highlight = fmax(highlight, spread_at(ROTATION_OWN_QUADRATIC, i ? 20 : 10, 16));
    }
    test_verdict(own <= LEVEL / 4 && highlight <= LEVEL / 2, "rotation_planes",
                 "the library's planes: %.2g up to 80 degrees, highlight %.2g up to 20, n = 16; a level is %.2g", own, highlight,
                 LEVEL);
}

/* Rows do, as paper 001 has it: not to be seen up to 20 degrees, plainly from 80 on; and our integers add nothing to it. */
static void test_along_rows(void)
{
    const double small = spread_at(ROTATION_SLERP, 20, 1), large = spread_at(ROTATION_SLERP, 80, 1);
    const double own_small = spread_at(ROTATION_OWN_ARC, 20, 1), own_large = spread_at(ROTATION_OWN_ARC, 80, 1);
    test_verdict(small < LEVEL / 4 && large > 10 * LEVEL, "rotation_rows",
                 "normals that turn evenly: %.2g at 20 degrees, %.2g at 80", small, large);
    test_verdict(fabs(own_small - small) <= LEVEL / 8 && fabs(own_large - large) <= LEVEL / 8, "rotation_arcs",
                 "the library's arcs: %.2g at 20 degrees, %.2g at 80", own_small, own_large);
}

int main(void)
{
    test_make();
    test_over_triangle();
    test_along_rows();
    return test_end();
}
