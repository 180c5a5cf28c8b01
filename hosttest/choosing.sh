#!/bin/sh
# SPDX-License-Identifier: MIT
# The tables of docs/CHOOSING.md, between their marks, from build/report/*.csv; and whether what its prose says of them holds.
# usage: choosing.sh REPORT_FOLDER [--check]    (--check: compare only, exit status 1 if the page differs or its prose is wrong)
set -u
report=$1 mode=${2:-write} page=docs/CHOOSING.md
for f in cycles size kernel_cycles lobe image plan; do
    [ -s "$report/$f.csv" ] || { echo "choosing: $report/$f.csv is missing; run make choosing"; exit 1; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

# core CORE MHZ SCENES: what each choice costs and errs; frames a second of the first scene at so many MHz, where cycles are known. Errors
# are the worst of these scenes and of the same with tight highlights.
core() {
    awk -F, -v core="$1" -v mhz="$2" -v scenes="$3" '
        FNR == 1 { next }
        FILENAME ~ /size/ && $1 == core { flash[$2] = $3 + $4 + $5 }
        FILENAME ~ /\/cycles/ && $1 == core && $4 == "rgb565" { cost[$3, $2] = $8 == "" ? $7 : $8; pixels[$2] = $6 }
        FILENAME ~ /image/ && $3 == "rgb565" && $4 == "exact" { worst[$2, $1] = $8; off[$2, $1] = 100 - 100 * $9 }
        function judge(judged, s) {
            if (worst[judged, s] > most) most = worst[judged, s]
            if (off[judged, s] > share) share = off[judged, s]
        }
        function row(label, model, weighed, judged, i, s) {
            printf "| %s |", label
            most = share = 0
            for (i = 1; i <= n; i++) {
                s = scene[i]
                if (!((model, s) in cost) || !((judged, s) in worst) || !(weighed in flash)) exit failed = 1
                printf " %.1f |", cost[model, s]
                judge(judged, s)
                judge(judged, s "-tight")
            }
            if (mhz) printf " %.1f |", mhz * 1e6 / cost[model, scene[1]] / pixels[scene[1]]
            printf " %d | %d | %.2f %% |\n", flash[weighed], most, share
        }
        END {
            n = split(scenes, scene, " ")
            printf "| choice |"
            for (i = 1; i <= n; i++) printf " %s |", scene[i]
            printf "%s flash | largest error | off by more |\n|---|", mhz ? " frames/s at " mhz " MHz |" : ""
            for (i = 1; i <= n + (mhz ? 4 : 3); i++) printf "---|"
            print ""
            row("flat", "flat", "flat", "flat")
            row("Gouraud", "gouraud", "gouraud", "gouraud")
            row("diffuse, quadratic", "diffuse", "diffuse", "diffuse")
            row("gloss, quadratic", "gloss", "gloss", "gloss-quadratic")
            row("gloss, arcs", "gloss-arc", "arc", "gloss-arc")
            row("gloss, planned", "gloss-planned", "planned", "gloss-planned")
            exit failed
        }' "$report/size.csv" "$report/cycles.csv" "$report/image.csv"
}

cores() {
    scenes="icosphere-320 icosphere-1280 torus teapot"
    printf '**Cortex-M0+**\n\n'
    core m0plus 48 "$scenes" || return 1
    printf '\n**Cortex-M4**, nominal cycles\n\n'
    core m4 80 "$scenes" || return 1
    printf '\n**RV32IMC**, instructions in place of cycles, which no manual gives\n\n'
    core rv32imc 0 "$scenes" || return 1
    printf '\n**ATmega1284P**\n\n'
    core atmega1284p 20 "icosphere-128 icosphere-320" || return 1
    printf '\n**RV32EC**, no multiplier: instructions, and times those of RV32IMC\n\n'
    multiplier
}

# What is lost without a multiplier.
multiplier() {
    awk -F, -v scenes="icosphere-320 icosphere-1280 teapot" '
        FNR > 1 && $4 == "rgb565" { cost[$1, $3, $2] = $7 }
        function row(label, model, i, slow, fast) {
            printf "| %s |", label
            for (i = 1; i <= n; i++) {
                slow = cost["rv32ec", model, scene[i]]; fast = cost["rv32imc", model, scene[i]]
                if (!(slow > 0 && fast > 0)) exit failed = 1
                printf " %.0f (%.1f times) |", slow, slow / fast
            }
            print ""
        }
        END {
            n = split(scenes, scene, " ")
            print "| choice | icosphere-320 | icosphere-1280 | teapot |"
            print "|---|---|---|---|"
            row("Gouraud", "gouraud")
            row("gloss, quadratic", "gloss")
            row("gloss, arcs", "gloss-arc")
            row("gloss, planned", "gloss-planned")
            exit failed
        }' "$report/cycles.csv"
}

# Lobes reckoned for each pixel: errors of integers, cost of an evaluation.
lobes() {
    awk -F, '
        FNR == 1 { next }
        FILENAME ~ /kernel/ && $2 ~ /^lobe/ { cost[$1, $2] = $5 == "" ? $4 : $5 }
        FILENAME ~ /\/lobe/ && $3 == "integer" { error[$1, $2] = $6; if ($2 == 100) products[$1] = $4 }
        FILENAME ~ /image/ && $1 == "icosphere-320-tight" && $3 == "rgb888" && $4 == "exact" { levels[$2] = $8; psnr[$2] = $7 }
        function row(label, kernel, lobe, variant, c) {
            printf "| %s | %d | %.4f | %.4f | %.4f | %d (%.1f dB) |", label, products[lobe], error[lobe, 16], error[lobe, 100], \
                error[lobe, 1000], levels[variant], psnr[variant]
            for (c = 1; c <= n; c++) {
                if (!((cores[c], kernel) in cost) || !((lobe, 100) in error) || !(variant in levels)) exit failed = 1
                printf " %.0f |", cost[cores[c], kernel]
            }
            print ""
        }
        END {
            n = split("m0plus m4 rv32imc atmega1284p", cores, " ")
            print "| lobe | products | error, n = 16 | n = 100 | n = 1000 | icosphere-320-tight | M0+ | M4 | RV32IMC | ATmega1284P |"
            print "|---|---|---|---|---|---|---|---|---|---|"
            row("`LMB_LOBE_W2`", "lobe-w2", "w2", "gloss-w2")
            row("`LMB_LOBE_W4`", "lobe-w4", "w4", "gloss-w4")
            row("`LMB_LOBE_W8`", "lobe-w8", "w8", "gloss-w8")
            row("`LMB_LOBE_W16`", "lobe-w16", "w16", "gloss-w16")
            row("`LMB_LOBE_TUNED`", "lobe", "lambent", "gloss")
            exit failed
        }' "$report/kernel_cycles.csv" "$report/lobe.csv" "$report/image.csv"
}

# What the planner chooses, and how far whole frames are from exact.
planned() {
    awk -F, '
        FNR == 1 { next }
        FILENAME ~ /plan/ { ways[$1, $2] = ways[$1, $2] (ways[$1, $2] == "" ? "" : "; ") $5 " " $6 " " $7 " " $8 " " $9 }
        FILENAME ~ /image/ && $2 == "gloss-planned" && $4 == "exact" {
            if ($3 == "rgb565") order[++n] = $1
            error[$1, $3] = sprintf("%d, %.1f dB, %d", $8, $7, $10)
        }
        END {
            print "| scene | RGB565: ways of N.L; of the highlight | error, PSNR, seen | RGB888: ways | error, PSNR, seen |"
            print "|---|---|---|---|---|"
            for (i = 1; i <= n; i++) {
                s = order[i]
                if (!((s, "rgb565") in ways) || !((s, "rgb888") in ways) || !((s, "rgb888") in error)) exit 1
                printf "| %s | %s | %s | %s | %s |\n", s, ways[s, "rgb565"], error[s, "rgb565"], ways[s, "rgb888"], error[s, "rgb888"]
            }
            exit n == 0
        }' "$report/plan.csv" "$report/image.csv"
}

# Sentences of the page that a change of figures could make untrue: a line each.
prose() {
    awk -F, '
        FNR == 1 { next }
        FILENAME ~ /\/cycles/ && $4 == "rgb565" && $1 ~ /^(m0plus|m4|rv32imc|atmega1284p)$/ { cost[$1, $3, $2] = $7; where[$1 " " $2] }
        FILENAME ~ /image/ && $4 == "exact" && $8 > error[$2, $3] { error[$2, $3] = $8 }
        FILENAME ~ /image/ && $4 == "exact" && $2 == "gloss-quadratic" && $1 !~ /tight|still/ && $8 > error["broad", $3] { error["broad", $3] = $8 }
        function say(text, wrong) { print (wrong == "" ? "pass" : "FAIL") " choosing: " text (wrong == "" ? "" : "; but" wrong) }
        # where model a costs no more than model b, of cores that match
        function dearer(a, b, cores, w, at, wrong) {
            for (w in where) {
                split(w, at, " ")
                if (at[1] ~ cores && !(cost[at[1], a, at[2]] > cost[at[1], b, at[2]])) wrong = wrong " not on " w
            }
            return wrong
        }
        function most(model, format, levels) { return error[model, format] <= levels ? "" : " " error[model, format] }
        END {
            say("Gouraud costs more than gloss by quadratics on M0+, M4 and ATmega1284P", dearer("gouraud", "gloss", "m0plus|m4|atmega"))
            say("arcs cost more than planned frames", dearer("gloss-arc", "gloss-planned", "."))
            say("quadratics are within 2 levels of RGB565 where n = 16", most("broad", "rgb565", 2))
            say("and are not where highlights are tight", most("gloss-quadratic", "rgb565", 2) == "" ? " they are" : "")
            say("planned frames and arcs are within 1 level",
                most("gloss-planned", "rgb565", 1) most("gloss-planned", "rgb888", 1) most("gloss-arc", "rgb565", 1) most("gloss-arc", "rgb888", 1))
        }' "$report/cycles.csv" "$report/image.csv"
}

cp "$page" "$work/page"
for name in cores lobes planned; do
    {
        echo "<!-- $name: begin (make choosing) -->"
        $name && echo "<!-- $name: end -->"
    } >"$work/block" || { echo "FAIL choosing $name: figures are missing in $report; run make choosing"; exit 1; }
    grep -q "<!-- $name: begin" "$work/page" && grep -q "<!-- $name: end" "$work/page" || { echo "FAIL choosing $name: no marks in $page"; status=1; }
    awk -v block="$work/block" -v name="$name" -f hosttest/block.awk "$work/page" >"$work/next"
    if [ "$mode" = --check ]; then
        if cmp -s "$work/page" "$work/next"; then
            echo "pass choosing $name: $(grep -c '^| ' "$work/block") lines, as the commands print them"
        else
            echo "FAIL choosing $name: $page is not what the commands print; run make choosing"
            diff "$work/page" "$work/next"
            status=1
        fi
    fi
    cp "$work/next" "$work/page"
done
prose >"$work/prose"
if [ "$mode" = --check ]; then cat "$work/prose"; else grep '^FAIL' "$work/prose"; cat "$work/page" >"$page"; fi
grep -q '^FAIL' "$work/prose" && status=1
exit $status
