#!/bin/sh
# The adapters of port/display/ compile against the names and types of what they adapt to, by GCC
# and Clang, warnings as errors, and their panels show what qv_render makes of the whole frame.
set -eu
. tests/tap
build=${BUILD:-build}
WARNINGS="-pedantic -Wall -Wextra -Werror -Wconversion -Wshadow -Wcast-qual -Wundef"
INCLUDE="-Icore -Iport/display -Itests/display"

# built CC CXX: compiles the adapters and their test.
# shellcheck disable=SC2086 # options are several words
built() {
    rm -f "$work"/*.o
    for source in port/display/*.c tests/display/*.c; do
        $1 -std=c99 $WARNINGS $INCLUDE -c "$source" -o "$work/$(basename "$source" .c).o" || return 1
    done
    for source in port/display/*.cpp tests/display/*.cpp; do
        $2 -std=c++11 $WARNINGS $INCLUDE -c "$source" -o "$work/$(basename "$source" .cpp).o" ||
            return 1
    done
    $2 "$work"/*.o "$build/host/libqvol.a" -o "$work/adapters"
}

make -s TARGET=host BUILD="$build" lib >&2
check "adapters compile by clang" built clang clang++
check "adapters compile by gcc" built gcc g++
"$work/adapters" >"$work/tap" || true
while read -r line; do
    case $line in
    ok\ *) outcome 0 "${line#*- }" ;;
    not\ ok\ *) outcome 1 "${line#*- }" ;;
    esac
done <"$work/tap"
grep -q '^1\.\.' "$work/tap" && status=0 || status=1
outcome $status "all adapters ran"
finish
