#!/bin/sh
# qvol.h from C++: three standards, two compilers, warnings as errors, linked with
# the library and run.
set -eu
. tests/tap
build=${BUILD:-build}

cat >"$work/program.cpp" <<'END'
#include "qvol.h"
#include <cstring>

int main()
{
    qv_transfer table;
    qv_control_point points[2];
    std::memset(points, 0, sizeof points);
    points[1].index = 255;
    points[1].rgba[3] = 65535;
    if (qv_transfer_build(&table, points, 2) != QV_OK || table.rgba[255][3] != 65535)
        return 1;
    qv_scene scene = qv_scene();
    qv_classifier classifier = qv_classifier();
    qv_block block = qv_block();
    if (qv_classify(points, sizeof points, scene.volume.storage, &classifier, &block) == QV_OK)
        return 4;
    scene.sampling = &qv_weighted_indexed8;
    qv_context context;
    if (qv_init(&context, &scene) == QV_OK)
        return 2;
    return std::strcmp(qv_version(), QV_VERSION) == 0 ? 0 : 3;
}
END

make -s TARGET=host BUILD="$build" lib >&2
runs() { # runs COMPILER STANDARD
    $1 -std="$2" -pedantic -Wall -Wextra -Werror -Icore "$work/program.cpp" \
        "$build/host/libqvol.a" -o "$work/program" && "$work/program"
}

for compiler in g++ clang++; do
    for standard in c++98 c++11 c++17; do
        check "$compiler -std=$standard" runs $compiler $standard
    done
done
finish
