/* SPDX-License-Identifier: MIT */
/* Whole frames against the references, with OpenImageIO as a second judge.
 *
 *   test_image [SEED [FOLDER]] [--pictures FOLDER] [--verbose]
 *
 * A frame that fails leaves three pictures in FOLDER (build/failed unless given): ours, the reference, and 16 times the
 * difference about grey. --pictures writes those three for every frame; --verbose says of every frame that fails how.
 *
 * Bars (NUMERICS): against the same model in double, coverage identical; 99.9 % of pixels within one level, none off by more
 * than two; RGB888 PSNR 55 dB. Against the truth beyond the model no bar is given, since method and mesh have errors of their
 * own; what is asked there only excludes a wrong model, and says so where it stands.
 */
#include "oiio.h"
#include "reference.h"
#include "reference_scenes.h"
#include "test.h"

#include <string.h>

#define BAR_SHARE 0.999
#define BAR_MAX 2
#define BAR_DB 55.0
#define PICTURES_MAX 2 /* failures of a property that leave pictures */

static const char *failed_folder = "build/failed", *pictures_folder;
static bool verbose;

#define VARIANTS REF_GLOSS /* all but the scene's default, which is one of them */
enum { ALL = (1 << VARIANTS) - 1, GLOSS = 15 << 3 };

/* ------------------------------------------------------------------------------------------------------------------- pictures */

/* Writes NAME_ours.png, NAME_reference.png and NAME_difference.png; note names them. */
static void leave_pictures(const char *folder, const char *name, const ref_drawn *drawn, const uint8_t *levels, char note[400])
{
    static const char *const kind[] = {"ours", "reference", "difference"};
    size_t pixels = (size_t)drawn->width * (size_t)drawn->height;
    uint8_t *rgb = malloc(9 * pixels);
    int i;
    note[0] = 0;
    if (!rgb) return;
    ref_visible(rgb, drawn->levels, pixels, drawn->format);
    ref_visible(rgb + 3 * pixels, levels, pixels, drawn->format);
    oiio_amplify(rgb, rgb + 3 * pixels, drawn->width, drawn->height, 16, OIIO_OFFSET, rgb + 6 * pixels);
    for (i = 0; i < 3; i++) {
        char path[300];
        size_t used = strlen(note);
        snprintf(path, sizeof path, "%s/%s_%s.png", folder, name, kind[i]);
        if (oiio_write(path, rgb + (size_t)i * 3 * pixels, drawn->width, drawn->height)) strcpy(path, "(not written)");
        snprintf(note + used, 400 - used, " %s", path);
    }
    free(rgb);
}

/* ---------------------------------------------------------------------------------------------------------- against the model */

/* What all frames of one property come to. */
typedef struct tally {
    const char *name;
    bool pooled; /* frames of a few hundred pixels: the share is counted over all frames */
    bool large_faces;
    bool ok;
    unsigned frames, left;
    uint64_t pixels, within_1[2], ambiguous; /* [format] */
    int max_error[2];
    double share[2], psnr_db;
    char worst[64], failure[700];
} tally;

static void tally_begin(tally *t, const char *name, bool pooled)
{
    memset(t, 0, sizeof *t);
    t->name = name;
    t->pooled = pooled;
    t->ok = true;
    t->share[0] = t->share[1] = 1;
    t->psnr_db = 99;
}

/* A large face of one colour may be one level off as a whole, where the true value is next to a tie: 48 dB, and no fault. So flat
 * shading is not asked for the PSNR where faces are large; its largest error is one level then. */
static bool meets_bars(const ref_score *score, const ref_frame *frame, const ref_drawn *drawn, bool pooled, bool large_faces)
{
    if (score->coverage_mismatch || frame->clipped || drawn->shaded != frame->fragments || score->pixels == 0) return false;
    if (!pooled && score->share_within_1 < BAR_SHARE) return false;
    if (score->max_error > BAR_MAX) return false;
    if (drawn->format == LMB_RGB565) return true;
    return large_faces ? score->max_error <= 1 : score->psnr_db >= BAR_DB;
}

/* OpenImageIO's word on the same levels. Its figures are over the whole frame, where ours are over painted pixels. */
static bool oiio_agrees(const ref_score *score, const ref_drawn *drawn, const uint8_t *levels)
{
    oiio_difference d;
    double part = (double)drawn->width * drawn->height, psnr;
    if (oiio_compare(drawn->levels, levels, drawn->width, drawn->height, 1, &d)) return false;
    if (d.over != score->pixels - score->within_1 || fabs(d.max - score->max_error) > 0.01) return false;
    if (drawn->format == LMB_RGB565 || d.rms == 0) return true; /* RGB565: its channels differ in scale, which PSNR minds */
    psnr = fmin(99, d.psnr - 10 * log10(part / (double)score->pixels));
    return fabs(psnr - score->psnr_db) < 0.01;
}

