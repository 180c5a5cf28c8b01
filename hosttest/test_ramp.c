/* SPDX-License-Identifier: MIT */
/* Ramps of RGB565 under one light: pixels that are added field by field, and what comes out against exact sums in doubles. */
#include "../port/run.h"
#include "guarded.h"

/* ---------------------------------------------------------------------------------------------------- the sum of two pixels */

static uint32_t field_sum(uint32_t a, uint32_t b, unsigned shift, uint32_t top)
{
    uint32_t sum = (a >> shift & top) + (b >> shift & top);
    return (sum > top ? top : sum) << shift;
}

static uint32_t saturated(uint32_t a, uint32_t b)
{
    return field_sum(a, b, 11, 31) | field_sum(a, b, 5, 63) | field_sum(a, b, 0, 31);
}

/* Whether some field runs over, whatever the others do. */
static int runs_over(uint32_t a, uint32_t b)
{
    return (a >> 11) + (b >> 11) > 31 || (a >> 5 & 63) + (b >> 5 & 63) > 63 || (a & 31) + (b & 31) > 31;
}

typedef struct sums {
    uint64_t pairs, wrong, misjudged;
} sums;

static void take_pair(sums *s, uint32_t a, uint32_t b)
{
    const uint32_t want = saturated(a, b), got = (uint16_t)add_565(a, b);
    if (got != want && s->wrong++ < 3) {
        printf("  %04x and %04x give %04x, want %04x\n", (unsigned)a, (unsigned)b, (unsigned)got, (unsigned)want);
    }
    s->misjudged += (carries_565(a, b) != 0) != runs_over(a, b);
    s->pairs++;
}

/* All pairs of two neighbouring fields, with the third in pairs that run over, just do, just do not, and are full; and pairs at
 * random. */
static void test_add(test_random *random)
{
    static const uint32_t five[6][2] = {{0, 0}, {31, 31}, {16, 15}, {16, 16}, {31, 1}, {0, 31}};
    sums s = {0, 0, 0};
    uint32_t i, k;
    for (i = 0; i < 1u << 22; i++) {
        for (k = 0; k < 6; k++) {
            take_pair(&s, (i & 0x7ff) | five[k][0] << 11, i >> 11 | five[k][1] << 11); /* green and blue */
            take_pair(&s, (i & 0x7ff) << 5 | five[k][0], i >> 11 << 5 | five[k][1]);   /* red and green */
        }
        take_pair(&s, (uint32_t)test_next(random) & 0xffff, (uint32_t)test_next(random) & 0xffff);
    }
    test_verdict(!s.wrong && !s.misjudged, "ramp: pixels are added field by field, each saturated",
                 "%" PRIu64 " of %" PRIu64 " pairs are wrong, carries of %" PRIu64 " misjudged", s.wrong, s.pairs, s.misjudged);
}

/* ----------------------------------------------------------------------------------------------------------------- materials */

static lmb_rgb any_colour(test_random *random, int kind)
{
    const int64_t bits = test_integer(random, 1, 7);
    if (kind == 0) return random_colour(random);
    if (kind == 1) return rgb(255, 255, 255);
    return rgb(bits & 1 ? 255 : 0, bits & 2 ? 255 : 0, bits & 4 ? 255 : 0);
}

static void random_paint(test_random *random, lmb_paint *paint, lmb_material *material, int kind)
{
    static const lmb_light lamp = {{0, 0, 16384}, {255, 255, 255}};
    lmb_look look;
    material->ambient = test_integer(random, 0, 1) ? rgb(0, 4, 8) : any_colour(random, kind);
    material->diffuse = any_colour(random, kind);
    material->specular = any_colour(random, kind);
    material->shininess = (uint16_t)exp(test_real(random, 0, log(LMB_SHININESS_MAX + 0.9)));
    if (lmb_look_prepare(&look, material, &lamp, 1, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC)) abort();
    lmb_paint_prepare(paint, &look, LMB_RGB565);
}

/* -------------------------------------------------------------------------------------------------------- against exact sums */

#define LENGTH 64

typedef struct levels {
    double worst, share, squares;    /* largest error in levels; of its bound */
    uint64_t values, equal, over[3]; /* levels equal to the exact ones rounded; pixels off by 1, 2, and more */
    lmb_material material;           /* of the worst */
    double n_l, n_h;
} levels;

/* What the model has for a channel, of one: colours as they are given. */
static double exact(uint8_t ambient, uint8_t diffuse, uint8_t specular, unsigned n, double n_l, double n_h)
{
    double sum = ambient + diffuse * fmin(1, fmax(0, n_l)) + specular * pow(fmin(1, fmax(0, n_h)), n);
    return fmin(1, sum / 255);
}

/* How far a level may be from the exact one: half a level for each of the two ramps; half a step of 1/64 of N.L and of 1/256 of
 * the argument, over which cos^n rises by n quiet / 512 at most; and, where there is no highlight to be seen, the tolerance.
 * Colours are kept to 2^-15. */
static double bound_of(const lmb_paint *paint, double argument, int top, double diffuse, double specular)
{
    const double quiet = ldexp(paint->look.light[0].quiet_q30, -30),
                 base = 0.5 + top * (diffuse / (2 * LMB_RAMP) + ldexp(3, -15));
    if (argument <= 0) return base + top * LMB_TOLERANCE_RGB565 / 65536.0;
    return base + 0.5 + top * specular * paint->look.lobe.shininess * quiet / (2 * LMB_GLEAM);
}

