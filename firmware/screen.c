/* SPDX-License-Identifier: MIT */
/* Vertices onto the screen. Under an orthographic camera a coordinate is linear in the position, and with t the position turned
 * (exact, three products of 16 bits) one more product of 16 bits gives it:
 *   x, y   (origin + floor(t / 2^15) gain) / 2^17, gain = focal 2^(scale + 6)
 *   depth  (origin + floor(t / 2^15) gain) / 2^14
 * with the place of the mesh's own origin in origin: what does not depend on the vertex is done once for all.
 *
 * Bounds: |t| <= 1.01 * 2^14 * 2^15 sqrt(3) < 28663 * 2^15, so t moves x by less than gain / 64 pixels.
 * Error: gain is off by up to a half and t / 2^15, evened out by half a gain in the origin, too: together (28663 + gain) / 2^18 of
 * 1/16 pixel. That is 1/146 pixel in the corners of the cube that positions can fill, and 1/32768 of half its side; up to GAIN_MAX,
 * 375 pixels for half a side, less than 0.0184 pixel, beside the rounding to 1/16 pixel.
 *
 * Larger meshes, those a thousand pixels from the frame's corner, those deeper than the range of depths, and all under perspective
 * go vertex by vertex through lmb_mesh_place and lmb_project. Where neither perspective nor depth is built in there is no such way:
 * up to 510 pixels meshes are drawn somewhat less exactly, and beyond they are not. */
#include "flash.h"

#include "clip.h"
#include "screen.h"
#include "vec.h"

#define GAIN_MAX 48000
#define ORIGIN_MAX 1020 /* pixels that origin and t may move x together: 2^31 is 1024, and floors take three */
#define SHIFT 17
#define DEPTH_SHIFT 14
#define DEPTH_GAIN_MAX 32768

/* Depths up to here may be nearer than the near plane: they are not that exact. Clipping knows better. */
#define NEAR_MARGIN 4

#if LMB_SCREEN_EXACT
/* A vertex is farther away than the origin by -t 2^(scale + 2) in Q16.16; depth_gain over 2^(14 + depth_shift) makes that a depth.
 * The origin's distance from the near plane, which may not fit, is taken in two parts. */
static bool depth_begin(lmb_screen *s)
{
    const lmb_camera *camera = s->camera;
    int32_t gain = (int32_t)camera->depth_gain, w = lmb_sub(0, s->pose->z), near_q16 = camera->near_q16, most = (int32_t)1 << 30;
    int32_t half = lmb_sub(lmb_shr(w, 1), lmb_shr(near_q16, 1)), down = camera->depth_shift - s->mesh->scale - 17, depth;
    if (down < 1 || camera->depth_shift < 16) return false;
    depth = lmb_mul_shr_sat(half, gain, camera->depth_shift - 1u);
    if (depth <= -most || depth >= most) return false;
    depth = lmb_add(depth, lmb_mul(lmb_sub(w & 1, near_q16 & 1), lmb_shr(gain, camera->depth_shift)));
    s->depth_gain = down > 30 ? 0 : lmb_shr_round(gain, (unsigned)down);
    s->depth = lmb_sub(depth, lmb_shr(s->depth_gain, 1));
    return s->depth_gain <= DEPTH_GAIN_MAX;
}
#endif

/* focal 2^up, rounded; where that is beyond all use, still something beyond. */
static int32_t gain_of(int32_t focal_q16, int32_t up)
{
    if (up >= 0) return lmb_shl(lmb_min(focal_q16, 65536), (unsigned)up);
    return lmb_shr(lmb_add(lmb_shr(focal_q16, (unsigned)~up), 1), 1); /* ~up is -up - 1 */
}

/* centre + place focal / 2^28 + a half in 1/16 pixel, and more, both with 17 more fraction bits; from 1024 pixels on it wraps.
 * Takes the gain away where with what t adds it might. */
static LMB_OUTLINE int32_t origin_of(lmb_screen *s, int32_t centre, int32_t place, int32_t more)
{
    const int64_t product = lmb_mul_wide(place, s->camera->focal_q16);
    const int32_t pixel = lmb_add((int32_t)(product >> 32), lmb_shr(centre, 4));
    if ((pixel ^ lmb_shr(pixel, 31)) > lmb_sub(ORIGIN_MAX, lmb_shr(s->gain, 6))) s->gain = 0;
    return lmb_signed((uint32_t)(product >> 11) + ((2 * (uint32_t)centre + 1) << (SHIFT - 1)) + (uint32_t)more);
}

/* Half a gain, which what is floored falls short by, is added; y is the other way round. */
void lmb_screen_begin(lmb_screen *s)
{
    const lmb_camera *camera = s->camera;
    const lmb_pose *pose = s->pose;
    const int32_t gain = gain_of(camera->focal_q16, s->mesh->scale + 6), half = lmb_shr(gain, 1);
    s->gain = gain;
    s->origin[0] = origin_of(s, camera->x, pose->x, half);
    s->origin[1] = origin_of(s, camera->y, lmb_sub(0, pose->y), lmb_sub(0, half));
#if LMB_SCREEN_EXACT
    s->direct = s->gain > 0 && s->gain <= GAIN_MAX && !camera->perspective && depth_begin(s);
#endif
}

