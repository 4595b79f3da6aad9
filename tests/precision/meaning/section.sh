#!/bin/sh
# Section 3: what to choose for an error that is wanted.
set -eu
exec tests/bench/choose.sh report
