# SPDX-License-Identifier: MIT
# Errors of the ways along a span over its length, the normal turning by 15 and by 90 degrees.
set multiplot layout 1,2 title "Largest error of N·L over the length of the span, integer kernels" offset 0,0.2 margins 0.095,0.975,0.115,0.865 spacing 0.03
set logscale xy
set xrange [1:4096]
set yrange [1e-7:1e5]
set format y "10^{%L}"
set xtics (1, 10, 100, 1000)
set ytics 1e-7,10,10
set xlabel "pixels"
set ylabel "error, full scale is 1"
set key top left
set arrow 1 from graph 0,first 0.00196 to graph 1,first 0.00196 nohead lw 1 dt (4,4) lc rgb "#444444" back
do for [psi in "15 90"] {
    file = data."/paper-001-error-length-".psi.".dat"
    set title "ψ = ".psi."°"
    if (psi eq "90") { unset ylabel; set format y ""; unset key }
    plot file using 1:(column("linear")) with lines lt 8 title "linear", \
        "" using 1:(column("quadratic")) with lines lt 4 title "quadratic", \
        "" using 1:(column("normalise_sqrt")) with lines lt 3 title "normalise\\_sqrt", \
        "" using 1:(column("kuijk_blake")) with lines lt 6 title "kuijk\\_blake", \
        "" using 1:(column("plain16")) with lines lt 5 title "plain16, eq. 14", \
        "" using 1:(column("plain32")) with lines lt 7 title "plain32, eq. 14", \
        "" using 1:(column("lambent")) with lines lt 2 title "lambent"
}
unset multiplot
