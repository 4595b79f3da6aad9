#!/bin/sh
# What the objects of core and fixedpoint ask for and hold: nothing undefined but
# memcpy, memset, memmove and the compiler's 32-bit integer helpers (no floating
# point, no 64-bit division); no variable that lasts; no division in a loop over
# samples; no recursion; on an AVR no constant in RAM.
set -eu
. tests/tap

# Helpers of Arm's run-time ABI (IHI 0043, section 4.2) for integers: products and
# shifts of 64 bits, comparison, division of 32 bits; and GCC's jump tables.
HELPERS='__aeabi_(lmul|llsl|llsr|lasr|lcmp|ulcmp|idiv|idivmod|uidiv|uidivmod)|__gnu_thumb1_case_(sqi|uqi|shi|uhi|si)'
ALLOWED="^(memcpy|memset|memmove|$HELPERS)\$"

result() { # result NAME: passes when $work/bad is empty
    check "$1" sh -c "cat '$work/bad' && [ ! -s '$work/bad' ]"
}

compile() { # compile PREFIX COMPILER OPTION...: objects to $work/objects
    rm -rf "$work/objects"
    mkdir "$work/objects"
    for file in core/*.c fixedpoint/*.c; do
        "$@" -std=c99 -ffreestanding -fno-pic -ffunction-sections -Icore -Ifixedpoint -c "$file" \
            -o "$work/objects/$(basename "$file" .c).o" 2>>"$work/messages" ||
            echo "$file does not compile" >>"$work/broken"
    done
}

check_symbols() { # check_symbols NAME NM
    "$2" -u "$work"/objects/*.o | awk '$1 == "U" { print $2 }' | sort -u >"$work/wanted"
    "$2" --defined-only -g "$work"/objects/*.o | awk 'NF == 3 { print $3 }' | sort -u >"$work/own"
    comm -23 "$work/wanted" "$work/own" | grep -Ev "$ALLOWED" >"$work/bad" || :
    cat "$work/broken" >>"$work/bad" 2>/dev/null || :
    result "$1: nothing undefined but memory functions and integer helpers"
    "$2" -A "$work"/objects/*.o | awk '$(NF - 1) ~ /^[BbCcDdGgSs]$/' >"$work/bad"
    cat "$work/broken" >>"$work/bad" 2>/dev/null || :
    result "$1: no variable in .data or .bss"
}

# What a sample runs through: the loops over samples, and the functions of optical depth and
# of wide numbers. No instruction that divides, and no function; two that a sample does not
# call are left out.
check_divisions() { # check_divisions NAME OBJDUMP
    for name in $(cd "$work/objects" && ls sample_*.o levels_*.o) \
        splatting_added.o splatting_over.o footprint.o \
        fx_exp.o fx_log.o fx_log8.o fx_phi.o fx_correct.o fx_wide.o fx_scaled.o; do
        "$2" -dr "$work/objects/$name" | awk -v name="$name" '
            /^Disassembly/ { next }
            />:$/ { function_name = $2; found = 1; next }
            function_name ~ /<(fx_divide|fx_correct_slices)>/ { next }
            /[[:space:]][us]div|__aeabi_u?l?i?div|fx_divide/ { print name, function_name, $0 }
            END { if (!found) print name, "holds no code" }'
    done >"$work/bad"
    result "$1: no division in a loop over samples"
}

# Through pages and qv_linear, the caller's own read functions are called.
OF_CALLER='^(core/pages[.]c:[a-z_]+|qv_pages_[a-z]+|qv_linear_read) __indirect_call'

# Calls as pairs for tsort, which reports a loop. A call through a pointer may
# reach every function whose address stands in a constant. Optimised, so that a
# constant argument which names a function is a plain call; tail calls stay calls.
check_recursion() {
    compile gcc -O2 -fno-optimize-sibling-calls -fcallgraph-info
    sed -n 's/^edge: { sourcename: "\([^"]*\)" targetname: "\([^"]*\)".*/\1 \2/p' \
        "$work"/objects/*.ci >"$work/every_call" 2>/dev/null || :
    grep -Ev "$OF_CALLER" "$work/every_call" >"$work/calls" || :
    readelf -rW "$work"/objects/*.o | awk '
        /^Relocation section/ { in_data = /\.rela?\.(ro)?data/ }
        in_data && match($0, /\.text\.[A-Za-z0-9_]+/) { print substr($0, RSTART + 6, RLENGTH - 6) }
        in_data && $5 ~ /^qv_/ { print $5 }' | sort -u >"$work/targets"
    awk 'NR == FNR { target[$1]; next }
         { print
           for (side = 1; side <= 2; side++) {
               name = $side
               sub(/^.*:/, "", name)
               if (name in target)
                   print "__indirect_call", $side
           } }' "$work/targets" "$work/calls" >"$work/pairs"
    awk '$1 == $2 { print $1, "calls itself" }' "$work/pairs" >"$work/bad"
    tsort "$work/pairs" >/dev/null 2>>"$work/bad" || :
    [ -s "$work/calls" ] && [ -s "$work/targets" ] || echo "no call was found" >>"$work/bad"
    result "no recursion, not even through a pointer"
}

# On an AVR read-only data is copied to RAM, but for what lies in program memory.
check_ram() {
    make -s TARGET=avr BUILD="${BUILD:-build}" lib >&2
    avr-objdump -h "${BUILD:-build}/avr/libqvol.a" | awk '
        / file format / { file = $1; found = 1 }
        $2 ~ /^\.(rodata|data|bss)/ && $3 !~ /^0+$/ { print file, $2, $3 }
        END { if (!found) print "no object was found" }' >"$work/bad"
    result "avr: no constant in RAM"
}

for optimise in -Os -O3; do
    compile gcc $optimise
    check_symbols "this machine $optimise" nm
    for core in cortex-m0 cortex-m3; do
        compile arm-none-eabi-gcc -mcpu=$core -mthumb $optimise
        check_symbols "$core $optimise" arm-none-eabi-nm
        check_divisions "$core $optimise" arm-none-eabi-objdump
    done
done
check_recursion
check_ram
finish
