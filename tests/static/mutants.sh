#!/bin/sh
# A fixed sample of the mutants of the numeric stages: each must change a row of the test vectors.
# make mutants runs all of them; tests/mutation/README.md says what that means.
. tests/tap
BUILD=${BUILD:-build}

/usr/bin/python3 tests/mutation/mutate.py --sample tests/mutation/sample --out "$BUILD/mutants-sample" \
    >"$work/mutants" 2>&1
outcome $? "sample of mutants: it ran"
sed 's/^/# /' "$work/mutants"
grep -q '^[1-9][0-9]* mutants: [0-9]* killed, 0 survived' "$work/mutants"
outcome $? "sample of mutants: none survived"
finish
