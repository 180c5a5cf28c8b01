/* SPDX-License-Identifier: MIT */
/* Claims of paper 001, by what they are about. Between claims_001*.c only. */
#ifndef PAPERS_CLAIMS_001_H
#define PAPERS_CLAIMS_001_H

#include "claim.h"
#include "steps.h"

void claims_001_equations(void);           /* (2) to (14) and the operations that they take */
void claims_001_rivals(void);              /* what it says of Gouraud, Phong, Kuijk and Blake, Lyon, Giloi; quality */
void claims_001_speed(const char *report); /* over twice as fast */

static inline claim claim_001(const char *name, bool literal, const char *definition)
{
    claim c = {"001", name, definition, literal};
    return c;
}

#define CLAIM_DEGREE (3.14159265358979323846 / 180)
#define CLAIM_HALF_LEVEL (0.5 / 255)

#endif
