#!/bin/sh
# The errors in the table of qvol advise are what tests/advise/errors.c measures. Its costs are
# compared where they are counted anyway: tests/device/insns.sh.
set -u
. tests/tap
BUILD=${BUILD:-build}
export BUILD

check "the programs are built" \
    make -s BUILD="$BUILD" "$BUILD/tests/advise/errors" "$BUILD/host/qvol"
check "errors are measured" sh -c '"$1" >"$2"' - "$BUILD/tests/advise/errors" "$work/measured"
check "the table is read" sh -c 'tests/bench/advise.sh lines | grep "^error " >"$1"' - "$work/table"
check "every mode has its errors" sh -c 'sort "$1" | diff -u "$2" -' - "$work/measured" "$work/table"
# shellcheck disable=SC2016
check "every mode has its costs on every target" sh -c '
    tests/bench/advise.sh lines | awk "
        /^error/ { modes += \$4 == 1; next }
        \$2 != \"blend\" { costs[\$1]++ }
        END {
            for (t in costs) { targets++; if (costs[t] != modes) { print t, costs[t]; exit 1 } }
            exit targets != 11
        }"'

# shellcheck disable=SC2016
check "README.md shows what the table says (make readme)" sh -c '
    sed -n "/^<!-- choices -->/,/^<!-- \/choices -->/p" README.md | sed "1d;\$d" >"$1/shown"
    tests/bench/choose.sh | diff -u "$1/shown" -' - "$work"
finish
