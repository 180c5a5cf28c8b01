/* SPDX-License-Identifier: MIT */
/* Looks: what is taken and refused, material times light for every pair of colours, half vectors against doubles; highlights that
 * do not show, and their ramps. */
#include "../firmware/lambent.h"
#include "test.h"

/* The last light has the direction given, the others look along the axis. */
static void test_look_errors(void)
{
    static const struct {
        unsigned lights, model, step;
        uint16_t shininess;
        lmb_vec last;
        int want;
    } cases[] = {
        {1, 3, 0, 1, {0, 0, 16384}, LMB_OK},           {LMB_LIGHTS, 3, 1, LMB_SHININESS_MAX, {0, 0, 16384}, LMB_OK},
        {2, 3, 2, 1, {0, 0, -16384}, LMB_OK}, /* from behind: the half vector vanishes */
        {1, 3, 2, 1, {0, 17100, 0}, LMB_OK},           {1, 3, 2, 1, {-15660, 0, 0}, LMB_OK},
        {0, 3, 0, 1, {0, 0, 16384}, LMB_ERROR_LIGHTS}, {LMB_LIGHTS + 1, 3, 0, 1, {0, 0, 16384}, LMB_ERROR_LIGHTS},
        {1, 4, 0, 1, {0, 0, 16384}, LMB_ERROR_VALUE},  {1, 3, 4, 1, {0, 0, 16384}, LMB_ERROR_VALUE},
        {1, 3, 0, 0, {0, 0, 16384}, LMB_ERROR_VALUE},  {1, 3, 0, LMB_SHININESS_MAX + 1, {0, 0, 16384}, LMB_ERROR_VALUE},
        {2, 3, 0, 1, {0, 0, 0}, LMB_ERROR_VALUE},      {2, 3, 0, 1, {0, 17300, 0}, LMB_ERROR_VALUE},
        {4, 3, 0, 1, {0, 0, -15460}, LMB_ERROR_VALUE}, {3, 3, 0, 1, {32767, 32767, 32767}, LMB_ERROR_VALUE},
    };
    static const lmb_vec axis = {0, 0, 16384};
    static const lmb_rgb white = {255, 255, 255};
    lmb_material material = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, 1};
    lmb_light light[LMB_LIGHTS + 1];
    lmb_look look;
    unsigned i, k, n = sizeof cases / sizeof *cases;
    int faults = 0, got;
    for (i = 0; i < n; i++) {
        for (k = 0; k <= LMB_LIGHTS; k++) {
            light[k].direction = k + 1 == cases[i].lights ? cases[i].last : axis;
            light[k].colour = white;
        }
        material.shininess = cases[i].shininess;
        got = lmb_look_prepare(&look, &material, light, cases[i].lights, (enum lmb_model)cases[i].model,
                               (enum lmb_step_kind)cases[i].step);
        if (got != cases[i].want) printf("  case %u gives %d, not %d\n", i, got, cases[i].want), faults++;
    }
    test_verdict(!faults, "look: good arguments are taken, bad ones refused", "%d faults in %u cases", faults, n);
}

/* Material times light as UQ1.15, rounded to nearest, for all 65536 pairs; ambient alone for all 256. */
static void test_products(void)
{
    int a, b, faults = 0;
    for (a = 0; a < 256; a++) {
        for (b = 0; b < 256; b++) {
            const lmb_rgb m = {(uint8_t)a, (uint8_t)b, 255};
            const lmb_material material = {m, m, m, 10};
            const lmb_light light = {{0, 0, 16384}, {(uint8_t)b, (uint8_t)a, (uint8_t)a}};
            const long want = lround(a * b * 32768.0 / 65025);
            lmb_look look;
            if (lmb_look_prepare(&look, &material, &light, 1, LMB_MODEL_GLOSS, LMB_STEP_LINEAR)) abort();
            faults += look.light[0].diffuse_q15[0] != want || look.light[0].diffuse_q15[1] != want;
            faults += look.light[0].specular_q15[0] != want || look.light[0].specular_q15[1] != want;
            faults +=
                look.light[0].diffuse_q15[2] != lround(a * 32768.0 / 255) || look.ambient_q15[0] != lround(a * 32768.0 / 255);
        }
    }
    test_verdict(!faults, "look: material times light", "%d of 65536 pairs of colours are not rounded to nearest", faults);
}

