#!/bin/sh
# SPDX-License-Identifier: MIT
# One line, pass or FAIL: are the numbers that an image of port/demo/digest.c prints those of the host, line by line?
# usage: digest.sh NAME FOLDER HOST_IMAGE COMMAND...      runs COMMAND in FOLDER, emptied before
set -u
name=$1 folder=$2 host=$3
shift 3
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder" || exit 2
faults=
"$host" >wanted 2>&1 || faults="; the host's exit status $?"
timeout 120 "$@" </dev/null >got 2>log
status=$?
[ $status = 0 ] || faults="$faults; exit status $status $(tail -n 1 log)"
parts=$(grep -Ec '^[a-z]+ [0-9a-f]{8}$' wanted)
[ "$parts" -gt 0 ] || faults="$faults; the host prints no numbers"
cmp -s wanted got || faults="$faults; differs in: $(diff wanted got | sed -n 's/^[<>] \([a-z]*\).*/\1/p' | sort -u | tr '\n' ' ')"
if [ -z "$faults" ]; then
    echo "pass digest $name: $parts of $parts parts as on the host: $(echo $(cut -d' ' -f1 wanted))"
else
    echo "FAIL digest $name: ${faults#; }"
fi
