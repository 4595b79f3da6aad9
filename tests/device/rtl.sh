#!/bin/sh
# The hardware of tests/rtl, which is written from tests/SPEC.md alone: its operations counted, and
# every value of its stages compared with tests/vectors, in two simulators.
. tests/tap

BUILD=${BUILD:-build}
OUT=$BUILD/rtl
RTL=tests/rtl
STAGES="weights sample8 sample16 separate8 separate16 under over transmittance transmittance16
    cell readout pixel"
UNITS="weights interpolate separate opacity under over march transmittance transmittance16
    addresses background readout pixel"
SOURCES=$(find $RTL -name '*.v' ! -name 'bench*' ! -name exp_power.v | sort | tr '\n' ' ')
BENCHES=$(find $RTL -name 'bench*.v' | sort | tr '\n' ' ')
mkdir -p "$OUT"

# The sizes of the vectors, and where their columns lie in a row.
layout() {
    # shellcheck disable=SC2046 # a word a file
    awk -f "$RTL/layout.awk" $(printf 'tests/vectors/%s.hex ' $STAGES) >"$OUT/layout.vh"
}

table() {
    iverilog -g2005 -s exp_power -o "$OUT/exp_power" "$RTL/exp_power.v" &&
        vvp -n "$OUT/exp_power" >"$work/exp_power.hex" &&
        cmp "$work/exp_power.hex" "$RTL/exp_power.hex"
}

# Each column is compared or fed in, by its name or counted from number 0 of its array. Of the
# transmittance's w the unit keeps 6 bits only.
columns() {
    sed -n 's/^`define \([a-z0-9]*\)_\([a-z0-9_]*\) .*-:.*/\1 \2/p' "$OUT/layout.vh" |
        sed -e '/^transmittance w$/d' | sort -u >"$work/columns"
    [ -s "$work/columns" ] || return 1
    while read -r stage column; do
        first=$(echo "$column" | sed 's/[0-9]*$//')0
        grep -Eq "\`${stage}_($column|${column}_top|${first}_top)([^a-z0-9_]|\$)" $RTL/bench_*.v || {
            echo "no bench has column $column of $stage"
            return 1
        }
    done <"$work/columns"
}

# instances WIDTH MODULE: how many of the module the interpolation unit for so many bits has.
instances() {
    grep -c "\.scope module, .* \"$2\" " "$OUT/interpolate$1"
}

# operators WIDTH KIND: how many multiplications, sums, subtractions are in its netlist.
operators() {
    grep -c "\.arith/$2 " "$OUT/interpolate$1"
}

# The rounding within a multiplier is no adder: see mul.v.
count() {
    iverilog -g2005 -s interpolate -Pinterpolate.BITS="$1" -y "$RTL" -o "$OUT/interpolate$1" \
        "$RTL/interpolate.v" || return 1
    multipliers=$(instances "$1" mul)
    adders=$(($(instances "$1" add) + $(instances "$1" sub)))
    products=$(operators "$1" mult)
    sums=$(($(operators "$1" sum) + $(operators "$1" sub)))
    echo "$multipliers multipliers, $adders adders; $products products, $sums sums"
    [ "$multipliers $adders $products $sums" = "36 47 36 47" ]
}

# The same in the netlist of a synthesizer, where the rounding shows as one more sum.
synthesis() {
    yosys -q -p "read_verilog $SOURCES;
        chparam -set BITS $1 interpolate; hierarchy -top interpolate; proc; flatten; check -assert;
        select -assert-count 36 t:\$mul; select -assert-count 48 t:\$add t:\$sub %u;
        select -assert-none t:\$dlatch"
}

# With the numbers of multipliers and adders that README.md tells; the roundings within
# multipliers, which stand in mul.v, are no adders.
synthesizable() {
    numbers=$(awk -F'|' -v unit="\`$1\`" '
        index($2, unit) { print $7 + 0, $8 + 0; exit }' $RTL/README.md)
    [ -n "$numbers" ] || return 1
    yosys -q -p "read_verilog $SOURCES;
        hierarchy -top $1; proc; flatten; check -assert; select -assert-none t:\$dlatch;
        select -assert-count ${numbers% *} t:\$mul;
        select -assert-count ${numbers#* } t:\$add t:\$sub %u n:*mul.v* %d"
}

lint() {
    verilator --lint-only -Wall -Wno-UNUSEDSIGNAL -y "$RTL" "$RTL/$1.v"
}

# stages SIMULATOR LOG: a line for each stage that the log says passed, with all its rows.
stages() {
    sed "/^# /!d" "$2" # rows and columns that differ
    for stage in $STAGES; do
        rows=$(sed -n "s/^\`define ${stage}_ROWS //p" "$OUT/layout.vh")
        grep -qx "PASS $stage $rows" "$2"
        outcome $? "$1: all $rows vectors of $stage"
    done
    grep -qx "PASS march 8" "$2"
    outcome $? "$1: examples S18 to S24 of the specification"
}

icarus() {
    # shellcheck disable=SC2086 # a word a file
    iverilog -g2005 -s benches -y "$RTL" -I "$OUT" -I "$RTL" -o "$OUT/benches" $BENCHES
}

# Verilator warns of widths that the benches extend with zeros.
verilated() {
    # shellcheck disable=SC2086
    verilator --binary --timing -Wno-WIDTH -CFLAGS -O0 -I"$OUT" -I"$RTL" -y "$RTL" \
        --top-module benches --Mdir "$OUT/verilated" $BENCHES
}

check "layout of the vectors" layout
check "table of exponentials, from its formula" table
check "benches have every column" columns
for width in 8 16; do
    check "interpolation of $width bits: 36 multipliers, 47 adders" count $width
    check "interpolation of $width bits: the same after synthesis" synthesis $width
done
for unit in $UNITS; do
    check "$unit: synthesizable, with its multipliers and adders" synthesizable "$unit"
    check "$unit: lint" lint "$unit"
done
check "icarus: benches" icarus
timeout 60 vvp -n "$OUT/benches" >"$work/icarus"
stages icarus "$work/icarus"
check "verilator: benches" verilated
timeout 60 "$OUT/verilated/Vbenches" >"$work/verilator"
stages verilator "$work/verilator"
finish
