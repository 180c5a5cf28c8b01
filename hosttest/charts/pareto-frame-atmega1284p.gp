# SPDX-License-Identifier: MIT
# height: 406
# Error and cost of what hosttest/pareto compares: see its pareto.c.
heading = "Frames: error before it is rounded to the format; ATmega1284P"
kind = "frame"
load charts."panels.gp"