/* A component of a position turned, in line where code need not be small. */
#if LMB_SHORT_CUTS
static inline int32_t turn(const lmb_vec *row, const lmb_vec *v)
{
    return lmb_add(lmb_add(lmb_mul16(row->x, v->x), lmb_mul16(row->y, v->y)), lmb_mul16(row->z, v->z));
}
#else
#define turn lmb_vec_dot_q28
#endif

/* Q.14 in mesh units to Q16.16 in units: times 2^(scale + 2), and scale <= -2. */
static int32_t placed(int32_t place_q16, int32_t turned, unsigned down)
{
    return lmb_add(place_q16, lmb_shr(lmb_add(turned, lmb_shr(lmb_shl(1, down), 1)), down));
}

lmb_point lmb_mesh_place(const lmb_mesh *mesh, const lmb_pose *pose, uint32_t i)
{
    lmb_vec room;
    const lmb_vec *v = lmb_vec_read(&mesh->positions[i], &room);
    unsigned down = (unsigned)-(mesh->scale + 2);
    lmb_point p;
    p.x = placed(pose->x, turn(&pose->rotation.row[0], v), down);
    p.y = placed(pose->y, turn(&pose->rotation.row[1], v), down);
    p.z = placed(pose->z, turn(&pose->rotation.row[2], v), down);
    return p;
}

#if LMB_SCREEN_EXACT
static bool beyond_guard(int32_t q4) { return q4 > LMB_GUARD_NEAR * 16L || q4 < -LMB_GUARD_NEAR * 16L; }

/* The long way. */
static void project(const lmb_screen *s, uint32_t i, lmb_vertex *corner)
{
    lmb_vec room;
    lmb_vec_copy(&corner->normal, lmb_vec_read(&s->mesh->normals[i], &room));
    if (!lmb_project(s->camera, lmb_mesh_place(s->mesh, s->pose, i), corner) || beyond_guard(lmb_sub(corner->x, s->camera->x)) ||
        beyond_guard(lmb_sub(corner->y, s->camera->y))) {
        corner->x = LMB_NOT_ON_SCREEN;
    }
}
#endif

static inline int32_t y_of(const lmb_screen *s, const lmb_vec *row, const lmb_vec *v)
{
    return lmb_shr(lmb_sub(s->origin[1], lmb_mul(lmb_shr(turn(row, v), 15), s->gain)), SHIFT);
}

int32_t lmb_screen_y(const lmb_screen *s, uint32_t i)
{
    lmb_vec room;
    return y_of(s, &s->pose->rotation.row[1], lmb_vec_read(&s->mesh->positions[i], &room));
}

void lmb_screen_project(const lmb_screen *screen, const LMB_FLASH uint16_t *index, uint32_t count, lmb_vertex *corner)
{
#if LMB_SHORT_CUTS
    const lmb_screen copy = *screen, *s = &copy; /* in registers, beyond the reach of what is stored */
    const lmb_matrix turned = s->pose->rotation, *r = &turned;
#else
    const lmb_screen *s = screen;
    const lmb_matrix *r = &s->pose->rotation;
#endif
    uint32_t n = 0;
#if LMB_SCREEN_EXACT
    for (; !s->direct && n < count; n++) project(screen, index ? index[n] : n, corner + n);
#endif
    for (corner += n; n < count; n++, corner++) {
        const uint32_t i = index ? index[n] : n;
        lmb_vec room;
        const lmb_vec *v = lmb_vec_read(&s->mesh->positions[i], &room);
        int32_t t;
        t = lmb_shr(turn(&r->row[0], v), 15);
        corner->x = lmb_shr(lmb_add(s->origin[0], lmb_mul(t, s->gain)), SHIFT);
        corner->y = y_of(s, &r->row[1], v);
        corner->depth = 0;
#if LMB_SCREEN_EXACT
        {
            int32_t depth;
            t = lmb_shr(turn(&r->row[2], v), 15);
            depth = lmb_shr(lmb_sub(s->depth, lmb_mul(t, s->depth_gain)), DEPTH_SHIFT);
            if ((uint32_t)lmb_sub(depth, NEAR_MARGIN) > 65535 - NEAR_MARGIN) {
                if (depth < NEAR_MARGIN) corner->x = LMB_NOT_ON_SCREEN;
                depth = 65535;
            }
            if (LMB_WITH_DEPTH) corner->depth = (uint16_t)depth;
        }
#endif
        lmb_vec_copy(&corner->normal, lmb_vec_read(&s->mesh->normals[i], &room));
    }
}

void lmb_mesh_project(const lmb_mesh *mesh, const lmb_pose *pose, const lmb_camera *camera, lmb_vertex *vertices)
{
    lmb_screen screen;
    screen.mesh = mesh;
    screen.pose = pose;
    screen.camera = camera;
    lmb_screen_begin(&screen);
    lmb_screen_project(&screen, 0, mesh->vertices, vertices);
}
