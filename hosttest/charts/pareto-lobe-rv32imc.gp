# SPDX-License-Identifier: MIT
# height: 1086
# Error and cost of what hosttest/pareto compares: see its pareto.c.
heading = "The lobe: error of one evaluation; RV32IMC"
kind = "lobe"
load charts."panels.gp"