/* Half vectors halve the angle between light and viewer; rays turned into a mesh's space keep their angle to its normals. */
static void test_half_vectors(test_random *random)
{
    double worst = 0, worst_turned = 0;
    int i;
    for (i = 0; i < 200000; i++) {
        const lmb_material material = {{1, 1, 1}, {9, 9, 9}, {9, 9, 9}, 10};
        double x = test_real(random, -1, 1), y = test_real(random, -1, 1), z = test_real(random, -0.9, 1),
               r = sqrt(x * x + y * y + z * z);
        lmb_light light = {{(int16_t)lround(x / r * 16384), (int16_t)lround(y / r * 16384), (int16_t)lround(z / r * 16384)},
                           {9, 9, 9}};
        const lmb_matrix m = lmb_rotation((uint16_t)test_next(random), (uint16_t)test_next(random), (uint16_t)test_next(random));
        const lmb_vec *l, *h;
        lmb_look look;
        lmb_rays rays;
        if (r < 0.1 || lmb_look_prepare(&look, &material, &light, 1, LMB_MODEL_GLOSS, LMB_STEP_LINEAR)) continue;
        l = &look.light[0].direction;
        h = &look.light[0].half;
        r = sqrt((double)l->x * l->x + (double)l->y * l->y + (l->z + 16384.0) * (l->z + 16384.0)) / 16384;
        worst = fmax(worst, fmax(fabs(h->x - l->x / r), fmax(fabs(h->y - l->y / r), fabs(h->z - (l->z + 16384) / r))));
        lmb_rays_prepare(&rays, &look, &m);
        l = &rays.light[0].half; /* the transpose of m times half */
        x = ((double)m.row[0].x * h->x + (double)m.row[1].x * h->y + (double)m.row[2].x * h->z) / 16384;
        y = ((double)m.row[0].y * h->x + (double)m.row[1].y * h->y + (double)m.row[2].y * h->z) / 16384;
        z = ((double)m.row[0].z * h->x + (double)m.row[1].z * h->y + (double)m.row[2].z * h->z) / 16384;
        worst_turned = fmax(worst_turned, fmax(fabs(l->x - x), fmax(fabs(l->y - y), fabs(l->z - z))));
    }
    test_verdict(worst <= LMB_NORMALISE_MAX_ERROR * 16384, "look: half vectors", "off by %.4f / 16384 at most", worst);
    test_verdict(worst_turned <= 0.5001, "look: rays in a mesh's space", "off by %.4f / 16384 at most", worst_turned);
}

/* ------------------------------------------------------------------------------------------ highlights that do not show */

static lmb_rgb random_colour(test_random *random)
{
    const int64_t faint = test_integer(random, 0, 3);
    lmb_rgb c = {(uint8_t)(test_integer(random, 0, 255) >> faint), (uint8_t)(test_integer(random, 0, 255) >> 2 * faint),
                 (uint8_t)(test_integer(random, 0, 255) >> 3 * faint)};
    return c;
}

static void random_look(test_random *random, lmb_look *look, enum lmb_lobe_kind kind)
{
    lmb_material material;
    lmb_light light[LMB_LIGHTS];
    unsigned i, n = (unsigned)test_integer(random, 1, LMB_LIGHTS);
    material.ambient = material.diffuse = random_colour(random);
    material.specular = random_colour(random);
    material.shininess = (uint16_t)exp(test_real(random, 0, log(LMB_SHININESS_MAX + 0.9)));
    for (i = 0; i < n; i++) {
        const lmb_vec forward = {0, 0, 16384};
        light[i].direction = forward;
        light[i].colour = random_colour(random);
    }
    if (lmb_look_prepare(look, &material, light, n, LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC)) abort();
    if (lmb_look_lobe(look, kind, (uint16_t)test_integer(random, 0, 500))) abort();
}

/* A light's brightest specular channel, of one. */
static double strength_of(const struct lmb_look_light *light)
{
    return fmax(fmax(light->specular_q15[0], light->specular_q15[1]), light->specular_q15[2]) / 32768;
}

/* The argument of the highlight at v = 1 - N.H as planes have it, in doubles. */
static double argument_at(const struct lmb_look_light *light, double v)
{
    return ldexp(light->line.top_q30, -30) - ldexp(light->line.slope, light->line.shift - 15) * v;
}

static double lobe_at(const lmb_look *look, double v)
{
    return lmb_lobe_eval(&look->lobe, (int32_t)fmin(ldexp(v, 30), 2147483647.0)) / 32768.0;
}

/* What a place v of a light's highlight comes to: how much beyond the tolerance it is where it is left out, how much short of it
 * where it is not. */
typedef struct shows {
    double beyond, short_of;
} shows;

static void take_place(shows *e, const lmb_look *look, unsigned i, double v, double tolerance)
{
    const double brightness = strength_of(&look->light[i]) * lobe_at(look, v);
    if (v < 0 || v > 2 - ldexp(1, -17)) return; /* W_m of a small n is still bright at the far end, and is left out there alone */
    if (look->specular_on >> i & 1 && argument_at(&look->light[i], v) > 0) {
        e->short_of = fmax(e->short_of, tolerance - brightness);
    } else {
        e->beyond = fmax(e->beyond, brightness - tolerance);
    }
}

/* The lobe is stepped in 2^-15 and so is what the material makes of it; s is stepped in 2^-16, of which m squarings make up to
 * 2^m times as much; and the last place that shows is known to 2^-18 of v, over which cos^n falls by less than n 2^-18. */
