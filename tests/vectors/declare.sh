#!/bin/sh
# Declares the rows of a folder of vectors: what the first N rows of a stage hash to under a
# version of the specification. A line is only ever added, so that rows that change under the same
# version contradict what was declared; tests/static/vectors.sh compares.
set -eu
folder=$1
declared=$folder/declared
version=$(sed -n 's/^#define QV_SPECIFICATION  *\([0-9]*\)$/\1/p' core/qvol.h)
touch "$declared"
for file in "$folder"/*.csv; do
    rows=$(($(wc -l <"$file") - 1))
    line="$version $(basename "$file" .csv) $rows"
    grep -q "^$line " "$declared" ||
        echo "$line $(sha256sum <"$file" | cut -d' ' -f1)" >>"$declared"
done