static void describe_failure(tally *t, const char *label, const ref_score *score, const ref_frame *frame, const ref_drawn *drawn,
                             const uint8_t *levels)
{
    char note[400] = "", text[700];
    if (t->left < PICTURES_MAX) leave_pictures(failed_folder, label, drawn, levels, note);
    snprintf(text, sizeof text,
             "%s: coverage mismatch %llu, %llu fragments for %llu, %u clipped; share within 1 %.6f, max %d, %.2f dB; worst at "
             "(%d, %d): got %d %d %d, want %d %d %d, object %u triangle %u;%s",
             label, (unsigned long long)score->coverage_mismatch, (unsigned long long)drawn->shaded,
             (unsigned long long)frame->fragments, (unsigned)frame->clipped, score->share_within_1, score->max_error,
             score->psnr_db, score->x, score->y, score->drawn[0], score->drawn[1], score->drawn[2], score->wanted[0],
             score->wanted[1], score->wanted[2], (unsigned)(score->triangle >> 24), (unsigned)(score->triangle & 0xffffffu),
             note);
    if (verbose) fprintf(stderr, "%s\n", text);
    if (t->left++ == 0) memcpy(t->failure, text, sizeof text);
}

static void tally_frame(tally *t, const scene *s, const ref_variant *v, const ref_frame *frame, enum lmb_format format)
{
    uint8_t *levels = malloc((size_t)s->width * (size_t)s->height * 3);
    ref_drawn drawn;
    ref_score score;
    char label[128], note[400];
    int is888 = format == LMB_RGB888;
    ref_draw(&drawn, s, v->model, ref_step_of(v, s), format);
    ref_judge(&score, frame, &drawn, levels);
    snprintf(label, sizeof label, "%s_%s_%s", s->name, v->name, is888 ? "rgb888" : "rgb565");
    if (!meets_bars(&score, frame, &drawn, t->pooled, t->large_faces && v->model == LMB_MODEL_FLAT) ||
        !oiio_agrees(&score, &drawn, levels)) {
        t->ok = false;
        describe_failure(t, label, &score, frame, &drawn, levels);
    }
    if (pictures_folder) leave_pictures(pictures_folder, label, &drawn, levels, note);
    t->frames++;
    if (is888) t->pixels += score.pixels;
    t->within_1[is888] += score.within_1;
    t->ambiguous += score.ambiguous;
    if (score.max_error > t->max_error[is888]) t->max_error[is888] = score.max_error;
    t->share[is888] = fmin(t->share[is888], score.share_within_1);
    if (is888 && score.psnr_db < t->psnr_db) {
        t->psnr_db = score.psnr_db;
        snprintf(t->worst, sizeof t->worst, "%s %s", s->name, v->name);
    }
    ref_drawn_end(&drawn);
    free(levels);
}

/* Judges a scene by the variants whose bits are set, in both formats. */
static void tally_scene(tally *t, const scene *s, unsigned which)
{
    unsigned i;
    for (i = 0; i < VARIANTS; i++) {
        ref_frame frame;
        if (!(which >> i & 1u)) continue;
        ref_same_model(&frame, s, ref_variants[i].model, ref_step_of(&ref_variants[i], s));
        tally_frame(t, s, &ref_variants[i], &frame, LMB_RGB565);
        tally_frame(t, s, &ref_variants[i], &frame, LMB_RGB888);
        ref_frame_end(&frame);
    }
}

static void tally_end(tally *t)
{
    int i;
    for (i = 0; i < 2 && t->pooled; i++) {
        t->share[i] = (double)t->within_1[i] / (double)t->pixels;
        if (t->share[i] < BAR_SHARE) t->ok = false;
    }
    if (t->ok) {
        test_verdict(1, t->name,
                     "%u frames, %llu pixels, coverage identical; rgb888 within 1 %.5f%s, max %d, %.2f dB (%s); rgb565 within 1 "
                     "%.5f, max %d; %llu of equal depth",
                     t->frames, (unsigned long long)t->pixels, t->share[1], t->pooled ? " (pooled)" : "", t->max_error[1],
                     t->psnr_db, t->worst, t->share[0], t->max_error[0], (unsigned long long)t->ambiguous);
    } else {
        test_verdict(0, t->name, "%u of %u frames; share rgb888 %.5f rgb565 %.5f, max %d and %d; first %s", t->left, t->frames,
                     t->share[1], t->share[0], t->max_error[1], t->max_error[0], t->failure);
    }
}

