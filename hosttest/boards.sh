#!/bin/sh
# SPDX-License-Identifier: MIT
# Does a board keep what port/board.h promises? Runs the self-test and the fault of port/demo/ and judges what arrives.
# usage: boards.sh NAME FOLDER NM COUNTER FAULT SELFTEST_IMAGE FAULT_IMAGE COMMAND...
#            COMMAND: runs an image in the place of the word IMAGE. NM: lists symbols. COUNTER: none where there is none.
#            FAULT: the exit status that a fault must have; empty: the board has none to show
set -u
name=$1 folder=$2 nm=$3 counter=$4 fault=$5 selftest=$6 broken=$7
shift 7
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder" || exit 2
expected="ok   memory is set up
ok   stack is aligned
ok   blocks move
ok   file is written
ok   missing folder is an error
ok   $([ "$counter" = none ] && echo "there is no counter" || echo "counter moves on")"
faults=

# go IMAGE OPTION...: runs IMAGE.
command=$*
go() {
    image=$1
    shift
    # shellcheck disable=SC2086
    timeout 100 $(echo "$command" | sed "s|IMAGE|$image|g") "$@" </dev/null
}

# Emulated RAM begins as zeros and real RAM does not: leave something where start-up must clear. And let time pass quickly, so that
# counters of 24 bits start over a few times.
options=
case $command in
qemu-system-*)
    for variable in zeroed preset; do
        address=$("$nm" "$selftest" | awk -v v=$variable '$3 == v { print $1 }')
        options="$options -device loader,addr=0x$address,data=0x55aa55aa,data-len=4"
    done
    options="$options -icount shift=10"
    ;;
esac
# shellcheck disable=SC2086
go "$selftest" $options >log 2>&1
status=$?
[ "$(cat log)" = "$expected" ] || faults="$faults; it said '$(grep -vxF "$expected" log | tr "\n" " ")'"
[ $status = 42 ] || faults="$faults; exit status $status instead of 42"
od -An -v -tu1 selftest.bin 2>/dev/null | awk '{ for (i = 1; i <= NF; i++) bad += $i != (7 * n++) % 256 } END { exit bad || n != 520 }' ||
    faults="$faults; selftest.bin is not what was written"

if [ -n "$fault" ]; then
    go "$broken" >fault.log 2>&1
    status=$?
    [ $status = "$fault" ] || faults="$faults; a fault has exit status $status instead of $fault"
    grep -q '^going to fault' fault.log || faults="$faults; nothing printed before the fault"
fi
if [ -z "$faults" ]; then
    echo "pass board $name: memory, stack, blocks, files, ${counter:+no }counter, exit status${fault:+; a fault has status $fault}"
else
    echo "FAIL board $name: ${faults#; }"
fi
