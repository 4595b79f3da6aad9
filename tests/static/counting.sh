#!/bin/sh
# Operation counts: the library built with FX_COUNTING, where numbers of the kernel
# are structures. Also that a raw * or + on them does not compile.
set -u
: "${CC:=cc}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
flags="-std=c99 -pedantic -Wall -Wextra -Werror -O1 -DFX_COUNTING=1 -Icore -Ifixedpoint -Itests/counting"

# shellcheck disable=SC2086
$CC $flags core/*.c fixedpoint/*.c tests/counting/*.c -o "$work/counting" && "$work/counting"
code=$?
[ "$code" -le 1 ] || exit "$code"

for operation in 'v * v' 'v + v' 'v - v'; do
    printf '#include "fx_weight.h"\nfx_weight f(fx_weight v);\nfx_weight f(fx_weight v) { return %s; }\n' \
        "$operation" >"$work/raw.c"
    # shellcheck disable=SC2086
    if $CC $flags -c "$work/raw.c" -o "$work/raw.o" 2>/dev/null; then
        echo "not ok - a raw '$operation' of weights compiles"
        code=1
    else
        echo "ok - a raw '$operation' of weights does not compile"
    fi
done
exit "$code"
