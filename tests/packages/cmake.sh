#!/bin/sh
# The CMake package: installed, found by a project of its own, for this machine and for a device.
set -eu
. tests/packages/common

for_a_device() {
    rm -rf "$site"
    mkdir "$site"
    CMAKE_TOOLCHAIN_FILE=$STAND_IN/cortex-m4.cmake follow
}

installed() {
    (cd "$site/sdk" && find . -type f | sort) >"$work/installed"
    cat "$work/installed"
    grep -Fx ./include/qvol.h "$work/installed" && ! grep -v 'qvol' "$work/installed"
}

pkg_config() {
    file=$(find "$site/sdk" -name qvol.pc)
    # shellcheck disable=SC2046 # several options
    PKG_CONFIG_PATH=$(dirname "$file") && export PKG_CONFIG_PATH &&
        "$CC" port/example/*.c $(pkg-config --cflags --libs qvol) -o "$work/program" &&
        runs_here "$work/program"
}

refuses_another_version() {
    sed -i 's/find_package(qvol [0-9.]*/find_package(qvol 999/' "$site/ball/CMakeLists.txt"
    ! cmake -S "$site/ball" -B "$work/refused" -DCMAKE_PREFIX_PATH="$site/sdk"
}

check "the example draws here" expected
check "port/README.md has lines for CMake" lines CMake
check "they build the example" follow
check "it draws the picture" runs_here "$site/build/ball"
check "the library is whole" holds_everything nm "$site"/sdk/lib*/libqvol.a
check "nothing but qvol is installed" installed
check "its pkg-config file finds it" pkg_config
check "another version is not found" refuses_another_version
check "the same lines for a Cortex-M4" for_a_device
check "the firmware draws the picture" runs_on cortex-m4 "$site/build/ball"
check "it has the assembly of Thumb-2" \
    sh -c "arm-none-eabi-nm '$site/build/ball' | grep ' T walk_march_indexed8'"
check "its library is whole" holds_everything arm-none-eabi-nm "$site/sdk/lib/libqvol.a"
finish
