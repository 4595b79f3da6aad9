#!/bin/sh
# Layout of every C file, static analysis of the library, and shell scripts.
set -eu
unset MAKEFLAGS MFLAGS MAKELEVEL # of a make that runs this script
echo "1..1"
if messages=$(make -s lint 2>&1); then
    echo "ok 1 - make lint"
else
    echo "not ok 1 - make lint"
    printf '%s\n' "$messages" | sed 's/^/# /'
    exit 1
fi
