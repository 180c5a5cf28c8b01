# SPDX-License-Identifier: MIT
set title "Paper 003, figure 1: cos^n x"
set xlabel "angle x, degrees"
set ylabel "intensity"
set xrange [-90:90]
set yrange [0:1.05]
set xtics 30
f = data."/paper-003-figure-1.dat"
plot f u 1:2 w l lt 3 t "n = 2", \
     f u 1:3 w l lt 4 t "n = 8", \
     f u 1:4 w l lt 1 t "n = 32", \
     f u 1:5 every 8 w p lt 2 t "Lambent, the same n", \
     f u 1:6 every 8 w p lt 2 notitle, \
     f u 1:7 every 4 w p lt 2 notitle
