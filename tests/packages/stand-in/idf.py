#!/bin/sh
# Stands for ESP-IDF's tool:
#
#     idf.py -C FOLDER set-target CHIP | build
#
# Checks each component's idf_component.yml and builds with the functions of
# esp-idf/tools/cmake/project.cmake, whatever the chip, for a Cortex-M0.
set -eu
if [ $# -lt 3 ] || [ "$1" != -C ]; then
    echo "usage: idf.py -C FOLDER set-target CHIP | build" >&2
    exit 2
fi
folder=$2
case $3 in
set-target) exit 0 ;;
build) ;;
*) exit 2 ;;
esac
for manifest in "$folder"/components/*/idf_component.yml; do
    "$PYTHON" "$STAND_IN/esp-idf/manifest.py" "$manifest"
done
IDF_PATH=$STAND_IN/esp-idf cmake -S "$folder" -B "$folder/build" \
    -DCMAKE_TOOLCHAIN_FILE="$STAND_IN/cortex-m0.cmake"
cmake --build "$folder/build"
