#!/bin/sh
# The functions of optical depth beside those of other libraries, as a Markdown
# table: errors (as the unit tests measure them), and on each device code and tables in
# bytes (-Os; all that a program which calls nothing else links) and what a call takes
# (-O2), in instructions and, on AVR, in cycles.
set -eu
: "${BUILD:=build}"
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

tool() { # tool TARGET NAME: a program of its compiler's package
    compiler=$(make -s TARGET="$1" print-TARGET_CC)
    echo "${compiler%gcc}$2"
}

machine() { # machine TARGET: what the compiler is told of it
    make -s TARGET="$1" print-TARGET_CPU
}

# count TARGET: lines "NAME INSTRUCTIONS CYCLES" of a call, less those of an
# empty one; what the third figure is on a Cortex-M does not matter.
count() {
    out=$BUILD/devices-O2
    make -s TARGET="$1" OPTIMISE=-O2 BUILD="$out" "$out/$1/functions.elf" >&2
    EMULATOR_REPORT=$work/regions toolchain/emulate "$1" "$out/$1/functions.elf" >"$work/names" \
        2>"$work/messages" || { cat "$work/messages" >&2; exit 1; }
    paste -d ' ' "$work/names" "$work/regions" |
        awk 'NR == 1 { empty = $6; empty_cycles = $8 }
             { printf "%s %.0f %.0f\n", $1, ($6 - empty) / 256, ($8 - empty_cycles) / 256 }' \
            >"$work/$1"
}

calls() { # calls TARGET SUBJECT COLUMN
    awk -v name="$2" -v column="$3" '$1 == name { print $column }' "$work/$1"
}

rom() { # rom TARGET FUNCTION: "CODE + TABLES" in bytes; nothing that is called is missing
    # shellcheck disable=SC2046 # several options
    "$(tool "$1" gcc)" $(machine "$1") -nostdlib -r -Wl,--gc-sections,-e,"$2",-u,"$2" \
        "$BUILD/$1/libqvol.a" -lgcc -o "$work/linked"
    if "$(tool "$1" nm)" -u "$work/linked" | grep . >&2; then
        return 1
    fi
    "$(tool "$1" size)" -A "$work/linked" | awk '
        /^\.text/ { code += $2 } /^\.(rodata|progmem)/ { tables += $2 }
        END { print code + 0, "+", tables + 0 }'
}

errors() { # errors NAME: "MAX | RMS | BIAS" of a line of the unit tests
    sed -n "s/^# $1: max \([^,]*\), rms \([^,]*\), bias \(.*\)/\1 | \2 | \3/p" "$work/errors"
}

row() { # row FUNCTION SUBJECT UNIT NAME: one line of the table
    m0=$(rom cortex-m0 "$1")
    m3=$(rom cortex-m3 "$1")
    avr=$(rom avr "$1")
    echo "| $1 | $3 | $(errors "$4") | $m0 | $(calls cortex-m0 "$2" 2) |" \
        "$m3 | $(calls cortex-m3 "$2" 2) | $avr | $(calls avr "$2" 2) | $(calls avr "$2" 3) |"
}

for target in cortex-m0 cortex-m3 avr; do
    make -s TARGET=$target OPTIMISE=-Os BUILD="$BUILD" lib >&2
done
for name in exp log phi correct; do
    make -s BUILD="$BUILD" "$BUILD/tests/unit/test_fx_$name" >&2
    "$BUILD/tests/unit/test_fx_$name" 2>/dev/null | grep '^# ' >>"$work/errors"
done
count cortex-m0
count cortex-m3
count avr

cat <<END
Functions of optical depth: bytes of code + tables at -Os, instructions of a call at -O2.
Errors in units of the result, the same on every machine: the worst, the root of the mean
square, the mean. Measured with $(arm-none-eabi-gcc --version | head -n 1)
and $(avr-gcc --version | head -n 1) for an ATmega1284P.

The last rows are quoted, not measured here: libfixmath and CMSIS-DSP, gcc 12 -O2, a Cortex-M4
in the place of the M3; a dash stands where no figure is known. libfixmath takes 32 KiB of RAM
beside its code. CMSIS-DSP has no exponential function in fixed point.

| function | unit | worst | rms | bias | M0 bytes | M0 | M3 bytes | M3 | AVR bytes | AVR | AVR cycles |
|---|---|---|---|---|---|---|---|---|---|---|---|
END
row fx_transmittance transmittance '2^-31' 'transmittance, units of 2^-31'
row fx_transmittance16 transmittance16 '1/65535' 'transmittance of 16 bits, units of 1\/65535'
row fx_depth_of_transmittance depth '2^-28' 'depth of a transmittance, units of 2^-28'
row fx_extinction_of_unorm16 extinction16 '2^-24' 'extinction of 16 bits, units of 2^-24'
row fx_extinction_of_unorm8 extinction8 '2^-24' 'extinction of 8 bits, units of 2^-24'
row fx_phi phi '2^-16' 'phi, units of 2^-16'
row fx_correct_opacity correct_opacity '1/65535' 'corrected opacity, units of 1\/65535'
row fx_correct_colour correct_colour '2^-16 of it' 'colour factor, units of 2^-16 of it'
cat <<'END'
| libfixmath fix16_exp, -10.4 .. 0 (quoted) | 2^-16 | 4.00 | .31 | +.02 | - | 6512 | - | 1904 (M4) | - | - | - |
| libfixmath fix16_log, 0 .. 1 (quoted) | 2^-16 | 483 | 2.2 | - | - | 26224 | - | 8505 (M4) | - | - | - |
| libfixmath fix16_log, 1 .. 32768 (quoted) | 2^-16 | 2.6 | .48 | - | - | 26224 | - | 8505 (M4) | - | - | - |
| CMSIS-DSP arm_vlog_q15 (quoted) | 2^-15 | 1.75 | .95 | -.88 | - | 263 | - | 201 (M4) | - | - | - |
| CMSIS-DSP arm_vlog_q31 (quoted) | 2^-31 | 1.72 | .90 | -.88 | - | 1855 | - | 313 (M4) | - | - | - |
END
