#!/bin/sh
# SPDX-License-Identifier: MIT
# One line for an image: its sections' bytes by kind. usage: sections.sh NAME TOOL_PREFIX IMAGE
set -u
"${2}size" -A "$3" | awk -v name="$1" '
    $1 ~ /^\.(text|start|vectors)/ { text += $2 }
    $1 ~ /^\.rodata/               { rodata += $2 }
    $1 ~ /^\.data/                 { data += $2 }
    $1 ~ /^\.bss/                  { bss += $2 }
    END {
        printf "%-16s text %6d  rodata %6d  data %5d  bss %6d\n", name, text, rodata, data, bss
        exit text == 0
    }'
