# SPDX-License-Identifier: MIT
set title "Paper 003, figure 2: the epicentre, a row of a lit sphere through its highlight, n = 32"
set xlabel "pixel of the row"
set ylabel "level, of 255"
set xrange [0:240]
set yrange [0:270]
set key top left
f = data."/paper-003-figure-2.dat"
plot f u 1:2 w l lt 1 t "cos^{32}, exact", \
     f u 1:3 w l lt 3 t "paper 003, as printed", \
     f u 1:5 every 6 w p lt 2 ps 0.9 t "Lambent"
