#!/bin/sh
# What sampling costs beside opacity-weighted sampling of the same width: instructions a
# sample on the emulated Cortex-M3, exact, as tests/bench/device.sh counts them in a scene
# where every sample is taken.
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

at_most() { # at_most RATIO STORAGE MODE BASE: MODE of STORAGE beside weighted BASE
    cost=$(figure "$2" "$3")
    base=$(figure "$4" weighted)
    ratio=$(awk -v cost="${cost:-0}" -v base="${base:-0}" \
        'BEGIN { print cost && base ? sprintf("%.3f", cost / base) : "unknown" }')
    status=0
    awk -v ratio="$ratio" -v most="$1" 'BEGIN { exit !(ratio + 0 > 0 && ratio <= most) }' ||
        status=1
    outcome $status "$3 of $2: $ratio of at most $1 times weighted $4 ($cost by $base)"
}

check "instructions of every mode" counted
at_most 1.35 rgbt8 extinction rgba8
at_most 1.35 rgbt16 extinction rgba16
at_most 1.35 indexed8_t8 extinction indexed8
at_most 1.35 indexed8_t16 extinction indexed8_16
at_most 4 rgbt8 bspline_extinction rgba8
at_most 4 rgbt16 bspline_extinction rgba16
at_most 4 indexed8_t8 bspline_extinction indexed8
at_most 4 indexed8_t16 bspline_extinction indexed8_16
at_most 4 rgba8 bspline_weighted rgba8
at_most 4 rgba16 bspline_weighted rgba16
at_most 4 indexed8 bspline_weighted indexed8
at_most 4 indexed8_16 bspline_weighted indexed8_16
finish
