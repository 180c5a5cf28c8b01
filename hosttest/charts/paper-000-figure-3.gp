# SPDX-License-Identifier: MIT
set title "Paper 000, figure 3: the highlight for n = 100"
set xlabel "angle between N and H, degrees"
set ylabel "intensity"
set xrange [0:30]
set yrange [0:1.05]
set key width 2
f = data."/paper-000-figure-3.dat"
plot f u 1:2 w l lt 1 t "cos^{100}", \
     f u 1:3 w l lt 3 t "W_2 (m = 2)", \
     f u 1:4 w l lt 4 t "Schlick", \
     f u 1:5 every 8 w p lt 2 ps 0.9 t "Lambent"
