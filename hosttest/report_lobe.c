/* SPDX-License-Identifier: MIT */
/* Writes the accuracy of every lobe of hosttest/papers/lobes.h for every shininess as CSV, in real arithmetic and, where it has a
 * kernel of integers (hosttest/compare/), in integer arithmetic, against cos^n over the quarter turn.
 *
 * multiplications and additions are those of one evaluation from the argument that runs along a row; products of an exact power
 * are those of squaring and multiplying, in integers three of 16 bits each; powf, expf, divisions and reads are not counted.
 * at_degrees is where the largest error is; the mean square is taken evenly over the angle; monotone: never rises with the angle,
 * on a grid of 4096.
 */
#include "papers/lobe_errors.h"

#include <stdio.h>
#include <string.h>

static const compare_lobe_kernel *kernel_of(const paper_lobe *lobe)
{
    unsigned i;
    for (i = 0; i < compare_lobe_count; i++) {
        const compare_lobe_kernel *k = &compare_lobes[i];
        if (!k->is_float && !strcmp(k->name + strlen("lobe-"), lobe->name)) return k;
    }
    return NULL;
}

static void print_line(const lobe_subject *s, const double *truth)
{
    const lobe_errors f = lobe_measure(s, truth);
    const lobe_cost cost = paper_lobe_cost(s->lobe, s->n, s->kernel ? LOBE_INTEGER : LOBE_CARRIED);
    printf("%s,%u,%s,%d,%d,%.7f,%.4f,%.7f,%d\n", s->lobe->name, s->n, s->kernel ? "integer" : "real", cost.multiplications,
           cost.additions, f.most, f.angle * 90 / PAPER_QUARTER_TURN, f.rms, f.monotone);
}

int main(void)
{
    static double truth[LOBE_GRID + 1];
    static compare_lobe prepared;
    printf("lobe,n,arithmetic,multiplications,additions,max_abs_error,at_degrees,rms_error,monotone\n");
    for (unsigned n = 1; n <= LMB_SHININESS_MAX; n++) {
        if (compare_lobe_prepare(&prepared, n) != LMB_OK) return 1;
        lobe_truth(truth, n);
        for (unsigned k = 0; k < paper_lobe_count; k++) {
            lobe_subject s = {&paper_lobes[k], NULL, &prepared, n};
            print_line(&s, truth);
            s.kernel = kernel_of(s.lobe);
            if (s.kernel) print_line(&s, truth);
        }
    }
    return 0;
}
