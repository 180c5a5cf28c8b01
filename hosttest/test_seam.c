/* SPDX-License-Identifier: MIT */
/* Shading along edges that two triangles share: what both say there is the same within a level, whatever each has chosen for
 * itself (a straight term where it bends little, a curve for an arc, an exact plane where it is thin). */
#include "../firmware/step.h"

#include "shapes.h"

/* Two triangles on either side of the way from corner 0 to corner 1; 2 is left of it on the screen, 3 is right. */
typedef struct pair {
    lmb_vertex v[4];
} pair;

typedef struct seam_case {
    enum lmb_model model;
    enum lmb_step_kind step;
    uint16_t tolerance;
    unsigned shininess;
    double spread; /* angle of normals from their common direction, at most */
    double bound;  /* of the difference, one is full intensity */
    const char *name;
} seam_case;

static void corner_at(lmb_vertex *v, double x, double y)
{
    v->x = (int32_t)lround(x * PX);
    v->y = (int32_t)lround(y * PX);
    v->depth = 0;
}

/* The shared edge runs mostly down, so that rows cross it. */
static void pair_make(test_random *r, pair *p, double spread)
{
    const lmb_vec axis = random_unit(r);
    int i;
    corner_at(&p->v[0], test_real(r, 24, 40), test_real(r, 2, 20));
    corner_at(&p->v[1], test_real(r, 24, 40), test_real(r, 44, 62));
    corner_at(&p->v[2], test_real(r, 1, 20), test_real(r, 2, 62));
    corner_at(&p->v[3], test_real(r, 44, 63), test_real(r, 2, 62));
    for (i = 0; i < 4; i++) {
        const lmb_vec off = random_unit(r);
        const double reach = tan(spread * test_real(r, 0, 0.999));
        p->v[i].normal = unit(axis.x + reach * off.x, axis.y + reach * off.y, axis.z + reach * off.z);
    }
}

/* A term of a span at a real number of pixels from its first: planes and curves are polynomials, arcs sinusoids, taken on from the two
 * pixels at that end. */
static double term_at(const lmb_span *span, lmb_term term, double n)
{
    const lmb_arc *arc = &span->arc;
    double f[2] = {0, 0}, phi;
    int i, first = 0;
    if (span->kind == LMB_SPAN_FLAT) return term.f / 1073741824.0;
    if (span->kind == LMB_SPAN_PLANE) return (term.f + n * term.d + n * (n - 1) / 2 * term.c) / 1073741824.0;
    if (n > 1) first = span->length - 2;
    for (i = -first; i < 2; i++) {
        if (i >= 0) f[i] = term.f / 1073741824.0;
        lmb_arc_step(arc, &term);
    }
    n -= first;
    phi = 2 * asin(sqrt(ldexp(arc->kappa, -13 - arc->kappa_shift - arc->guard)) / 2);
    if (phi < 1e-9) return f[0] + n * (f[1] - f[0]);
    return (f[0] * sin((1 - n) * phi) + f[1] * sin(n * phi)) / sin(phi);
}

static double clamped(double x) { return fmin(fmax(x, 0), 1); }

/* What a span says: its diffuse term, and its highlight. */
static void intensities(const lmb_look *look, const lmb_span *span, double n, double out[2])
{
    double s;
    out[0] = span->diffuse_on ? clamped(term_at(span, span->diffuse[0], n)) : 0;
    out[1] = 0;
    if (!span->specular_on) return;
    s = term_at(span, span->specular[0], n);
    if (look->model != LMB_MODEL_GLOSS) {
        out[1] = clamped(s);
        return;
    }
    if (span->kind == LMB_SPAN_ARC) s += span->specular[0].c / 1073741824.0;
    s = ldexp(s, span->exponent[0] + 16);
    out[1] = s <= 0 ? 0 : lmb_lobe_at(&look->lobe, (int32_t)floor(s) + look->light[0].dark_q16) / 32768.0;
}

/* Says for each row what one triangle holds where the shared edge crosses it. Rows where it has fewer than three pixels are left out. */
typedef struct side {
    double value[SIDE][2];
    bool known[SIDE];
} side;

static void side_make(side *s, const lmb_look *look, const lmb_rays *rays, const pair *p, int other)
{
    const lmb_window window = {0, 0, SIDE, SIDE, false};
    const lmb_vertex *a = &p->v[0], *b = &p->v[1];
    lmb_triangle t;
    lmb_span span;
    int y;
    for (y = 0; y < SIDE; y++) s->known[y] = false;
    if (!lmb_triangle_begin(&t, look, rays, other == 2 ? a : b, &p->v[other], other == 2 ? b : a, &window)) return;
    while (lmb_triangle_next(&t, &span)) {
        const double x = a->x + (span.y * PX + 8.0 - a->y) * (b->x - a->x) / (b->y - a->y), n = (x - 8) / PX - span.x;
        const double outside = n < 0 ? -n : n - (span.length - 1);
        if (span.length < 3 || outside > 1 || span.y * PX + 8 <= a->y || span.y * PX + 8 >= b->y) continue;
        intensities(look, &span, n, s->value[span.y]);
        s->known[span.y] = true;
    }
}

