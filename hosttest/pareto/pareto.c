/* SPDX-License-Identifier: MIT */
/* Writes pareto.csv to stdout: what each lobe, way along a span and frame costs on a core, what it errs by and how many bytes it
 * takes.
 *
 *   lobe    one evaluation; scene n-N, and n-1-1000 for all exponents, of which cycles are the mean of the others. Against
 *           max(0, cos)^n; the mean square evenly over the quarter turn
 *   span    a pixel with its share of the set-up; scene psi-DEGREES-m-PIXELS. Against the normal that turns evenly
 *   frame   a pixel of a whole frame, vertices and triangles in it; scene SCENE-FORMAT. Against arcs and exact powers in double;
 *           of the intensities before they are rounded to levels
 * cycles are instructions where unit says so. bytes: of lobes and spans flash of what the linker keeps for the kernel alone, and
 * tables that are made in RAM; of frames those of all functions that were executed.
 *
 * usage: pareto FILE...    (kernel_cycles.csv, frames.csv and bytes.csv of each core)
 */
#include "table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv)
{
    static pareto_table table;
    int i;
    if (argc < 2 || !strcmp(argv[1], "--help")) {
        fprintf(argc < 2 ? stderr : stdout,
                "usage: pareto FILE...\n"
                "  FILE  kernel_cycles.csv, frames.csv and bytes.csv of each core; make pareto calls this\n"
                "writes pareto.csv to stdout\n");
        return argc < 2 ? 2 : EXIT_SUCCESS;
    }
    for (i = 1; i < argc; i++) pareto_costs_read(argv[i]);
    if (!pareto_core(0) || !pareto_frame_at(0)) {
        fprintf(stderr, "pareto: frames or bytes are missing; make pareto gives all files\n");
        return EXIT_FAILURE;
    }
    pareto_lobes(&table);
    pareto_spans(&table);
    pareto_frames(&table);
    pareto_table_fronts(&table);
    pareto_table_print(&table);
    return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
