# SPDX-License-Identifier: MIT
set title "Paper 003, figure 5: coefficient C"
set xlabel "exponent n"
set ylabel "C"
set logscale x
set xrange [1:1000]
set yrange [0.998:1.014]
chosen(n) = n == 1 || n == 2 || n == 5 || n == 10 || n == 20 || n == 50 || n == 100 || n == 200 || n == 500 || n == 1000
f = data."/paper-003-figure-5.dat"
plot f u 1:2 w l lt 1 t "printed: 1", \
     f u 1:3 w l lt 3 t "refitted, by integrals", \
     f u 1:4 w l lt 4 t "refitted, at three nodes", \
     f u 1:(chosen($1) ? $5 : NaN) w p lt 2 t "our law, one cubic in 1/n"
