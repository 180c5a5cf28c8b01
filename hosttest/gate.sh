#!/bin/sh
# SPDX-License-Identifier: MIT
# The gate: objects of the library and the filler hold no division, square root or float, no data that can be written, no symbol
# without the prefix, and call nothing but themselves and what is allowed.
# usage: gate.sh NAME TOOL_PREFIX ARCHIVE    (NAME: host or m0plus; TOOL_PREFIX: of nm and objdump, may be empty)
set -u
name=$1 prefix=$2 archive=$3
status=0

verdict() { # verdict CONDITION NAME TEXT
    if [ "$1" = 0 ]; then echo "pass gate $name: $2"; else echo "FAIL gate $name: $3"; status=1; fi
}

# What a compiler may call for: block copies, 64-bit products and shifts. Nothing that divides, takes roots or knows floats.
case $name in
host) allowed='^(memcpy|memset|memmove|memcmp)$' ;;
m0plus) allowed='^(memcpy|memset|memmove|memcmp|__aeabi_memcpy4?|__aeabi_memset4?|__aeabi_memclr4?|__aeabi_lmul|__aeabi_llsl|__aeabi_llsr|__aeabi_lasr|__gnu_thumb1_case_[a-z]+)$' ;;
*) echo "gate.sh: unknown target $name"; exit 2 ;;
esac

defined=$("${prefix}nm" --defined-only "$archive" 2>/dev/null | awk 'NF == 3 { print $3 }' | sort -u)
[ -n "$defined" ]
verdict $? "$(echo "$defined" | wc -l) symbols in $(basename "$archive")" "$archive holds no symbols: nothing was tested"

foreign=$("${prefix}nm" -u "$archive" | awk 'NF == 2 && $1 == "U" { print $2 }' | sort -u | grep -vxF "$defined" |
    grep -vE "$allowed")
[ -z "$foreign" ]
verdict $? "no undefined symbol beyond the allowed ones" "calls $(echo $foreign)"

bare=$("${prefix}nm" -g --defined-only "$archive" | awk 'NF == 3 { print $3 }' | grep -v '^lmb_')
[ -z "$bare" ]
verdict $? "every external symbol begins with lmb_" "external symbols without the prefix: $(echo $bare)"

writable=$("${prefix}nm" --defined-only "$archive" | awk 'NF == 3 && $2 ~ /^[bBdDcCsSgG]$/ { print $3 }')
[ -z "$writable" ]
verdict $? "no static data that can be written" "static data: $(echo $writable)"

# The mnemonic column only: addresses, symbols and comments may well hold these letters.
bad=$("${prefix}objdump" -d --no-show-raw-insn "$archive" | awk -F'\t' 'NF >= 2 { split($2, m, " "); print m[1] }' | sort -u |
    grep -E '^(i?div[lqwb]?|[su]div|v?(sqrt|div)[a-z0-9.]*|f(add|sub|mul|div|ld|st|ild|ist|sqrt)[a-z]*|v(add|sub|mul|div|fma|ml[as]|cvt|sqrt)\.[f].*|(add|sub|mul|div|sqrt|cvt[a-z0-9]*|comi|ucomi)s[sd]|(add|sub|mul|div|sqrt)p[sd]|[a-z0-9.]+\.f(16|32|64))$')
[ -z "$bad" ]
verdict $? "no instruction divides, takes roots or computes with floats" "instructions: $(echo $bad)"

exit $status
