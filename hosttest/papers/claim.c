/* SPDX-License-Identifier: MIT */
/* Claims: their verdicts, and all of them as text, CSV and Markdown. */
#include "claim.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 512, TEXT = CLAIM_TEXT };

static claim_record record[MOST];
static unsigned records;

static const char *const verdict_name[] = {"holds", "holds where defined", "does not hold"};

static void fail(const char *why, const char *what)
{
    fprintf(stderr, "replicate: %s: %s\n", why, what);
    exit(EXIT_FAILURE);
}

static void plain_or_fail(const char *text)
{
    if (strpbrk(text, ",\"\n")) fail("a comma, a quotation mark or a line's end in a record", text);
}

static claim_record *add(claim c, bool met)
{
    claim_record *r = &record[records];
    if (records++ == MOST) fail("too many records", c.name);
    plain_or_fail(c.name);
    plain_or_fail(c.definition);
    r->about = c;
    r->verdict = !met ? CLAIM_DOES_NOT_HOLD : c.literal ? CLAIM_HOLDS : CLAIM_HOLDS_WHERE_DEFINED;
    return r;
}

static bool meets(enum claim_bar bar, double stated, int digits, double measured)
{
    const double half = 0.5 * pow(10, -digits), apart = measured - stated;
    switch (bar) {
    case CLAIM_AT_MOST:
        return apart <= half;
    case CLAIM_AT_LEAST:
        return apart >= -half;
    default:
        return fabs(apart) <= fmax(half, fabs(stated) / 20);
    }
}

void claim_number(claim c, enum claim_bar bar, double stated, int digits, const char *unit, double measured)
{
    static const char *const sign[] = {"<= ", ">= ", ""};
    claim_record *r;
    if (isnan(measured)) fail("not measured, so run make report first", c.name);
    r = add(c, meets(bar, stated, digits, measured));
    snprintf(r->stated, TEXT, "%s%.*f%s", sign[bar], digits, stated, unit);
    snprintf(r->measured, TEXT, "%.3g%s", measured, unit);
}

void claim_fact(claim c, const char *stated, bool met, const char *measured, ...)
{
    claim_record *r = add(c, met);
    va_list arguments;
    snprintf(r->stated, TEXT, "%s", stated);
    va_start(arguments, measured);
    vsnprintf(r->measured, TEXT, measured, arguments);
    va_end(arguments);
    plain_or_fail(r->stated);
    plain_or_fail(r->measured);
}

double claim_instructions(const char *report, const char *core, const char *kernel)
{
    char path[512], line[256], at_core[64], at_kernel[64], unit[32];
    double instructions, found = NAN;
    FILE *file;
    snprintf(path, sizeof path, "%s/kernel_cycles.csv", report);
    file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file)) {
        if (sscanf(line, "%63[^,],%63[^,],%31[^,],%lf", at_core, at_kernel, unit, &instructions) == 4 && !strcmp(at_core, core) &&
            !strcmp(at_kernel, kernel))
            found = instructions;
    }
    if (file) fclose(file);
    return found;
}

/* ------------------------------------------------------------------------------------------------------------------ printing */

const claim_record *claim_latest(void) { return records ? &record[records - 1] : NULL; }

void claim_print_text(void)
{
    unsigned i, count[3] = {0, 0, 0};
    for (i = 0; i < records; i++) {
        const claim_record *r = &record[i];
        const bool first = i == 0 || strcmp(record[i - 1].about.name, r->about.name);
        if (i == 0 || strcmp(record[i - 1].about.paper, r->about.paper)) printf("\npaper %s\n", r->about.paper);
        if (first) printf("  %-38s states %s\n", r->about.name, r->stated);
        printf("    %-20s %-22s %s\n", verdict_name[r->verdict], r->measured, r->about.definition);
        count[r->verdict]++;
    }
    printf("\n%u records: %u hold, %u hold where defined, %u do not hold\n", records, count[0], count[1], count[2]);
}

void claim_print_csv(void)
{
    unsigned i;
    printf("paper,claim,stated,measured,definition,verdict\n");
    for (i = 0; i < records; i++)
        printf("%s,%s,%s,%s,%s,%s\n", record[i].about.paper, record[i].about.name, record[i].stated, record[i].measured,
               record[i].about.definition, verdict_name[record[i].verdict]);
}

void claim_print_markdown(const char *paper)
{
    unsigned i;
    printf("| claim | stated | measured | as we define it | verdict |\n|---|---|---|---|---|\n");
    for (i = 0; i < records; i++) {
        const claim_record *r = &record[i];
        const bool first = i == 0 || strcmp(record[i - 1].about.name, r->about.name);
        if (strcmp(r->about.paper, paper)) continue;
        printf("| %s | %s | %s | %s | %s |\n", first ? r->about.name : "", first ? r->stated : "", r->measured,
               r->about.definition, verdict_name[r->verdict]);
    }
}
