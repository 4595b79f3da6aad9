#!/bin/sh
# core and fixedpoint compile with no configuration and no C library: nothing but
# the headers that a freestanding compiler brings itself.
set -eu
. tests/tap
top=$(pwd)

# compiles COMPILER OPTION...: every file in one command, as a user would.
compiles() {
    cd "$work" && "$@" -std=c99 -ffreestanding -nostdinc \
        -isystem "$("$@" -print-file-name=include)" -I"$top/core" -I"$top/fixedpoint" \
        -c "$top"/core/*.c "$top"/fixedpoint/*.c
}

builds() { # builds NAME COMPILER OPTION...
    name=$1
    shift
    (compiles "$@") >"$work/messages" 2>&1 && status=0 || status=$?
    outcome $status "freestanding build: $name"
    [ $status -eq 0 ] || sed 's/^/# /' "$work/messages"
}

builds gcc gcc
builds clang clang
builds "gcc, 32 bits" gcc -m32
builds "Cortex-M0" arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb
builds "Cortex-M3" arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
builds "AVR" avr-gcc -mmcu=atmega1284p
finish
