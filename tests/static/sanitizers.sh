#!/bin/sh
# Unit tests, golden scenes and the tests of the command on a build that stops at
# any undefined behaviour and any access beyond an object.
set -eu
build=${BUILD:-build}/sanitized
unset MAKEFLAGS MFLAGS MAKELEVEL # of a make that runs this script
number=0
failed=0

result() { # result STATUS NAME: STATUS 0 has passed
    number=$((number + 1))
    [ "$1" -eq 0 ] || failed=1
    [ "$1" -eq 0 ] || printf 'not '
    echo "ok $number - sanitized: $2"
}

# runs NAME COMMAND...: what a failed one says follows its name.
runs() {
    name=$1
    shift
    status=0
    "$@" >"$work/log" 2>&1 || status=1
    result $status "$name"
    [ $status -eq 0 ] || grep -v -e '^ok ' -e '^  [A-Z][A-Z]  ' "$work/log" | head -n 40 | sed 's/^/# /'
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

export BUILD="$build" QVOL="$build/host/qvol" CC=gcc
export CFLAGS="-g -fsanitize=address,undefined -fno-sanitize-recover=all" OPTIMISE=-O1
# The address space holds the sanitizers' maps: memory is limited by the allocator.
export MEMORY_KB=unlimited ASAN_OPTIONS=allocator_may_return_null=1:max_allocation_size_mb=512

runs "unit tests and golden scenes" make -s BUILD="$build" check
runs "the command compiles" make -s BUILD="$build" "$QVOL"
for script in tests/command/*.sh; do
    case $script in
    */fuzz.sh | */packages.sh) continue ;; # build the command themselves
    esac
    runs "$script" sh "$script"
done
echo "1..$number"
exit $failed
