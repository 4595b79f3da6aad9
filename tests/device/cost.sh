#!/bin/sh
# What sampling costs beside opacity-weighted sampling of the same width: instructions a
# sample on the emulated Cortex-M3, exact, as tests/bench/device.sh counts them in a scene
# where every sample is taken. The base of each ratio is what weighted took when the ratio was
# set, so that a faster kernel of weighted does not count against the others.
set -eu
. tests/tap
build=${BUILD:-build}

counted() { # all modes, into $work/counts
    BUILD=$build tests/bench/device.sh cortex-m3 >"$work/counts"
}

figure() { # figure STORAGE MODE
    awk -v storage="$1" -v mode="$2" '$1 == storage && $2 == mode && $3 == "full" { print $4 }' \
        "$work/counts"
}

at_most() { # at_most TIMES STORAGE MODE BASE WEIGHTED
    cost=$(figure "$2" "$3")
    weighted=$(figure "$5" weighted)
    status=0
    awk -v cost="${cost:-0}" -v times="$1" -v base="$4" \
        'BEGIN { exit !(cost + 0 > 0 && cost + 0 <= times * base) }' || status=1
    outcome $status "$3 of $2: ${cost:-unknown}, at most $1 times $4; weighted $5: $weighted"
}

check "instructions of every mode" counted
at_most 1.35 rgbt8 extinction 306 rgba8
at_most 1.35 rgbt16 extinction 371 rgba16
at_most 1.35 indexed8_t8 extinction 324 indexed8
at_most 1.35 indexed8_t16 extinction 389 indexed8_16
at_most 4 rgbt8 bspline_extinction 306 rgba8
at_most 4 rgbt16 bspline_extinction 371 rgba16
at_most 4 indexed8_t8 bspline_extinction 324 indexed8
at_most 4 indexed8_t16 bspline_extinction 389 indexed8_16
at_most 4 rgba8 bspline_weighted 306 rgba8
at_most 4 rgba16 bspline_weighted 371 rgba16
at_most 4 indexed8 bspline_weighted 324 indexed8
at_most 4 indexed8_16 bspline_weighted 389 indexed8_16
finish
