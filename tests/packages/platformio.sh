#!/bin/sh
# The PlatformIO library: library.json and the files that it names, in a project of its own.
set -eu
. tests/packages/common
firmware=$site/ball/.pio/build/megaatmega2560
make -s TARGET=avr BUILD="$BUILD" "$BUILD/emulator/avr" >&2
check "the example draws here" expected
check "port/README.md has lines for PlatformIO" lines PlatformIO
check "they build the example" follow
check "the library is whole" holds_everything avr-nm "$firmware"/lib/qvol/*.o
check "the firmware draws the picture" prints_on_avr atmega2560 "$firmware/firmware.elf"
check "constants stay in flash" keeps_constants_in_flash "$firmware/firmware.elf"
finish
