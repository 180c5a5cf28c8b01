# SPDX-License-Identifier: MIT
set title "Paper 000, figure 4: largest relative error up to the inflection of cos^n"
set xlabel "exponent n"
set ylabel "relative error, %; lower edge: less or none"
set logscale xy
set xrange [2:1000]
set xtics (2, 4, 8, 16, 32, 64, 125, 250, 500, 1000)
set yrange [0.003:30]
shown(e) = e > 0.003 ? e : 0.003
set key bottom right
set key width 2
f = data."/paper-000-figure-4.dat"
plot f u 1:(shown($3)) w l lt 4 t "Schlick", \
     f u 1:(shown($2)) w l lt 3 t "W_2 (m = 2)", \
     f u 1:(shown($4)) w l lt 2 t "Lambent"
