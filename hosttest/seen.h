/* SPDX-License-Identifier: MIT */
/* What someone sees of a drawn frame's distance from a reference. */
#ifndef LMB_SEEN_H
#define LMB_SEEN_H

#include "reference.h"

/* The pixels of the whole frame that someone would tell from the reference's in the frame's format, as oiio_perceptual counts them.
 * -1 after a message on stderr if it cannot. */
int seen_pixels(const ref_drawn *drawn, const ref_frame *frame);

#endif
