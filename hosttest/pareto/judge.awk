# SPDX-License-Identifier: MIT
# Whether pareto.csv is whole and its fronts are fronts. usage: awk -f judge.awk missing.txt pareto.csv; a line pass or FAIL each.
# Methods that a scope has on any core in any scene of a format are expected on all others, but for what missing.txt names.
function matches(text, pattern) {
    gsub(/[.+]/, "[&]", pattern)
    gsub(/\*/, ".*", pattern)
    return text ~ ("^" pattern "$")
}
function verdict(good, text) { print (good ? "pass" : "FAIL") " pareto " text }
# Frames of one format have one list of methods; and those of the comparisons paint without depth.
function group(scope, scene) {
    if (scope != "frame") return scope
    return scope " " (scene ~ /rgb888$/ ? "rgb888" : scene ~ /^icosphere/ ? "rgb565" : "rgb565 deep")
}
function reason(core, scope, scene, method,    i, j, n, list) {
    for (i = 1; i <= reasons; i++) {
        if (r_core[i] != core || r_scope[i] != scope || !matches(scene, r_scene[i])) continue
        n = split(r_methods[i], list, ",")
        for (j = 1; j <= n; j++) if (matches(method, list[j])) { used[i] = 1; return 1 }
    }
    return 0
}
FILENAME ~ /missing/ {
    if (/^#/ || NF < 5) next
    r_core[++reasons] = $1; r_scope[reasons] = $2; r_scene[reasons] = $3; r_methods[reasons] = $4
    next
}
FNR == 1 {
    header = $0 == "core,scope,scene,method,cycles,unit,max_abs_error,rms_error,psnr_db,bytes,on_front"
    FS = ","
    next
}
{
    n = split($0, f, ",")
    rows++
    key = f[1] "," f[2] "," f[3]
    if (n != 11 || (key "," f[4]) in there) bad = bad " " FNR
    there[key "," f[4]] = 1
    panel[key] = 1
    scenes[f[2] "," f[3]] = 1
    cores[f[1]] = 1
    methods[group(f[2], f[3]) "," f[4]] = 1
    psnr = f[8] > 1.2e-5 ? -20 * log(f[8]) / log(10) : 99
    if (!(f[5] > 0 && f[10] > 0 && f[7] + 1e-7 >= f[8] && f[8] >= 0 && (psnr - f[9]) ^ 2 < 0.25)) bad = bad " " FNR
    if (f[6] !~ /^(cycles|instructions)\/(pixel|evaluation)$/ || (f[6] ~ /^instr/) != (f[1] == "rv32imc")) bad = bad " " FNR
    i = ++count[key]
    cost[key, i] = f[5] + 0; error[key, i] = f[7] + 0; front[key, i] = f[11] + 0; name[key, i] = f[4]
}
# By cost, then by error: a point is on the front if it errs less than all that are cheaper, or is the same as the one before.
function front_of(key,    i, j, k, order, least, wrong, last, want) {
    for (i = 1; i <= count[key]; i++) {
        for (j = i; j > 1; j--) {
            k = order[j - 1]
            if (cost[key, k] < cost[key, i] || (cost[key, k] == cost[key, i] && error[key, k] <= error[key, i])) break
            order[j] = k
        }
        order[j] = i
    }
    least = 1e300
    for (j = 1; j <= count[key]; j++) {
        i = order[j]
        want = error[key, i] < least || (j > 1 && last && cost[key, i] == cost[key, order[j - 1]] && error[key, i] == error[key, order[j - 1]])
        if (want != front[key, i]) wrong = wrong " " name[key, i]
        if (error[key, i] < least) least = error[key, i]
        last = want
    }
    return wrong
}
END {
    verdict(header && rows > 0, "header: the columns that are promised, " rows " rows")
    verdict(bad == "" && rows > 0, "rows: eleven sound figures each, no row twice" (bad == "" ? "" : "; but lines" bad))
    for (core in cores) for (s in scenes) for (m in methods) {
        split(s, a, ","); split(m, b, ",")
        if (group(a[1], a[2]) != b[1]) continue
        if ((core "," s "," b[2]) in there) { if (reason(core, a[1], a[2], b[2])) surplus = surplus " " core "," s "," b[2] }
        else if (!reason(core, a[1], a[2], b[2])) missing = missing " " core "," s "," b[2]
        else excused++
    }
    ncores = 0
    for (core in cores) ncores++
    verdict(missing == "" && ncores == 4, "methods: every one on " ncores " cores in every scene, " excused + 0 " absences with a reason" (missing == "" ? "" : "; but not" substr(missing, 1, 300)))
    unused = ""
    for (i = 1; i <= reasons; i++) if (!used[i]) unused = unused " " i
    verdict(surplus == "" && unused == "", "absences: each reason is needed" (unused == "" ? "" : "; but not" unused) (surplus == "" ? "" : "; there are" substr(surplus, 1, 300)))
    for (key in panel) { w = front_of(key); panels++; if (w != "") off = off "; " key ":" w }
    verdict(off == "", "fronts: those of " panels " panels found again" (off == "" ? "" : off))
}
