/* SPDX-License-Identifier: MIT */
/* What each method does outside of its safe region. */
#include "stability.h"

#include <string.h>

/* By kind and the beginning of a method's name; the longest that fits counts. */
static const struct words {
    const char *kind, *method, *outside;
} words[] = {
    {"span", "flat", "one value for the span: the whole change along it is lost"},
    {"span", "linear", "the bulge of the arc is cut off: 1 - cos(psi / 2) at any length"},
    {"span", "quadratic", "the cubic part is lost: psi^3 / 125 and from some 60 degrees on more"},
    {"span", "normalise",
     "normals run faster in the middle than at the ends; opposite ones meet at zero and have no direction there"},
    {"span", "float_", "as its form in double, nearly"},
    {"span", "slerp", "opposite normals span no plane"},
    {"span", "kuijk_blake", "opposite normals span no plane; near them the sine of their angle has few bits"},
    {"span", "lyon_taylor", "as normalise; beyond some 60 degrees three terms of the series no longer reach unit length"},
    {"span", "forward_length", "as normalise"},
    {"span", "reflection_map", "as coarse as its cells at any angle"},
    {"span", "eq7", "rounding 2 cos(phi) loses the angle where phi is small: errors grow with the square of the length"},
    {"span", "eq14", "only opposite normals: they span no plane"},
    {"span", "plain", "rounding 2 cos(phi) loses the angle where phi is small: errors grow with the square of the length"},
    {"span", "block", "the recurrence of eq. 7 in longer strides: errors grow as there"},
    {"span", "block3_printed", "does not hold: at phi = 0 it does not give back a constant"},
    {"span", "block4_printed", "does not hold: at phi = 0 it does not give back a constant"},
    {"span", "lambent", "beyond 120 degrees terms run linearly by choice; nothing wraps"},
    {"lobe", "phong", "R.V is another angle: it meets N.H up to the fourth power of the angle"},
    {"lobe", "blinn", "nowhere: it is the definition"},
    {"lobe", "powf", "nowhere: it is the definition"},
    {"lobe", "acosf", "as chebyshev_published: the same with the angle by arccos"},
    {"lobe", "float-squarings", "as w16"},
    {"lobe", "float-schlick", "as schlick"},
    {"lobe", "schlick", "too wide; never reaches zero: five times cos^n where that is 0.05"},
    {"lobe", "gauss", "for small n the cosine falls to zero sooner than its exponential"},
    {"lobe", "w", "too dark below the middle; n below m wants fewer squarings; past its zero it grows again unless clamped"},
    {"lobe", "lyon", "as w16: the same function of the angle"},
    {"lobe", "chebyshev", "a parabola: zero where cos^n is still 0.2; past that it falls without end unless clamped"},
    {"lobe", "table", "one of 256 entries: where n is large cos^n falls within a few of them"},
    {"lobe", "lambent", "nowhere; past its zero it would grow again and is clamped"},
    {"turned", "linear", "nowhere"},
    {"turned", "normalise", "nowhere"},
    {"turned", "quadratic", "nowhere"},
    {"turned", "lambent_linear", "nowhere"},
    {"turned", "lambent_quadratic", "nowhere"},
    {"turned", "rows", "what a point gets depends on how the triangle lies on the screen"},
    {"turned", "slerp", "what a point gets depends on how the triangle lies on the screen"},
    {"turned", "lambent_arc", "as slerp: rows are what the method is"},
};

const char *stability_outside(const char *kind, const char *method)
{
    const char *found = NULL;
    size_t best = 0;
    unsigned i;
    for (i = 0; i < sizeof words / sizeof words[0]; i++) {
        const size_t length = strlen(words[i].method);
        if (length <= best || strcmp(kind, words[i].kind) || strncmp(method, words[i].method, length)) continue;
        best = length;
        found = words[i].outside;
    }
    return found;
}
