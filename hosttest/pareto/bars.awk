# SPDX-License-Identifier: MIT
# The figures that pareto.csv is judged by, a line each: NAME CORE SCENE FIGURE TEXT.
#
#   planned   per cent that the planner's frame, at the tolerance that paints set, takes more than the fastest fixed choice that is as
#             good: whose error, at whatever tolerance, is within half a level of the format or the planner's own error
#   curve     per cent that the planner's frames over tolerances take more, at worst, than the cheapest of anyone's of no greater error
#   arcs      times that the planner's frame is faster than arcs everywhere: on RGB888 with four squarings, on RGB565 looked up, as the
#             paint has it
#   lobes     per cent that the tuned lobe takes more than a rival, where that is no more accurate: the cheapest of the tuned ones. Not
#             above zero: the rival is dominated. 99999: none of ours is as accurate. SCENE is n-N:RIVAL
#   ways      the same of the library's arc and other ways along a span; SCENE is psi-...:RIVAL
BEGIN { FS = ","; inf = 1e9 }
NR == 1 { next }
{
    key = $1 FS $2 FS $3
    if (!(key in count)) { order[++keys] = key; core[keys] = $1; scope[keys] = $2; scene[keys] = $3 }
    n = ++count[key]
    name[key, n] = $4; cost[key, $4] = $5; error[key, $4] = $7
}
function is_ours(method) { return method ~ /^(lambent|tuned)/ }
function within(key, limit, fixed,    i, m, best) { # the cheapest of no greater error
    best = ""
    for (i = 1; i <= count[key]; i++) {
        m = name[key, i]
        if (fixed && (m ~ /^planned/ || m !~ /^(flat|gouraud|linear|quadratic|arc)/)) continue
        if (error[key, m] <= limit && (best == "" || cost[key, m] < cost[key, best])) best = m
    }
    return best
}
function more(a, b) { return 100 * (a / b - 1) }
function frame(k,    key, limit, best, i, m, c, worst, where, arc) {
    key = order[k]
    limit = scene[k] ~ /rgb888/ ? 0.5 / 255 : 0.5 / 63
    if (error[key, "planned"] > limit) limit = error[key, "planned"]
    best = within(key, limit, 1)
    printf "planned %s %s %.1f %.1f against %.1f of %s, errors %.5f and %.5f\n", core[k], scene[k], more(cost[key, "planned"], cost[key, best]),
        cost[key, "planned"], cost[key, best], best, error[key, "planned"], error[key, best]
    worst = -inf
    for (i = 1; i <= count[key]; i++) {
        m = name[key, i]
        if (m !~ /^planned\//) continue
        best = within(key, error[key, m], 0)
        c = more(cost[key, m], cost[key, best])
        if (c > worst) { worst = c; where = m " " sprintf("%.1f", cost[key, m]) " against " sprintf("%.1f", cost[key, best]) " of " best }
    }
    printf "curve %s %s %.1f %s\n", core[k], scene[k], worst, where
    arc = scene[k] ~ /rgb888/ ? "arc-w16" : "arc"
    printf "arcs %s %s %.2f %.1f against %.1f of %s\n", core[k], scene[k], cost[key, arc] / cost[key, "planned"], cost[key, "planned"], cost[key, arc], arc
}
function rivals(k, what,    key, i, j, m, o, best) {
    key = order[k]
    for (i = 1; i <= count[key]; i++) {
        m = name[key, i]
        if (is_ours(m)) continue
        best = ""
        for (j = 1; j <= count[key]; j++) {
            o = name[key, j]
            if (is_ours(o) && error[key, o] <= error[key, m] && (best == "" || cost[key, o] < cost[key, best])) best = o
        }
        if (best == "") printf "%s %s %s:%s 99999 none of ours errs as little as %.7f\n", what, core[k], scene[k], m, error[key, m]
        else printf "%s %s %s:%s %.1f %.2f of %s against %.2f, errors %.5f and %.5f\n", what, core[k], scene[k], m, \
            more(cost[key, best], cost[key, m]), cost[key, best], best, cost[key, m], error[key, best], error[key, m]
    }
}
END {
    for (k = 1; k <= keys; k++) {
        if (scope[k] == "frame") frame(k)
        if (scope[k] == "lobe") rivals(k, "lobes")
        if (scope[k] == "span") rivals(k, "ways")
    }
}
