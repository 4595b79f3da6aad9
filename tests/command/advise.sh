#!/bin/sh
# Advice: the cheapest configuration that is as exact as is wanted, and what is refused.
. tests/command/common
TARGETS="cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33 cortex-m55 rv32imc rv32ec avr powerpc host"
table=$PWD/tests/bench/advise.sh

"$table" lines >"$work/lines"
cd "$work" || exit 1
"$PYTHON" "$TESTS/volumes.py" in_12x10x8_uint8.raw

advise() { # advise TARGET ERROR OPTION...
    target=$1 error=$2
    shift 2
    "$QVOL" advise --target "$target" --error "$error" "$@"
}

# Found from the table by a program of its own: the costs of a voxel's length of ray.
cheapest() { # cheapest TARGET ERROR
    awk -v target="$1" -v most="$2" '
        $1 == target && $2 != "blend" { cost[$2, $3] = $4; next }
        $1 == "error" && ($2, $3) in cost && $6 <= 100 * most {
            length_cost = cost[$2, $3] / $4
            if (!found || length_cost < least) { found = 1; least = length_cost }
        }
        END { if (found) print least; else print "none" }' lines lines
}

# The first configuration's number of that name.
number_of() { # number_of NAME <REPORT
    sed -n "s/^ *\"$1\": \([0-9.]*\),*\$/\1/p" | head -n 1
}

is_cheapest() { # is_cheapest TARGET ERROR
    expected=$(cheapest "$1" "$2")
    if [ "$expected" = none ]; then
        ! advise "$1" "$2" >/dev/null 2>&1
        return
    fi
    advise "$1" "$2" --json >report.json || return 1
    found=$(number_of cost_of_voxel <report.json)
    echo "$1, $2: $found, expected $expected"
    "$PYTHON" -c 'import sys; sys.exit(float(sys.argv[1]) != float(sys.argv[2]))' "$found" "$expected"
}

all_cheapest() { # all_cheapest TARGET
    for error in 0.2 0.5 1 2 4 16 64 255; do
        is_cheapest "$1" "$error" || return 1
    done
}
for target in $TARGETS; do
    check "the cheapest on $target, for errors of .2 to 255" all_cheapest "$target"
done

# All that are listed reach what is wanted, the cheapest first, and none of the others does.
lists_all() {
    advise cortex-m4 4 --rms 0.5 --voxel-bytes 4 --json | "$PYTHON" -c '
import json, sys
listed = json.load(sys.stdin)
rows = listed["configurations"]
assert listed["target"] == "cortex-m4" and listed["unit"] == "instructions" and rows
assert all(r["worst_x100"] <= 400 and r["rms_x100"] <= 50 and r["voxel_bytes"] <= 4 for r in rows)
costs = [r["cost_of_voxel"] for r in rows]
assert costs == sorted(costs)
assert all(r["cost_of_sample"] / r["step"] == r["cost_of_voxel"] for r in rows)
table = [line.split() for line in open("lines")]
small = lambda storage: "16" not in storage or storage.startswith("indexed8")
reach = [t for t in table if t[0] == "error" and int(t[4]) <= 50 and int(t[5]) <= 400 and small(t[1])]
assert len(reach) == len(rows), (len(reach), len(rows))'
}
check "everything that reaches it is listed, the cheapest first" lists_all

check "an AVR counts cycles" sh -c '"$1" advise --target avr --error 64 | grep -q "cycles a sample"' - "$QVOL"
check "the same samples are nearer than the medium" sh -c '
    medium=$("$1" advise --target cortex-m0 --error 0.6 --json | grep -c sampling)
    samples=$("$1" advise --target cortex-m0 --error 0.6 --against samples --json | grep -c sampling)
    "$1" advise --target cortex-m0 --error 0.6 --against samples | grep -q "same samples" &&
        [ "$medium" -gt 0 ] && [ "$samples" -gt 0 ]' - "$QVOL"

# qvol render takes the options, and reports the sampling that was promised.
renders() {
    advise host 255 --json >report.json
    sed -n 's/^ *"options": "\(.*\)",$/\1/p' report.json >options
    [ "$(wc -l <options)" -gt 100 ] || return 1
    while read -r line; do
        # shellcheck disable=SC2086 # several options
        "$QVOL" render in_12x10x8_uint8.raw -o a.pam --size 16x16 --quiet $line ||
            { echo "$line"; return 1; }
    done <options
}
check "every option is one of qvol render" renders

# ---- Frame buffers ------------------------------------------------------------------

