# SPDX-License-Identifier: MIT
# Maps of errors, several to a chart. Before it is loaded: file, title and panels as words, across, low, high.
# Columns and rows are set by maps-spans.gp or maps-lobes.gp. Errors as colours: luminance rises with them, so greyscale reads the
# same, and jumps at a level of 255.

n = words(panels)
down = int(ceil(n / (across + 0.0)))
set multiplot layout down,across margins 0.10,0.90,0.10,0.88 spacing 0.035,0.075 title title font ",14"
set cbrange [low:high]
level = -2.41 # 1/255
set palette defined (low "#00224E", level "#7A93B5", level "#D9A92C", high "#FFF9CC")
unset key
unset grid
set border 15
set tics scale 0.4 out nomirror
set format x ""
set format y ""
do for [i = 0:n - 1] {
    last_row = i >= n - across
    left = i % across == 0
    right_top = i == across - 1
    set title word(panels, i + 1) noenhanced offset 0,-0.8
    if (last_row) { set xlabel x_label offset 0,0.6; eval x_tics } else { unset xlabel; eval x_bare }
    if (left) { set ylabel y_label offset y_offset,0; eval y_tics } else { unset ylabel; eval y_bare }
    if (right_top) {
        set colorbox user origin 0.915,0.10 size 0.02,0.80
        set cbtics scale 0 format "10^{%g}"
    } else { unset colorbox }
    plot file index i matrix with image
}
unset multiplot
