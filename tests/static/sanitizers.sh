#!/bin/sh
# Unit tests, golden scenes and the tests of the command on a build that stops at
# any undefined behaviour and any access beyond an object.
set -eu
. tests/tap
build=${BUILD:-build}/sanitized


export BUILD="$build" QVOL="$build/host/qvol" CC=gcc
export CFLAGS="-g -fsanitize=address,undefined -fno-sanitize-recover=all" OPTIMISE=-O1
# The address space holds the sanitizers' maps: memory is limited by the allocator.
export MEMORY_KB=unlimited ASAN_OPTIONS=allocator_may_return_null=1:max_allocation_size_mb=512

check "sanitized: unit tests and golden scenes" make -s BUILD="$build" check
check "sanitized: the command compiles" make -s BUILD="$build" "$QVOL"
for script in tests/command/*.sh; do
    case $script in
    */fuzz.sh | */packages.sh) continue ;; # build the command themselves
    esac
    check "sanitized: $script" sh "$script"
done
finish
