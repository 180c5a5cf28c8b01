/* SPDX-License-Identifier: MIT */
/* make replicate: every claim of the three papers beside what we measure.
 * usage: replicate [--csv | --lobes | --markdown PAPER] REPORT_FOLDER */
#include "claim.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv)
{
    const bool csv = argc == 3 && !strcmp(argv[1], "--csv");
    const bool lobes = argc == 3 && !strcmp(argv[1], "--lobes");
    const char *paper = argc == 4 && !strcmp(argv[1], "--markdown") ? argv[2] : NULL;
    const char *report = argv[argc - 1];
    if (argc != 2 && !csv && !lobes && !paper) {
        fprintf(stderr, "usage: replicate [--csv | --lobes | --markdown PAPER] REPORT_FOLDER\n");
        return 2;
    }
    if (lobes) {
        claim_print_lobes(report);
        return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
    }
    claims_000(report);
    claims_001(report);
    claims_003(report);
    if (csv)
        claim_print_csv();
    else if (paper)
        claim_print_markdown(paper);
    else
        claim_print_text();
    return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
