#!/bin/sh
# Speeds: instructions a sample on the emulated devices, samples a second on this
# machine beside a plain float renderer of the same picture. Markdown tables.
set -eu
: "${CC:=cc}" "${BUILD:=build}"
cd "$(dirname "$0")/../.."
make -s BUILD="$BUILD/bench-host" OPTIMISE=-O2 CFLAGS= lib >&2
$CC -std=c99 -D_POSIX_C_SOURCE=200809L -O2 -Icore tests/bench/bench_host.c \
    tests/bench/float_renderer.c "$BUILD/bench-host/host/libqvol.a" -lm -o "$BUILD/bench-host/bench"
tests/bench/device.sh
echo
echo "Host ($($CC --version | head -n 1), -O2, one thread; 256x256 frame of 128x128x128 voxels):"
echo
"$BUILD/bench-host/bench"
