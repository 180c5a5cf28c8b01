# SPDX-License-Identifier: MIT
# A heading, a key and the panels that papers/panels.c writes, whose places are in pixels. Before it is loaded: heading, and kind:
# lobe, span or frame.

set multiplot
set border 0
unset tics
unset key
unset grid
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 0
set xrange [0:800]
set yrange [height:0]
set label heading at 400,16 center font ",14"
set label "others" at 76,38 left point pt 7 ps 0.8 lc rgb "#0072B2" offset 0.8,0 font ",10"
set label kind eq "frame" ? "the planner, by tolerance" : "ours" at 152,38 left point pt 5 ps 0.9 lc rgb "#D55E00" offset 0.8,0 font ",10"
if (kind eq "frame") {
    set label "fixed choices; dots: other tolerances" at 346,38 left point pt 9 ps 1 lc rgb "#009E73" offset 0.8,0 font ",10"
}
set arrow from 604,38 to 630,38 nohead lw 4 lc rgb "#DDCCBB"
set label "the front" at 636,38 left font ",10"
set arrow from 708,38 to 732,38 nohead lw 1 dt (4,4) lc rgb "#777777"
set label "a level" at 738,38 left font ",10"
plot NaN
set border 3
set grid
set xtics nomirror out scale 0.6 font ",10"
set ytics nomirror out scale 0.6
load data."/".name.".dat"
unset multiplot