static double doubt(const lmb_look *look)
{
    return ldexp(2, -15) + ldexp(1, look->lobe.multiplications - 16) + ldexp(look->lobe.shininess, -18);
}

/* Whatever the lobe, what is left out is fainter than the tolerance, and what is not left out is not; dark is s there. */
static void test_tolerance(test_random *random)
{
    shows e = {0, 0};
    double share = 0;
    int i, faults = 0, none = 0, lights = 0;
    for (i = 0; i < 20000; i++) {
        const uint16_t tolerance = (uint16_t)(i % 4 ? test_integer(random, 0, 65535) >> test_integer(random, 0, 16) : 0);
        lmb_look look;
        unsigned k;
        int p;
        random_look(random, &look, (enum lmb_lobe_kind)(i % 5));
        if (i & 1) lmb_look_ramp(&look); /* undone */
        lmb_look_tolerance(&look, tolerance);
        for (k = 0; k < look.lights; k++, lights++) {
            const struct lmb_look_light *light = &look.light[k];
            const double quiet = ldexp(light->quiet_q30, -30);
            shows here = {0, 0};
            faults += light->dark_q16 != lmb_lobe_argument(&look.lobe, light->quiet_q30);
            faults += (look.specular_on >> k & 1) != (light->quiet_q30 > 0);
            faults += fabs(argument_at(light, 0) - (look.lobe.alpha_q30 - light->dark_q16 * 16384.0) / 1073741824.0) > 0;
            none += light->quiet_q30 == 0;
            for (p = -20; p <= 20; p++) take_place(&here, &look, k, quiet + ldexp(p, -19), tolerance / 65536.0);
            for (p = 0; p <= 40; p++) take_place(&here, &look, k, p / 20.0, tolerance / 65536.0);
            share = fmax(share, fmax(here.beyond, here.short_of) / doubt(&look));
            e.beyond = fmax(e.beyond, here.beyond);
            e.short_of = fmax(e.short_of, here.short_of);
        }
    }
    test_verdict(!faults && share <= 1 && none > 0, "look: highlights fainter than the tolerance are left out, and no others",
                 "%d faults of %d lights, %d without a highlight; left out up to %.6f beyond it, kept up to %.6f short of it, "
                 "%.2f of the bound",
                 faults, lights, none, e.beyond, e.short_of, share);
}

/* A ramp's argument falls from one at N.H = 1 to zero at quiet, and gives cos^n there, its place rounded to 2^-15 of the ramp; at
 * quiet that is all but fainter than the tolerance. */
static void test_ramp(test_random *random)
{
    double worst_line = 0, worst = 0, share = 0;
    int i, ends = 0, falls = 0, highlights = 0;
    for (i = 0; i < 4000; i++) {
        lmb_look look;
        unsigned k, p;
        const uint16_t tolerance = (uint16_t)(test_integer(random, 0, 9999) >> test_integer(random, 0, 14));
        random_look(random, &look, LMB_LOBE_TUNED);
        lmb_look_tolerance(&look, tolerance);
        lmb_look_ramp(&look);
        for (k = 0; k < look.lights; k++) {
            const struct lmb_look_light *light = &look.light[k];
            const double quiet = ldexp(light->quiet_q30, -30), steep = look.lobe.shininess * quiet;
            int32_t last = 0;
            if (!(look.specular_on >> k & 1)) continue;
            highlights++;
            worst_line = fmax(worst_line, fmax(fabs(argument_at(light, 0) - 1), fabs(argument_at(light, quiet))));
            ends += lmb_look_ramp_at(&look, k, 0x40000000) != 32768 || lmb_look_ramp_at(&look, k, 0xffffffff) != 32768;
            ends += fabs(strength_of(light) * pow(1 - fmin(1, quiet), look.lobe.shininess) - tolerance / 65536.0) > doubt(&look);
            for (p = 0; p <= 512; p++) {
                const uint32_t argument = p == 512 ? 0x40000000 : (p << 21) + (uint32_t)test_integer(random, 0, 0x1fffff);
                const double v = quiet * (1 - ldexp(argument, -30)), want = v < 1 ? pow(1 - v, look.lobe.shininess) : 0;
                const int32_t got = lmb_look_ramp_at(&look, k, argument);
                const double bound = ldexp(steep, -15) + ldexp(1, -15);
                falls += got < last;
                last = got;
                worst = fmax(worst, fabs(got / 32768.0 - want));
                share = fmax(share, fabs(got / 32768.0 - want) / bound);
            }
        }
    }
    test_verdict(worst_line <= ldexp(1, -15) && !ends && !falls && share <= 1,
                 "look: ramps fall from one to where the highlight ends, and give the power",
                 "%d highlights: ends off by %.7f, %d ends wrong, %d fall; power off by %.6f, %.2f of the bound", highlights,
                 worst_line, ends, falls, worst, share);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_look_errors();
    test_products();
    test_half_vectors(&random);
    test_tolerance(&random);
    test_ramp(&random);
    return test_end();
}
