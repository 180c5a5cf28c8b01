# SPDX-License-Identifier: MIT
# height: 1426
# Error and cost of what hosttest/pareto compares: see its pareto.c.
heading = "Frames: error before it is rounded to the format; RV32IMC"
kind = "frame"
load charts."panels.gp"