static void test_same_model(void)
{
    unsigned i;
    for (i = 0; i < scene_count(); i++) {
        char name[64];
        tally t;
        scene s;
        scene_make(&s, i);
        snprintf(name, sizeof name, "image_model_%s", s.name);
        tally_begin(&t, name, false);
        tally_scene(&t, &s, ALL);
        tally_end(&t);
    }
}

/* ---------------------------------------------------------------------------------------------------------- against the truth */

/* Wrong models end below this: flat shading of the demo scenes has 25 to 36 dB, a highlight in the wrong place less than flat.
 * All per-pixel gloss of these meshes has 43 dB and more. */
#define TRUTH_DB 40.0
/* The outline of a mesh of 320 triangles is short of its sphere's by 1.8 % of the area. */
#define OUTLINE_SHARE 0.025

static ref_score truth_of(const scene *s, const ref_variant *v, const ref_frame *frame)
{
    ref_score score;
    ref_drawn drawn;
    ref_draw(&drawn, s, v->model, ref_step_of(v, s), LMB_RGB888);
    ref_judge(&score, frame, &drawn, NULL);
    ref_drawn_end(&drawn);
    return score;
}

/* Flat, Gouraud, per-pixel gloss: each nearer to Phong than the one before; and gloss near enough to be that model. */
static void test_truth(void)
{
    unsigned i, k;
    for (i = 0; i < scene_count(); i++) {
        char name[64], surface_figures[96] = "no surface but the mesh";
        ref_frame phong, surface;
        ref_score score[VARIANTS], true_score;
        scene s;
        bool ok;
        scene_make(&s, i);
        snprintf(name, sizeof name, "image_truth_%s", s.name);
        ref_normalised_phong(&phong, &s, true);
        for (k = 0; k < VARIANTS; k++) score[k] = truth_of(&s, &ref_variants[k], &phong);
        ref_frame_end(&phong);
        ok = score[0].psnr_db < score[1].psnr_db && score[1].psnr_db < score[4].psnr_db && score[4].psnr_db >= TRUTH_DB &&
             score[5].psnr_db >= TRUTH_DB;
        ok = ok && (double)score[4].coverage_mismatch <= OUTLINE_SHARE * (double)score[4].pixels;
        if (ref_true_surface(&surface, &s, true)) {
            true_score = truth_of(&s, &ref_variants[REF_GLOSS_QUADRATIC], &surface);
            ref_frame_end(&surface);
            ok = ok && true_score.psnr_db >= TRUTH_DB;
            ok = ok && (double)true_score.coverage_mismatch <= OUTLINE_SHARE * (double)true_score.pixels;
            snprintf(surface_figures, sizeof surface_figures, "true surface %.2f dB, %.5f within 1, outline %llu",
                     true_score.psnr_db, true_score.share_within_1, (unsigned long long)true_score.coverage_mismatch);
        }
        test_verdict(ok, name,
                     "Phong: flat %.2f, gouraud %.2f, linear %.2f, quadratic %.2f, arc %.2f dB, %.5f within 1, outline %llu; %s",
                     score[0].psnr_db, score[1].psnr_db, score[3].psnr_db, score[4].psnr_db, score[5].psnr_db,
                     score[4].share_within_1, (unsigned long long)score[4].coverage_mismatch, surface_figures);
    }
}

/* ---------------------------------------------------------------------------------------------------------------- hard scenes */

static void test_set(const hard_set *set)
{
    tally t;
    unsigned i;
    tally_begin(&t, set->name, set->small);
    t.large_faces = set->large_faces;
    for (i = 0; i < set->scenes; i++) {
        char label[HARD_LABEL];
        scene s;
        set->make(&s, i, label);
        tally_scene(&t, &s, set->gloss_only ? GLOSS : ALL);
    }
    tally_end(&t);
}

