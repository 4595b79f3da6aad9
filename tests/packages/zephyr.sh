#!/bin/sh
# The Zephyr module: its description, its Kconfig and its sources, in an application of its own.
set -eu
. tests/packages/common

# Without CONFIG_QVOL nothing is built.
is_left_out() {
    sed -i 's/CONFIG_QVOL=y/CONFIG_QVOL=n/' "$site/ball/prj.conf"
    rm -rf "$site/build"
    ! (cd "$site" && sh -eu "$work/lines.build") && [ ! -e "$site/build/modules/module/libqvol.a" ]
}

check "the example draws here" expected
check "port/README.md has lines for Zephyr" lines Zephyr
check "they build the example" follow
check "the firmware draws the picture" runs_on cortex-m0 "$site/build/zephyr/zephyr.elf"
check "the library is whole" holds_everything arm-none-eabi-nm "$site/build/modules/module/libqvol.a"
grep west "$work/lines" >"$work/lines.build"
check "without CONFIG_QVOL it is left out" is_left_out
finish
