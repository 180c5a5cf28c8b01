/* SPDX-License-Identifier: MIT */
/* Whole frames that the planner draws against what it plans against: normals that turn evenly along edges and along each row, and the
 * power itself, in double.
 *
 * Bars: coverage identical; no pixel of a demo scene off by more than one level of the format, which is what rounding to levels alone
 * may cost. RGB888: PSNR 55 dB, and no pixel that someone would tell from the exact one; RGB565, whose levels can be seen one by one,
 * has its count printed beside that of arcs. test_image has the planner on scenes made to break things.
 */
#include "seen.h"
#include "test.h"

#define BAR_DB 55.0

typedef struct judged {
    ref_score score;
    bool same_coverage;
    int seen;
} judged;

static judged judge(const scene *s, const ref_frame *exact, unsigned variant, enum lmb_format format)
{
    judged j;
    ref_drawn drawn;
    ref_draw_variant(&drawn, s, &ref_variants[variant], format);
    ref_judge(&j.score, exact, &drawn, NULL);
    j.same_coverage = !j.score.coverage_mismatch && !exact->clipped && drawn.shaded == exact->fragments && j.score.pixels > 0;
    j.seen = seen_pixels(&drawn, exact);
    ref_drawn_end(&drawn);
    return j;
}

static bool within_level(const judged *j, enum lmb_format format)
{
    if (!j->same_coverage || j->score.max_error > 1 || j->seen < 0) return false;
    return format == LMB_RGB565 || (j->score.psnr_db >= BAR_DB && j->seen == 0);
}

static const char *name_of(enum lmb_format format) { return format == LMB_RGB565 ? "rgb565" : "rgb888"; }

/* One demo scene in one format. */
static void test_planned(const scene *s, const ref_frame *exact, enum lmb_format format)
{
    const judged planned = judge(s, exact, REF_GLOSS_PLANNED, format), arc = judge(s, exact, REF_GLOSS_ARC, format);
    const ref_score *p = &planned.score;
    char name[64];
    snprintf(name, sizeof name, "exact_%s_%s", s->name, name_of(format));
    test_verdict(
        within_level(&planned, format), name,
        "planned: %llu pixels, largest error %d, %.4f %% within one level, %.2f dB, %d seen (arcs %.2f dB, %d); worst at "
        "(%d, %d): got %d %d %d, want %d %d %d, object %u triangle %u",
        (unsigned long long)p->pixels, p->max_error, 100 * p->share_within_1, p->psnr_db, planned.seen, arc.score.psnr_db,
        arc.seen, p->x, p->y, p->drawn[0], p->drawn[1], p->drawn[2], p->wanted[0], p->wanted[1], p->wanted[2],
        (unsigned)(p->triangle >> 24), (unsigned)(p->triangle & 0xffffffu));
}

static void test_demo_scenes(void)
{
    unsigned i;
    for (i = 0; i < scene_count(); i++) {
        ref_frame exact;
        scene s;
        scene_make(&s, i);
        ref_exact(&exact, &s, true);
        test_planned(&s, &exact, LMB_RGB565);
        test_planned(&s, &exact, LMB_RGB888);
        ref_frame_end(&exact);
    }
}

/* A judge that finds no fault in flat shading, in lines where quadratics are due, or in a lobe that is too wide, would find none in the
 * planner. */
static void test_judge_sees(void)
{
    static const unsigned fault[] = {REF_FLAT, REF_GOURAUD, REF_GLOSS_LINEAR, REF_GLOSS_W4};
    ref_frame exact;
    unsigned i, missed = 0;
    int seen = 0;
    scene s;
    scene_make(&s, 0);
    ref_exact(&exact, &s, true);
    for (i = 0; i < sizeof fault / sizeof fault[0]; i++) {
        const judged small = judge(&s, &exact, fault[i], LMB_RGB565), large = judge(&s, &exact, fault[i], LMB_RGB888);
        missed += within_level(&small, LMB_RGB565);
        missed += within_level(&large, LMB_RGB888);
        if (fault[i] != REF_GLOSS_W4) missed += large.seen == 0; /* a wide lobe has no edge that an eye could find */
        seen += large.seen;
    }
    ref_frame_end(&exact);
    test_verdict(missed == 0, "exact_judge_sees", "%u faulty frames in two formats, %u missed, %d pixels seen",
                 (unsigned)(sizeof fault / sizeof fault[0]), missed, seen);
}

int main(void)
{
    test_judge_sees();
    test_demo_scenes();
    return test_end();
}
