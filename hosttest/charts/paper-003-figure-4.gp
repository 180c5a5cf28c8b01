# SPDX-License-Identifier: MIT
set title "Paper 003, figure 4: coefficient B"
set xlabel "exponent n"
set ylabel "B, per radian"
set xrange [0:1000]
f = data."/paper-003-figure-4.dat"
plot f u 1:2 w l lt 1 t "printed, four pieces", \
     f u 1:3 w l lt 3 t "refitted, by integrals", \
     f u 1:4 w l lt 4 t "refitted, at three nodes", \
     f u 1:5 every 10 w p lt 2 t "our law, n^{1/2} times a cubic in 1/n"
