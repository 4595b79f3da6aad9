#!/bin/sh
# core and fixedpoint hold no floating point: no constant of that kind stands in
# them, and they compile with the types' names poisoned and with floating-point
# registers forbidden.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
number=0
failed=0

# compiles NAME COMPILER OPTION...: every file, one result.
compiles() {
    name=$1
    shift
    number=$((number + 1))
    for file in core/*.c fixedpoint/*.c; do
        if ! "$@" -std=c99 -O2 -ffreestanding -Icore -Ifixedpoint -include tests/static/poison.h \
            -c "$file" -o "$work/object.o" 2>"$work/messages"; then
            failed=$((failed + 1))
            echo "not ok $number - no floating point for $name: $file"
            sed 's/^/# /' "$work/messages"
            return
        fi
    done
    echo "ok $number - no floating point for $name"
}

# floating_constants FILE: prints floating constants, which compilers fold away
# before any other check sees them. Comments and strings are taken out first.
floating_constants() {
    gcc -fpreprocessed -dD -E -P "$1" 2>/dev/null | sed 's/"[^"]*"//g' |
        grep -E '(^|[^[:alnum:]_.])([0-9]+\.[0-9]*|\.[0-9]+|[0-9]+[eE][-+]?[0-9]+|0[xX][[:xdigit:].]+[pP][-+]?[0-9]+)'
}

no_constants() {
    number=$((number + 1))
    for file in core/*.[ch] fixedpoint/*.[ch]; do
        if floating_constants "$file" >"$work/constants"; then
            failed=$((failed + 1))
            echo "not ok $number - no floating constant: $file"
            sed 's/^/# /' "$work/constants"
            return
        fi
    done
    echo "ok $number - no floating constant"
}

# The search must find each form that C knows.
finds_constants() {
    number=$((number + 1))
    for constant in 0.5 .5f 1. 1e3 2E-1L 0x1p-2; do
        echo "int half(void) { return (int)($constant * 65536); }" >"$work/constant.c"
        if ! floating_constants "$work/constant.c" >/dev/null; then
            failed=$((failed + 1))
            echo "not ok $number - a floating constant is found: $constant"
            return
        fi
    done
    echo "ok $number - a floating constant is found in every form"
}

compiles "this machine, gcc" gcc -mgeneral-regs-only
compiles "this machine, clang" clang
compiles "Cortex-M0" arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb -mgeneral-regs-only
compiles "Cortex-M3" arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb -mgeneral-regs-only
no_constants
finds_constants
echo "1..$number"
[ "$failed" -eq 0 ]
