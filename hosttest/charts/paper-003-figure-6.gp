# SPDX-License-Identifier: MIT
set title "Paper 003, figure 6: the parabola against cos^{32}"
set xlabel "angle x, degrees"
set ylabel "intensity"
set xrange [0:40]
set yrange [0:1.05]
f = data."/paper-003-figure-6.dat"
plot f u 1:2 w l lt 1 t "cos^{32} x", \
     f u 1:3 w l lt 3 t "A x^2 + B x + C, as printed", \
     f u 1:4 w l lt 4 t "the same, refitted", \
     f u 1:5 every 8 w p lt 2 ps 0.9 t "Lambent"
