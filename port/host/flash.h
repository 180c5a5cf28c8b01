/* SPDX-License-Identifier: MIT */
/* Bytes of code and stack that a view wants of the library, from linked images (make costs). */
#ifndef LMB_HOST_FLASH_H
#define LMB_HOST_FLASH_H

#include "view.h"

typedef struct flash_need {
    unsigned long fast, small, stack; /* code with -O2 and -Os; stack below lmb_draw_mesh */
} flash_need;

/* What is linked of a model, and what each part adds to gloss. */
enum flash_of { FLASH_FLAT, FLASH_GOURAUD, FLASH_DIFFUSE, FLASH_GLOSS, FLASH_ARC, FLASH_PLANNED, FLASH_MODELS };
enum flash_part { FLASH_DEPTH = FLASH_MODELS, FLASH_PERSPECTIVE, FLASH_RGB888, FLASH_LIGHTS, FLASH_PAINTER, FLASH_ROWS };

/* False if the core was not weighed. */
bool flash_find(flash_need *need, const char *core, const view *v);

#endif
