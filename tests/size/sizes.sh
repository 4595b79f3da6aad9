#!/bin/sh
# What the library takes on each target, by configuration (size.mk), all built with -Os:
#
#     tests/size/sizes.sh lines TARGET...    the lines of measure.sh
#     tests/size/sizes.sh table              such lines, from standard input, as Markdown
#     tests/size/sizes.sh readme             the same, for README.md
set -eu
usage() {
    echo "usage: tests/size/sizes.sh lines TARGET... | table | readme" >&2
    exit 2
}
[ $# -ge 1 ] || usage
kind=$1
shift

# lines TARGET: the golden tests build the same library.
lines() {
    build=${BUILD:-build}/golden-Os
    make -s TARGET="$1" BUILD="$build" OPTIMISE=-Os "$build/$1/sizes" >&2
    cat "$build/$1/sizes"
}

table() {
    cat <<'END'
| target | configuration | code | tables | .data | .bss | context | scratch | stack | seen | deepest call |
|---|---|---|---|---|---|---|---|---|---|---|
END
    awk '{ printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n",
           $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, "`" $11 "`" }'
}

# The minimal program on every target, and every program on the smallest Cortex-M.
readme() {
    cat <<'END'
| target | program | code and tables | .data, .bss | context | stack |
|---|---|---|---|---|---|
END
    awk '$1 == "cortex-m0" && $2 != "library" || $2 == "minimal" {
        printf "| %s | %s | %d | %d, %d | %s | %s |\n", $1, $2, $3 + $4, $5, $6, $7, $9 }'
}

case $kind in
lines)
    for target; do
        lines "$target"
    done
    ;;
table) table ;;
readme) readme ;;
*) usage ;;
esac
