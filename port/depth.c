/* SPDX-License-Identifier: MIT */
/* The depth test: which pixels of a row are seen. */
#include "depth.h"

#if LMB_WITH_DEPTH
void lmb_depth_run(depth_row *row) { depth_run(row); }
#else
typedef int lmb_no_depth; /* a translation unit needs a declaration */
#endif
