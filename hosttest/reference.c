/* SPDX-License-Identifier: MIT */
/* References in double: vectors, materials, frames, and per-pixel normalised Phong. */
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -------------------------------------------------------------------------------------------------------------------- vectors */

ref_vec ref_make(lmb_vec v)
{
    ref_vec r = {v.x, v.y, v.z};
    return r;
}

ref_vec ref_add(ref_vec a, ref_vec b)
{
    ref_vec r = {a.x + b.x, a.y + b.y, a.z + b.z};
    return r;
}

ref_vec ref_sub(ref_vec a, ref_vec b)
{
    ref_vec r = {a.x - b.x, a.y - b.y, a.z - b.z};
    return r;
}

ref_vec ref_scale(ref_vec a, double s)
{
    ref_vec r = {a.x * s, a.y * s, a.z * s};
    return r;
}

double ref_dot(ref_vec a, ref_vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

ref_vec ref_cross(ref_vec a, ref_vec b)
{
    ref_vec r = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return r;
}

ref_vec ref_unit(ref_vec a)
{
    static const ref_vec viewer = {0, 0, 1};
    double length = sqrt(ref_dot(a, a));
    return length > 0 ? ref_scale(a, 1 / length) : viewer;
}

ref_vec ref_slerp(ref_vec a, ref_vec b, double t)
{
    ref_vec across = ref_cross(a, b);
    double sine = sqrt(ref_dot(across, across)), cosine = ref_dot(a, b), psi = atan2(sine, cosine);
    if (sine < 1e-12 || 1 - cosine > LMB_ARC_U_MAX / 268435456.0) return ref_add(ref_scale(a, 1 - t), ref_scale(b, t));
    return ref_add(ref_scale(a, sin((1 - t) * psi) / sine), ref_scale(b, sin(t * psi) / sine));
}

ref_vec ref_turn(const lmb_matrix *m, ref_vec v)
{
    ref_vec r = {ref_dot(ref_make(m->row[0]), v), ref_dot(ref_make(m->row[1]), v), ref_dot(ref_make(m->row[2]), v)};
    return ref_scale(r, 1 / 16384.0);
}

ref_vec ref_turn_back(const lmb_matrix *m, ref_vec v)
{
    ref_vec r = ref_add(ref_scale(ref_make(m->row[0]), v.x), ref_scale(ref_make(m->row[1]), v.y));
    return ref_scale(ref_add(r, ref_scale(ref_make(m->row[2]), v.z)), 1 / 16384.0);
}

/* ------------------------------------------------------------------------------------------------------------------ materials */

static void fold(double out[3], lmb_rgb material, lmb_rgb light)
{
    out[0] = material.r / 255.0 * (light.r / 255.0);
    out[1] = material.g / 255.0 * (light.g / 255.0);
    out[2] = material.b / 255.0 * (light.b / 255.0);
}

void ref_shader_begin(ref_shader *shader, const scene *s, const scene_object *object, bool highlight)
{
    static const ref_vec viewer = {0, 0, 1};
    static const lmb_rgb white = {255, 255, 255};
    const lmb_matrix *rotation = &object->pose.rotation;
    unsigned i;
    fold(shader->ambient, object->material.ambient, white);
    shader->lights = s->lights;
    shader->shininess = object->material.shininess;
    shader->highlight = highlight;
    for (i = 0; i < s->lights; i++) {
        ref_vec direction = ref_unit(ref_make(s->light[i].direction));
        ref_vec half = ref_unit(ref_add(direction, viewer));
        shader->light[i].direction = ref_unit(ref_turn_back(rotation, direction));
        shader->light[i].half = ref_unit(ref_turn_back(rotation, half));
        fold(shader->light[i].diffuse, object->material.diffuse, s->light[i].colour);
        fold(shader->light[i].specular, object->material.specular, s->light[i].colour);
    }
}

void ref_terms_of(const ref_shader *shader, ref_vec normal, ref_terms *terms)
{
    unsigned i;
    for (i = 0; i < shader->lights; i++) {
        terms->diffuse[i] = ref_dot(normal, shader->light[i].direction);
        terms->specular[i] = ref_dot(normal, shader->light[i].half);
    }
}

static double cosine(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

void ref_terms_light(const ref_shader *shader, ref_terms *terms)
{
    unsigned i;
    for (i = 0; i < shader->lights; i++) {
        terms->diffuse[i] = cosine(terms->diffuse[i]);
        terms->specular[i] = shader->highlight ? pow(cosine(terms->specular[i]), shader->shininess) : 0;
    }
}

void ref_terms_colour(const ref_shader *shader, const ref_terms *lit, double rgb[3])
{
    unsigned i;
    int c;
    for (c = 0; c < 3; c++) {
        rgb[c] = shader->ambient[c];
        for (i = 0; i < shader->lights; i++) {
            rgb[c] += shader->light[i].diffuse[c] * lit->diffuse[i] + shader->light[i].specular[c] * lit->specular[i];
        }
        rgb[c] = fmin(rgb[c], 1);
    }
}

void ref_colour(const ref_shader *shader, ref_vec normal, double rgb[3])
{
    ref_terms terms;
    ref_terms_of(shader, normal, &terms);
    ref_terms_light(shader, &terms);
    ref_terms_colour(shader, &terms, rgb);
}

/* --------------------------------------------------------------------------------------------------------------------- frames */

void ref_frame_begin(ref_frame *frame, const scene *s, double slack)
{
    size_t pixels = (size_t)s->width * (size_t)s->height;
    frame->width = s->width;
    frame->height = s->height;
    frame->depth = s->depth;
    frame->slack = slack;
    frame->fragments = 0;
    frame->clipped = 0;
    frame->fragment = malloc(pixels * REF_LAYERS * sizeof *frame->fragment);
    frame->layers = calloc(pixels, 1);
    if (!frame->fragment || !frame->layers) {
        fprintf(stderr, "reference: out of memory\n");
        exit(EXIT_FAILURE);
    }
}

void ref_frame_end(ref_frame *frame)
{
    free(frame->fragment);
    free(frame->layers);
}

void ref_frame_add(ref_frame *frame, int x, int y, double depth, const double rgb[3], uint32_t triangle)
{
    size_t pixel = (size_t)y * (size_t)frame->width + (size_t)x;
    ref_fragment *layer = frame->fragment + pixel * REF_LAYERS;
    int count = frame->depth ? frame->layers[pixel] : 0, at = count, c;
    frame->fragments++;
    while (at > 0 && layer[at - 1].depth > depth) at--;
    if (at == REF_LAYERS) return;
    if (count == REF_LAYERS) count--;
    memmove(layer + at + 1, layer + at, (size_t)(count - at) * sizeof *layer);
    layer[at].depth = depth;
    for (c = 0; c < 3; c++) layer[at].rgb[c] = (float)rgb[c];
    layer[at].triangle = triangle;
    frame->layers[pixel] = (uint8_t)(count + 1);
}

/* ----------------------------------------------------------------------------------------------------------- normalised Phong */

ref_ray ref_pixel_ray(const lmb_camera *camera, double x, double y)
{
    double focal = camera->focal_q16 / 65536.0;
    double right = (x + 0.5 - camera->x / 16.0) / focal, up = (camera->y / 16.0 - y - 0.5) / focal;
    ref_ray ray = {{0, 0, 0}, {0, 0, -1}};
    ref_vec *across = camera->perspective ? &ray.direction : &ray.origin;
    across->x = right;
    across->y = up;
    return ray;
}

/* A triangle in space with what its pixels need. */
typedef struct facet {
    ref_vec p[3], normal[3];
    int left, top, right, bottom; /* pixels that may see it */
} facet;

static ref_vec placed(const scene_object *object, uint32_t vertex)
{
    ref_vec p = ref_scale(ref_make(object->mesh->positions[vertex]), ldexp(1, object->mesh->scale));
    ref_vec at = {object->pose.x / 65536.0, object->pose.y / 65536.0, object->pose.z / 65536.0};
    return ref_add(ref_turn(&object->pose.rotation, p), at);
}

static int within(double x, int limit) { return x < 0 ? 0 : x > limit ? limit : (int)x; }

/* The whole frame if a corner is nearer than the near plane, which rays that start at the camera do not mind. */
static void facet_bounds(facet *f, const scene *s)
{
    const lmb_camera *camera = &s->camera;
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    int k;
    for (k = 0; k < 3; k++) {
        double scale = camera->focal_q16 / 65536.0 / (camera->perspective ? -f->p[k].z : 1);
        double x = camera->x / 16.0 + f->p[k].x * scale, y = camera->y / 16.0 - f->p[k].y * scale;
        if (-f->p[k].z * 65536 < camera->near_q16) {
            left = top = -1e9;
            right = bottom = 1e9;
        }
        left = fmin(left, x);
        right = fmax(right, x);
        top = fmin(top, y);
        bottom = fmax(bottom, y);
    }
    f->left = within(left - 1, s->width);
    f->right = within(right + 2, s->width);
    f->top = within(top - 1, s->height);
    f->bottom = within(bottom + 2, s->height);
}

/* Where the ray meets the triangle's front: barycentric coordinates and the distance (Moller and Trumbore 1997). */
static bool facet_hit(const facet *f, const ref_ray *ray, double weight[3], double *distance)
{
    ref_vec ab = ref_sub(f->p[1], f->p[0]), ac = ref_sub(f->p[2], f->p[0]), from = ref_sub(ray->origin, f->p[0]);
    ref_vec across = ref_cross(ray->direction, ac), turned = ref_cross(from, ab);
    double det = ref_dot(ab, across);
    if (det <= 0) return false;
    weight[1] = ref_dot(from, across) / det;
    weight[2] = ref_dot(ray->direction, turned) / det;
    weight[0] = 1 - weight[1] - weight[2];
    *distance = ref_dot(ac, turned) / det;
    return weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0;
}

static void facet_paint(ref_frame *frame, const scene *s, const facet *f, const ref_shader *shader, uint32_t triangle)
{
    int x, y, k;
    for (y = f->top; y < f->bottom; y++) {
        for (x = f->left; x < f->right; x++) {
            ref_ray ray = ref_pixel_ray(&s->camera, x, y);
            double weight[3], distance, rgb[3];
            ref_vec normal = {0, 0, 0};
            if (!facet_hit(f, &ray, weight, &distance) || distance * 65536 < s->camera.near_q16) continue;
            for (k = 0; k < 3; k++) normal = ref_add(normal, ref_scale(f->normal[k], weight[k]));
            ref_colour(shader, ref_unit(normal), rgb);
            ref_frame_add(frame, x, y, distance, rgb, triangle);
        }
    }
}

void ref_normalised_phong(ref_frame *frame, const scene *s, bool highlight)
{
    unsigned i;
    uint32_t t;
    int k;
    ref_frame_begin(frame, s, 0);
    for (i = 0; i < s->objects; i++) {
        const scene_object *object = &s->object[i];
        ref_shader shader;
        ref_shader_begin(&shader, s, object, highlight);
        for (t = 0; t < object->mesh->triangles; t++) {
            facet f;
            for (k = 0; k < 3; k++) {
                uint16_t vertex = object->mesh->indices[3 * t + (uint32_t)k];
                f.p[k] = placed(object, vertex);
                f.normal[k] = ref_unit(ref_make(object->mesh->normals[vertex]));
            }
            facet_bounds(&f, s);
            facet_paint(frame, s, &f, &shader, (uint32_t)i << 24 | t);
        }
    }
}
