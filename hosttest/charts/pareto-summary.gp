# SPDX-License-Identifier: MIT
# height: 442
# The frame that most is measured on, by every means.
heading = "A sphere of 1280 triangles with highlight, RGB565, 240 × 240; Cortex-M0+"
kind = "frame"
load charts."panels.gp"
