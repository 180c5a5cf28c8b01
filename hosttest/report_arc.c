/* SPDX-License-Identifier: MIT */
/* arc.csv: the largest error of the recurrences of paper 001 and of the library's arc, over angles and lengths. */
#include "arc_reference.h"

#define PHASES 24

enum { PLAIN16, PLAIN32, BLOCK4, LAMBENT, STEPS };

static const char *const step_name[STEPS] = {"plain16", "plain32", "block4", "lambent"};

/* Adds the errors of all forms over one arc that starts at the given phase. */
static void measure(double psi, uint32_t pixels, double amplitude, double phase, double worst[STEPS])
{
    const int32_t u = arc_u_q28(psi), a = arc_q30(amplitude * cos(phase));
    const int32_t rise = arc_q30(amplitude * (cos(phase + psi) - cos(phase)));
    lmb_plain16 plain16;
    lmb_plain32 plain32;
    lmb_block4 block4;
    lmb_arc arc;
    lmb_term term;
    int32_t block[4] = {0, 0, 0, 0};
    uint32_t t;
    lmb_plain16_prepare(&plain16, u, pixels * LMB_ARC_PIXEL, a, rise);
    lmb_plain32_prepare(&plain32, u, pixels * LMB_ARC_PIXEL, a, rise);
    lmb_block4_prepare(&block4, u, pixels * LMB_ARC_PIXEL, a, rise);
    lmb_arc_prepare(&arc, u, pixels * LMB_ARC_PIXEL, 0);
    lmb_arc_start(&arc, &term, a, rise);
    block[3] = block4.f;
    for (t = 0; t <= pixels; t++) {
        const double want = amplitude * cos(phase + psi * t / pixels);
        if (t % 4 == 1) lmb_block4_step(&block4, block);
        worst[PLAIN16] = fmax(worst[PLAIN16], fabs(plain16.f / 16384.0 - want));
        worst[PLAIN32] = fmax(worst[PLAIN32], fabs(plain32.f / 1073741824.0 - want));
        worst[BLOCK4] = fmax(worst[BLOCK4], fabs(block[(t + 3) % 4] / 16384.0 - want));
        worst[LAMBENT] = fmax(worst[LAMBENT], fabs(term.f / 1073741824.0 - want));
        lmb_plain16_step(&plain16);
        lmb_plain32_step(&plain32);
        lmb_arc_step(&arc, &term);
    }
}

int main(void)
{
    static const double psi[] = {0.01, 0.1, 0.5, 1, 2, 5, 10, 15, 30, 45, 60, 75, 90, 105, 120};
    static const uint32_t pixels[] = {1, 2, 4, 8, 16, 32, 64, 100, 128, 240, 256, 512, 800, 1024, 2048, 4096};
    test_random r = {0x9E3779B97F4A7C15u};
    unsigned i, j, k;
    printf("step,psi_degrees,pixels,max_abs_error\n");
    for (i = 0; i < sizeof psi / sizeof *psi; i++) {
        for (j = 0; j < sizeof pixels / sizeof *pixels; j++) {
            double worst[STEPS] = {0, 0, 0, 0};
            for (k = 0; k < 3 * PHASES; k++) {
                double phase = 2 * ARC_PI * (k / 3 + test_real(&r, 0, 1)) / PHASES;
                measure(psi[i] * ARC_PI / 180, pixels[j], k % 3 ? test_real(&r, 0.25, 1) : 1, phase, worst);
            }
            for (k = 0; k < STEPS; k++) printf("%s,%g,%u,%.3g\n", step_name[k], psi[i], (unsigned)pixels[j], worst[k]);
        }
    }
    return 0;
}
