#!/bin/sh
# What the library takes on each target, by configuration (size.mk), all built with -Os:
#
#     tests/size/sizes.sh lines TARGET...    the lines of measure.sh
#     tests/size/sizes.sh table              such lines, from standard input, as Markdown
#     tests/size/sizes.sh document           the same, as SIZES.md
#     tests/size/sizes.sh readme             the same, as a table for README.md
set -eu
usage() {
    echo "usage: tests/size/sizes.sh lines TARGET... | table | document | readme" >&2
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

compilers() {
    for compiler in arm-none-eabi-gcc riscv64-unknown-elf-gcc avr-gcc powerpc-linux-gnu-gcc gcc \
        clang; do
        echo "- $($compiler --version | head -n 1)"
    done
}

document() {
    cat <<'END'
# Sizes

`make size-update` writes this file; the tests fail where a figure is more than 1 % above it. In
bytes, at `-Os`, of what a program takes of the library, of the compiler's helpers and of memcpy,
memset and memmove: flash (code, tables), RAM from start to end (.data, .bss), what the library
keeps of a scene in the caller's memory (context), what it works in there beside pixels (scratch: a
transfer table, a frame buffer of 16x8 pixels, or sums of as many), and the stack below the
deepest call of a function that is linked: by the graph of calls, and as the emulator saw it below
the calls that the program makes. A dash stands for what cannot be told: WebAssembly keeps a stack
of its own.

| configuration | what the program uses, all of indexed8 into RGB565 |
|---|---|
| minimal | one weighted mode, an orthographic camera |
| perspective | the same with a perspective camera |
| rays | both cameras, a few pixels a call, classification of scalars |
| extinction | rays, and sampling of extinction |
| dithering | rays, and dithered slices into a frame buffer |
| pyramid | rays, and levels made, chosen and sampled by extinction |
| freevoxels | rays, and FreeVoxels: attenuation, its levels, splats with a lamp |
| everything | all of these |
| library | every function of the library at once, for its deepest stack; runs nowhere |

Compilers:

END
    compilers
    echo
    table
}

# The minimal program on every target, and every program on the smallest Cortex-M.
readme() {
    cat <<'END'
Bytes at `-Os` (indexed8 into RGB565; compiler's helpers included) of the smallest program on every
target, and of what a device may want besides on a Cortex-M0; `make size` prints them all, and
[tests/size/SIZES.md](tests/size/SIZES.md) says what each program uses. Stack is that below the
deepest call, by the graph of calls:

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
document) document ;;
readme) readme ;;
*) usage ;;
esac
