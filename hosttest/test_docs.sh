#!/bin/sh
# SPDX-License-Identifier: MIT
# What the documents name is there: files, targets of make, functions, macros and tests. Capitals in a path stand for any.
# usage: test_docs.sh
set -u
cd "$(dirname "$0")/.." || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{ ls hosttest hosttest/*; cat firmware/*.[ch] linker/* port/*.[ch] port/*/*.[ch] tables/*.[ch] hosttest/*.[ch] hosttest/*/*.[ch] Makefile hosttest/*/*.mk port/*.mk; } >"$work/sources"
for doc in README.md CONTRIBUTING.md docs/*.md; do
    missing=
    # names of code: lmb_x, LMB_X, and tests as xxx_yyy within backticks; a trailing * or … stands for any end
    for name in $(grep -o '`[A-Za-z_][A-Za-z0-9_]*[*…]*`' "$doc" | tr -d '`*…' | grep '_' | sort -u); do
        grep -q "$name" "$work/sources" || missing="$missing $name"
    done
    # paths within backticks or links
    for path in $(grep -oE '[`(](firmware|port|hosttest|tables|linker|docs)/[A-Za-z0-9_./-]*[`)]' "$doc" | tr -d '`()' | sort -u); do
        case $path in */[A-Z]*) ;; *) [ -e "$path" ] || missing="$missing $path" ;; esac
    done
    for path in $(grep -oE '\]\([a-zA-Z0-9_./-]+\)' "$doc" | tr -d '()]' | sort -u); do
        [ -e "$(dirname "$doc")/$path" ] || missing="$missing $path"
    done
    for target in $(grep -oE '`make [a-z-]+' "$doc" | sed 's/`make //' | sort -u); do
        grep -q "^$target:" Makefile hosttest/profile/profile.mk hosttest/estimate/estimate.mk || missing="$missing make:$target"
    done
    if [ -z "$missing" ]; then echo "pass docs $doc: what it names is there"; else echo "FAIL docs $doc: names what is not there:$missing"; fi
done
