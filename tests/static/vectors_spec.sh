#!/bin/sh
# The test vectors follow from tests/SPEC.md: a program that is written from it alone, on GMP and
# MPFR, gets the inputs of each stage and nothing else, and writes the same file to the byte.
set -eu
. tests/tap
: "${BUILD:=build}"
generator=$BUILD/tests/vectors/from_spec

# inputs STAGE: its file, with every value taken out that is no input.
inputs() {
    awk -F'\t' -v OFS=, -v stage="$1" '
        NR == FNR { if ($1 == stage && $4 == "in") input[$3]; next }
        FNR == 1 { for (i = 3; i <= NF; i++) is_result[i] = !($i in input) }
        FNR > 1 { for (i = 3; i <= NF; i++) if (is_result[i]) $i = "" }
        { print }' tests/vectors/fields.tsv FS=, "tests/vectors/$1.csv"
}

same() {
    inputs "$1" >"$work/inputs" && "$generator" "$1" <"$work/inputs" >"$work/computed" &&
        cmp "$work/computed" "tests/vectors/$1.csv"
}

check "it is built without the library's headers" make -s BUILD="$BUILD" "$generator"
"$generator" --list >"$work/known"
cut -f1 tests/vectors/fields.tsv | sed 1d | uniq >"$work/stages"
while read -r stage; do
    rows=$(($(wc -l <"tests/vectors/$stage.csv") - 1))
    check "$stage: $rows rows follow from SPEC.md" same "$stage"
done <"$work/stages"
check "it knows these stages and no others" cmp "$work/stages" "$work/known"

# What it would not notice, it could not test: a row with another input has other results.
sed 's/^\(weights-00001,[a-z]*\),1,/\1,2,/' tests/vectors/weights.csv >"$work/changed"
"$generator" weights <"$work/changed" >"$work/computed"
outcome "$(cmp -s "$work/changed" "$work/computed" && echo 1 || echo 0)" "a changed input shows"
finish
