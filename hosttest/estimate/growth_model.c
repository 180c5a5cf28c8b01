/* SPDX-License-Identifier: MIT */
/* What lmb-estimate says of the frames of growth.csv and of those between: core,axis,value,model,estimated.
 * usage: growth_model > CSV */
#include "../../port/host/costs.h"
#include "../profile/growth.h"

#include <stdio.h>
#include <stdlib.h>

static void print(const growth_frame *f)
{
    static scene s;
    static lmb_paint paint;
    cost_counts counts;
    double parts[COST_PARTS];
    unsigned i;
    const cost_frame frame = {f->mesh, &s.object[0].pose, &s.camera, &paint, f->size, f->size, f->rows, f->anew, false, false};
    if (!growth_prepare(f, &s, &paint) || cost_count(&counts, &frame)) {
        fprintf(stderr, "growth_model: cannot draw %s-%lu\n", f->axis, (unsigned long)f->value);
        exit(EXIT_FAILURE);
    }
    for (i = 0; i < cost_core_count; i++) {
        printf("%s,%s,%lu,%s,%.0f\n", cost_cores[i].name, f->axis, (unsigned long)f->value,
               f->model == LMB_MODEL_GLOSS ? "gloss" : "diffuse", cost_sum(&cost_cores[i], &counts, parts));
    }
}

/* Values between those that are measured. */
static void print_between(void)
{
    growth_frame f = {"pixels", 0, &mesh_icosphere_320, LMB_MODEL_GLOSS, 0, 0, false};
    for (f.size = 40; f.size < 480; f.size += 16) {
        f.rows = f.size;
        f.value = (uint32_t)f.size;
        print(&f);
    }
    f.axis = "rows";
    f.mesh = &mesh_icosphere_1280;
    f.size = 240;
    for (f.rows = 3; f.rows < 240; f.rows += f.rows / 4 + 1) {
        f.value = (uint32_t)f.rows;
        print(&f);
    }
    f.value = 240;
    f.rows = 240;
    print(&f);
}

int main(void)
{
    printf("core,axis,value,model,estimated\n");
    growth_frames(print);
    print_between();
    return EXIT_SUCCESS;
}
