#!/bin/sh
# The ESP-IDF component: its manifest and its sources, in an application of its own.
set -eu
. tests/packages/common
check "the example draws here" expected
check "port/README.md has lines for ESP-IDF" lines ESP-IDF
check "they build the example" follow
check "the firmware draws the picture" runs_on cortex-m0 "$site/ball/build/ball.elf"
check "the library is whole" \
    holds_everything arm-none-eabi-nm "$site/ball/build/esp-idf/qvol/libqvol.a"
finish
