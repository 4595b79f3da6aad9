#!/bin/sh
# Layout of every C file, static analysis of the library, and shell scripts.
set -eu
. tests/tap
check "make lint" make -s lint
finish
