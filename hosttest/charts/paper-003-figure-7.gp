# SPDX-License-Identifier: MIT
set title "Paper 003, figure 7: relative error of the parabola against cos^n"
set xlabel "n^{1/2} x, radians"
set ylabel "relative error, %"
set xrange [0:1.6]
set yrange [-12:6]
set key bottom left
set arrow from 0,2 to 1.6,2 nohead lt 8
set arrow from 0,-2 to 1.6,-2 nohead lt 8
set label "the paper's ±2 %" at 1.58,2.5 right textcolor rgb "#666666"
f = data."/paper-003-figure-7.dat"
plot f u 1:2 w l lt 3 t "as printed, n = 8", \
     f u 1:3 w l lt 4 t "as printed, n = 31", \
     f u 1:4 w l lt 5 t "as printed, n = 255", \
     f u 1:5 w l lt 7 lw 3 t "refitted, n = 255", \
     f u 1:6 w l lt 6 t "W_{16} of paper 000", \
     f u 1:7 w l lt 2 t "Lambent"
