/* SPDX-License-Identifier: MIT */
/* Nanoseconds a pixel of the ways along a span, on this very machine: the least of many runs. What instructions do not say is how
 * long a root or a division takes. usage: time_steps */
#include "papers/steps_kernels.h"

#include <stdio.h>
#include <time.h>

enum { PIXELS = 1024, RUNS = 400, REPEATS = 64 };

static double seconds_of(const compare_step_kernel *kernel, const kernel_span *span)
{
    static int32_t out[PIXELS + COMPARE_STEP_SPARE];
    static compare_step_map map;
    compare_step_state state;
    clock_t start;
    unsigned i;
    compare_step_light(&map, span->ray);
    state.map = &map;
    kernel->begin(&state, span->from, span->to, span->ray, PIXELS);
    start = clock();
    for (i = 0; i < REPEATS; i++) kernel->run(&state, out, PIXELS);
    return (double)(clock() - start) / CLOCKS_PER_SEC;
}

int main(void)
{
    const kernel_span span = kernel_span_series(0.5, PIXELS, 3);
    unsigned i, k;
    printf("step,nanoseconds_per_pixel\n");
    for (i = 0; i < compare_step_count; i++) {
        double least = 1e9;
        for (k = 0; k < RUNS; k++) least = fmin(least, seconds_of(&compare_steps[i], &span));
        printf("%s,%.2f\n", compare_steps[i].name, least * 1e9 / PIXELS / REPEATS);
    }
    return 0;
}
