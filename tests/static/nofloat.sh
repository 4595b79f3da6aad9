#!/bin/sh
# core and fixedpoint hold no floating point: no constant of that kind stands in
# them, and they compile with the types' names poisoned and with floating-point
# registers forbidden.
set -eu
. tests/tap

# compiles COMPILER OPTION...: every file.
compiles() {
    for file in core/*.c fixedpoint/*.c; do
        "$@" -std=c99 -O2 -ffreestanding -Icore -Ifixedpoint -include tests/static/poison.h \
            -c "$file" -o "$work/object.o" || return
    done
}

# floating_constants FILE: prints floating constants, which compilers fold away
# before any other check sees them. Comments and strings are taken out first.
floating_constants() {
    gcc -fpreprocessed -dD -E -P "$1" 2>/dev/null | sed 's/"[^"]*"//g' |
        grep -E '(^|[^[:alnum:]_.])([0-9]+\.[0-9]*|\.[0-9]+|[0-9]+[eE][-+]?[0-9]+|0[xX][[:xdigit:].]+[pP][-+]?[0-9]+)'
}

no_constants() {
    for file in core/*.[ch] fixedpoint/*.[ch]; do
        if floating_constants "$file"; then
            echo "$file"
            return 1
        fi
    done
}

# The search must find each form that C knows.
finds_constants() {
    for constant in 0.5 .5f 1. 1e3 2E-1L 0x1p-2; do
        echo "int half(void) { return (int)($constant * 65536); }" >"$work/constant.c"
        if ! floating_constants "$work/constant.c" >/dev/null; then
            echo "$constant"
            return 1
        fi
    done
}

check "no floating point for this machine, gcc" compiles gcc -mgeneral-regs-only
check "no floating point for this machine, clang" compiles clang
check "no floating point for Cortex-M0" compiles arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb \
    -mgeneral-regs-only
check "no floating point for Cortex-M3" compiles arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb \
    -mgeneral-regs-only
check "no floating constant" no_constants
check "a floating constant is found in every form" finds_constants
finish
