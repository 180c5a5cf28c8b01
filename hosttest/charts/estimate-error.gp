# SPDX-License-Identifier: MIT
# How far lmb-estimate is off on frames that it was not fitted on; report/estimate.csv beside the data's folder.
frames(core) = sprintf("< awk -F, '$1 == \"%s\" { print $(NF - 2) / 1e6, 100 * $NF }' '%s/../report/estimate.csv'", core, data)
set title "Estimate beside profiler: frames of models, poses and materials on which nothing was fitted"
set xlabel "million cycles a frame (RV32IMC: instructions)"
set ylabel "estimate beyond what was measured, %"
set logscale x
set xrange [0.2:30]
set xtics (0.2, 0.5, 1, 2, 5, 10, 20)
set yrange [-12:12]
set ytics -10,5,10
set arrow 1 from graph 0,first 10 to graph 1,first 10 nohead lw 1 dt (4,4) lc rgb "#444444" back
set arrow 2 from graph 0,first -10 to graph 1,first -10 nohead lw 1 dt (4,4) lc rgb "#444444" back
set label 1 "what is promised" at graph 0.02,first 10.8 font ",9" tc rgb "#444444"
set key bottom right horizontal
plot frames("m0plus") with points lt 2 ps 1 title "Cortex-M0+", frames("m4") with points lt 3 ps 1 title "Cortex-M4", \
    frames("rv32imc") with points lt 4 ps 1 title "RV32IMC"