buffer() { # buffer PATTERN ERROR OPTION...
    pattern=$1 error=$2
    shift 2
    advise cortex-m0 "$error" "$@" >text || return 1
    cat text
    grep -q "$pattern" text
}
check "8 bits of anything are dithered" buffer "qv_over_rgb888," 29.69 --slices 1024 --framebuffer 8
check "a tighter error takes residuals" buffer "qv_over_rgb888_residual8," 1 --slices 1024 --framebuffer 8
check "4 bits of residual" buffer "qv_over_rgb888_residual4," 5 --residual 4
check "a fog is easier" buffer "qv_over_rgb888," 5.5 --content fog --framebuffer 8
# A dithered blend is off by less than a level, or a unit of its residual and 1/2 for reading.
check "one slice is off by a level" buffer "at most 1.00 of 255, in a constant fog 1.00" 2 \
    --slices 1 --framebuffer 8
check "four slices, 4 bits of residual" buffer "at most 0.75 of 255" 2 \
    --slices 4 --framebuffer 8 --residual 4
check "few bits, three slices" buffer "at most 28.80 of 255, in a constant fog 27.20" 30 \
    --slices 3 --framebuffer 565
check "24 bits are rounded" buffer "dither    none" 0.6 --framebuffer 24
check "few bits of high opacity are rounded" buffer "qv_hardware_rgb565_rounded," 14 \
    --framebuffer 565 --opacity 0.9
check "without bits, the cheapest buffer" buffer "qv_over_rgb16," 0.8 --slices 1000
check "frame buffers as JSON" sh -c '"$1" advise --target cortex-m0 --error 30 --slices 64 --json |
    "$2" -c "
import json, sys
rows = json.load(sys.stdin)[\"configurations\"]
assert [r[\"cost_of_pixel\"] for r in rows] == sorted(r[\"cost_of_pixel\"] for r in rows)
assert all(r[\"worst_x100\"] <= 3000 for r in rows) and len(rows) > 3"' - "$QVOL" "$PYTHON"

# ---- What is refused ----------------------------------------------------------------

refuses "an error that nothing reaches" 1 "cortex-m0: --error: .*the best, qv_bspline.* at most 0.25" \
    "$QVOL" advise --target cortex-m0 --error 0.1
refuses "an RMS that nothing reaches" 1 "--rms: .*the best, qv_" \
    "$QVOL" advise --target cortex-m0 --rms 0.01
refuses "a frame buffer that does not reach it" 1 \
    "cortex-m0: --error: .*the best, qv_over_rgb888_residual8, is off by at most 0.73" \
    "$QVOL" advise --target cortex-m0 --error 0.1 --framebuffer 8
refuses "no such target" 2 "--target: unknown 'cortex-m5', use one of $(echo $TARGETS | sed 's/ /, /g')" \
    "$QVOL" advise --target cortex-m5 --error 1
refuses "no target" 2 "--target: needs a device" "$QVOL" advise --error 1
refuses "no error" 2 "--error: needs a number" "$QVOL" advise --target host
refuses "an RMS of a frame buffer" 2 "--error: needs" "$QVOL" advise --target host --rms 1 --slices 5
refuses "an RMS beside the error of a frame buffer" 2 "--rms: needs advice on rays" \
    "$QVOL" advise --target host --error 1 --rms 1 --slices 5
refuses "--against of a frame buffer" 2 "--against: needs" "$QVOL" advise --target host --error 1 --against medium --slices 5
refuses "--voxel-bytes of a frame buffer" 2 "--voxel-bytes: needs" "$QVOL" advise --target host --error 1 --voxel-bytes 4 --slices 5
refuses "a residual beside 16 bits" 2 "--residual: needs --framebuffer 8" \
    "$QVOL" advise --target host --error 1 --residual 4 --framebuffer 16
refuses "4097 slices" 2 "--slices: needs at most 4096" "$QVOL" advise --target host --error 1 --slices 4097
refuses "an error of 0" 2 "--error: '0' is not a number from 0.01 to 255" "$QVOL" advise --target host --error 0
refuses "--error much" 2 "--error: 'much' is not a number" "$QVOL" advise --target host --error much
refuses "--opacity 0" 2 "--opacity: '0' is not a number from" "$QVOL" advise --target host --error 1 --opacity 0
refuses "--opacity 2" 2 "--opacity: '2' is not a number from" "$QVOL" advise --target host --error 1 --opacity 2
refuses "--content smoke" 2 "any, fog" "$QVOL" advise --target host --error 1 --content smoke
refuses "--against all" 2 "medium, samples" "$QVOL" advise --target host --error 1 --against all
refuses "--voxel-bytes 9" 2 "whole number from 1 to 8" "$QVOL" advise --target host --error 1 --voxel-bytes 9
refuses "an operand" 2 "1 given" "$QVOL" advise --target host --error 1 scan.nii
refuses "an option of another command" 2 "--zoom: unknown\|--zoom" "$QVOL" advise --target host --error 1 --zoom 2
finish
