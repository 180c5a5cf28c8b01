/* SPDX-License-Identifier: MIT */
/* Writes image.csv to stdout: how far each demo scene, drawn by the library, is from each of the references.
 *
 * Errors are in levels of 255 for rgb888 and of the format for rgb565; psnr_db is 99 where nothing differs. Figures are over
 * pixels that both have painted; coverage_mismatch counts those that one of them has. exact is the reference that the
 * planner's choices are measured by; lobes of paper 000, which have errors of their own, are held against it alone. perceptual: of a
 * whole frame, the pixels that someone would tell from those of exact (oiio.h).
 */
#include "reference.h"
#include "seen.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What does not depend on the variant; [1] has a highlight. */
typedef struct truths {
    ref_frame exact[2], phong[2], surface[2];
    bool has_surface;
} truths;

static void row(const scene *s, const ref_variant *v, const ref_drawn *drawn, const char *reference, const ref_frame *frame)
{
    ref_score score;
    ref_judge(&score, frame, drawn, NULL);
    printf("%s,%s,%s,%s,%llu,%llu,%.2f,%d,%.6f,", s->name, v->name, drawn->format == LMB_RGB565 ? "rgb565" : "rgb888", reference,
           (unsigned long long)score.pixels, (unsigned long long)score.coverage_mismatch, score.psnr_db, score.max_error,
           score.share_within_1);
    if (!strcmp(reference, "exact")) {
        const int seen = seen_pixels(drawn, frame);
        if (seen < 0) exit(EXIT_FAILURE);
        printf("%d", seen);
    }
    printf("\n");
}

static void report(const scene *s, const ref_variant *v, const truths *t)
{
    static const enum lmb_format formats[] = {LMB_RGB565, LMB_RGB888};
    const int highlight = v->model != LMB_MODEL_DIFFUSE;
    ref_frame same;
    int i;
    if (v->lobe == LMB_LOBE_TUNED) ref_same_model(&same, s, v->model, ref_step_of(v, s));
    for (i = 0; i < 2; i++) {
        ref_drawn drawn;
        ref_draw_variant(&drawn, s, v, formats[i]);
        row(s, v, &drawn, "exact", &t->exact[highlight]);
        if (v->lobe == LMB_LOBE_TUNED) {
            row(s, v, &drawn, "same_model", &same);
            row(s, v, &drawn, "normalised_phong", &t->phong[highlight]);
            if (t->has_surface) row(s, v, &drawn, "true_surface", &t->surface[highlight]);
        }
        ref_drawn_end(&drawn);
    }
    if (v->lobe == LMB_LOBE_TUNED) ref_frame_end(&same);
}

int main(void)
{
    unsigned i, k;
    int highlight;
    printf("scene,model,format,reference,pixels,coverage_mismatch,psnr_db,max_error,share_within_1,perceptual\n");
    for (i = 0; i < scene_count(); i++) {
        truths t;
        scene s;
        scene_make(&s, i);
        for (highlight = 0; highlight < 2; highlight++) {
            ref_exact(&t.exact[highlight], &s, highlight);
            ref_normalised_phong(&t.phong[highlight], &s, highlight);
            t.has_surface = ref_true_surface(&t.surface[highlight], &s, highlight);
        }
        for (k = 0; k < REF_VARIANTS; k++) report(&s, &ref_variants[k], &t);
        for (highlight = 0; highlight < 2; highlight++) {
            ref_frame_end(&t.exact[highlight]);
            ref_frame_end(&t.phong[highlight]);
            if (t.has_surface) ref_frame_end(&t.surface[highlight]);
        }
    }
    return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
