# SPDX-License-Identifier: MIT
file = data . "/stability-rotation.dat"
set title "One point of a triangle that is turned on the screen by 360°"
set xlabel "angle between corners' normals, degrees"
set ylabel "spread of N.L"
set logscale y
set format y "10^{%T}"
set xrange [0:90]
set yrange [1e-6:1]
set key bottom right
set arrow from 0,0.00392 to 90,0.00392 nohead lc rgb "#888888" lw 1
set label "a level of 255" at 1,0.00588 left textcolor rgb "#666666"
plot file using 1:4 with linespoints lt 2 title "lambent, arcs by rows", \
    file using 1:5 with linespoints lt 6 title "lambent, quadratic", \
    file using 1:2 with lines lt 3 title "slerp by rows (paper 001)", \
    file using 1:3 with lines lt 4 title "linear normals by rows"
