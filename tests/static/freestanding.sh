#!/bin/sh
# core and fixedpoint compile with no configuration and no C library: nothing but
# the headers that a freestanding compiler brings itself.
set -eu
top=$(pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
number=0
failed=0

# compiles NAME COMPILER OPTION...: every file in one command, as a user would.
compiles() {
    name=$1
    shift
    number=$((number + 1))
    if (cd "$work" && "$@" -std=c99 -ffreestanding -nostdinc \
        -isystem "$("$@" -print-file-name=include)" -I"$top/core" -I"$top/fixedpoint" \
        -c "$top"/core/*.c "$top"/fixedpoint/*.c) 2>"$work/messages"; then
        echo "ok $number - freestanding build: $name"
    else
        failed=$((failed + 1))
        echo "not ok $number - freestanding build: $name"
        sed 's/^/# /' "$work/messages"
    fi
}

compiles gcc gcc
compiles clang clang
compiles "gcc, 32 bits" gcc -m32
compiles "Cortex-M0" arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb
compiles "Cortex-M3" arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
echo "1..$number"
[ "$failed" -eq 0 ]
