# SPDX-License-Identifier: MIT
# Errors of the ways along a span of 240 pixels, over the angle by which its normal turns.
file = data."/paper-001-error-psi.dat"
set multiplot layout 1,2 title "Largest error of N·L along 240 pixels, integer kernels" offset 0,0.2 margins 0.095,0.975,0.115,0.865 spacing 0.03
set logscale xy
set xrange [0.1:120]
set yrange [1e-7:1e5]
set format y "10^{%L}"
set xtics (0.1, 1, 10, 90)
set ytics 1e-7,10,1
set xlabel "ψ, degrees"
set ylabel "error, full scale is 1"
set key top left
set arrow 1 from graph 0,first 0.00196 to graph 1,first 0.00196 nohead lw 1 dt (4,4) lc rgb "#444444" back
set label 1 "half a level of 255" at 0.4,0.0011 font ",9" tc rgb "#444444" front
set title "the normal does not turn evenly"
plot for [i=1:6] file using "psi":(column(word("flat linear quadratic normalise_sqrt lyon_taylor reflection_map",i))) with lines lt i+2 \
    title word("flat linear quadratic normalise\\_sqrt lyon\\_taylor reflection\\_map",i)
set title "it turns evenly but for rounding"
unset ylabel
set format y ""
unset label 1
plot file using "psi":(column("plain16")) with lines lt 3 title "plain16, eq. 14", \
    "" using "psi":(column("block4")) with lines lt 4 title "block4, eq. 7 to 11 corrected", \
    "" using "psi":(column("eq7_vector16")) with lines lt 5 title "eq7\\_vector16, eq. 7", \
    "" using "psi":(column("kuijk_blake")) with lines lt 6 title "kuijk\\_blake", \
    "" using "psi":(column("plain32")) with lines lt 7 title "plain32, eq. 14", \
    "" using "psi":(column("lambent")) with lines lt 2 title "lambent"
unset multiplot
