# SPDX-License-Identifier: MIT
# Instructions beside errors of the ways along a span; instructions from the profiler's report beside the data's folder.
points = "< awk -F'[, ]' '".\
    "FILENAME ~ /kernel_cycles/ { if ($1 == \"m0plus\") cost[$2] = $4; next } ".\
    "(\"step-\" $1) in cost { print $1, cost[\"step-\" $1] + cost[\"step-\" $1 \"-setup\"] / 32, $2, $3 }' ".\
    data."/../report/kernel_cycles.csv ".data."/paper-001-cost.dat"
set multiplot layout 1,2 title "Largest error of N·L along 240 pixels; Cortex-M0+, spans of 32 pixels with their set-up" \
    offset 0,0.2 margins 0.095,0.975,0.115,0.865 spacing 0.03
set logscale xy
set xrange [4:12000]
set yrange [1e-6:30]
set format y "10^{%L}"
set xtics (10, 100, 1000)
set ytics 1e-6,10
set xlabel "instructions a pixel"
set ylabel "error, full scale is 1"
unset key
set arrow 1 from graph 0,first 0.00196 to graph 1,first 0.00196 nohead lw 1 dt (4,4) lc rgb "#444444" back
set label 1 "half a level of 255" at 4.5,0.0028 font ",9" tc rgb "#444444"
# What lies on another point is shown, but not named.
unnamed = " block2 block3 block4 block4_32 forward_length normalise_textbook float_normalise_textbook "
# Names run up, down, left or right from their points, so that they do not run into each other.
side(name, k) = strstrt(k == 3 ? " plain32 kuijk_blake " : \
    " lyon_taylor normalise_multiply normalise_sqrt kuijk_blake plain32 ", " ".name." ") ? "down" : \
    strstrt(k == 3 ? " quadratic lyon_taylor linear lambent " : " quadratic linear lambent ", " ".name." ") ? "left" : \
    name eq "eq7_vector32" || (k == 3 && name eq "reflection_map") ? "right" : "up"
shown(name) = strstrt(unnamed, " ".name." ") ? "" : name eq "lambent" ? "" : name
at(name, k, where) = side(name, k) eq where ? shown(name) : ""
ours(name, x) = name eq "lambent" ? x : NaN
do for [k=3:4] {
    set title k == 3 ? "ψ = 15°" : "ψ = 90°"
    if (k == 4) { unset ylabel; set format y ""; unset label 1 }
    plot points using 2:k with points pt 7 ps 0.7 lc rgb "#0072B2", \
        "" using 2:k:(at(strcol(1), k, "up")) with labels left rotate by 40 offset 0.4,0.4 font ",9" noenhanced, \
        "" using 2:k:(at(strcol(1), k, "down")) with labels left rotate by -40 offset 0.4,-0.4 font ",9" noenhanced, \
        "" using 2:k:(at(strcol(1), k, "left")) with labels right offset -0.7,0 font ",9" noenhanced, \
        "" using 2:k:(at(strcol(1), k, "right")) with labels left offset 0.8,-0.4 font ",9" noenhanced, \
        "" using (ours(strcol(1), $2)):k with points lt 2 ps 1.3, \
        "" using (ours(strcol(1), $2)):k:(strcol(1)) with labels right offset -0.9,0 font ",11" tc rgb "#D55E00"
}
unset multiplot
