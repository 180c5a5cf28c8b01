# SPDX-License-Identifier: MIT
set title "Paper 000, figure 9: largest relative error from the inflection to where cos^n = 0.2"
set xlabel "exponent n"
set ylabel "relative error, %; lower edge: less or none"
set logscale xy
set xrange [2:250]
set xtics (2, 4, 8, 16, 32, 64, 125, 250)
set yrange [0.005:300]
shown(e) = e > 0.005 ? e : 0.005
set key bottom right
f = data."/paper-000-figure-9.dat"
plot f u 1:(shown($6)) w l lt 7 t "Schlick", \
     f u 1:(shown($2)) w l lt 3 t "W_{4}, the paper's W_1", \
     f u 1:(shown($3)) w l lt 4 t "W_{8}, the paper's W_2", \
     f u 1:(shown($4)) w l lt 5 t "W_{16}, the paper's W_3", \
     f u 1:(shown($5)) w l lt 2 t "Lambent"
