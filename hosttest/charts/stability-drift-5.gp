# SPDX-License-Identifier: MIT
file = data . "/stability-drift-5.dat"
set title "Drift along a span of 4096 pixels between normals 5° apart"
set xlabel "pixel"
set ylabel "largest error so far"
set logscale xy
set format y "10^{%T}"
set xrange [1:4096]
set xtics (1, 8, 64, 512, 4096)
set key top left
set arrow from 1,0.00392 to 4096,0.00392 nohead lc rgb "#888888" lw 1
set label "a level of 255" at 4096,0.00549 right textcolor rgb "#666666"
plot file using 1:2 with lines lt 2 title "lambent", \
    file using 1:3 with lines lt 3 title "plain16 (eq. 14)", \
    file using 1:4 with lines lt 4 title "plain32 (eq. 14)", \
    file using 1:5 with lines lt 5 title "block4\\_32 (eq. 8-11)", \
    file using 1:6 with lines lt 7 title "eq7\\_vector32"
