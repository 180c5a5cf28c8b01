#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs an image that draws the demo scenes, and compares its frames with the host's.
# usage: frames.sh run FOLDER COMMAND...
#            runs COMMAND in FOLDER, emptied before; prints what it prints; fails if it does
#        frames.sh compare NAME FOLDER REFERENCE CRC32 SCENES [WHY]
#            one line, pass or FAIL, for the frames in FOLDER against those in REFERENCE, byte for byte. CRC32: a program that
#            prints the CRC-32 of a file. SCENES: all, or those that NAME draws; WHY the others are left out.
#            Writes FOLDER/frames.csv: target,scene,bytes,crc32,matches_host
set -u

run() {
    folder=$1
    shift
    rm -rf "$folder" && mkdir -p "$folder" && cd "$folder" || exit 2
    timeout 300 "$@" </dev/null >log 2>&1
    status=$?
    [ $status = 0 ] || echo "exit status $status of: $*" >>log
    cat log
    return $status
}

# judge SCENE: adds to faults what is wrong with it.
judge() {
    file=$folder/$1.565
    printed=$(sed -n "s/^$1: \([0-9]* bytes, crc32 [0-9a-f]*\).*/\1/p" "$folder/log")
    if [ ! -f "$file" ]; then
        faults="$faults; $1 is missing"
        return
    fi
    bytes=$(wc -c <"$file")
    crc=$("$crc32" "$file")
    if cmp -s "$file" "$reference/$1.565"; then
        match=yes
    else
        match=no
        faults="$faults; $1 differs from byte $(cmp "$file" "$reference/$1.565" 2>&1 | sed -n 's/.* byte \([0-9]*\).*/\1/p') on"
    fi
    [ "$printed" = "$bytes bytes, crc32 $crc" ] || faults="$faults; $1 has $bytes bytes, crc32 $crc, but it printed '$printed'"
    echo "$name,$1,$bytes,$crc,$match" >>"$folder/frames.csv"
}

compare() {
    name=$1 folder=$2 reference=$3 crc32=$4 scenes=$5 why=${6:-}
    all=$(cd "$reference" && ls | sed -n 's/\.565$//p')
    [ "$scenes" = all ] && scenes=$all
    faults= drawn=0 left=
    [ -n "$all" ] || faults="; the host has drawn nothing"
    : >"$folder/frames.csv"
    for s in $scenes; do
        judge "$s"
        drawn=$((drawn + 1))
    done
    for s in $all; do
        case " $(echo $scenes) " in *" $s "*) ;; *) left="$left $s" ;; esac
    done
    [ -z "$left" ] || [ -n "$why" ] || faults="$faults; leaves out$left without a reason"
    grep -q '^exit status' "$folder/log" && faults="$faults; $(grep '^exit status' "$folder/log" | cut -d' ' -f1-3)"
    if [ -z "$faults" ]; then
        echo "pass frames $name: $drawn scenes identical to the host's${left:+; left out:$left ($why)}"
    else
        echo "FAIL frames $name: ${faults#; }"
    fi
}

mode=$1
shift
case $mode in
run) run "$@" ;;
compare) compare "$@" ;;
*) echo "usage: see $0"; exit 2 ;;
esac
