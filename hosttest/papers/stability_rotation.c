/* SPDX-License-Identifier: MIT */
/* Up to which angle between corners a triangle keeps its shading within a level when it is turned on the screen (rotation.h). */
#include "stability.h"

#include "rotation.h"

#define ANGLES 30 /* of 3 degrees each */

static double spread_of(enum rotation_way way, double degrees)
{
    double worst = 0;
    unsigned shape;
    for (shape = 0; shape < 3; shape++) {
        const rotation_case c = rotation_make(degrees, shape);
        worst = fmax(worst, rotation_spread(&c, way, 1));
    }
    return worst;
}

int stability_of_rotation(stability_row *out, int room)
{
    int way, i, n = 0;
    for (way = 0; way < ROTATION_WAYS && n + 2 <= room; way++, n += 2) {
        double worst = 0, inside = 0;
        int safe = 0;
        for (i = 1; i <= ANGLES; i++) {
            worst = fmax(worst, spread_of((enum rotation_way)way, 3 * i));
            if (worst <= STABILITY_LEVEL) safe = i, inside = worst;
        }
        for (i = 0; i < 2; i++) {
            out[n + i].kind = "turned";
            out[n + i].method = rotation_name[way];
            out[n + i].arithmetic = rotation_is_integer((enum rotation_way)way) ? "32-bit" : "double";
        }
        snprintf(out[n].region, sizeof out[n].region, safe ? "turned by 360 deg; psi <= %d deg" : "none", 3 * safe);
        out[n].max_abs_error = inside;
        out[n].safe = safe > 0;
        snprintf(out[n + 1].region, sizeof out[n + 1].region, "everywhere: turned by 360 deg; psi 3 to %d deg", 3 * ANGLES);
        out[n + 1].max_abs_error = worst;
        out[n + 1].safe = worst <= STABILITY_LEVEL;
    }
    return n;
}
