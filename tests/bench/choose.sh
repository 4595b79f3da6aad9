#!/bin/sh
# What a storage, a mode and a step cost on a device, and how far the picture of a real scan is off,
# as a Markdown table. Errors are in levels of 255, over all pixels and colours of 512x512, beside
# the same mode with 16-bit voxels; where modes weigh by length, with an eighth of a voxel a step.
# Instructions are those of a sample inside a ray (tests/bench/device.sh).
set -eu
: "${BUILD:=build}" "${QVOL:=build/host/qvol}" "${OPTIMISE:=-O2}"
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
SCAN=/usr/share/mricron/templates/ch2.nii.gz
TARGETS="cortex-m0 cortex-m4 rv32imc"
BY_LENGTH="--unit-distance 1"
EXTINCTION="--extinction auto"

# mode of the command; storage; step; options; storage and mode as device.sh names them; bytes
CHOICES="
weighted           | rgba16   | 1   |            | rgba16 weighted              | 8
weighted           | rgba8    | 1   |            | rgba8 weighted               | 4
weighted           | indexed8 | 1   | --palette-bits 16 | indexed8_16 weighted  | 1
weighted           | indexed8 | 1   |            | indexed8 weighted            | 1
preweighted        | associated8 | 1 |           | associated8 preweighted      | 4
weighted           | rgba8    | 0.5 | $BY_LENGTH | rgba8 corrected              | 4
weighted           | rgba8    | 1   | $BY_LENGTH | rgba8 corrected              | 4
weighted           | rgba8    | 2   | $BY_LENGTH | rgba8 corrected              | 4
extinction         | rgbt16   | 0.5 | $BY_LENGTH $EXTINCTION | rgbt16 extinction | 8
extinction         | rgbt16   | 1   | $BY_LENGTH $EXTINCTION | rgbt16 extinction | 8
extinction         | rgbt16   | 2   | $BY_LENGTH $EXTINCTION | rgbt16 extinction | 8
extinction         | rgbt8    | 1   | $BY_LENGTH $EXTINCTION | rgbt8 extinction  | 4
extinction         | indexed8 | 1   | $BY_LENGTH $EXTINCTION | indexed8_t8 extinction | 1
bspline-extinction | rgbt16   | 1   | $BY_LENGTH $EXTINCTION | rgbt16 bspline_extinction | 8
bspline-extinction | rgbt8    | 1   | $BY_LENGTH $EXTINCTION | rgbt8 bspline_extinction | 4"

# A subshell, whose variables are its own.
picture() ( # picture FILE MODE STORAGE STEP OPTIONS...
    file=$1 mode=$2 storage=$3 step=$4
    shift 4
    "$QVOL" render "$SCAN" --quiet --tf head --zoom 1.45 --elevation 14 --azimuth 130 \
        --sampling "$mode" --storage "$storage" --step "$step" -o "$file" "$@"
)

# errors MODE STORAGE STEP OPTIONS...: "RMS LARGEST" beside the best picture of the mode.
errors() {
    mode=$1 storage=$2 step=$3
    shift 3
    by_length=
    finest=1
    case $* in *--unit-distance*) by_length=l finest=0.125 ;; esac
    best=$work/best-$mode$by_length.png
    case $mode in
    preweighted) best=$work/best-weighted.png ;;
    *extinction) wide=rgbt16 ;;
    *) wide=rgba16 ;;
    esac
    [ -s "$best" ] || picture "$best" "$mode" "$wide" $finest "$@"
    picture "$work/picture.png" "$mode" "$storage" "$step" "$@"
    "$QVOL" compare "$work/picture.png" "$best" --json >"$work/compared" || true
    awk -F'[:,]' '/"max"/ { if ($2 > most) most = $2 } /"rms"/ { squares += $2 * $2 }
        END { printf "%.2f %d\n", sqrt(squares / 3), most }' "$work/compared"
}

instructions() { # instructions TARGET STORAGE MODE
    awk -v storage="$2" -v mode="$3" \
        '$1 == storage && $2 == mode && $3 == "inside" { print $4 }' "$work/$1"
}

for target in $TARGETS; do
    BUILD=$BUILD OPTIMISE=$OPTIMISE tests/bench/device.sh "$target" >"$work/$target"
done
echo "| sampling | storage | step, voxels | bytes a voxel | M0 | M4 | rv32imc | error, RMS | at most |"
echo "|---|---|---|---|---|---|---|---|---|"
echo "$CHOICES" | while IFS='|' read -r mode storage step options bench bytes; do
    [ -n "$mode" ] || continue
    # shellcheck disable=SC2086 # options, and the two names, are several words
    {
        found=$(errors $mode $storage $step $options)
        set -- $bench
        # shellcheck disable=SC2016
        echo "| $(echo $mode)$(case $options in *unit*) echo ', by length' ;; esac) |" \
            "$(echo $storage)$(case $1 in *_16) echo ', 16-bit palette' ;; esac) | $(echo $step) |" \
            "$(echo $bytes) | $(instructions cortex-m0 "$@") | $(instructions cortex-m4 "$@") |" \
            "$(instructions rv32imc "$@") | ${found% *} | ${found#* } |"
    }
done
