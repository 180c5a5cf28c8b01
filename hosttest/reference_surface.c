/* SPDX-License-Identifier: MIT */
/* The reference true_surface: rays against the sphere and the torus that the meshes stand for, in double.
 *
 * Rays are taken into the object's space by the inverse of its rotation as it stands (Q2.14 makes it not quite orthogonal), so
 * that surface and mesh have the same place and shape. The sphere is a quadratic equation; the torus is marched along its
 * distance function, which never oversteps, and ends by bisection.
 */
#include "reference.h"

#include <math.h>

#define MARCH_STEPS 512
#define MARCH_NEAR 1e-4 /* inside this distance the crossing is sought with steps of its own */
#define MARCH_STEP 1e-4
#define TORUS_REACH (SCENE_TORUS_MAJOR + SCENE_TORUS_MINOR)

typedef struct solid {
    ref_vec axis[3]; /* columns of the inverse rotation: object = sum of axis[k] * space[k] */
    ref_vec origin;  /* of the object, in space */
    enum scene_surface kind;
} solid;

/* The inverse by cofactors: its columns are cross products of the rows over the determinant. */
static void surface_begin(solid *surface, const scene_object *object)
{
    const lmb_matrix *m = &object->pose.rotation;
    ref_vec a = ref_scale(ref_make(m->row[0]), 1 / 16384.0), b = ref_scale(ref_make(m->row[1]), 1 / 16384.0);
    ref_vec c = ref_scale(ref_make(m->row[2]), 1 / 16384.0);
    double determinant = ref_dot(a, ref_cross(b, c));
    surface->axis[0] = ref_scale(ref_cross(b, c), 1 / determinant);
    surface->axis[1] = ref_scale(ref_cross(c, a), 1 / determinant);
    surface->axis[2] = ref_scale(ref_cross(a, b), 1 / determinant);
    surface->origin.x = object->pose.x / 65536.0;
    surface->origin.y = object->pose.y / 65536.0;
    surface->origin.z = object->pose.z / 65536.0;
    surface->kind = object->surface;
}

static ref_vec into(const solid *s, ref_vec v)
{
    return ref_add(ref_add(ref_scale(s->axis[0], v.x), ref_scale(s->axis[1], v.y)), ref_scale(s->axis[2], v.z));
}

static ref_vec at(const ref_ray *ray, double t) { return ref_add(ray->origin, ref_scale(ray->direction, t)); }

/* The nearer and the farther crossing of a ball about the origin. */
static bool ball(const ref_ray *ray, double radius, double *in, double *out)
{
    double a = ref_dot(ray->direction, ray->direction), b = ref_dot(ray->origin, ray->direction) / a;
    double c = (ref_dot(ray->origin, ray->origin) - radius * radius) / a, root = b * b - c;
    if (root < 0) return false;
    root = sqrt(root);
    *in = -b - root;
    *out = -b + root;
    return *out > 0;
}

/* The distance from the torus about z, below zero inside. */
static double torus_distance(ref_vec p) { return hypot(hypot(p.x, p.y) - SCENE_TORUS_MAJOR, p.z) - SCENE_TORUS_MINOR; }

static ref_vec torus_normal(ref_vec p)
{
    double around = hypot(p.x, p.y), k = around > 0 ? 1 - SCENE_TORUS_MAJOR / around : 0;
    ref_vec n = {p.x * k, p.y * k, p.z};
    return ref_unit(n);
}

static bool torus(const ref_ray *ray, double *t)
{
    double end, low, speed = sqrt(ref_dot(ray->direction, ray->direction)), distance;
    int i;
    if (!ball(ray, TORUS_REACH, t, &end)) return false;
    *t = fmax(*t, 0);
    for (i = 0; i < MARCH_STEPS; i++) {
        distance = torus_distance(at(ray, *t));
        if (distance < 0) break;
        *t += fmax(distance, MARCH_STEP) / speed;
        if (*t > end) return false;
    }
    if (i == 0 || i == MARCH_STEPS) return false; /* the eye is inside; or it never crosses */
    low = *t - (MARCH_NEAR + MARCH_STEP) / speed;
    for (i = 0; i < 60; i++) {
        double middle = (low + *t) / 2;
        if (torus_distance(at(ray, middle)) < 0) {
            *t = middle;
        } else {
            low = middle;
        }
    }
    return true;
}

/* Where the ray, in the object's space, meets the surface first, and its normal there. */
static bool hit(const solid *s, const ref_ray *ray, double *t, ref_vec *normal)
{
    double out;
    if (s->kind == SCENE_SPHERE) {
        if (!ball(ray, 1, t, &out)) return false;
        *normal = ref_unit(at(ray, *t));
    } else {
        if (!torus(ray, t)) return false;
        *normal = torus_normal(at(ray, *t));
    }
    return true;
}

bool ref_true_surface(ref_frame *frame, const scene *s, bool highlight)
{
    unsigned i;
    int x, y;
    for (i = 0; i < s->objects; i++) {
        if (s->object[i].surface == SCENE_MESH_ONLY) return false;
    }
    ref_frame_begin(frame, s, 0);
    for (i = 0; i < s->objects; i++) {
        ref_shader shader;
        solid surface;
        ref_shader_begin(&shader, s, &s->object[i], highlight);
        surface_begin(&surface, &s->object[i]);
        for (y = 0; y < s->height; y++) {
            for (x = 0; x < s->width; x++) {
                ref_ray ray = ref_pixel_ray(&s->camera, x, y);
                double t, rgb[3];
                ref_vec normal;
                ray.origin = into(&surface, ref_sub(ray.origin, surface.origin));
                ray.direction = into(&surface, ray.direction);
                if (!hit(&surface, &ray, &t, &normal) || t * 65536 < s->camera.near_q16) continue;
                ref_colour(&shader, normal, rgb);
                ref_frame_add(frame, x, y, t, rgb, (uint32_t)i << 24);
            }
        }
    }
    return true;
}
