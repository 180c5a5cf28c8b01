#!/bin/sh
# SPDX-License-Identifier: MIT
# The README's tables of figures, from build/report/*.csv; written between its marks.
# usage: figures.sh REPORT_FOLDER [--check]    (--check: compare only, exit status 1 if the README differs)
set -u
report=$1 mode=${2:-write}
for f in "$report/lobe.csv" "$report/arc.csv" "$report/span.csv" "$report/image.csv" "$report/size.csv" "$report/cycles.csv"; do
    [ -s "$f" ] || { echo "figures: $f is missing; run make figures"; exit 1; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# worst FILE CONDITION COLUMN: the largest value of a column where an awk condition on the fields holds.
worst() { awk -F, "NR > 1 && $2 { if (\$$3 + 0 > w) w = \$$3 + 0 } END { printf \"%.2g\", w }" "$1"; }
# sizes CORE NAME: a row of the table of sizes.
sizes() {
    awk -F, -v core="$1" -v name="$2" '
        NR > 1 && $1 == core { flash[$2] = $3 + $4 + $5; ram[$2] = $5 + $6; stack[$2] = $7; n += $2 ~ /^(flat|diffuse|gloss|everything)$/ }
        END {
            if (n != 4) exit 1
            printf "| %s | %d | %d | %d | %d | %d | %s |\n", name, flash["flat"], flash["diffuse"], flash["gloss"], flash["everything"], \
                ram["everything"], stack["gloss"]
        }' "$report/size.csv" || { echo "figures: $1 is missing in $report/size.csv" >&2; exit 1; }
}

spheres="icosphere-320 icosphere-1280"
# frames CORE NAME MODEL SCENES: a row of the table of frames, instructions (cycles) a pixel.
frames() {
    awk -F, -v core="$1" -v name="$2" -v model="$3" -v scenes="$4" '
        $1 == core && $3 == model { cell[$2] = $8 == "" ? sprintf("%.1f", $7) : sprintf("%.1f (%.1f)", $7, $8) }
        END {
            if (!("icosphere-320" in cell)) exit 1
            n = split(scenes, scene, " ")
            printf "| %s |", name
            for (i = 1; i <= n; i++) printf " %s |", cell[scene[i]]
            print ""
        }' "$report/cycles.csv" || { echo "figures: $1 $3 is missing in $report/cycles.csv" >&2; exit 1; }
}

{
    echo "<!-- figures: begin (make figures) -->"
    echo "| what | largest error | bar |"
    echo "|---|---|---|"
    echo "| highlight, every n from 1 to 1000, integers, at most 4 multiplications | $(worst "$report/lobe.csv" '$1=="lambent" && $3=="integer"' 6) | 1/700 = 0.0014 |"
    echo "| the same as published (W₁₆), n from 16 on | $(worst "$report/lobe.csv" '$1=="w16" && $3=="integer" && $2>=16' 6) | |"
    echo "| arc, 1 to 1024 pixels, turn up to 90° | $(worst "$report/arc.csv" '$1=="lambent" && $2<=90 && $3<=1024' 4) | 2⁻¹⁴ = 0.000061 |"
    echo "| the recurrence as published, 16 bits, the same | $(worst "$report/arc.csv" '$1=="plain16" && $2<=90 && $3<=1024' 4) | |"
    echo "| span from two Q2.14 normals, diffuse | $(worst "$report/span.csv" '$1=="diffuse" && $3<=90' 5) | 1/2000 = 0.0005 |"
    echo "| span, highlight, n up to 256 | $(worst "$report/span.csv" '$1=="specular" && $2<=256 && $3<=90' 5) | 1/255 = 0.0039 |"
    echo "| span, highlight, n up to 1000 | $(worst "$report/span.csv" '$1=="specular" && $3<=90' 5) | 2/255 = 0.0078 |"
    echo
    echo "Frames against the same model in double precision, gloss; errors in levels of the format:"
    echo
    echo "| scene | pixels | RGB888: PSNR | largest error | within one level | RGB565: largest error |"
    echo "|---|---|---|---|---|---|"
    awk -F, 'NR > 1 && $2 == "gloss" && $4 == "same_model" {
        if ($3 == "rgb888") { order[++n] = $1; pixels[$1] = $5; psnr[$1] = $7; most[$1] = $8; share[$1] = $9 } else most565[$1] = $8 }
        END { for (i = 1; i <= n; i++) { s = order[i]; printf "| %s | %d | %.1f dB | %d | %.3f %% | %d |\n", s, pixels[s], psnr[s], most[s], share[s] * 100, most565[s] } }' \
        "$report/image.csv"
    echo
    echo "Bytes of flash from mesh to pixels (\`everything\`: all models, steps, formats, lights, depth), of static RAM, and of stack below a call of"
    echo "\`lmb_draw_mesh\`; gcc -Os, sections collected:"
    echo
    echo "| core | flat | diffuse | gloss | everything | static RAM | stack, gloss |"
    echo "|---|---|---|---|---|---|---|"
    sizes m0plus Cortex-M0+
    sizes m4 Cortex-M4
    sizes rv32imc RV32IMC
    sizes rv32ec RV32EC
    sizes atmega1284p ATmega1284P
    sizes lx106 "LX106 (ESP8266)"
    echo
    echo "Instructions per pixel of whole frames, everything from vertices to pixels counted, and where a manual gives them cycles (M4: nominal);"
    echo "gloss, RGB565, 240 × 240, gcc -O2; torus and teapot with a depth buffer:"
    echo
    echo "| core | icosphere-320 | icosphere-1280 | torus | teapot |"
    echo "|---|---|---|---|---|"
    frames m0plus Cortex-M0+ gloss "$spheres torus teapot"
    frames m4 Cortex-M4 gloss "$spheres torus teapot"
    frames m33 Cortex-M33 gloss "$spheres torus teapot"
    frames rv32imc RV32IMC gloss "$spheres torus teapot"
    echo
    echo "The same icospheres by other means on Cortex-M0+ ([docs/COMPARISON.md](docs/COMPARISON.md) defines each):"
    echo
    echo "| method | icosphere-320 | icosphere-1280 |"
    echo "|---|---|---|"
    frames m0plus "ours, per pixel" gloss "$spheres"
    frames m0plus "integer Gouraud, highlight at corners" integer-gouraud "$spheres"
    frames m0plus "integer Phong, root and division" integer-phong-sqrt "$spheres"
    frames m0plus "the same as textbooks have it" integer-phong-textbook "$spheres"
    frames m0plus "float Phong, sqrtf and powf" float-phong "$spheres"
    echo "<!-- figures: end -->"
} >"$work/block"

awk -v block="$work/block" -v name=figures -f hosttest/block.awk README.md >"$work/README.md"
if [ "$mode" = --check ]; then
    if cmp -s README.md "$work/README.md"; then
        echo "pass README figures: as the commands print them"
    else
        echo "FAIL README figures: not what the commands print; run make figures"
        diff README.md "$work/README.md"
        exit 1
    fi
else
    cat "$work/README.md" >README.md
fi
