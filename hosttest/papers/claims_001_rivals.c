/* SPDX-License-Identifier: MIT */
/* What paper 001 says of other ways, of its own quality, and of its speed. */
#include "claims_001.h"

#include "steps_kernels.h"
#include "steps_parts.h"

#include <stdio.h>

/* A definition made up here: records hold on to their text. */
static const char *kept(const char *text)
{
    static char room[128][128];
    static unsigned used;
    char *to = room[used < 127 ? used++ : used];
    snprintf(to, sizeof room[0], "%s", text);
    return to;
}

/* ------------------------------------------------------------------------------------------------------------------ quality */

static double f[PAPER_PIXELS_MAX + 4], g[PAPER_PIXELS_MAX + 4];

/* The largest |f^n - g^n| of two steps over 240 pixels, rays all round the plane of the normals and in it. */
static double difference_of(const char *a, const char *b, double degrees, double n)
{
    double worst = 0;
    unsigned i, t;
    for (i = 0; i < 48; i++) {
        const paper_span span = paper_span_flat(degrees * CLAIM_DEGREE, 240, 7.5 * i * CLAIM_DEGREE, 0);
        paper_step_named(a)->run(&span, f);
        paper_step_named(b)->run(&span, g);
        for (t = 0; t <= 240; t++) worst = fmax(worst, fabs(pow(fmax(f[t], 0), n) - pow(fmax(g[t], 0), n)));
    }
    return worst;
}

