# SPDX-License-Identifier: MIT
set title "Paper 000, figure 6: W_{8}, the paper's W_2, for n = 35"
set xlabel "angle between N and H, degrees"
set ylabel "intensity"
set xrange [0:45]
set yrange [0:1.05]
set key width 2
f = data."/paper-000-figure-6.dat"
plot f u 1:2 w l lt 1 t "cos^{35}", \
     f u 1:3 w l lt 3 t "W_{8}", \
     f u 1:4 every 8 w p lt 2 ps 0.9 t "Lambent"
