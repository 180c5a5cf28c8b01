# SPDX-License-Identifier: MIT
# Axes of maps over psi (43 columns, 0.01 to 179 degrees) and pixels (24 rows, 1 to 4096, two to an octave from 8 on).
at(psi) = 42 * log(psi / 0.01) / log(17900)
x_label = "{/Symbol y}, degrees"
y_label = "pixels"
x_tics = sprintf('set xtics ("0.01" %f, "0.1" %f, "1" %f, "10" %f, "90" %f)', at(0.01), at(0.1), at(1), at(10), at(90))
x_bare = sprintf('set xtics ("" %f, "" %f, "" %f, "" %f, "" %f)', at(0.01), at(0.1), at(1), at(10), at(90))
y_tics = 'set ytics ("1" 0, "8" 5, "64" 11, "512" 17, "4096" 23)'
y_bare = 'set ytics ("" 0, "" 5, "" 11, "" 17, "" 23)'
y_offset = 1.5
