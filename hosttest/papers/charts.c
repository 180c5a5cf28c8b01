/* SPDX-License-Identifier: MIT */
/* Files of chart data. */
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
