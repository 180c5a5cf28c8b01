# SPDX-License-Identifier: MIT
# height: 600
file = data . "/stability-spans-16.dat"
title = "Largest error along a span, 16-bit arithmetic"
panels = "plain16 eq7_vector16 block4 normalise_sqrt forward_length reflection_map"
across = 3
low = -6
high = 0
load charts . "maps-spans.gp"
load charts . "maps.gp"