/* Anything: mesh, pose, camera, light, material, shininess. */
static void test_random_scenes(test_random *random)
{
    tally t;
    int i;
    tally_begin(&t, "image_random", false);
    t.large_faces = true;
    for (i = 0; i < 16; i++) {
        scene s, demo;
        char label[HARD_LABEL];
        lmb_material *material;
        scene_make(&demo, (unsigned)(2 * test_integer(random, 0, 3)));
        snprintf(label, sizeof label, "random-%d", i);
        hard_scene(&s, label, 150, 70, i & 1 ? demo.object[0].mesh : hard_mesh((enum hard_mesh)test_integer(random, 1, 3)),
                   lmb_rotation((uint16_t)test_next(random), (uint16_t)test_next(random), (uint16_t)test_next(random)));
        if (i & 2) hard_scene_near(&s, 70, test_real(random, 1.8, 6));
        s.object[0].pose.x = (int32_t)test_integer(random, -20000, 20000);
        s.object[0].pose.y = (int32_t)test_integer(random, -20000, 20000);
        material = &s.object[0].material;
        material->shininess = (uint16_t)test_integer(random, 1, 400);
        material->diffuse.r = (uint8_t)test_next(random);
        material->specular.g = (uint8_t)test_next(random);
        hard_light(&s, 0, test_real(random, -1, 1), test_real(random, -1, 1), test_real(random, -0.3, 1), s.light[0].colour);
        if (i & 4) {
            hard_light(&s, 1, test_real(random, -1, 1), test_real(random, -1, 1), test_real(random, 0, 1), material->diffuse);
        }
        tally_scene(&t, &s, ALL);
    }
    tally_end(&t);
}

/* ------------------------------------------------------------------------------------------------------------------- cut ones */

/* Seen from so near that the near plane, and LMB_SCREEN_MAX, cut triangles. Corners of the cut are the library's own there, so
 * the judge is Phong. Interpolating on the screen instead of in space costs most here. */
#define NEAR_DB 30.0
#define NEAR_OUTLINE 0.005
static void test_clipped(void)
{
    static const double distance[] = {1.6, 1.22, 1.19, 0.6, 0.3};
    double worst = 99, outline = 0;
    uint64_t pixels = 0;
    uint32_t cut = 0;
    int i;
    for (i = 0; i < 5; i++) {
        scene s, demo;
        ref_frame phong, same;
        ref_score score;
        char label[HARD_LABEL];
        scene_make(&demo, i > 2 ? 4 : 2);
        snprintf(label, sizeof label, "near-%g", distance[i]);
        hard_scene(&s, label, 200, 100, demo.object[0].mesh, lmb_rotation(hard_turn(i > 2 ? 75 : 20), hard_turn(11), 0));
        hard_scene_near(&s, i == 1 || i == 2 ? 45 : 150, distance[i]); /* the second and third look at a ring */
        ref_normalised_phong(&phong, &s, true);
        score = truth_of(&s, &ref_variants[REF_GLOSS_QUADRATIC], &phong);
        ref_same_model(&same, &s, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC);
        cut += same.clipped;
        pixels += score.pixels;
        worst = fmin(worst, score.psnr_db);
        outline = fmax(outline, (double)score.coverage_mismatch / fmax(1, (double)score.pixels));
        if (pictures_folder) {
            uint8_t *levels = malloc(200 * 200 * 3);
            char note[400];
            ref_drawn drawn;
            ref_draw(&drawn, &s, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, LMB_RGB888);
            ref_judge(&score, &phong, &drawn, levels);
            leave_pictures(pictures_folder, label, &drawn, levels, note);
            ref_drawn_end(&drawn);
            free(levels);
        }
        ref_frame_end(&phong);
        ref_frame_end(&same);
    }
    test_verdict(worst >= NEAR_DB && outline <= NEAR_OUTLINE && cut > 0, "image_clipped",
                 "5 frames, %llu pixels, %u triangles cut; worst %.2f dB against Phong, outline off on %.5f of pixels",
                 (unsigned long long)pixels, (unsigned)cut, worst, outline);
}

/* --------------------------------------------------------------------------------------------------------- the judge on trial */

static void one_degree(scene *s) { s->light[0].direction.x = (int16_t)(s->light[0].direction.x + 286); }
static void one_ambient(scene *s) { s->object[0].material.ambient.g = (uint8_t)(s->object[0].material.ambient.g + 2); }
static void shinier(scene *s) { s->object[0].material.shininess = (uint16_t)(s->object[0].material.shininess + 4); }
static void shifted(scene *s) { s->object[0].pose.x += 65536 / 110 / 8; }
static void turned(scene *s) { s->object[0].pose.rotation = lmb_rotation(hard_turn(17.5), hard_turn(31), 0); }

