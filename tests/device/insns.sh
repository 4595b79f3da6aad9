#!/bin/sh
# What a sample inside a ray executes, as tests/bench/insns.sh counts it, is within what is
# promised; and how many times as much the same arithmetic takes in software floats.
set -eu
. tests/tap
BUILD=${BUILD:-build}
export BUILD

measured() {
    tests/bench/insns.sh samples cortex-m0 cortex-m3 cortex-m4 cortex-m55 rv32imc avr >"$work/lines"
}

figure() { # figure TARGET STORAGE MODE
    awk -v target="$1" -v storage="$2" -v mode="$3" \
        '$1 == target && $2 == storage && $3 == mode && $4 == "inside" { print $5 }' "$work/lines"
}

at_most() { # at_most COUNT TARGET STORAGE MODE
    count=$(figure "$2" "$3" "$4")
    status=0
    { [ -n "$count" ] && [ "$count" -le "$1" ]; } || status=1
    outcome $status "$2: a sample $4 $3 takes ${count:-unknown} of $1"
}

ratio() { # ratio TARGET: floats beside weighted rgba8
    awk -v float="$(figure "$1" float weighted)" -v whole="$(figure "$1" rgba8 weighted)" \
        'BEGIN { print whole ? sprintf("%.1f", float / whole) : 0 }'
}

at_least() { # at_least RATIO TARGET
    times=$(ratio "$2")
    status=0
    awk -v times="$times" -v least="$1" 'BEGIN { exit !(times >= least) }' || status=1
    outcome $status "$2: floats take $times times as much, at least $1"
}

check "instructions of every mode" measured
at_most 340 cortex-m0 rgba8 weighted
at_most 175 cortex-m3 rgba8 weighted
at_most 150 cortex-m4 rgba8 weighted
at_most 60 cortex-m55 rgba8 weighted
at_most 215 rv32imc rgba8 weighted
at_most 150 cortex-m0 associated8 preweighted
at_most 100 cortex-m4 associated8 preweighted
for target in cortex-m0 cortex-m3 cortex-m4 rv32imc; do
    at_least 15 $target
done
# The floats of an AVR are written by hand for it, products of 64 bits by no one: no 15 there.
at_least 2 avr

# The table of qvol advise has the same counts, but for what a small change of the code moves.
tests/bench/advise.sh lines >"$work/advise"
in_table() {
    awk 'NR == FNR { count[$1, $2, $3] = $4; next }
        $2 == "float" || $4 != "inside" { next }
        { rows++; told = count[$1, $2, $3] + 0; off = told > $5 ? told - $5 : $5 - told }
        off > .05 * $5 { print "table", told ", counted", $0; bad = 1 }
        END { exit bad || rows < 100 }' "$work/advise" "$work/lines"
}
check "the table of qvol advise has these counts within 5 % (make advise writes it)" in_table
finish
