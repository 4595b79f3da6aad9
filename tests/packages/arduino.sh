#!/bin/sh
# The Arduino library: its sketch for a Mega, and for an Uno, which has 2 KB of RAM and no
# instruction that reads far.
set -eu
. tests/packages/common

for_an_uno() {
    sed -i 's/arduino:avr:mega/arduino:avr:uno/' "$work/lines"
    rm -rf "$site/build" && follow
}

# Of library.properties: each field that Arduino's index asks for, once, and a value.
has_its_fields() {
    for field in name version author maintainer sentence paragraph category url architectures; do
        grep -c "^$field=." "$DIST/arduino/qvol/library.properties" | grep -qx 1 || {
            echo "$field"
            return 1
        }
    done
}

has_keywords() {
    grep -P '^qv_render\tKEYWORD2$' "$DIST/arduino/qvol/keywords.txt" &&
        grep -P '^qv_volume\tKEYWORD1$' "$DIST/arduino/qvol/keywords.txt" &&
        grep -P '^QV_OK\tLITERAL1$' "$DIST/arduino/qvol/keywords.txt" &&
        ! grep -vP '^(qv|QV)_\w+\t(KEYWORD[12]|LITERAL1)$' "$DIST/arduino/qvol/keywords.txt"
}

without_warnings() {
    ! grep -A4 'warning:.*' "$work/log" | grep 'qvol\|sketch'
}

followed() {
    follow >"$work/log" 2>&1 || { cat "$work/log" && false; }
}

make -s TARGET=avr BUILD="$BUILD" "$BUILD/emulator/avr" >&2
check "the example draws here" expected
check "library.properties has its fields" has_its_fields
check "keywords.txt has functions, types and constants" has_keywords
check "port/README.md has lines for Arduino" lines Arduino
check "they build the sketch" followed
check "without warnings of its own" without_warnings
check "the library is whole" holds_everything avr-gcc-nm "$site"/build/libraries/qvol/qvol/*.o
check "the sketch draws the picture" prints_on_avr atmega2560 "$site/build/Ball.ino.elf"
check "constants stay in flash" keeps_constants_in_flash "$site/build/Ball.ino.elf"
check "the same lines for an Uno" for_an_uno
check "the Uno draws the picture" prints_on_avr atmega328p "$site/build/Ball.ino.elf"
finish
