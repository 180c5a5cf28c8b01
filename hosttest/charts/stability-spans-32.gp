# SPDX-License-Identifier: MIT
# height: 800
file = data . "/stability-spans-32.dat"
title = "Largest error along a span, 32-bit arithmetic"
panels = "linear quadratic lyon_taylor kuijk_blake plain32 block4_32 eq7_vector32 normalise_textbook lambent"
across = 3
low = -6
high = 0
load charts . "maps-spans.gp"
load charts . "maps.gp"
