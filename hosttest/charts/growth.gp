# SPDX-License-Identifier: MIT
# What the charts of growth share: measured frames as points, what lmb-estimate says as lines. axis, from and to are set before.
measured(core, model) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\" && $4 == \"%s\" { print $3, ($12 == \"\" ? $11 : $12) / 1e6 }' '%s/../report/growth.csv'", \
    core, axis, model, data)
estimated(core, model) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\" && $4 == \"%s\" { print $3, $5 / 1e6 }' '%s/../report/growth_model.csv' | sort -n", \
    core, axis, model, data)
set logscale xy
set xrange [from:to]
set ylabel "million cycles a frame (RV32IMC: instructions)"
set key top left
set format y "%g"
