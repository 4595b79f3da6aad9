#!/bin/sh
# The head that turns on the panels of emulated boards, in strips: checksums of the device and of
# the host, and every pixel of the screenshots.
set -eu
. tests/tap
build=${BUILD:-build}

same_checksums() { # same_checksums TARGET: of every frame of one turn
    frames=0
    while read -r _ frame _ device _; do
        make -s TARGET="$1" BUILD="$build" "$build/$1/frame$frame.json" || return 1
        host=$(sed -n 's/.*"crc32": "\(.*\)".*/\1/p' "$build/$1/frame$frame.json")
        echo "frame $frame: device $device, host $host"
        [ "$device" = "$host" ] || return 1
        frames=$((frames + 1))
    done <"$work/$1"
    [ "$frames" -eq 8 ]
}

frames_differ() {
    [ "$(cut -d ' ' -f 4 "$work/$1" | sort -u | wc -l)" -eq 8 ]
}

shows_something() { # shows_something PICTURE: it has dark and bright places
    /usr/bin/python3 - "$1" <<'END'
import sys
from PIL import Image, ImageStat

spread = max(ImageStat.Stat(Image.open(sys.argv[1]).convert("RGB")).stddev)
sys.exit(f"standard deviation {spread}" if spread < 20 else 0)
END
}

for target in cortex-m3 rv32imc; do
    check "$target: firmware builds" make -s TARGET=$target BUILD="$build" "$build/$target/head.elf"
    check "$target: one turn, and its end" sh -c "toolchain/emulate $target \
        '$build/$target/head.elf' exit >'$work/$target'"
    check "$target: checksums of 8 frames are the host's" same_checksums $target
    check "$target: 8 different frames" frames_differ $target
    sed -n "s/^frame 0.* stack/# $target: stack of the firmware/p" "$work/$target"
done
check "screenshots have the host's pixels" toolchain/gallery "$work/gallery" cortex-m3 rv32imc
for target in cortex-m3 rv32imc; do
    check "$target: the panel shows something" shows_something "$work/gallery/$target-0.png"
done
finish
