/* SPDX-License-Identifier: MIT */
/* The frames of growth.csv, for the program that is measured and for the host, which estimates them. */
#ifndef LMB_PROFILE_GROWTH_H
#define LMB_PROFILE_GROWTH_H

#include "../../port/demo/scenes.h"

extern const lmb_mesh mesh_icosphere_20, mesh_icosphere_80, mesh_icosphere_5120, mesh_icosphere_20480;
extern const lmb_mesh mesh_icosphere_320, mesh_icosphere_1280;

/* A frame to measure. */
typedef struct growth_frame {
    const char *axis;
    uint32_t value; /* along that axis */
    const lmb_mesh *mesh;
    enum lmb_model model;
    int size, rows;
    bool anew; /* corners are projected for each triangle anew */
} growth_frame;

/* The scene that a frame shows, and its paint. False if the library refuses it. */
static inline bool growth_prepare(const growth_frame *f, scene *s, lmb_paint *paint)
{
    lmb_look look;
    scene_make(s, 0);
    lmb_camera_orthographic(&s->camera, f->size, f->size, f->size * 30037L, 65536, 8 * 65536L); /* 110 of 240 pixels */
    if (lmb_look_prepare(&look, &s->object[0].material, s->light, 1, f->model, LMB_STEP_QUADRATIC)) return false;
    lmb_paint_prepare(paint, &look, LMB_RGB565);
    return true;
}

/* Each of them. */
static inline void growth_frames(void (*each)(const growth_frame *f))
{
    static const lmb_mesh *const meshes[] = {&mesh_icosphere_20,   &mesh_icosphere_80,   &mesh_icosphere_320,
                                             &mesh_icosphere_1280, &mesh_icosphere_5120, &mesh_icosphere_20480};
    static const uint16_t sizes[] = {32, 48, 64, 96, 128, 160, 240, 320, 400, 480}, rows[] = {120, 60, 30, 16, 8, 4, 2};
    growth_frame f;
    unsigned i, model;
    f.anew = false;
    for (model = 0; model < 2; model++) {
        f.model = model ? LMB_MODEL_DIFFUSE : LMB_MODEL_GLOSS;
        f.axis = "triangles";
        f.size = f.rows = 240;
        for (i = 0; i < sizeof meshes / sizeof meshes[0]; i++) {
            f.mesh = meshes[i];
            f.value = f.mesh->triangles;
            each(&f);
        }
        f.axis = "pixels";
        f.mesh = &mesh_icosphere_320;
        for (i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
            f.value = sizes[i];
            f.size = f.rows = sizes[i];
            each(&f);
        }
    }
    f.model = LMB_MODEL_GLOSS;
    f.axis = "rows";
    f.mesh = &mesh_icosphere_1280;
    f.size = 240;
    for (i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        f.value = rows[i];
        f.rows = rows[i];
        each(&f);
    }
    f.axis = "rows-anew";
    f.anew = true;
    for (i = 0; i < 4; i++) {
        f.value = i ? rows[i - 1] : 240;
        f.rows = (int)f.value;
        each(&f);
    }
}

#endif
