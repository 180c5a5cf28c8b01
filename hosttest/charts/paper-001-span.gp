# SPDX-License-Identifier: MIT
# One span as it is shaded: the cosine, and the highlight that is its 64th power.
file = data."/paper-001-span.dat"
set multiplot layout 1,2 title "A span of 240 pixels whose normal turns by 90°" offset 0,0.2 margins 0.075,0.975,0.115,0.865 spacing 0.08
set xrange [0:240]
set xtics 0,60,240
set xlabel "pixel"
power(x, n) = x > 0 ? x ** n : 0
set key bottom left width -1
set yrange [-0.1:1.2]
set ytics 0,0.2,1.2
set title "N·H"
plot file using 1:(column("exact")) with lines lt 1 title "exact, eq. 2", \
    "" using 1:(column("lambent")) every 12 with points lt 2 ps 0.9 title "lambent", \
    "" using 1:(column("normalise_sqrt")) with lines lt 3 title "normalise\\_sqrt", \
    "" using 1:(column("quadratic")) with lines lt 4 title "quadratic", \
    "" using 1:(column("linear")) with lines lt 8 title "linear", \
    "" using 1:(column("plain16")) with lines lt 5 title "plain16, eq. 14", \
    "" using 1:(column("block4")) with lines lt 7 title "block4, corrected"
set title "(N·H)^{64}"
unset key
plot file using 1:(power(column("exact"), 64)) with lines lt 1, \
    "" using 1:(power(column("lambent"), 64)) every 12 with points lt 2 ps 0.9, \
    "" using 1:(power(column("normalise_sqrt"), 64)) with lines lt 3, \
    "" using 1:(power(column("quadratic"), 64)) with lines lt 4, \
    "" using 1:(power(column("linear"), 64)) with lines lt 8, \
    "" using 1:(power(column("plain16"), 64)) with lines lt 5, \
    "" using 1:(power(column("block4"), 64)) with lines lt 7
unset multiplot
