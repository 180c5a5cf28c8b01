/* SPDX-License-Identifier: MIT */
/* Perceptual counts: both frames as 8-bit RGB, before OpenImageIO. */
#include "seen.h"
#include "oiio.h"

#include <stdio.h>
#include <stdlib.h>

int seen_pixels(const ref_drawn *drawn, const ref_frame *frame)
{
    const size_t pixels = (size_t)drawn->width * (size_t)drawn->height;
    uint8_t *levels = malloc(9 * pixels), *ours = levels + 3 * pixels, *theirs = levels + 6 * pixels;
    ref_score score;
    int seen = -1;
    if (levels) {
        ref_judge(&score, frame, drawn, levels);
        ref_visible(ours, drawn->levels, pixels, drawn->format);
        ref_visible(theirs, levels, pixels, drawn->format);
        seen = oiio_perceptual(ours, theirs, drawn->width, drawn->height);
    }
    free(levels);
    if (seen < 0) fprintf(stderr, "no perceptual count of %d x %d pixels\n", drawn->width, drawn->height);
    return seen;
}
