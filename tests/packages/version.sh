#!/bin/sh
# One version: that of qvol.h stands in every manifest of every package, the newest of CHANGELOG.md
# is the same, and no manifest has a mark that was not filled in.
set -eu
. tests/packages/common

VERSION=$(printf '#include "qvol.h"\nQV_VERSION\n' | "$CC" -E -P -Icore - | tail -n 1 | tr -d '"')

agrees() { # agrees FILE COMMAND...: which prints the version that the file names, once or more
    file=$1
    shift
    "$@" "$DIST/$file" | sort -u >"$work/named"
    echo "$file: $(cat "$work/named")"
    printf '%s\n' "$VERSION" | cmp -s - "$work/named"
}

of_numbers() {
    printf '#include "qvol.h"\nQV_VERSION_MAJOR.QV_VERSION_MINOR.QV_VERSION_PATCH\n' |
        "$CC" -E -P -Icore - | tail -n 1 | tr -d ' ' | grep -Fx "$VERSION"
}

json() {
    "$PYTHON" -c 'import json, sys; print(json.load(open(sys.argv[1]))["version"])' "$1"
}

yaml() {
    "$PYTHON" -c 'import sys, yaml; print(yaml.safe_load(open(sys.argv[1]))["version"])' "$1"
}

marks() {
    ! grep -rnE '@[A-Z]+@' "$DIST" --include='*' | grep -v 'qvol.pc.in:.*@\(PREFIX\|LIBDIR\)@'
}

# Every manifest of port/ that can name the version has been asked here.
all_asked() {
    grep -rl '@VERSION@' port | sort >"$work/with_version"
    sort >"$work/asked" <<'LIST'
port/arduino/library.properties
port/cmake/CMakeLists.txt
port/cmake/example/CMakeLists.txt
port/cmsis/example/ball.csolution.yml
port/cmsis/qvol.qvol.pdsc
port/esp-idf/CMakeLists.txt
port/esp-idf/idf_component.yml
port/pkg-config/qvol.pc.in
port/platformio/library.json
port/zephyr/zephyr/CMakeLists.txt
port/zephyr/zephyr/Kconfig
port/zephyr/zephyr/module.yml
LIST
    diff "$work/with_version" "$work/asked"
}

comment() { # the version in a file's first lines
    sed -n 's/^# qvol \([0-9.]*[0-9]\).*/\1/p' "$1"
}

check "QV_VERSION is its three numbers" of_numbers
check "every manifest with a version is asked" all_asked
check "CMake" agrees cmake/qvol/CMakeLists.txt sed -n 's/^project(qvol VERSION \([^ ]*\).*/\1/p'
check "CMake's example" agrees cmake/qvol/example/CMakeLists.txt \
    sed -n 's/^find_package(qvol \([^ ]*\) .*/\1/p'
check "pkg-config" agrees cmake/qvol/qvol.pc.in sed -n 's/^Version: //p'
for file in zephyr/module.yml zephyr/Kconfig zephyr/CMakeLists.txt; do
    check "Zephyr's $file" agrees zephyr/qvol/$file comment
done
check "ESP-IDF" agrees esp-idf/qvol/idf_component.yml yaml
check "ESP-IDF's CMakeLists.txt" agrees esp-idf/qvol/CMakeLists.txt comment
check "PlatformIO" agrees platformio/qvol/library.json json
check "Arduino" agrees arduino/qvol/library.properties sed -n 's/^version=//p'
check "CMSIS-Pack: release" agrees cmsis/qvol/qvol.qvol.pdsc \
    sed -n 's/.*<release version="\([^"]*\)".*/\1/p'
check "CMSIS-Pack: component" agrees cmsis/qvol/qvol.qvol.pdsc sed -n 's/.*Cversion="\([^"]*\)".*/\1/p'
check "CMSIS-Pack's example" agrees cmsis/qvol/example/ball.csolution.yml \
    sed -n 's/.*pack: qvol::qvol@>=//p'
check "one header and one source" agrees amalgamation/qvol.h \
    sed -n 's/^#define QV_VERSION  *"\(.*\)"/\1/p'
check "CHANGELOG.md" agrees cmake/qvol/CHANGELOG.md awk '/^## / && !n++ { print $2 }'
check "no mark is left" marks
finish
