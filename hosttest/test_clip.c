/* SPDX-License-Identifier: MIT */
/* Clipping in space: corners that a near plane or the guard leaves, where they are and which way they face, against doubles. */
#include "../firmware/clip.h"
#include "../firmware/screen.h"
#include "test.h"

#define NEAR 1.0    /* units */
#define FOCAL 200.0 /* pixels */
#define SIZE 400    /* of the frame */

typedef struct corner {
    double p[3], n[3];
} corner;

/* How far inside a plane: 0 the near plane, 1 to 4 the guard right, left, top, bottom. */
static double inside(const double p[3], int plane)
{
    double reach = -p[2] * LMB_GUARD / FOCAL;
    return plane == 0   ? -p[2] - NEAR
           : plane == 1 ? reach - p[0]
           : plane == 2 ? reach + p[0]
           : plane == 3 ? reach - p[1]
                        : reach + p[1];
}

/* Sutherland and Hodgman by the book: keeps what is inside, cuts edges that cross, interpolates along them and normalises. -1 if
 * an edge crosses so flatly that where it does is a matter of the last bits. */
static int clip_reference(corner *polygon, int corners)
{
    corner in[9];
    int plane, i, k, n;
    for (plane = 0; plane < 5 && corners > 0; plane++) {
        for (i = 0; i < corners; i++) in[i] = polygon[i];
        for (i = 0, n = 0; i < corners; i++) {
            const corner *a = &in[i], *b = &in[(i + 1) % corners];
            double da = inside(a->p, plane), db = inside(b->p, plane), t = da / (da - db), length;
            if (da >= 0) polygon[n++] = *a;
            if ((da >= 0) == (db >= 0)) continue;
            if (fabs(da - db) < 0.2 * hypot(hypot(a->p[0] - b->p[0], a->p[1] - b->p[1]), a->p[2] - b->p[2])) return -1;
            for (k = 0, length = 0; k < 3; k++) {
                polygon[n].p[k] = a->p[k] + t * (b->p[k] - a->p[k]);
                polygon[n].n[k] = a->n[k] + t * (b->n[k] - a->n[k]);
                length += polygon[n].n[k] * polygon[n].n[k];
            }
            for (k = 0; k < 3; k++) polygon[n].n[k] *= 16384 / sqrt(length);
            n++;
        }
        corners = n;
    }
    return corners;
}

static void random_corner(test_random *r, corner *to, lmb_corner *given, double reach, double spread)
{
    double axis = test_real(r, 0, 6.28), length = 0, v[3];
    int k;
    v[0] = cos(axis) * spread, v[1] = sin(axis) * spread, v[2] = 1;
    for (k = 0; k < 3; k++) length += v[k] * v[k];
    given->screen.x = LMB_NOT_ON_SCREEN;
    given->p.x = (int32_t)lround(test_real(r, -reach, reach) * 65536);
    given->p.y = (int32_t)lround(test_real(r, -reach, reach) * 65536);
    given->p.z = (int32_t)lround(test_real(r, -40, 30) * 65536);
    given->screen.normal.x = (int16_t)lround(v[0] / sqrt(length) * 16384);
    given->screen.normal.y = (int16_t)lround(v[1] / sqrt(length) * 16384);
    given->screen.normal.z = (int16_t)lround(v[2] / sqrt(length) * 16384);
    to->p[0] = given->p.x / 65536.0, to->p[1] = given->p.y / 65536.0, to->p[2] = given->p.z / 65536.0;
    to->n[0] = given->screen.normal.x, to->n[1] = given->screen.normal.y, to->n[2] = given->screen.normal.z;
}

/* The angle, in radians, between a corner's normal and the reference's; *away: their distance in pixels. */
static double compare(const lmb_vertex *v, const corner *want, double *away)
{
    double x = SIZE / 2.0 - FOCAL * want->p[0] / want->p[2], y = SIZE / 2.0 + FOCAL * want->p[1] / want->p[2];
    double scale = 16384 / sqrt(want->n[0] * want->n[0] + want->n[1] * want->n[1] + want->n[2] * want->n[2]);
    *away = hypot(v->x / 16.0 - x, v->y / 16.0 - y);
    return sqrt(pow(v->normal.x - want->n[0] * scale, 2) + pow(v->normal.y - want->n[1] * scale, 2) +
                pow(v->normal.z - want->n[2] * scale, 2)) /
           16384;
}

/* near: triangles within the guard, cut by the near plane alone; else by all planes. */
static void test_corners(test_random *r, int near)
{
    double worst = 0, farthest = 0;
    long cuts = 0, wrong = 0, judged = 0, i;
    lmb_camera camera;
    if (lmb_camera_perspective(&camera, SIZE, SIZE, (int32_t)(FOCAL * 65536), (int32_t)(NEAR * 65536), 100 * 65536)) abort();
    for (i = 0; i < 200000; i++) {
        corner polygon[9];
        lmb_corner given[LMB_CLIP_MAX + 1];
        lmb_vertex out[LMB_CLIP_MAX];
        unsigned count, k;
        int corners;
        for (k = 0; k < 3; k++) random_corner(r, &polygon[k], &given[k], near ? 8 : 4000, test_real(r, 0, 1));
        corners = clip_reference(polygon, 3);
        if (corners < 0) continue;
        judged++;
        count = lmb_clip(&camera, given, out);
        cuts += corners > 3 || (corners == 3 && count == 3);
        wrong += count != (unsigned)corners;
        for (k = 0; k < count && count == (unsigned)corners; k++) {
            double away, angle = compare(&out[k], &polygon[k], &away);
            worst = fmax(worst, angle);
            farthest = fmax(farthest, away);
        }
    }
    /* Distances are known to 2^-14 unit, so at a slope of 0.2 a cut moves by 3e-4 unit along its edge: under 0.2 pixel at the
     * near plane, and under 1e-4 of edges of a unit and more. At the guard 2^-16 unit at the near distance is 1/328 pixel, and
     * x/w, 80 there, counts as often. Normals are rounded to 0.87 / 16384 in all. */
    test_verdict(wrong <= judged / 10000 && farthest < (near ? 0.25 : 1) && worst < 3.0 / 16384 && cuts > i / 10,
                 near ? "clip: corners at the near plane" : "clip: corners at the guard",
                 "%ld polygons of %ld triangles, normals off by %.2g rad, corners by %.3g px, %ld with another number of corners",
                 cuts, i, worst, farthest, wrong);
}

int main(int argc, char **argv)
{
    test_random random = test_seed(argc, argv);
    test_corners(&random, 1);
    test_corners(&random, 0);
    return test_end();
}
