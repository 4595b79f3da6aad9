#!/bin/sh
# The figures of one program of size.mk, in bytes, as a line of words:
#
#     tests/size/measure.sh TARGET NAME [OBJDUMP]
#
#     TARGET NAME CODE TABLES DATA BSS CONTEXT SCRATCH GRAPH RUN CALL
#
# CONTEXT is what the library keeps of a scene in the caller's memory, SCRATCH what it works
# in there beside pixels (size.h). GRAPH is the deepest stack below any call of a function that is
# linked, by the graph of calls, and CALL which; RUN what the emulator saw below the calls that
# were made, which must not be more. "-" stands for what cannot be told: without OBJDUMP
# stacks, as of a machine that keeps its own.
set -eu
if [ $# -ne 2 ] && [ $# -ne 3 ]; then
    echo "usage: tests/size/measure.sh TARGET NAME [OBJDUMP]" >&2
    exit 2
fi
out=${BUILD:-build}/$1
program=$out/size_$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

toolchain/size_report "$program.map" >"$work/sizes"
echo - - >"$work/graph"
if [ $# -eq 3 ]; then
    export EMULATOR_REPORT="$work/regions"
    toolchain/stack_report "$3" "$program.elf" "$program.map" "$out" tests/size/indirect_calls \
        >"$work/graph"
fi
run=-
if [ "$2" = library ]; then
    printf 'context -\nscratch -\n' >>"$work/sizes"
else
    toolchain/emulate "$1" "$program.elf" >>"$work/sizes"
fi
if [ -s "$work/regions" ]; then
    run=$(awk '{ for (i = 3; i < NF; i += 2) if ($i == "stack" && $(i + 1) > most) most = $(i + 1) }
               END { print most }' "$work/regions")
fi
read -r graph call <"$work/graph"
if [ "$run" != - ] && [ "$run" -gt "$graph" ]; then
    echo "measure.sh: $program took a stack of $run bytes, its graph of calls says $graph" >&2
    exit 1
fi
awk -v target="$1" -v name="$2" -v stack="$graph $run $call" '
    { of[$1] = $2 }
    END { print target, name, of["code"], of["tables"], of["data"], of["bss"], of["context"],
              of["scratch"], stack }' "$work/sizes"
