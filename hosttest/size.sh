#!/bin/sh
# SPDX-License-Identifier: MIT
# Bytes of flash on Cortex-M0+: links a program that draws with the library, sections collected, and subtracts the same program
# without it. usage: size.sh BUILD_FOLDER
set -u
build=$1
cc=arm-none-eabi-gcc
flags="-mcpu=cortex-m0plus -mthumb -std=c99 -ffreestanding -ffunction-sections -fdata-sections -Ifirmware"
budget=$(awk '$1 == "m0plus" && $2 == "gloss" && $3 == "flash" { print $4 }' hosttest/budgets.txt)
command -v $cc >/dev/null 2>&1 || { echo "size: $cc is missing; run make deps"; exit 1; }
mkdir -p "$build" || exit 1

# link NAME DEFINE...: build/NAME.elf
link() {
    out=$build/$1.elf
    shift
    $cc $flags -Os "$@" -nostartfiles -Wl,--gc-sections,-e,main,-Map="$out.map" hosttest/size_main.c firmware/*.c port/*.c -o "$out" \
        -nostdlib -lgcc 2>"$build/link.log" || { cat "$build/link.log"; exit 1; }
}
bytes() { arm-none-eabi-size "$1" | awk 'NR == 2 { print $1 + $2 }'; }
static_ram() { arm-none-eabi-size "$1" | awk 'NR == 2 { print $2 + $3 }'; }

link empty -DSIZE_EMPTY
link gloss -DSIZE_GLOSS -DLMB_LIGHTS=1 -DLMB_WITH_ARC=0 -DLMB_WITH_CORNERS=0 -DLMB_WITH_PERSPECTIVE=0 -DLMB_WITH_DEPTH=0 -DLMB_WITH_LARGE=0 -DLMB_WITH_LOBES=0 -DLMB_WITH_RGB888=0
link everything -DSIZE_EVERYTHING
empty=$(bytes "$build/empty.elf")
gloss=$(($(bytes "$build/gloss.elf") - empty))
everything=$(($(bytes "$build/everything.elf") - empty))
ram=$(($(static_ram "$build/gloss.elf") - $(static_ram "$build/empty.elf")))

echo "Cortex-M0+, gcc -Os, sections collected, beyond an empty program:"
echo "  gloss: diffuse + specular, quadratic, RGB565, mesh to pixels   $gloss bytes of flash"
echo "  everything: all models, steps, formats, lights, depth          $everything bytes of flash"
echo "  static RAM                                                     $ram bytes"
echo "Leaving out of everything (gcc -Os -DLMB_WITH_...=0) saves, in bytes:"
for part in ARC CORNERS PERSPECTIVE DEPTH LARGE LOBES RGB565 RGB888; do
    link without -DSIZE_EVERYTHING "-DLMB_WITH_$part=0"
    printf '  %-12s %5d\n' "$part" $((everything + empty - $(bytes "$build/without.elf")))
done
link without -DSIZE_EVERYTHING -DLMB_LIGHTS=1
printf '  %-12s %5d\n' "LIGHTS=1" $((everything + empty - $(bytes "$build/without.elf")))
echo "Largest functions and tables of gloss:"
arm-none-eabi-nm --size-sort -r -S "$build/gloss.elf" | awk '
    function hex(s,  i, v) { v = 0; for (i = 1; i <= length(s); i++) v = v * 16 + index("0123456789abcdef", substr(s, i, 1)) - 1; return v }
    { printf "  %6d  %s\n", hex($2), $4 }' | head -n 24

status=0
if [ "$gloss" -le "$budget" ]; then
    echo "pass flash m0plus gloss: $gloss bytes, budget $budget, headroom $((budget - gloss))"
else
    echo "FAIL flash m0plus gloss: $gloss bytes, budget $budget"
    status=1
fi
if [ "$ram" = 0 ]; then echo "pass static RAM m0plus gloss: 0 bytes"; else echo "FAIL static RAM m0plus gloss: $ram bytes"; status=1; fi
exit $status
