#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs what the tests need, from Debian packages; says which, and does nothing where nothing is missing.
set -u

# The host: compilers, 32 bits as well, judging images.
packages="make gcc g++ clang libc6-dev lib32gcc-12-dev libc6-dev-i386 pkg-config libopenimageio-dev openimageio-tools"
# A big-endian host.
packages="$packages gcc-powerpc-linux-gnu libc6-dev-powerpc-cross qemu-user"
# The boards: compilers and emulators.
packages="$packages gcc-arm-none-eabi gcc-riscv64-unknown-elf gcc-xtensa-lx106 gcc-avr binutils-avr avr-libc"
packages="$packages qemu-system-arm qemu-system-misc libsimavr-dev"
# Charts.
packages="$packages gnuplot-nox fonts-dejavu-core"
# A libm for what others do with floats.
packages="$packages libnewlib-arm-none-eabi"

missing=
for p in $packages; do
    dpkg-query -W -f '${Status}' "$p" 2>/dev/null | grep -q 'install ok installed' || missing="$missing $p"
done
if [ -z "$missing" ]; then
    exit 0
fi
if ! command -v apt-get >/dev/null 2>&1; then
    echo "deps: this system has no apt-get; install these packages or their like, then run make check again:"
    echo "  $packages"
    exit 1
fi

as_root=
if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
        echo "deps: run this as root: apt-get install$missing"
        exit 1
    fi
    as_root=sudo
fi

echo "deps: installing$missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
export DEBIAN_FRONTEND=noninteractive
if ! { $as_root apt-get update -qq && $as_root apt-get install -y -qq --no-install-recommends $missing; } >"$log" 2>&1; then
    tail -n 20 "$log"
    echo "deps: apt-get failed, see above"
    exit 1
fi
