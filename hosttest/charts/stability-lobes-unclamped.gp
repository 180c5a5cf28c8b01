# SPDX-License-Identifier: MIT
# height: 600
file = data . "/stability-lobes-unclamped.dat"
title = "Lobes before their clamp: absolute error"
panels = "w2 w4 w8 w16 chebyshev_published lambent"
across = 3
low = -6
high = 6
load charts . "maps-lobes.gp"
load charts . "maps.gp"