/* Small faults in what the library draws must fail the bars; none must not. */
static void test_judge_sees(void)
{
    static const struct {
        const char *name;
        void (*change)(scene *);
    } fault[] = {{"light by a degree", one_degree},
                 {"ambient by two levels", one_ambient},
                 {"shininess 100 as 104", shinier},
                 {"shift by an eighth of a pixel", shifted},
                 {"pose by half a degree", turned}};
    unsigned i, missed = 0, false_alarms;
    ref_frame frame;
    ref_drawn drawn;
    ref_score score;
    scene s;
    scene_make(&s, 1);
    ref_same_model(&frame, &s, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC);
    ref_draw(&drawn, &s, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, LMB_RGB888);
    ref_judge(&score, &frame, &drawn, NULL);
    false_alarms = !meets_bars(&score, &frame, &drawn, false, false);
    drawn.levels[3 * (120 * 240 + 120) + 1] ^= 4; /* one pixel off by four */
    drawn.painted[0] = true;                      /* and one too many */
    ref_judge(&score, &frame, &drawn, NULL);
    missed += score.coverage_mismatch != 1 || score.max_error < 3 || score.x != 120 || score.y != 120;
    ref_drawn_end(&drawn);
    for (i = 0; i < sizeof fault / sizeof fault[0]; i++) {
        scene wrong = s;
        fault[i].change(&wrong);
        ref_draw(&drawn, &wrong, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, LMB_RGB888);
        ref_judge(&score, &frame, &drawn, NULL);
        missed += meets_bars(&score, &frame, &drawn, false, false);
        ref_drawn_end(&drawn);
    }
    ref_draw(&drawn, &s, LMB_MODEL_GLOSS, LMB_STEP_LINEAR, LMB_RGB888);
    ref_judge(&score, &frame, &drawn, NULL);
    missed += meets_bars(&score, &frame, &drawn, false, false);
    ref_drawn_end(&drawn);
    ref_frame_end(&frame);
    test_verdict(!missed && !false_alarms, "image_judge_sees", "%u faults, %u missed; %u false alarms",
                 (unsigned)(sizeof fault / sizeof fault[0]) + 2, missed, false_alarms);
}

/* Pictures survive the file, and OpenImageIO finds in them what was put there. */
static void test_oiio(void)
{
    enum { WIDTH = 31, HEIGHT = 17, BYTES = WIDTH * HEIGHT * 3 };
    static uint8_t a[BYTES], b[BYTES], shown[BYTES];
    char path[300];
    uint8_t *back;
    oiio_difference d;
    int i, width = 0, height = 0, ok;
    for (i = 0; i < BYTES; i++) a[i] = b[i] = (uint8_t)(i * 37 + i / 93);
    a[300] = 100, b[300] = 105;
    a[301] = 50, b[301] = 48;
    a[600] = 200, b[600] = 199;
    ok = !oiio_compare(a, b, WIDTH, HEIGHT, 1, &d) && fabs(d.max - 5) < 0.001 && d.over == 1;
    ok = ok && fabs(d.rms - sqrt(30.0 / BYTES)) < 1e-4 && fabs(d.mean - 8.0 / BYTES) < 1e-4;
    ok = ok && !oiio_amplify(a, b, WIDTH, HEIGHT, 16, OIIO_OFFSET, shown) && shown[300] == 48 && shown[301] == 160;
    ok = ok && shown[600] == 144 && shown[0] == 128;
    ok = ok && !oiio_amplify(a, b, WIDTH, HEIGHT, 16, OIIO_ABSOLUTE, shown);
    ok = ok && shown[300] == 80 && shown[301] == 32 && shown[0] == 0;
    snprintf(path, sizeof path, "%s/roundtrip.png", failed_folder);
    ok = ok && !oiio_write(path, a, WIDTH, HEIGHT);
    back = ok ? oiio_read(path, &width, &height) : NULL;
    ok = ok && back && width == WIDTH && height == HEIGHT && !memcmp(a, back, BYTES);
    free(back);
    remove(path);
    test_verdict(ok, "image_oiio", "PNG comes back byte for byte; max %.3f, rms %.4f, %llu pixel over one level", d.max, d.rms,
                 (unsigned long long)d.over);
}

/* ----------------------------------------------------------------------------------------------------------------------- main */

/* Takes the options out of the arguments. */
static int take_options(int argc, char **argv)
{
    int i, kept = 1;
    for (i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--pictures") && i + 1 < argc) {
            pictures_folder = argv[++i];
        } else if (!strcmp(argv[i], "--verbose")) {
            verbose = true;
        } else {
            argv[kept++] = argv[i];
        }
    }
    return kept;
}

int main(int argc, char **argv)
{
    test_random random;
    unsigned i;
    argc = take_options(argc, argv);
    random = test_seed(argc, argv);
    if (argc > 2) failed_folder = argv[2];
    test_oiio();
    test_judge_sees();
    test_same_model();
    test_truth();
    test_clipped();
    for (i = 0; i < hard_set_count; i++) test_set(&hard_sets[i]);
    test_random_scenes(&random);
    hard_meshes_end();
    return test_end();
}
