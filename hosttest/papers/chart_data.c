/* SPDX-License-Identifier: MIT */
/* make charts: writes the data of all charts. usage: chart_data FOLDER */
#include "charts.h"

#include <stdlib.h>

static const char *writing = "";

static void fail(void)
{
    fprintf(stderr, "chart_data: cannot write %s\n", writing);
    exit(EXIT_FAILURE);
}

FILE *chart_open(const char *folder, const char *name)
{
    static char path[512];
    FILE *file;
    snprintf(path, sizeof path, "%s/%s.dat", folder, name);
    writing = path;
    file = fopen(path, "w");
    if (!file) fail();
    return file;
}

void chart_close(FILE *file)
{
    if (ferror(file) | fclose(file)) fail();
}

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