/* The largest angle up to which two steps differ by less than half a level of 255, to a tenth of a degree. */
static double alike_up_to(const char *a, const char *b, double n)
{
    double low = 0, high = 120;
    while (high - low > 0.1) {
        const double middle = (low + high) / 2;
        if (difference_of(a, b, middle, n) < CLAIM_HALF_LEVEL)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void quality(void)
{
    static const char *const alike = "same picture";
    claim_number(claim_001("quality-of-phong", false, "N.L by (2) less N.L normalised; 15 degrees"), CLAIM_AT_MOST,
                 CLAIM_HALF_LEVEL, 4, "", difference_of("slerp", "normalise", 15, 1));
    claim_number(claim_001("quality-of-phong", false, "the same; 45 degrees"), CLAIM_AT_MOST, CLAIM_HALF_LEVEL, 4, "",
                 difference_of("slerp", "normalise", 45, 1));
    claim_number(claim_001("quality-of-phong", false, "the same; 90 degrees"), CLAIM_AT_MOST, CLAIM_HALF_LEVEL, 4, "",
                 difference_of("slerp", "normalise", 90, 1));
    claim_fact(claim_001("quality-of-phong-angle", false, "N.L within half a level of 255"), alike, true, "up to %.1f degrees",
               alike_up_to("slerp", "normalise", 1));
    claim_fact(claim_001("quality-of-phong-angle", false, "(N.H)^16 within half a level"), alike, true, "up to %.1f degrees",
               alike_up_to("slerp", "normalise", 16));
    claim_fact(claim_001("quality-of-phong-angle", false, "(N.H)^100 within half a level"), alike, true, "up to %.1f degrees",
               alike_up_to("slerp", "normalise", 100));
}

static void gouraud(void)
{
    claim_fact(claim_001("gouraud-for-matt-surfaces", true, "15 degrees; N.L and (N.H)^100 against (2)"),
               "good for matt; poor for gloss",
               difference_of("linear", "slerp", 15, 1) < 0.01 && difference_of("linear", "slerp", 15, 100) > 0.1, "%.2g and %.2g",
               difference_of("linear", "slerp", 15, 1), difference_of("linear", "slerp", 15, 100));
    claim_fact(claim_001("flat-shows-its-edges", true, "15 degrees; step at an edge is twice this"), "sharp boundaries",
               difference_of("flat", "slerp", 15, 1) > CLAIM_HALF_LEVEL, "%.2g", difference_of("flat", "slerp", 15, 1));
}

/* ------------------------------------------------------------------------------------------------------------ other methods */

static paper_cost cost_of(const char *name, bool of_span)
{
    paper_cost pixel, span;
    paper_step_cost(paper_step_named(name), &pixel, &span);
    return of_span ? span : pixel;
}

static void kuijk_blake(void)
{
    const paper_cost line = cost_of("kuijk_blake", true), pixel = cost_of("kuijk_blake", false);
    claim_fact(claim_001("kuijk-blake-per-line", true, "counted"), "division and root and trigonometry",
               line.divisions > 0 && line.roots > 0 && line.sines > 0, "%g div %g root %g sines", line.divisions, line.roots,
               line.sines);
    claim_fact(claim_001("kuijk-blake-no-normalisation", true, "a pixel; counted"), "no division nor root",
               pixel.divisions + pixel.roots == 0, "%g; but %g cosine", pixel.divisions + pixel.roots, pixel.sines);
}

/* Taylor's series against the exact length. */
static void lyon(void)
{
    const paper_cost pixel = cost_of("lyon_taylor", false);
    const char *const rough = "not accurate enough";
    claim_fact(claim_001("lyon-no-division-nor-root", true, "a pixel; counted"), "none", pixel.divisions + pixel.roots == 0, "%g",
               pixel.divisions + pixel.roots);
    claim_fact(claim_001("lyon-three-terms-too-few", true, "N.L at 90 degrees; more than half a level of 255 off"), rough,
               difference_of("lyon_taylor", "normalise", 90, 1) > CLAIM_HALF_LEVEL, "%.2g",
               difference_of("lyon_taylor", "normalise", 90, 1));
    claim_fact(claim_001("lyon-three-terms-too-few", false, "N.L at 45 degrees"), rough,
               difference_of("lyon_taylor", "normalise", 45, 1) > CLAIM_HALF_LEVEL, "%.2g; good up to %.0f degrees",
               difference_of("lyon_taylor", "normalise", 45, 1), alike_up_to("lyon_taylor", "normalise", 1));
    claim_fact(claim_001("lyon-three-terms-too-few", false, "(N.H)^100 at 45 degrees"), rough,
               difference_of("lyon_taylor", "normalise", 45, 100) > CLAIM_HALF_LEVEL, "%.2g; good up to %.0f degrees",
               difference_of("lyon_taylor", "normalise", 45, 100), alike_up_to("lyon_taylor", "normalise", 100));
}

/* N.N of the next pixel: by products, or by its two differences. */
static paper_cost squares_by(bool differences)
{
    static const paper_cost nothing;
    const paper_vector n = {0.6, 0.5, 0.3};
    paper_count = nothing;
    if (differences)
        plus(plus(0.1, 0.2), 0.3);
    else
        dot(n, n);
    return paper_count;
}

static void forward_length(void)
{
    const paper_cost phong = cost_of("normalise", false), pixel = cost_of("forward_length", false);
    const paper_cost squares = squares_by(false), sums = squares_by(true);
    const double saved = squares.multiplications - sums.multiplications, added = squares.additions - sums.additions;
    claim_fact(claim_001("forward-differences-save", true, "N.N alone; counted"), "3 mul and 3 add", saved >= 3 && added >= 3,
               "%g mul and %g add", saved, added);
    claim_fact(claim_001("forward-differences-save", false, "N.N and N.L both by differences; counted"), "3 mul and 3 add",
               phong.multiplications - pixel.multiplications >= 3 && phong.additions - pixel.additions >= 3, "%g mul and %g add",
               phong.multiplications - pixel.multiplications, phong.additions - pixel.additions);
    claim_fact(claim_001("forward-differences-keep", true, "a pixel; counted"), "division and root",
               pixel.divisions > 0 && pixel.roots > 0, "%g div %g root", pixel.divisions, pixel.roots);
}

/* The worst of a reflection map of so many cells a side against Phong's normal, rays all round, 45 degrees. */
static double map_error(unsigned cells)
{
    double worst = 0;
    unsigned i, t;
    for (i = 0; i < 96; i++) {
        const kernel_span rounded = kernel_span_series(45 * CLAIM_DEGREE, 240, i);
        const paper_span span = kernel_span_exact(&rounded);
        paper_reflection_map(&span, f, cells);
        paper_step_named("normalise")->run(&span, g);
        for (t = 0; t <= 240; t++) worst = fmax(worst, fabs(f[t] - g[t]));
    }
    return worst;
}

/* What (14) errs in N.H where the viewer stands four lengths of the span before its middle, the light far off at 40 degrees, and
 * the normal turns by 30 degrees: H changes along the span, (14) holds that of the middle. */
static double viewer_near(void)
{
    const double light = 40 * CLAIM_DEGREE;
    double worst = 0, x;
    for (x = -0.5; x <= 0.5; x += 0.01) {
        const double half = (light - atan(x / 4)) / 2, normal = 30 * CLAIM_DEGREE * x;
        worst = fmax(worst, fabs(cos(normal - half) - cos(normal - light / 2)));
    }
    return worst;
}

/* Two maps of 16 bits and 257 lengths. */
static double map_bytes(unsigned cells) { return 2.0 * cells * cells * 2 + 2 * 257; }

static void giloi(void)
{
    static const unsigned cells[] = {16, 64, 256, 1024};
    unsigned i;
    for (i = 0; i < 4; i++) {
        char text[64];
        const double e = map_error(cells[i]);
        snprintf(text, sizeof text, "N.L of %u x %u cells; 45 degrees", cells[i], cells[i]);
        claim_fact(claim_001("giloi-coarse-and-large", i == 1, kept(text)), "worse than Phong; large tables",
                   e > CLAIM_HALF_LEVEL, "%.2g with %.0f bytes", e, map_bytes(cells[i]));
    }
    claim_fact(claim_001("giloi-wants-all-far-away", true, "so does (14): N.H; viewer four span lengths away"),
               "not so the new method", viewer_near() < CLAIM_HALF_LEVEL, "off by %.2g", viewer_near());
}

void claims_001_rivals(void)
{
    gouraud();
    quality();
    kuijk_blake();
    lyon();
    forward_length();
    giloi();
}

/* -------------------------------------------------------------------------------------------------------------------- speed */

/* Instructions of a span by a kernel, set-up and pixels. */
static double span_cost(const char *report, const char *core, const char *name, double pixels)
{
    char kernel[64];
    double set, each;
    snprintf(kernel, sizeof kernel, "step-%s-setup", name);
    set = claim_instructions(report, core, kernel);
    snprintf(kernel, sizeof kernel, "step-%s", name);
    each = claim_instructions(report, core, kernel);
    return pixels > 0 ? set + pixels * each : each;
}

/* Instructions before the first pixel, on Cortex-M0+. */
static double line_cost(const char *report, const char *name)
{
    return span_cost(report, "m0plus", name, 1) - span_cost(report, "m0plus", name, 0);
}

/* The shortest span on which a kernel is twice as fast as another; 0: none up to 4096. */
static unsigned twice_from(const char *report, const char *core, const char *ours, const char *theirs)
{
    unsigned pixels;
    for (pixels = 1; pixels <= 4096; pixels++)
        if (2 * span_cost(report, core, ours, pixels) <= span_cost(report, core, theirs, pixels)) return pixels;
    return 0;
}

/* What is compared: the paper's form, a rival, and whether the paper means those two. On the host instructions are not time, as a root
 * is one of them: make time. */
static const struct pair {
    const char *ours, *theirs;
    bool literal;
} pairs[] = {{"float_eq7_vector", "float_normalise_textbook", true},
             {"float_eq7_vector", "float_normalise", false},
             {"eq7_vector16", "normalise_textbook", true},
             {"eq7_vector32", "normalise_textbook", true},
             {"eq7_vector32", "normalise_multiply", false},
             {"plain16", "normalise_sqrt", false},
             {"plain32", "normalise_multiply", false},
             {"lambent", "normalise_multiply", false}};

static void faster(const char *report, const char *core, const struct pair *p)
{
    static const double length[] = {0, 32};
    static const char *const part[] = {"a pixel", "32 pixels and set-up"};
    unsigned i;
    for (i = 0; i < 2; i++) {
        char text[128];
        snprintf(text, sizeof text, "instructions %s; %s for %s; %s", core, p->ours, p->theirs, part[i]);
        claim_number(claim_001("over-twice-as-fast", p->literal && i == 0 && core[0] == 'm', kept(text)), CLAIM_AT_LEAST, 2, 1,
                     "x", span_cost(report, core, p->theirs, length[i]) / span_cost(report, core, p->ours, length[i]));
    }
}

static void faster_from(const char *report, const char *core, const struct pair *p)
{
    const unsigned pixels = twice_from(report, core, p->ours, p->theirs);
    char text[128];
    snprintf(text, sizeof text, "%s; %s for %s; set-up counted", core, p->ours, p->theirs);
    claim_fact(claim_001("over-twice-as-fast-from", false, kept(text)), "spans of one pixel", pixels == 1,
               pixels > 0 ? "%u pixels" : "no length up to 4096%.0u", pixels);
}

/* Whether the core was profiled: the host is one only where it can be. */
static bool measured(const char *report, const char *core) { return !isnan(claim_instructions(report, core, "step-lambent")); }

void claims_001_speed(const char *report)
{
    static const char *const core[] = {"m0plus", "host"};
    const unsigned cores = measured(report, core[1]) ? 2 : 1;
    unsigned i, k;
    for (i = 0; i < cores; i++)
        claim_number(claim_001("phong-dearer-than-gouraud", true,
                               i == 0 ? "m0plus; normalise_sqrt for linear; a pixel" : "host; the same"),
                     CLAIM_AT_LEAST, 2, 1, "x",
                     span_cost(report, core[i], "normalise_sqrt", 0) / span_cost(report, core[i], "linear", 0));
    claim_fact(claim_001("kuijk-blake-lines-limit-it", true, "m0plus; instructions to prepare a line of it and of (14)"),
               "limits its speed", line_cost(report, "kuijk_blake") > line_cost(report, "plain16"), "%.0f against %.0f",
               line_cost(report, "kuijk_blake"), line_cost(report, "plain16"));
    for (i = 0; i < cores; i++)
        for (k = 0; k < sizeof pairs / sizeof *pairs; k++) faster(report, core[i], &pairs[k]);
    for (i = 0; i < cores; i++)
        for (k = 0; k < sizeof pairs / sizeof *pairs; k++) faster_from(report, core[i], &pairs[k]);
}
