/* SPDX-License-Identifier: MIT */
/* make stability: where each method is safe, found by sweeps, and what it does elsewhere.
 * usage: stability [--csv | --markdown] */
#include "stability.h"

#include <string.h>

enum { ROOM = 512 };

static void print_text(const stability_row *row, int rows)
{
    int i;
    printf("Safe: within a level of 255; of normals that turn evenly, of cos^n, or of itself where a triangle is turned.\n");
    for (i = 0; i < rows; i += 2) {
        const char *outside = stability_outside(row[i].kind, row[i].method);
        printf("\n%s %s, %s\n", row[i].kind, row[i].method, row[i].arithmetic);
        if (row[i].safe) printf("  safe      %s: up to %.2g\n", row[i].region, row[i].max_abs_error);
        if (!row[i].safe) printf("  safe      nowhere\n");
        printf("  worst     %.3g\n  outside   %s\n", row[i + 1].max_abs_error, outside ? outside : "?");
    }
}

static void print_csv(const stability_row *row, int rows)
{
    int i;
    printf("method,arithmetic,region,max_abs_error,inside_is_safe\n");
    for (i = 0; i < rows; i++)
        printf("%s,%s,%s,%.3g,%s\n", row[i].method, row[i].arithmetic, row[i].region, row[i].max_abs_error,
               row[i].safe ? "yes" : "no");
}

/* Of what runs on a target, and of a triangle that is turned. */
static void print_markdown(const stability_row *row, int rows)
{
    int i;
    printf("| | method | arithmetic | safe where | worst anywhere | beyond |\n|---|---|---|---|---|---|\n");
    for (i = 0; i < rows; i += 2) {
        const char *outside = stability_outside(row[i].kind, row[i].method);
        if (!strncmp(row[i].arithmetic, "double", 6) && strcmp(row[i].kind, "turned")) continue;
        printf("| %s | `%s` | %s | %s | %.2g | %s |\n", row[i].kind, row[i].method, row[i].arithmetic,
               row[i].safe ? row[i].region : "nowhere", row[i + 1].max_abs_error, outside ? outside : "?");
    }
}

int main(int argc, char **argv)
{
    static stability_row row[ROOM];
    const bool csv = argc == 2 && !strcmp(argv[1], "--csv"), markdown = argc == 2 && !strcmp(argv[1], "--markdown");
    int rows = 0;
    if (argc > 1 && !csv && !markdown) {
        fprintf(stderr, "usage: stability [--csv | --markdown]\n");
        return 2;
    }
    fprintf(stderr, "stability: spans ...\n");
    rows += stability_of_steps(row + rows, ROOM - rows);
    fprintf(stderr, "stability: lobes ...\n");
    rows += stability_of_lobes(row + rows, ROOM - rows);
    fprintf(stderr, "stability: rotation ...\n");
    rows += stability_of_rotation(row + rows, ROOM - rows);
    if (csv)
        print_csv(row, rows);
    else if (markdown)
        print_markdown(row, rows);
    else
        print_text(row, rows);
    return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
