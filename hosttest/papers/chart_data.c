/* SPDX-License-Identifier: MIT */
/* make charts: writes the data of all charts; make pareto: of its own alone. usage: chart_data FOLDER [pareto] */
#include "charts.h"

#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv)
{
    if (argc < 2 || argc > 3 || (argc == 3 && strcmp(argv[2], "pareto"))) {
        fprintf(stderr, "usage: chart_data FOLDER [pareto]\n");
        return 2;
    }
    charts_pareto(argv[1]);
    if (argc == 3) return EXIT_SUCCESS;
    charts_lobes(argv[1]);
    charts_steps(argv[1]);
    charts_stability(argv[1]);
    return EXIT_SUCCESS;
}
