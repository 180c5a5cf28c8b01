/* SPDX-License-Identifier: MIT */
/* Wavefront OBJ files into memory: positions, normals and faces as they stand in the file. Host tools only.
 *
 * Read      v x y z (what follows, a weight or a colour, is checked to be numbers and ignored), vn x y z, and f with three
 *           corners or more in the forms v, v/vt, v//vn, v/vt/vn; negative indices count back from the last v or vn. Comments
 *           from #, lines continued by a final backslash (not in comments: Windows paths end so), CR LF, a byte order mark.
 * Ignored   vt.
 * Skipped   everything else, counted by keyword: obj_print_notes.
 * Refused   with one line `file:line: what is wrong`: numbers that are not numbers, not finite or beyond OBJ_NUMBER_MAX,
 *           normals of no length, indices out of range, faces of fewer than three corners, corners with and without a normal in
 *           one face, NUL bytes, statements longer than OBJ_STATEMENT_MAX, a file without a face.
 */
#ifndef LMB_HOST_OBJ_H
#define LMB_HOST_OBJ_H

#include <stdint.h>
#include <stdio.h>

#include "polygon.h"

#define OBJ_NUMBER_MAX 1e30                  /* its fourth power is still a double */
#define OBJ_STATEMENT_MAX ((size_t)16 << 20) /* bytes of one statement, continued lines included */
#define OBJ_PROGRESS_SIZE (2L << 20)         /* progress is shown for files larger than this, in bytes */
#define OBJ_KEYWORDS 32                      /* skipped keywords that are counted apart */
#define OBJ_QUOTE 36                         /* room for a word from the file in quotes, cut and made printable */
#define OBJ_NONE UINT32_MAX                  /* a corner without a normal */

struct obj_corner {
    uint32_t position, normal; /* from 0; normal may be OBJ_NONE */
};

struct obj_face {
    uint32_t first, corners; /* corner[first] and those after it */
    uint32_t line;
};

struct obj_skipped {
    char quoted[OBJ_QUOTE];
    unsigned long lines;
};

struct obj_model {
    char *path; /* as given */
    struct point3 *position, *normal;
    uint32_t *position_line;
    struct obj_corner *corner;
    struct obj_face *face;
    uint32_t positions, normals, corners, faces;
    struct obj_skipped skipped[OBJ_KEYWORDS + 1]; /* the last one: all further keywords */
    int keywords;
};

struct obj_options {
    FILE *progress; /* NULL: silent */
    int terminal;   /* progress goes to a terminal: one line, rewritten; otherwise a line for each quarter */
};

/* Reads a file; options may be NULL.
 *   return  0, or -1 after one line on errors; *model is to be given to obj_free in either case */
int obj_read(struct obj_model *model, const char *path, const struct obj_options *options, FILE *errors);

/* One line for each keyword that was skipped. */
void obj_print_notes(const struct obj_model *model, FILE *notes);

void obj_free(struct obj_model *model);

#endif
