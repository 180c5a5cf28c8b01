/* SPDX-License-Identifier: MIT */
/* What the papers claim and what we measure: one record for each claim and definition, its verdict reckoned from both.
 *
 * A claim may have several records, one for each definition under which its figure can be read. A verdict is
 *   holds                  met as the paper's own words have it
 *   holds where defined    met under the definition given, which is ours
 *   does not hold          not met under this definition
 * Text holds no comma and no quotation mark, so that papers.csv needs neither.
 */
#ifndef PAPERS_CLAIM_H
#define PAPERS_CLAIM_H

#include <stdbool.h>

enum claim_bar {
    CLAIM_AT_MOST,  /* met where measured <= stated, to the digits that the paper prints */
    CLAIM_AT_LEAST, /* met where measured >= stated, to these digits */
    CLAIM_ABOUT     /* met where they agree to these digits, or within a twentieth */
};

enum claim_verdict { CLAIM_HOLDS, CLAIM_HOLDS_WHERE_DEFINED, CLAIM_DOES_NOT_HOLD };

/* What is judged. */
typedef struct claim {
    const char *paper;      /* 000, 001, 003 */
    const char *name;       /* of the claim, as in table1-inflection-w4; the same for all its definitions */
    const char *definition; /* what was measured */
    bool literal;           /* that is what the paper says, in its own words */
} claim;

/* Judges a number. digits: decimals as the paper prints it. */
void claim_number(claim c, enum claim_bar bar, double stated, int digits, const char *unit, double measured);

/* Judges a statement. */
#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
void claim_fact(claim c, const char *stated, bool met, const char *measured, ...);

/* What was judged: as printed, and the verdict. */
enum { CLAIM_TEXT = 96 };
typedef struct claim_record {
    claim about;
    char stated[CLAIM_TEXT], measured[CLAIM_TEXT];
    enum claim_verdict verdict;
} claim_record;

const claim_record *claim_latest(void); /* NULL before the first */

void claim_print_text(void);
void claim_print_csv(void);
void claim_print_markdown(const char *paper); /* a table of one paper's */

/* The lobes of papers 000 and 003 side by side, as a table in Markdown (lobe_table.c). */
void claim_print_lobes(const char *report);

/* The records of each paper; report: the folder of kernel_cycles.csv, whose counts some of them read. */
void claims_000(const char *report);
void claims_001(const char *report);
void claims_003(const char *report);

/* Instructions of a kernel in report/kernel_cycles.csv; NaN if it is not there. */
double claim_instructions(const char *report, const char *core, const char *kernel);

#endif