static void take_pixel(levels *e, const lmb_paint *paint, const lmb_material *m, const uint8_t *pixel, double n_l,
                       double argument)
{
    const uint8_t *ambient = &m->ambient.r, *diffuse = &m->diffuse.r, *specular = &m->specular.r;
    const double n_h = 1 - (1 - argument) * ldexp(paint->look.light[0].quiet_q30, -30);
    int got[3], i, off = 0;
    levels_at(pixel, LMB_RGB565, got);
    for (i = 0; i < 3; i++) {
        const int top = top_of(LMB_RGB565, i);
        const double want = top * exact(ambient[i], diffuse[i], specular[i], m->shininess, n_l, n_h), error = fabs(got[i] - want);
        const int distance = abs(got[i] - (int)floor(want + 0.5));
        off = distance > off ? distance : off;
        e->equal += distance == 0;
        e->squares += error * error;
        e->values++;
        e->share = fmax(e->share, error / bound_of(paint, argument, top, diffuse[i] / 255.0, specular[i] / 255.0));
        if (error <= e->worst) continue;
        e->worst = error;
        e->material = *m;
        e->n_l = n_l;
        e->n_h = n_h;
    }
    if (off > 0) e->over[off > 2 ? 2 : off - 1]++;
}

/* Spans over which N.L and the argument run as they please, beyond both ends of their ramps. */
static void random_span(test_random *random, lmb_span *span, bool highlight)
{
    const double one = 1073741824.0;
    double from = test_real(random, -0.1, 1.1), to = test_real(random, -0.1, 1.1);
    memset(span, 0, sizeof *span);
    span->length = LENGTH;
    span->kind = LMB_SPAN_PLANE;
    span->diffuse_on = 1;
    span->diffuse[0].f = (int32_t)lround(from * one);
    span->diffuse[0].d = (int32_t)lround((to - from) * one / LENGTH);
    if (!highlight) return;
    from = test_real(random, -0.2, 1.1);
    to = test_real(random, -0.2, 1.1);
    span->specular_on = 1;
    span->exponent[0] = (uint8_t)test_integer(random, 0, 4);
    span->specular[0].f = (int32_t)lround(ldexp(from * one, -span->exponent[0]));
    span->specular[0].d = (int32_t)lround(ldexp((to - from) * one, -span->exponent[0]) / LENGTH);
}

static void take_span(test_random *random, levels *e, const lmb_paint *paint, const lmb_material *material)
{
    uint16_t row[LENGTH];
    lmb_surface surface;
    lmb_span span;
    int i;
    lmb_surface_strip(&surface, LMB_RGB565, row, NULL, LENGTH, 0, 1);
    random_span(random, &span, paint->look.specular_on);
    lmb_fill_span(&surface, paint, &span);
    for (i = 0; i < LENGTH; i++) {
        const double argument = span.specular_on ? ldexp(span.specular[0].f, span.exponent[0] - 30) : 0;
        take_pixel(e, paint, material, (const uint8_t *)&row[i], ldexp(span.diffuse[0].f, -30), argument);
        lmb_plane_step(&span.diffuse[0]);
        lmb_plane_step(&span.specular[0]);
    }
}

/* Pixels that are two levels off are to be one in 10000 at most, whatever the material: of frames one in 1000 may be off by more
 * than one level, and ramps are not all that errs. */
#define TWO_OFF (1.0 / 10000)

static void test_levels(test_random *random, const char *name, int kind)
{
    static lmb_paint paint;
    levels e;
    int i, k;
    double pixels;
    memset(&e, 0, sizeof e);
    for (i = 0; i < 4000; i++) {
        lmb_material material;
        random_paint(random, &paint, &material, kind);
        for (k = 0; k < 20; k++) take_span(random, &e, &paint, &material);
    }
    pixels = (double)e.values / 3;
    test_verdict(e.share <= 1, "ramp: within what steps and rounding allow of the exact sum",
                 "%s: worst %.3f levels, %.3f of the bound; at n = %d, N.L = %.3f, N.H = %.4f", name, e.worst, e.share,
                 e.material.shininess, e.n_l, e.n_h);
    test_verdict(e.over[2] == 0 && (double)e.over[1] <= TWO_OFF * pixels, "ramp: within one level of the exact sum rounded",
                 "%s: of %.0f pixels %.4f %% are one off, %" PRIu64 " two, %" PRIu64 " more; channels equal %.2f %%, rms error "
                 "%.3f levels",
                 name, pixels, 100 * (double)e.over[0] / pixels, e.over[1], e.over[2], 100 * (double)e.equal / (double)e.values,
                 sqrt(e.squares / (double)e.values));
}

/* More light never makes a channel darker. */
static void test_order(test_random *random)
{
    static lmb_paint paint;
    int i, k, c, falls = 0;
    for (i = 0; i < 3000; i++) {
        lmb_material material;
        int low[3], high[3];
        random_paint(random, &paint, &material, i % 3);
        for (k = 1; k < LMB_RAMP_TOP; k++) {
            levels_at((const uint8_t *)&paint.ramp[k - 1], LMB_RGB565, low);
            levels_at((const uint8_t *)&paint.ramp[k], LMB_RGB565, high);
            for (c = 0; c < 3; c++) falls += high[c] < low[c];
        }
        for (k = 1; k < LMB_GLEAM_TOP; k++) {
            levels_at((const uint8_t *)&paint.ramp[LMB_RAMP_TOP + k - 1], LMB_RGB565, low);
            levels_at((const uint8_t *)&paint.ramp[LMB_RAMP_TOP + k], LMB_RGB565, high);
            for (c = 0; c < 3; c++) falls += high[c] < low[c];
        }
    }
    test_verdict(!falls, "ramp: more light is never darker", "%d steps fall in the ramps of %d materials", falls, i);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_add(&random);
    test_levels(&random, "any colours", 0);
    test_levels(&random, "white", 1);
    test_levels(&random, "saturated colours", 2);
    test_order(&random);
    return test_end();
}
