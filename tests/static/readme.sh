#!/bin/sh
# The example of README.md, its first C block, compiles without a warning for this
# machine and for a Cortex-M0, and links there with nothing but the library.
set -eu
. tests/tap
build=${BUILD:-build}

awk '/^```c$/ && !done { inside = 1; next }
     /^```/ && inside  { inside = 0; done = 1 }
     inside' README.md >"$work/example.c"
check "README.md has an example" test -s "$work/example.c"
make -s TARGET=cortex-m0 BUILD="$build" lib >&2

strict="-std=c99 -pedantic -Wall -Wextra -Werror -Icore"
# shellcheck disable=SC2086 # several options
check "the example compiles here" gcc $strict -c "$work/example.c" -o "$work/host.o"
# shellcheck disable=SC2086
check "the example compiles for a Cortex-M0" arm-none-eabi-gcc $strict -mcpu=cortex-m0 -mthumb \
    -Os -ffreestanding -c "$work/example.c" -o "$work/device.o"

# What the example leaves to its reader (the volume, a function that sends pixels)
# may stay undefined; no function of the library may.
unknown() {
    arm-none-eabi-ld -r "$work/device.o" "$build/cortex-m0/libqvol.a" -o "$work/linked.o" &&
        ! arm-none-eabi-nm -u "$work/linked.o" | grep ' qv_' >&2
}
check "the example's functions are the library's" unknown
finish