static void test_seam(test_random *r, const seam_case *c)
{
    static const lmb_material plain = {{0, 0, 0}, {255, 255, 255}, {255, 255, 255}, 1};
    static side left, right;
    double worst[2] = {0, 0};
    int i, k, y, rows = 0;
    for (i = 0; i < 20000; i++) {
        lmb_material material = plain;
        lmb_light light = {random_unit(r), {255, 255, 255}};
        lmb_look look;
        lmb_rays rays;
        pair p;
        material.shininess = (uint16_t)c->shininess;
        pair_make(r, &p, c->spread);
        if (i & 1) light.direction = p.v[0].normal; /* the edge is lit */
        if (lmb_look_prepare(&look, &material, &light, 1, c->model, c->step)) abort();
        lmb_look_tolerance(&look, c->tolerance);
        lmb_rays_prepare(&rays, &look, NULL);
        side_make(&left, &look, &rays, &p, 2);
        side_make(&right, &look, &rays, &p, 3);
        for (y = 0; y < SIDE; y++) {
            if (!left.known[y] || !right.known[y]) continue;
            rows++;
            for (k = 0; k < 2; k++) worst[k] = fmax(worst[k], fabs(left.value[y][k] - right.value[y][k]));
        }
    }
    test_verdict(rows > i && worst[0] <= c->bound && worst[1] <= c->bound, c->name,
                 "both sides agree within %.5f (N.L) and %.5f (highlight) of %.5f, %d rows, n = %u", worst[0], worst[1], c->bound,
                 rows, c->shininess);
}

int main(int argc, char **argv)
{
    static const seam_case cases[] = {
        {LMB_MODEL_GOURAUD, LMB_STEP_LINEAR, 0, 16, 0.5, 1.0 / 255, "seam_gouraud"},
        {LMB_MODEL_GLOSS, LMB_STEP_LINEAR, 0, 16, 0.3, 1.0 / 255, "seam_linear"},
        {LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, 0, 16, 0.4, 1.0 / 255, "seam_quadratic"},
        {LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, LMB_TOLERANCE_RGB888, 100, 0.3, 1.0 / 255, "seam_quadratic_888"},
        {LMB_MODEL_GLOSS, LMB_STEP_QUADRATIC, LMB_TOLERANCE_RGB565, 16, 0.3, 1.0 / 63, "seam_quadratic_565"},
        {LMB_MODEL_GLOSS, LMB_STEP_ARC, 0, 16, 0.4, 1.0 / 255, "seam_arc"},
        {LMB_MODEL_GLOSS, LMB_STEP_ARC, LMB_TOLERANCE_RGB888, 100, 0.3, 1.0 / 255, "seam_arc_888"},
        {LMB_MODEL_GLOSS, LMB_STEP_ARC, LMB_TOLERANCE_RGB565, 16, 0.3, 1.0 / 63, "seam_arc_565"},
        {LMB_MODEL_GLOSS, LMB_STEP_PLANNED, LMB_TOLERANCE_RGB888, 16, 0.2, 2 * LMB_TOLERANCE_RGB888 / 65536.0,
         "seam_planned_888"},
        {LMB_MODEL_GLOSS, LMB_STEP_PLANNED, LMB_TOLERANCE_RGB888, 100, 0.1, 2 * LMB_TOLERANCE_RGB888 / 65536.0,
         "seam_planned_888"},
        {LMB_MODEL_GLOSS, LMB_STEP_PLANNED, LMB_TOLERANCE_RGB888, 100, 0.3, 2 * LMB_TOLERANCE_RGB888 / 65536.0,
         "seam_planned_888"},
        {LMB_MODEL_GLOSS, LMB_STEP_PLANNED, LMB_TOLERANCE_RGB565, 16, 0.3, 2 * LMB_TOLERANCE_RGB565 / 65536.0,
         "seam_planned_565"},
        {LMB_MODEL_GLOSS, LMB_STEP_PLANNED, LMB_TOLERANCE_RGB565, 100, 0.15, 2 * LMB_TOLERANCE_RGB565 / 65536.0,
         "seam_planned_565"},
        {LMB_MODEL_GLOSS, LMB_STEP_PLANNED, LMB_TOLERANCE_RGB565, 100, 0.5, 2 * LMB_TOLERANCE_RGB565 / 65536.0,
         "seam_planned_565"},
    };
    test_random r = test_seed(argc, argv);
    unsigned i;
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++) test_seam(&r, &cases[i]);
    return test_end();
}
