/* SPDX-License-Identifier: MIT */
/* make charts: writes the data of all charts. usage: chart_data FOLDER */
#include "charts.h"

#include <stdlib.h>

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: chart_data FOLDER\n");
        return 2;
    }
    charts_lobes(argv[1]);
    charts_steps(argv[1]);
    charts_stability(argv[1]);
    return EXIT_SUCCESS;
}
