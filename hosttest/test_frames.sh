#!/bin/sh
# SPDX-License-Identifier: MIT
# The comparison of frames must itself turn red: frames with faults that boards make.
# usage: test_frames.sh BUILD_FOLDER    after make frames, or make frames TARGET=host, there
set -u
build=$1
frames="$(dirname "$0")/frames.sh"
reference=$build/frames/reference
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

verdict() { # verdict CONDITION TEXT
    if [ "$1" = 0 ]; then echo "pass frames test: $2"; else echo "FAIL frames test: $2, but it does not"; status=1; fi
}

# fresh: the host's own frames as those of a board.
fresh() { rm -rf "$work/board" && cp -r "$build/frames/host" "$work/board"; }

# compared [SCENES [WHY]]: the verdict on the board.
compared() { "$frames" compare board "$work/board" "$reference" "$build/bin/crc32" "${1-all}" "${2-}"; }

# rewrite PROGRAM: rewrites the torus' bytes, one decimal a line, by an awk program; its printed line stays.
rewrite() {
    od -An -v -tu1 "$work/board/torus.565" | awk '{ for (i = 1; i <= NF; i++) print $i }' | awk "$1" |
        awk '{ printf "\\%03o", $1; if (NR % 512 == 0) print "" }' >"$work/octal"
    while read -r line; do printf "$line"; done <"$work/octal" >"$work/board/torus.565"
    # the last line ends without a newline where it is short
    [ -z "$line" ] || printf "$line" >>"$work/board/torus.565"
}

printf 123456789 >"$work/digits"
[ "$("$build/bin/crc32" "$work/digits")" = cbf43926 ]
verdict $? "crc32 of 123456789 is cbf43926"

fresh
compared | grep -q "^pass frames board: $(ls "$reference" | grep -c '\.565$') scenes"
verdict $? "passes frames that are the host's own"
rewrite '{ print }'
compared | grep -q '^pass'
verdict $? "passes them after they were taken apart and put together again, as below"

rewrite 'NR % 2 { first = $1; next } { print; print first }'
compared | grep -q '^FAIL.*torus differs'
verdict $? "sees bytes of pixels swapped, as a big-endian core would"
fresh
rewrite 'NR > 480 * 100 && NR <= 480 * 101 { next } { print } NR == 480 * 102 { for (i = 0; i < 480; i++) print 0 }'
compared | grep -q '^FAIL.*torus differs'
verdict $? "sees a strip that is a row too high"
fresh
rewrite 'NR == 57601 { print $1 + ($1 % 2 ? -1 : 1); next } { print }'
compared | grep -q '^FAIL.*torus differs from byte 57601 on'
verdict $? "sees one level in one pixel"
fresh
rewrite 'NR > 57600 { exit } { print }'
compared | grep -q '^FAIL'
verdict $? "sees half a frame"
fresh
rm "$work/board/torus.565"
compared | grep -q '^FAIL.*torus is missing'
verdict $? "sees a frame that is missing"

fresh
sed -i 's/^\(torus: .*\)./\1x/' "$work/board/log"
compared | grep -q "^FAIL.*torus has .* but it printed"
verdict $? "sees a board that has drawn something else than what arrived"
"$frames" run "$work/board" sh -c "cp '$(cd "$build" && pwd)'/frames/host/*.565 . ; grep -v '^exit' '$(cd "$build" && pwd)'/frames/host/log; exit 67" >/dev/null
compared | grep -q '^FAIL.*exit status 67'
verdict $? "sees a fault after the last frame"
fresh
compared "torus teapot" | grep -q '^FAIL.*leaves out .* without a reason'
verdict $? "sees scenes that are left out without a reason"
compared "torus teapot" "too large" | grep -q '^pass frames board: 2 scenes .*left out: .*still-life .*(too large)$'
verdict $? "names scenes that are left out for a reason"
mkdir "$work/none"
reference=$work/none
compared all | grep -q '^FAIL.*the host has drawn nothing'
verdict $? "sees that there is nothing to compare with"

[ "$("$frames" run "$work/run" sh -c "echo drawn; exit 3")" = "drawn
exit status 3 of: sh -c echo drawn; exit 3" ]
verdict $? "sees a command that fails"
exit $status
