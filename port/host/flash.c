/* SPDX-License-Identifier: MIT */
/* Bytes of code: those of the model, and what each part that a view wants adds to it. */
#include "flash.h"

#include <string.h>

#include "flash_table.h"

bool flash_find(flash_need *need, const char *core, const view *v)
{
    const bool gloss = v->model == LMB_MODEL_GLOSS, pixels = v->model >= LMB_MODEL_DIFFUSE;
    const int model = pixels && v->step == LMB_STEP_ARC       ? FLASH_ARC
                      : pixels && v->step == LMB_STEP_PLANNED ? FLASH_PLANNED
                      : gloss                                 ? FLASH_GLOSS
                      : v->model == LMB_MODEL_FLAT            ? FLASH_FLAT
                      : v->model == LMB_MODEL_GOURAUD         ? FLASH_GOURAUD
                                                              : FLASH_DIFFUSE;
    const bool on[FLASH_ROWS] = {[FLASH_DEPTH] = v->order == VIEW_DEPTH,
                                 [FLASH_PERSPECTIVE] = v->camera == 1,
                                 [FLASH_RGB888] = v->format == LMB_RGB888,
                                 [FLASH_LIGHTS] = v->lights > 1,
                                 [FLASH_PAINTER] = v->order == VIEW_PAINTER};
    size_t i;
    int part;
    for (i = 0; i < sizeof weighed / sizeof weighed[0] && strcmp(weighed[i].core, core); i++) {}
    if (i == sizeof weighed / sizeof weighed[0]) return false;
    need->fast = (unsigned long)weighed[i].fast[model];
    need->small = (unsigned long)weighed[i].small[model];
    need->stack = (unsigned long)weighed[i].stack[model];
    for (part = FLASH_MODELS; part < FLASH_ROWS; part++) {
        if (!on[part]) continue;
        need->fast += (unsigned long)(weighed[i].fast[part] - weighed[i].fast[FLASH_GLOSS]);
        need->small += (unsigned long)(weighed[i].small[part] - weighed[i].small[FLASH_GLOSS]);
    }
    return true;
}
