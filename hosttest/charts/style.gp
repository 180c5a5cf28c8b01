# SPDX-License-Identifier: MIT
# What all charts share. Called with: ARG1 the chart's script, ARG2 the folder of its data, ARG3 the file to write (.svg or .png),
# ARG4 its height: charts are 800 wide, and as high as the line "# height: N" of their script says, or 500.
#
# Colours are those of Okabe and Ito, which the colour-blind tell apart; dashes and points tell lines apart in greyscale too.
# 1 is for what is exact or wanted, 2 for what is ours, the others for what is compared.

data = ARG2
height = int(ARG4)
name = system(sprintf("basename '%s' .gp", ARG1))
if (ARG3[strlen(ARG3)-3:] eq ".png") {
    set terminal pngcairo size 800,int(ARG4) font "DejaVu Sans,11" enhanced background rgb "white"
} else {
    set terminal svg size 800,int(ARG4) font "DejaVu Sans,13" enhanced background rgb "white"
}
set output ARG3
set encoding utf8

set linetype 1 lw 3.5 dt 1 lc rgb "#000000" pt 7 ps 0.6
set linetype 2 lw 2.5 dt 1 lc rgb "#D55E00" pt 5 ps 0.7
set linetype 3 lw 2 dt (12,5) lc rgb "#0072B2" pt 9 ps 0.8
set linetype 4 lw 2 dt (3,4) lc rgb "#009E73" pt 11 ps 0.8
set linetype 5 lw 2 dt (12,4,2,4) lc rgb "#CC79A7" pt 13 ps 0.8
set linetype 6 lw 2 dt (20,6) lc rgb "#56B4E9" pt 6 ps 0.8
set linetype 7 lw 2 dt (8,3,2,3,2,3) lc rgb "#E69F00" pt 4 ps 0.8
set linetype 8 lw 1.5 dt (2,2) lc rgb "#666666" pt 8 ps 0.8
set linetype cycle 8

set border 3 lw 1 lc rgb "#444444"
set tics nomirror out scale 0.6
set grid lc rgb "#DDDDDD" lw 1 dt 1
set key top right Left reverse samplen 4 spacing 1.15 opaque box lc rgb "#DDDDDD"
set samples 400

charts = ARG1[:strlen(ARG1) - strlen(system(sprintf("basename '%s'", ARG1)))]
load ARG1
