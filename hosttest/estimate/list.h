/* SPDX-License-Identifier: MIT */
/* Lists of frames: one command line of lmb-estimate a line, models without folder and .obj. Blank lines and lines with # are notes. */
#ifndef ESTIMATE_LIST_H
#define ESTIMATE_LIST_H

#include "../../port/host/estimate.h"

typedef struct list_case {
    char *text; /* the line */
    estimate_view view;
    char *arguments[64];
    int model; /* of models */
} list_case;

typedef struct list {
    list_case *cases;
    unsigned count, models;
    char *names[64]; /* of models, as they stand in the list */
    lmb_mesh meshes[64];
} list;

/* Reads a list, and the models that it names from a folder. Ends the program with one line on errors. */
void list_read(list *l, const char *path, const char *folder);

#endif
