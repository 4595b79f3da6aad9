#!/bin/sh
# What to choose for an error that is wanted, as `qvol advise` tells it, in Markdown.
#
#     tests/bench/choose.sh           for README.md: the cheapest on each class of devices, and what
#                                     the usual modes cost
#     tests/bench/choose.sh report    section 3 of the precision report: all modes, frame buffers too
set -eu
: "${BUILD:=build}"
: "${QVOL:=$BUILD/host/qvol}"
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One of each class: a Cortex-M3, -M7 or -M33 is within a tenth of an M4.
CLASSES="cortex-m0 cortex-m4 cortex-m55 rv32imc rv32ec avr host"
USUAL="weighted_rgba16 weighted_rgba8 weighted_indexed8_16 weighted_indexed8 preweighted_associated8
corrected_rgba16 corrected_rgba8 extinction_rgbt16 extinction_rgbt8 extinction_indexed8_t8
bspline_extinction_rgbt16 bspline_extinction_rgbt8"

# first NAME: of the cheapest configuration, from a report on standard input.
first() {
    sed -n "s/^ *\"$1\": \"*\([^\",]*\)\"*,*\$/\1/p" | head -n 1
}

# advise TARGET ERROR OPTION...: the report; fails where nothing reaches the error, which qvol tells
# by status 1. Any other failure ends the program, so this must not run in a subshell.
advise() {
    target=$1 error=$2 status=0
    shift 2
    "$QVOL" advise --target "$target" --error "$error" "$@" --json >"$work/report" \
        2>"$work/message" || status=$?
    if [ $status -gt 1 ]; then
        cat "$work/message" >&2
        exit $status
    fi
    return $status
}

# rows NAME ERROR OPTION...: one for each configuration that is the cheapest somewhere.
rows() {
    name=$1
    shift
    for class in $CLASSES; do
        if advise "$class" "$@"; then
            echo "$(first sampling <"$work/report") $(first step <"$work/report")" \
                "$(first cost_of_voxel <"$work/report") $class"
        else
            echo "nothing - - $class"
        fi
    done >"$work/found"
    awk -v name="$name" -v error="$1" -v classes="$CLASSES" '
        {
            sub(/^qv_/, "", $1)
            row = $1 " | " $2
            if (!(row in seen)) { seen[row] = 1; order[++count] = row }
            cost[row, $4] = $3 == "-" ? "-" : sprintf("%.0f", $3)
        }
        END {
            columns = split(classes, class, " ")
            for (r = 1; r <= count; r++) {
                printf "| %s | %s | %s |", name, error, order[r]
                for (c = 1; c <= columns; c++) printf " %s |", cost[order[r], class[c]]
                print ""
            }
        }' "$work/found"
}

cheapest() {
    echo "| errors from | at most | mode and storage | step | $(echo "$CLASSES" | sed 's/ / | /g') |"
    echo "|---|---|---|---|$(echo "$CLASSES" | sed 's/[a-z0-9-]* */---|/g')"
    for wanted in 0.3 1 4 16 64; do
        rows "the medium" $wanted
    done
    for wanted in 1 4 16; do
        rows "the medium, 1 byte a voxel" $wanted --voxel-bytes 1
    done
    for wanted in 0.6 4 16; do
        rows "the same samples" $wanted --against samples
    done
}

# modes [NAME...]: all of them where none is named.
modes() {
    echo "| sampling and storage | bytes a voxel | M0 | M4 | rv32imc |" \
        "RMS and worst beside the same samples | beside the medium in steps of 1/4 | 1/2 | 1 | 2 |"
    echo "|---|---|---|---|---|---|---|---|---|---|"
    "$QVOL" advise --target host --error 255 --json >"$work/all"
    tests/bench/advise.sh lines >"$work/lines"
    awk -v wanted="$*" '
        function errors(rms, worst) { return sprintf("%.2f, %.2f", rms / 100, worst / 100) }
        FILENAME ~ /all$/ {
            gsub(/[",]/, "")
            if ($1 == "sampling:") name = substr($2, 4)
            if ($1 == "voxel_bytes:") bytes[name] = $2
            next
        }
        $2 == "blend" { next }
        $1 != "error" { cost[$1, $3 "_" $2] = $4; next }
        {
            name = $3 "_" $2
            medium[name, $4] = errors($5, $6)
            if ($4 == 1) { samples[name] = errors($7, $8); names[++count] = name }
        }
        END {
            if (wanted != "")
                count = split(wanted, names, " ")
            for (i = 1; i <= count; i++) {
                n = names[i]
                printf "| %s | %d | %d | %d | %d | %s |", n, bytes[n], cost["cortex-m0", n],
                    cost["cortex-m4", n], cost["rv32imc", n], samples[n]
                printf " %s | %s | %s | %s |\n", medium[n, .25], medium[n, .5], medium[n, 1],
                    medium[n, 2]
            }
        }' "$work/all" "$work/lines"
}

# The cheapest frame buffer for an error, of any content and of a fog.
buffers() {
    echo "| of 1000 slices | at most | $(echo "$CLASSES" | sed 's/ / | /g') |"
    echo "|---|---|$(echo "$CLASSES" | sed 's/[a-z0-9-]* */---|/g')"
    for content in any fog; do
        for wanted in 0.55 1 5 30; do
            printf '| %s | %s |' "$content" $wanted
            for class in $CLASSES; do
                advise "$class" $wanted --content $content --slices 1000 || { printf ' - |'; continue; }
                name=$(first blend <"$work/report")
                printf ' %s: %s |' "${name#qv_}" "$(first cost_of_pixel <"$work/report")"
            done
            echo
        done
    done
}

if [ "${1:-}" != report ]; then
    cat <<'END'
The cheapest of each class, for errors that no pixel may exceed: mode and storage, step in voxels,
and instructions (avr: cycles) for a voxel's length of a ray. An empty cell: another row for that
error is cheaper there. Where opacities hold for a length, the medium is what counts; where they hold
for a step, as in `weighted`, what the same samples show:

END
    cheapest
    cat <<'END'

What the usual modes cost, a sample inside a ray, and their errors:

END
    # shellcheck disable=SC2086 # several names
    modes $USUAL
    exit
fi
cat <<'END'
## 3 What it means

What `qvol advise` tells, from port/host/advise_table.h: `make advise` measures it, and
`tests/static/advise.sh` and `tests/device/insns.sh` compare it. Errors are in levels of 255, of
the worst pixel, over a scan, a fog, waves of colour and a ball, before pixels are packed. The
medium is what double precision shows in steps of 1/16 voxel with the mode's own reconstruction;
from the same samples is what storage and integers add.

### 3.1 The cheapest configuration

Mode and storage, step in voxels, and instructions (avr: cycles) for a voxel's length of a ray: a row
for each configuration that is the cheapest somewhere. A cell is empty where another one is cheaper,
a dash where nothing reaches the error.

END
cheapest
cat <<'END'

### 3.2 All of them

Instructions of a sample inside a ray.

END
modes
cat <<'END'

### 3.3 Frame buffers

The cheapest blend of the library, by its recommendation (`qv_recommend`), and instructions (avr:
cycles) of a pixel of a slice.

END
buffers
