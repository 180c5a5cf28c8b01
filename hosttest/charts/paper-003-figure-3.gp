# SPDX-License-Identifier: MIT
set title "Paper 003, figure 3: coefficient A"
set xlabel "exponent n"
set ylabel "A, per square radian"
set xrange [0:1000]
f = data."/paper-003-figure-3.dat"
plot f u 1:2 w l lt 1 t "printed: −(0.272 n + 0.16)", \
     f u 1:3 w l lt 3 t "refitted, by integrals", \
     f u 1:4 every 7 w p lt 4 t "refitted, at three nodes", \
     f u 1:5 every 10 w p lt 2 t "our law, one cubic in 1/n"
