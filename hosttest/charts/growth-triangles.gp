# SPDX-License-Identifier: MIT
# Cost of a frame against the triangles of its mesh; report/growth.csv and growth_model.csv beside the data's folder.
axis = "triangles"; from = 15; to = 28000
load charts."growth.gp"
set title "A sphere of more and more triangles, 240 × 240 pixels, RGB565: measured (points), estimated (lines)"
set xlabel "triangles of the mesh"
set xtics (20, 80, 320, 1280, 5120, 20480)
set yrange [0.2:60]
set ytics (0.2, 0.5, 1, 2, 5, 10, 20, 50)
plot estimated("m0plus", "gloss") with lines lt 2 title "Cortex-M0+, gloss", measured("m0plus", "gloss") with points lt 2 ps 1.1 notitle, \
    estimated("m0plus", "diffuse") with lines lt 7 title "Cortex-M0+, diffuse", measured("m0plus", "diffuse") with points lt 7 ps 1.1 notitle, \
    estimated("m4", "gloss") with lines lt 3 title "Cortex-M4, gloss", measured("m4", "gloss") with points lt 3 ps 1.1 notitle, \
    estimated("rv32imc", "gloss") with lines lt 4 title "RV32IMC, gloss", measured("rv32imc", "gloss") with points lt 4 ps 1.1 notitle
