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

cell() { # cell TARGET ERROR OPTION...
    target=$1 error=$2
    shift 2
    if ! "$QVOL" advise --target "$target" --error "$error" "$@" --json >"$work/report" \
        2>/dev/null; then
        echo "-"
        return
    fi
    name=$(first sampling <"$work/report")
    printf '%s, %s: %.0f\n' "${name#qv_}" "$(first step <"$work/report")" \
        "$(first cost_of_voxel <"$work/report")"
}

row() { # row NAME ERROR OPTION...
    printf '| %s | %s |' "$1" "$2"
    shift
    for target in $CLASSES; do
        printf ' %s |' "$(cell "$target" "$@")"
    done
    echo
}

cheapest() {
    echo "| errors from | at most | $(echo "$CLASSES" | sed 's/ / | /g') |"
    echo "|---|---|$(echo "$CLASSES" | sed 's/[a-z0-9-]* */---|/g')"
    for error in 0.3 1 4 16 64; do
        row "the medium" $error
    done
    for error in 1 4 16; do
        row "the medium, 1 byte a voxel" $error --voxel-bytes 1
    done
    for error in 0.6 4 16; do
        row "the same samples" $error --against samples
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
        for error in 0.55 1 5 30; do
            printf '| %s | %s |' "$content" $error
            for target in $CLASSES; do
                "$QVOL" advise --target "$target" --error $error --content $content --json \
                    >"$work/report" 2>/dev/null || { printf ' - |'; continue; }
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
and instructions (avr: cycles) for a voxel's length of a ray. Where opacities hold for a length, the
medium is what counts; where they hold for a step, as in `weighted`, what the same samples show:

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

Mode and storage, step in voxels, and instructions (avr: cycles) for a voxel's length of a ray; a
dash where nothing reaches it.

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
