/* SPDX-License-Identifier: MIT */
/* Triangles row by row for the comparisons. */
#include "walk.h"

/* The first row whose centre lies at y or below. */
static int32_t row_at(int32_t y) { return (y + 7) >> 4; }

/* On the row with centre yc the edge crosses at x0 + dx (yc - y0) / dy, in 1/16 pixel; the first pixel centre not left of that is
 * x = ceil(N / M), N = (x0 - 8) dy + dx (yc - y0), M = 16 dy, and gap = M x - N. With dx = step dy + part, N is dy times a whole
 * number of 1/16 pixels, and rest: only small numbers are left to divide. */
void compare_edge_begin(compare_edge *edge, const lmb_vertex *top, const lmb_vertex *bottom)
{
    int32_t dx = bottom->x - top->x, dy = bottom->y - top->y, below = 16 * row_at(top->y) + 8 - top->y;
    int32_t step = dx / dy, part = dx - step * dy, whole, rest;
    if (part < 0) {
        step--;
        part += dy;
    }
    rest = part * below; /* below 15 dy */
    whole = rest / dy;
    rest -= whole * dy;
    whole += top->x - 8 + step * below;
    edge->modulus = 16 * dy;
    edge->step = step;
    edge->part = 16 * part;
    edge->x = whole >> 4;
    edge->gap = -((whole & 15) * dy + rest);
    if (edge->gap < 0) {
        edge->gap += edge->modulus;
        edge->x++;
    }
}

/* Whether a to b crosses the centre line of a row. */
static bool crosses(const lmb_vertex *a, const lmb_vertex *b) { return row_at(a->y) < row_at(b->y); }

bool compare_walk_begin(compare_walk *walk, const lmb_vertex *a, const lmb_vertex *b, const lmb_vertex *c)
{
    const lmb_vertex *top = a, *left = b, *right = c, *first_left, *first_right;
    walk->bx = b->x - a->x;
    walk->by = b->y - a->y;
    walk->cx = c->x - a->x;
    walk->cy = c->y - a->y;
    walk->area_2 = walk->by * walk->cx - walk->bx * walk->cy;
    if (walk->area_2 <= 0) return false;
    /* counter-clockwise with y up: down from the top, the next corner is on the left */
    if (b->y < a->y && b->y <= c->y) {
        top = b, left = c, right = a;
    } else if (c->y < a->y) {
        top = c, left = a, right = b;
    }
    walk->middle_left = left->y < right->y;
    walk->middle = walk->middle_left ? left : right;
    walk->bottom = walk->middle_left ? right : left;
    walk->y = row_at(top->y);
    walk->y_switch = row_at(walk->middle->y);
    walk->y_end = row_at(walk->bottom->y);
    if (walk->y >= walk->y_end) return false;
    first_left = first_right = top;
    if (!crosses(top, walk->middle)) {
        if (walk->middle_left) first_left = walk->middle;
        if (!walk->middle_left) first_right = walk->middle;
    }
    compare_edge_begin(&walk->left, first_left, first_left == top ? left : right);
    compare_edge_begin(&walk->right, first_right, first_right == top ? right : left);
    return true;
}

bool compare_inside(const lmb_surface *surface, const lmb_vertex *vertices, unsigned count)
{
    const lmb_window *w = &surface->window;
    int32_t left = w->left * 16, right = w->right * 16, top = w->top * 16, bottom = w->bottom * 16;
    for (; count > 0; count--, vertices++) {
        if (vertices->x < left || vertices->x > right || vertices->y < top || vertices->y > bottom) return false;
    }
    return true;
}
