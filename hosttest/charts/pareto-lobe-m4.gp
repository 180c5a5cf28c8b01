# SPDX-License-Identifier: MIT
# height: 1086
# Error and cost of what hosttest/pareto compares: see its pareto.c.
heading = "The lobe: error of one evaluation; Cortex-M4"
kind = "lobe"
load charts."panels.gp"
