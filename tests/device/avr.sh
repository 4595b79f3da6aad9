#!/bin/sh
# A planet in fog on the simulated ATmega1284P, small and fast builds: 34 KB of volume from
# program memory, by slices into 12 KB of frame buffer, with dither. The bytes of this machine,
# by checksum; cycles and RAM are printed. The picture is left in BUILD/device/planet.pam.
set -eu
. tests/tap
: "${BUILD:=build}" "${CC:=cc}"

RAM=16384
GAP=256 # bytes that stay between data and stack: shorter ones may be paint by chance
CLOCK=20000000 # the most that an ATmega1284P takes
EMULATOR_SECONDS=${EMULATOR_SECONDS:-900}
export BUILD EMULATOR_SECONDS

on_host() {
    mkdir -p "$BUILD/device"
    $CC -std=c99 -O2 -Icore -Ifixedpoint -Iport -Iport/avr -Itests/device \
        tests/device/planet_host.c tests/device/planet.c port/avr/firmware_planet.c \
        port/console.c port/crc32.c core/*.c fixedpoint/*.c -o "$work/planet" &&
        PLANET_PICTURE=$BUILD/device/planet.pam "$work/planet" >"$work/expected" &&
        grep -q '^slices [0-9a-f]\{8\}$' "$work/expected"
}

builds() { # builds OPTIMISE
    make -s TARGET=avr OPTIMISE="$1" BUILD="$BUILD/avr$1" "$BUILD/avr$1/avr/planet.elf"
}

# Pointers of 16 bits do not reach it.
lies_far() { # lies_far OPTIMISE
    address=$(avr-nm "$BUILD/avr$1/avr/planet.elf" | awk '$3 == "planet_volume" { print $1 }')
    echo "volume at ${address:-no address}"
    [ $((0x${address:-0})) -ge 65536 ]
}

runs() { # runs OPTIMISE
    EMULATOR_REPORT=$work/regions$1 toolchain/emulate avr \
        "$BUILD/avr$1/avr/planet.elf" >"$work/results" && diff "$work/expected" "$work/results"
}

# What data and stack leave of the RAM was never written.
fits() { # fits OPTIMISE
    used=$(awk '$2 == 1 { print $8 }' "$work/regions$1")
    echo "${used:-nothing} of $RAM bytes used"
    [ "${used:-0}" -gt 12288 ] && [ "$used" -le $((RAM - GAP)) ]
}

figures() { # figures OPTIMISE
    size=$(avr-size -A "$BUILD/avr$1/avr/planet.elf" |
        awk '$1 == ".text" || $1 == ".data" { bytes += $2 } END { print bytes }')
    awk -v what="# planet on avr $1" -v clock=$CLOCK -v size="$size" -v ram=$RAM '
        $2 == 0 { printf "%s, 8 rows by rays: %.0f cycles\n", what, $6 }
        $2 == 1 { printf "%s, frame by slices: %.0f cycles, %.1f s at %d MHz\n", what, $6,
                      $6 / clock, clock / 1000000
                  printf "%s: %d of %d bytes of RAM, %d bytes of code and constants\n", what, $8,
                      ram, size }' "$work/regions$1"
}

check "planet on this machine" on_host
for optimise in -Os -O2; do
    check "planet on avr $optimise: builds" builds $optimise
    check "planet on avr $optimise: volume beyond 64 KB" lies_far $optimise
    check "planet on avr $optimise: bytes of this machine" runs $optimise
    check "planet on avr $optimise: data and stack fit the RAM" fits $optimise
    figures $optimise
done
finish
