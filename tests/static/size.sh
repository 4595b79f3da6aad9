#!/bin/sh
# Sizes on every target (tests/size): no figure more than 1 % above what tests/size/SIZES.md
# says, and what the library promises for any device. Stacks are those of the graph of calls,
# which are never below what the emulators saw, or nothing is printed at all.
set -eu
. tests/tap
table=tests/size/SIZES.md

MINIMAL_M0=4096
PERSPECTIVE_M0=6144
MINIMAL_RV32EC=6144
MINIMAL_AVR=10240
EVERYTHING_M0=32768
CONTEXT=256
STACK_32=512
STACK_AVR=384

# Programs whose deepest call keeps within that on 32 bits, but for marches in vectors, which have
# four samples at hand. What else does not are slices of what weighs by length, and B-splines of
# stored opacity or through pages.
WITHIN_STACK="minimal perspective rays extinction dithering pyramid freevoxels"

compared() { # compared TARGET: today's lines beside the table's
    awk -v target="$1" '
        BEGIN { split("code tables .data .bss context scratch stack seen", name) }
        FILENAME != "-" {
            gsub(/[|`]/, " ")
            $0 = $0
            if ($1 == target)
                for (i = 3; i <= 10; i++)
                    most[$2, i] = $i
            next
        }
        $1 == target {
            found = 1
            for (i = 3; i <= 10; i++) {
                if (!(($2, i) in most)) {
                    print $2, name[i - 2] ": not in the table"
                    bad = 1
                } else if ($i != "-" && $i > most[$2, i] * 1.01) {
                    print $2, name[i - 2] ":", $i, "instead of", most[$2, i]
                    bad = 1
                }
            }
        }
        END { exit bad || !found }' "$table" - <"$work/lines"
}

figure() { # figure TARGET CONFIGURATION WHAT
    awk -v target="$1" -v name="$2" -v columns="$3" '
        $1 == target && $2 == name {
            count = split(columns, column, "+")
            for (i = 1; i <= count; i++)
                sum += $column[i]
            print sum
        }' "$work/lines"
}

limit() { # limit TARGET CONFIGURATION MOST WHAT NAME: a sum of columns
    value=$(figure "$1" "$2" "$4")
    status=0
    { [ -n "$value" ] && [ "$value" -le "$3" ]; } || status=1
    outcome $status "$1, $2: ${value:-unknown} of $3 bytes of $5"
}

# goal TARGET CONFIGURATION AIM WHAT NAME: what is not reached yet is told; the table holds the rest.
goal() {
    value=$(figure "$1" "$2" "$4")
    [ "${value:-0}" -le "$3" ] || echo "# $1, $2: $value bytes of $5, where $3 are the aim"
}

FLASH=3+4
RAM=5+6
KEPT=7
STACK=9

make -s size-lines >"$work/lines"
for target in $(cut -d ' ' -f 1 "$work/lines" | uniq); do
    check "$target: no figure is more than 1 % above $table" compared "$target"
    limit "$target" everything 0 $RAM ".data and .bss"
    case $target in
    wasm32 | host-gcc) continue ;;
    avr) stack=$STACK_AVR ;;
    *) stack=$STACK_32 ;;
    esac
    limit "$target" minimal $CONTEXT $KEPT context
    for program in $WITHIN_STACK; do
        case "$target $program" in
        avr* | cortex-m55* | "powerpc pyramid") goal "$target" "$program" "$stack" $STACK stack ;;
        *) limit "$target" "$program" "$stack" $STACK stack ;;
        esac
    done
    goal "$target" everything "$stack" $STACK stack
    goal "$target" library "$stack" $STACK stack
done
limit cortex-m0 minimal $MINIMAL_M0 $FLASH flash
limit cortex-m0 perspective $PERSPECTIVE_M0 $FLASH flash
limit rv32ec minimal $MINIMAL_RV32EC $FLASH flash
goal avr minimal $MINIMAL_AVR $FLASH flash
goal cortex-m0 everything $EVERYTHING_M0 $FLASH flash
finish
