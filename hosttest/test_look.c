/* SPDX-License-Identifier: MIT */
/* Looks: what is taken and refused, material times light for every pair of colours, half vectors against doubles. */
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
        {1, 4, 0, 1, {0, 0, 16384}, LMB_ERROR_VALUE},  {1, 3, 3, 1, {0, 0, 16384}, LMB_ERROR_VALUE},
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

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_look_errors();
    test_products();
    test_half_vectors(&random);
    return test_end();
}
