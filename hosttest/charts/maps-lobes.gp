# SPDX-License-Identifier: MIT
# Axes of maps over shininess (60 columns, 1 to 1000) and angle (90 rows, to a quarter turn).
at(n) = 59 * log(n) / log(1000)
x_label = "shininess n"
y_label = "angle, degrees"
x_tics = sprintf('set xtics ("1" %f, "10" %f, "100" %f, "1000" %f)', at(1), at(10), at(100), at(1000))
x_bare = sprintf('set xtics ("" %f, "" %f, "" %f, "" %f)', at(1), at(10), at(100), at(1000))
y_tics = 'set ytics ("0" -0.5, "30" 29.5, "60" 59.5, "90" 89.5)'
y_bare = 'set ytics ("" -0.5, "" 29.5, "" 59.5, "" 89.5)'
y_offset = 0.3
