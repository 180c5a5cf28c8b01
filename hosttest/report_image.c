/* SPDX-License-Identifier: MIT */
/* Writes image.csv to stdout: how far each demo scene, drawn by the library, is from each of the three references.
 *
 * Errors are in levels of 255 for rgb888 and of the format for rgb565; psnr_db is 99 where nothing differs. Figures are over
 * pixels that both have painted; coverage_mismatch counts those that one of them has.
 */
#include "reference.h"

#include <stdio.h>
#include <stdlib.h>

/* What does not depend on the variant; [1] has a highlight. */
typedef struct truths {
    ref_frame phong[2], surface[2];
    bool has_surface;
} truths;

static void row(const scene *s, const ref_variant *v, const ref_drawn *drawn, const char *reference, const ref_frame *frame)
{
    ref_score score;
    ref_judge(&score, frame, drawn, NULL);
    printf("%s,%s,%s,%s,%llu,%llu,%.2f,%d,%.6f\n", s->name, v->name, drawn->format == LMB_RGB565 ? "rgb565" : "rgb888", reference,
           (unsigned long long)score.pixels, (unsigned long long)score.coverage_mismatch, score.psnr_db, score.max_error,
           score.share_within_1);
}

static void report(const scene *s, const ref_variant *v, const truths *t)
{
    static const enum lmb_format formats[] = {LMB_RGB565, LMB_RGB888};
    const enum lmb_step_kind step = ref_step_of(v, s);
    const int highlight = v->model != LMB_MODEL_DIFFUSE;
    ref_frame same;
    int i;
    ref_same_model(&same, s, v->model, step);
    for (i = 0; i < 2; i++) {
        ref_drawn drawn;
        ref_draw(&drawn, s, v->model, step, formats[i]);
        row(s, v, &drawn, "same_model", &same);
        row(s, v, &drawn, "normalised_phong", &t->phong[highlight]);
        if (t->has_surface) row(s, v, &drawn, "true_surface", &t->surface[highlight]);
        ref_drawn_end(&drawn);
    }
    ref_frame_end(&same);
}

int main(void)
{
    unsigned i, k;
    int highlight;
    printf("scene,model,format,reference,pixels,coverage_mismatch,psnr_db,max_error,share_within_1\n");
    for (i = 0; i < scene_count(); i++) {
        truths t;
        scene s;
        scene_make(&s, i);
        for (highlight = 0; highlight < 2; highlight++) {
            ref_normalised_phong(&t.phong[highlight], &s, highlight);
            t.has_surface = ref_true_surface(&t.surface[highlight], &s, highlight);
        }
        for (k = 0; k < REF_VARIANTS; k++) report(&s, &ref_variants[k], &t);
        for (highlight = 0; highlight < 2; highlight++) {
            ref_frame_end(&t.phong[highlight]);
            if (t.has_surface) ref_frame_end(&t.surface[highlight]);
        }
    }
    return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
