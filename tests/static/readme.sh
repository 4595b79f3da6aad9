#!/bin/sh
# The examples of README.md, its C blocks, compile without a warning for this machine
# and for a Cortex-M0, and link there with nothing but the library.
set -eu
. tests/tap
build=${BUILD:-build}

awk -v work="$work" '
    /^```c$/ { inside = 1; file = work "/example" ++count ".c"; next }
    /^```/   { inside = 0 }
    inside   { print >file }' README.md
make -s TARGET=cortex-m0 BUILD="$build" lib >&2

strict="-std=c99 -pedantic -Wall -Wextra -Werror -Icore"
# What an example leaves to its reader (the volume, a function that sends pixels) may
# stay undefined; no function of the library may.
unknown() { # unknown EXAMPLE
    arm-none-eabi-ld -r "$1.o" "$build/cortex-m0/libqvol.a" -o "$1.linked" &&
        ! arm-none-eabi-nm -u "$1.linked" | grep ' qv_' >&2
}

check "README.md has three examples" test -s "$work/example3.c"
for source in "$work"/example*.c; do
    name=$(basename "$source" .c)
    # shellcheck disable=SC2086 # several options
    check "$name compiles here" gcc $strict -c "$source" -o "$work/host.o"
    # shellcheck disable=SC2086
    check "$name compiles for a Cortex-M0" arm-none-eabi-gcc $strict -mcpu=cortex-m0 -mthumb -Os \
        -ffreestanding -c "$source" -o "$work/$name.o"
    check "$name calls functions of the library" unknown "$work/$name"
done
finish
