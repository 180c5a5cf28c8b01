# SPDX-License-Identifier: MIT
# Cost of a frame against the rows of its strips; report/growth.csv and growth_model.csv beside the data's folder.
axis = "rows"; from = 1.7; to = 300
load charts."growth.gp"
set title "A sphere of 1280 triangles in lower and lower strips: measured (points), estimated (lines)"
set xlabel "rows of a strip of 240 × 240 pixels (240: the whole frame)"
set xtics (2, 4, 8, 16, 30, 60, 120, 240)
set yrange [1:40]
set ytics (1, 2, 5, 10, 20, 40)
set key top right
plot estimated("m0plus", "gloss") with lines lt 2 title "Cortex-M0+", measured("m0plus", "gloss") with points lt 2 ps 1.1 notitle, \
    estimated("m4", "gloss") with lines lt 3 title "Cortex-M4", measured("m4", "gloss") with points lt 3 ps 1.1 notitle, \
    estimated("rv32imc", "gloss") with lines lt 4 title "RV32IMC", measured("rv32imc", "gloss") with points lt 4 ps 1.1 notitle, \
    axis = "rows-anew", estimated("m0plus", "gloss") with lines lt 8 title "Cortex-M0+, vertices projected anew", \
    measured("m0plus", "gloss") with points lt 8 ps 1.1 notitle
