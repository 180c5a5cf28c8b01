# SPDX-License-Identifier: MIT
# height: 800
file = data . "/stability-lobes-absolute.dat"
title = "Lobes: absolute error against cos^n"
panels = "schlick gauss chebyshev_published w4 w8 w16 table256 chebyshev_refit lambent"
across = 3
low = -6
high = 0
load charts . "maps-lobes.gp"
load charts . "maps.gp"
