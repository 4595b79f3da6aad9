#!/bin/sh
# The functions of optical depth beside those of other libraries, as a Markdown
# table: ROM on a Cortex-M0 (-Os; all that a program which calls nothing else links),
# errors (as the unit tests measure them), instructions a call on emulated devices.
set -eu
: "${BUILD:=build}"
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
plugin=$BUILD/emulator/count.so
small=$BUILD/cortex-m0/libqvol.a
libgcc=$(arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb -print-libgcc-file-name)

count() { # count TARGET BOARD: lines "NAME INSTRUCTIONS", less those of an empty call
    out=$BUILD/bench-O2
    make -s TARGET="$1" OPTIMISE=-O2 BUILD="$out" "$out/$1/functions.elf" >&2
    EMULATOR_OPTIONS="-plugin $plugin,out=$work/regions" \
        toolchain/emulate "$2" "$out/$1/functions.elf" >"$work/names" 2>"$work/messages" ||
        { cat "$work/messages" >&2; exit 1; }
    paste -d ' ' "$work/names" "$work/regions" |
        awk 'NR == 1 { empty = $6 } { printf "%s %.0f\n", $1, ($6 - empty) / 256 }' >"$work/$1"
}

rom() { # rom FUNCTION: "CODE TABLES" in bytes
    arm-none-eabi-ld --gc-sections -e "$1" -u "$1" "$small" "$libgcc" -o "$work/linked"
    arm-none-eabi-size -A "$work/linked" | awk '
        /^\.text/ { code = $2 } /^\.rodata/ { tables = $2 } END { print code + 0, tables + 0 }'
}

errors() { # errors NAME: "MAX | RMS | BIAS" of a line of the unit tests
    sed -n "s/^# $1: max \([^,]*\), rms \([^,]*\), bias \(.*\)/\1 | \2 | \3/p" "$work/errors"
}

row() { # row FUNCTION SUBJECT UNIT NAME: one line of the table
    # shellcheck disable=SC2046
    set -- "$@" $(rom "$1")
    echo "| $1 | $3 | $5 + $6 | $(errors "$4") |" \
        "$(awk -v name="$2" '$1 == name { print $2 }' "$work/cortex-m0") |" \
        "$(awk -v name="$2" '$1 == name { print $2 }' "$work/cortex-m3") |"
}

make -s TARGET=cortex-m3 BUILD="$BUILD" "$plugin" >&2
make -s TARGET=cortex-m0 OPTIMISE=-Os BUILD="$BUILD" "$small" >&2
for name in exp log phi correct; do
    make -s BUILD="$BUILD" "$BUILD/tests/unit/test_fx_$name" >&2
    "$BUILD/tests/unit/test_fx_$name" 2>/dev/null | grep '^# ' >>"$work/errors"
done
count cortex-m3 lm3s6965evb
count cortex-m0 microbit

echo "Functions of optical depth ($(arm-none-eabi-gcc --version | head -n 1)): bytes at -Os,"
echo "instructions at -O2. Of the others the M4 stands for the M3, and the unit is one of"
echo "their own result. Nothing is measured on AVR, for want of a port to it."
echo
echo "| function | unit of errors | code + tables | max | rms | bias | M0 | M3 |"
echo "|---|---|---|---|---|---|---|---|"
row fx_transmittance transmittance '2^-31' 'transmittance, units of 2^-31'
row fx_transmittance16 transmittance16 '1/65535' 'transmittance of 16 bits, units of 1\/65535'
row fx_extinction_of_unorm16 extinction16 '2^-24' 'extinction of 16 bits, units of 2^-24'
row fx_extinction_of_unorm8 extinction8 '2^-24' 'extinction of 8 bits, units of 2^-24'
row fx_phi phi '2^-16' 'phi, units of 2^-16'
row fx_correct_opacity correct_opacity '1/65535' 'corrected opacity, units of 1\/65535'
row fx_correct_colour correct_colour '2^-16 of it' 'colour factor, units of 2^-16 of it'
cat <<'END'
| libfixmath fix16_exp, [-10.4, 0) | 2^-16 | 32 KiB of RAM | 4.00 | .31 | +.02 | 6512 | 1904 |
| libfixmath fix16_log, (0, 1) | 2^-16 | 32 KiB of RAM | 483 | 2.2 | | 26224 | 8505 |
| CMSIS-DSP arm_vlog_q15 | 2^-15 | | 1.75 | .95 | -.88 | 263 | 201 |
| CMSIS-DSP arm_vlog_q31 | 2^-31 | | 1.72 | .90 | -.88 | 1855 | 313 |
END
