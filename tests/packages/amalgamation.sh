#!/bin/sh
# The library as one header and one source: by the lines of the page, without a warning, with
# the tests of make check, and as small on a Cortex-M0 as its parts.
set -eu
. tests/packages/common
one=$DIST/amalgamation
strict="-pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wcast-qual"
LIMIT=1 # per cent by which the smallest firmware may differ

compiles() { # compiles COMPILER OPTION...
    # shellcheck disable=SC2086 # several options
    "$@" -std=c99 $strict -ffreestanding -ffunction-sections -fdata-sections \
        -c "$one/qvol.c" -o "$work/qvol.o"
}

# The smallest firmware with either library: bytes of code and tables.
firmware() { # firmware BUILD VARIABLE=VALUE...
    top=$1
    shift
    make -s TARGET=cortex-m0 OPTIMISE=-Os BUILD="$top" "$@" "$top/cortex-m0/size_minimal.elf" &&
        toolchain/size_report "$top/cortex-m0/size_minimal.map" >"$work/report" &&
        awk '$1 == "code" { print $2 }' "$work/report" >"$work/code" && [ -s "$work/code" ]
}

as_small() {
    mkdir "$work/one" && compiles arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb -Os &&
        arm-none-eabi-ar rcs "$work/one/libqvol.a" "$work/qvol.o" &&
        firmware "$BUILD" && parts=$(cat "$work/code") &&
        firmware "$work/m0" LIBRARY="$work/one/libqvol.a" LIBRARY_OBJECTS= &&
        whole=$(cat "$work/code") &&
        echo "# smallest firmware: $whole bytes of one source, $parts of many" >"$work/sizes" &&
        [ "$((whole * 100))" -le "$((parts * (100 + LIMIT)))" ] &&
        [ "$((whole * 100))" -ge "$((parts * (100 - LIMIT)))" ]
}

whole() { # whole NM COMPILER OPTION...
    nm=$1
    shift
    compiles "$@" && holds_everything "$nm" "$work/qvol.o"
}

check "the example draws here" expected
check "the page has lines for one header and one source" lines "One header and one source"
check "they build the example" follow
check "it draws the picture" runs_here "$site/ball"
check "clang: no warning, nothing missing" whole nm clang -O0
check "avr-gcc: no warning, nothing missing" whole avr-nm avr-gcc -mmcu=atmega1284p -O0
check "the tests of make check" make -s BUILD="$BUILD" check-amalgamation
check "within $LIMIT % of the separate sources on a Cortex-M0" as_small
cat "$work/sizes" 2>/dev/null || :
finish
