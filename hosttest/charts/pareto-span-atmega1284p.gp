# SPDX-License-Identifier: MIT
# height: 746
# Error and cost of what hosttest/pareto compares: see its pareto.c.
heading = "Along a span: error of N·L, set-up in the cost; ATmega1284P"
kind = "span"
load charts."panels.gp"
