#!/bin/sh
# SPDX-License-Identifier: MIT
# The gate: objects of the library and the filler hold no division, square root or float, no data that can be written, no symbol
# without the prefix, and call nothing but themselves and what is allowed. An image that was linked from them holds no helper that
# divides, takes roots or knows floats, and no such instruction.
# usage: gate.sh NAME TOOL_PREFIX CALLS ARCHIVE [IMAGE]
#            TOOL_PREFIX: of nm and objdump, may be empty. CALLS: the compiler's helpers that objects may call, * for any
#            letters; never one that divides
set -u
name=$1 prefix=$2 calls=$3 archive=$4 image=${5:-}
status=0

verdict() { # verdict CONDITION TEXT TEXT_OF_FAILURE
    if [ "$1" = 0 ]; then echo "pass gate $name: $2"; else echo "FAIL gate $name: $3"; status=1; fi
}

defined() { "${prefix}nm" --defined-only "$1" 2>/dev/null | awk 'NF == 3 { print $3 }' | sort -u; }

# instructions FILE: those that divide, take roots or compute with floats, by the mnemonic column only: addresses, symbols and
# comments may well hold these letters.
instructions() {
    case $("${prefix}objdump" -f "$1" | sed -n 's/.*file format //p' | sort -u) in
    elf64-x86-64 | elf32-i386) bad='^(i?div[lqwb]?|f[a-z0-9]+|v?(add|sub|mul|div|sqrt|max|min|u?comi|cvt[a-z0-9]*)[sp][sd])$' ;;
    elf32-littlearm) bad='^([su]div|v?sqrt|vdiv)[a-z0-9.]*$|\.f(16|32|64)' ;;
    elf32-littleriscv) bad='^(c\.)?((div|rem)u?w?|f[ls][whdq](sp)?)$|^f[a-z0-9]+\.[shdqwlx]' ;;
    elf32-xtensa-le) bad='^(quo|rem)[su]$|\.s$' ;;
    elf32-powerpc) bad='^(div[a-z]*|f[a-z]+|[a-z]*sqrt[a-z]*)\.?$' ;;
    elf32-avr) bad='^$' ;; # the core has none: only helpers divide
    *) echo "unknown-file-format"; return ;;
    esac
    "${prefix}objdump" -d --no-show-raw-insn "$1" | awk -F'\t' 'NF >= 2 { split($2, m, " "); print m[1] }' | grep . | sort -u |
        grep -E "$bad"
}

# What a compiler may call for: block copies and what CALLS names.
allowed=$(echo memcpy memmove memset memcmp $calls | sed 's/[.]/\\./g; s/[*]/[a-z0-9_]*/g; s/ \{1,\}/|/g')
# Helpers of all compilers and libraries that divide, take roots, compute with floats or allocate.
forbidden='^__[a-z_]*(div|mod|sqrt)[a-z0-9_]*$|^__[a-z]+[hsdtx]f([0-9]|[sdt]i|[sdt]f[0-9]?)?$|^__(fix|float|fp)[a-z0-9_]*$'
forbidden="$forbidden|^__aeabi_(c?[fdh]|u?[il]2[fd])[a-z0-9_]+\$|^(sqrt|cbrt|pow|exp|log|sin|cos|tan|atan2?|floor|ceil)[fl]?\$"
forbidden="$forbidden|^fmod[fl]?\$|^_?(malloc|calloc|realloc|free|sbrk)(_r)?\$|^u?l?div\$"

symbols=$(defined "$archive")
[ -n "$symbols" ]
verdict $? "$(echo "$symbols" | wc -l) symbols in $(basename "$archive")" "$archive holds no symbols: nothing was tested"

foreign=$("${prefix}nm" -u "$archive" | awk 'NF == 2 && $1 == "U" { print $2 }' | sort -u | grep -vxF "$symbols" |
    while read -r s; do echo "$s" | grep -xE "$allowed" | grep -qvE "$forbidden" || echo "$s"; done)
[ -z "$foreign" ]
verdict $? "no undefined symbol beyond the allowed ones" "calls $(echo $foreign)"

bare=$("${prefix}nm" -g --defined-only "$archive" | awk 'NF == 3 { print $3 }' | grep -v '^lmb_')
[ -z "$bare" ]
verdict $? "every external symbol begins with lmb_" "external symbols without the prefix: $(echo $bare)"

writable=$("${prefix}nm" --defined-only "$archive" | awk 'NF == 3 && $2 ~ /^[bBdDcCsSgG]$/ { print $3 }')
# Of AVR even constant data are copied to RAM, but for what LMB_FLASH marks.
if "${prefix}objdump" -f "$archive" | grep -q 'file format elf32-avr'; then
    writable="$writable $("${prefix}objdump" -h "$archive" | awk '$2 ~ /^\.rodata/ && $3 !~ /^0+$/ { print $2 }')"
fi
[ -z "$(echo $writable)" ]
verdict $? "no static data that can be written" "static data: $(echo $writable)"

bad=$(instructions "$archive")
[ -z "$bad" ]
verdict $? "no instruction divides, takes roots or computes with floats" "instructions: $(echo $bad)"

if [ -n "$image" ]; then
    symbols=$(defined "$image")
    echo "$symbols" | grep -qx main && echo "$symbols" | grep -q '^lmb_'
    verdict $? "$(echo "$symbols" | wc -l) symbols in $(basename "$image")" \
        "$image is not an image with symbols: nothing was tested"

    bad=$(echo "$symbols" | grep -E "$forbidden")
    [ -z "$bad" ]
    verdict $? "no helper in the image that divides, takes roots or knows floats" "the image holds $(echo $bad)"

    bad=$(instructions "$image")
    [ -z "$bad" ]
    verdict $? "no such instruction in the image" "instructions in the image: $(echo $bad)"
fi
exit $status
