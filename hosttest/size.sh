#!/bin/sh
# SPDX-License-Identifier: MIT
# Bytes of flash, RAM and stack that the library takes on a target, configuration by configuration: of images of size_image.sh,
# sections collected, less the same program without the library.
# usage: size.sh table TARGET PREFIX FOLDER       figures and largest functions
#        size.sh csv TARGET PREFIX FOLDER         core,configuration,text,rodata,data,bss,stack
#        size.sh parts TARGET PREFIX FOLDER       what leaving a part out of everything saves, and the largest of gloss
#        size.sh flash TARGET PREFIX FOLDER IMAGE  bytes of flash of one image, such as gloss-O2
# FOLDER holds the images: FOLDER/gloss-Os/size.elf
set -u
cd "$(dirname "$0")/.." || exit 2
mode=$1 target=$2 prefix=$3 folder=$4

# sections IMAGE: its text, rodata, data and bss. AVR copies .rodata to RAM and reads .flash in place; others have no .flash.
sections() {
    "${prefix}size" -A "$1" | awk -v avr="$([ "$prefix" = avr- ] && echo 1)" '
        { bytes[$1] = $2 }
        END {
            if (!(".text" in bytes)) exit 1
            r = avr ? ".flash" : ".rodata"
            print bytes[".text"], bytes[r] + 0, bytes[".data"] + (avr ? bytes[".rodata"] : 0), bytes[".bss"] + 0
        }'
}

# beyond CONFIGURATION [OPTIMISATION]: the same, less those of the empty program.
beyond() {
    echo "$(sections "$folder/$1-${2:-Os}/size.elf") $(sections "$folder/empty-${2:-Os}/size.elf")" |
        awk 'NF != 8 { exit 1 } { print $1 - $5, $2 - $6, $3 - $7, $4 - $8 }'
}

# largest IMAGE N: bytes and names of its largest functions and tables.
largest() { "${prefix}nm" -t d --size-sort -r -S "$1" | awk -v n="$2" '$4 != "main" && n-- > 0 { print $2 + 0, $4 }'; }

# paint CONFIGURATION: bytes of a paint, which lies in the memory of the caller and is none of the others.
paint() {
    "${prefix}nm" -t d -S "$folder/$1-Os/size_main.o" | awk '$4 == "size_paint" { print $2 + 0 }'
}

# row CONFIGURATION: its text, rodata, data, bss and stack.
row() {
    bytes=$(beyond "$1") || { echo "size: no figures from $folder/$1-Os/size.elf" >&2; exit 1; }
    echo "$bytes $(hosttest/stack.sh figure "$prefix" "$folder/$1-Os" lmb_draw_mesh)"
}
# configurations: those that are weighed here, of which some cores have more.
configurations() {
    for c in flat gouraud diffuse gloss arc planned rgb888 everything; do
        case $c in gouraud | arc | planned | rgb888) [ -e "$folder/$c-Os/size.elf" ] || continue ;; esac
        echo $c
    done
}
flash() { beyond "$@" | awk '{ print $1 + $2 + $3 } END { exit NR != 1 }' || echo "size: no figures from $folder/$1-${2:-Os}/size.elf" >&2; }

case $mode in
table)
    echo "$target: $("${prefix}gcc" --version | head -n 1), -Os, sections collected, bytes beyond an empty program"
    echo "                 text  rodata    data     bss   stack   paint   largest"
    for c in $(configurations); do
        figures=$(row $c) || exit 1
        # shellcheck disable=SC2086
        printf '  %-10s  %7d %7d %7d %7d %7s %7s   %s\n' $c $figures "$(paint $c)" \
            "$(largest "$folder/$c-Os/size.elf" 4 | awk '{ printf "%s%s %s", (NR > 1 ? ", " : ""), $2, $1 }')"
    done
    ;;
csv)
    for c in $(configurations); do
        figures=$(row $c) || exit 1
        echo "$target,$c,$figures" | tr ' ' ','
    done
    ;;
parts)
    everything=$(flash everything)
    echo "Leaving out of everything on $target (-DLMB_WITH_...=0) saves, of $everything bytes of flash:"
    for image in "$folder"/without-*-Os; do
        part=$(basename "$image" -Os)
        bytes=$(flash "$part")
        printf '  %-14s %5d\n' "$(echo "${part#without-}" | sed 's/LIGHTS/LIGHTS to 1/')" $((everything - bytes))
    done
    echo "Largest functions and tables of gloss on $target:"
    largest "$folder/gloss-Os/size.elf" 24 | awk '{ printf "  %6d  %s\n", $1, $2 }'
    ;;
flash) flash "${5%-*}" "${5##*-}" ;;
*) echo "size.sh: no mode $mode"; exit 2 ;;
esac
