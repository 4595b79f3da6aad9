#!/bin/sh
# Operation counts: the library built with FX_COUNTING, where numbers of the kernel
# are structures. Also that a raw * or + on them does not compile.
set -u
: "${CC:=cc}"
. tests/tap
flags="-std=c99 -pedantic -Wall -Wextra -Werror -O1 -DFX_COUNTING=1 -Icore -Ifixedpoint -Itests/counting"

# shellcheck disable=SC2086 # several options
check "the counting build compiles" $CC $flags core/*.c fixedpoint/*.c tests/counting/*.c \
    -o "$work/counting"
"$work/counting" >"$work/tap"
while read -r line; do
    case $line in
    ok\ *) outcome 0 "${line#*- }" ;;
    *) outcome 1 "${line#*- }" ;;
    esac
done <"$work/tap"

compiles_raw() { # compiles_raw OPERATION
    printf '#include "fx_weight.h"\nfx_weight f(fx_weight v);\nfx_weight f(fx_weight v) { return %s; }\n' \
        "$1" >"$work/raw.c"
    # shellcheck disable=SC2086
    $CC $flags -c "$work/raw.c" -o "$work/raw.o" 2>/dev/null
}

for operation in 'v * v' 'v + v' 'v - v'; do
    ! compiles_raw "$operation"
    outcome $? "a raw '$operation' of weights does not compile"
done
finish
