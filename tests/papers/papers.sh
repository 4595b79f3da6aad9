#!/bin/sh
# make papers: recomputes the papers on which the library rests. Writes pictures, plots
# and tables to build/papers/PAPER; papers.sh PAPER... does some of them.
set -eu
cd "$(dirname "$0")/../.."
: "${BUILD:=build}" "${QVOL:=$BUILD/host/qvol}"
SOURCES=tests/papers
OUT=${PAPERS_OUT:-$BUILD/papers}

# compute PAPER: runs its program, which writes its tables to OUT/PAPER, and OUT/PAPER/data.
compute() {
    folder=$OUT/$1
    mkdir -p "$folder/data" "$folder/pictures"
    "$BUILD/tests/papers/$1" "$folder"
}

# plot NAME: draws with PAPER/NAME.gp.
plot() {
    gnuplot -c "$SOURCES/$paper/$1.gp" "$folder"
}

# sheet NAME TITLE COLUMNS [PICTURE LABEL]...: of the folder's pictures.
sheet() {
    /usr/bin/python3 "$SOURCES/sheet.py" "$folder" "$@"
}

# ---- Wittenbrink, Malzbender, Goss 1998 ---------------------------------------

# rms SCENE COLUMN: from the data of the bar chart.
rms() {
    awk -v scene="$1" -v column="$2" '$1 == scene { printf "%.1f", $column }' "$folder/data/rms.dat"
}

scene_sheet() { # scene_sheet SCENE TITLE
    set -- "$1" "$2" "$(rms "$1" 2)" "$(rms "$1" 3)" "$(rms "$1" 4)" "$(rms "$1" 5)"
    sheet "$1" "$2" 4 \
        "$1-32-separate" "32³: separate" "$1-32-weighted" "weighted" \
        "$1-32-difference" "difference, RMS $3" "$1-32-equalised" "difference, equalised" \
        "$1-32-aa-separate" "32³, antialiased: separate" "$1-32-aa-weighted" "weighted" \
        "$1-32-aa-difference" "difference, RMS $5" "$1-32-aa-equalised" "difference, equalised" \
        "$1-128-separate" "128³: separate" "$1-128-weighted" "weighted" \
        "$1-128-difference" "difference, RMS $4" "$1-128-equalised" "difference, equalised" \
        "$1-128-aa-separate" "128³, antialiased: separate" "$1-128-aa-weighted" "weighted" \
        "$1-128-aa-difference" "difference, RMS $6" "$1-128-aa-equalised" "difference, equalised"
}

wittenbrink() {
    plot phase_curve
    plot rms
    scene_sheet corner "Corner (figures 10 to 12); a step of one voxel of 32³"
    scene_sheet graze "Graze (figure 10); a step of one voxel of 32³"
    scene_sheet phase "Phase (figure 10); a step of one voxel of 32³"
    sheet torus "Torus, half a voxel a step (figure 8)" 3 \
        torus-separate "colour and opacity interpolated separately" \
        torus-weighted "opacity-weighted" torus-difference "difference"
}

# ---- Kraus and Buerger 2008 -----------------------------------------------------

wall_sheet() { # wall_sheet FIGURE BASIS
    sheet "figure$1" "Figure $1: a wall of one voxel, $2-based sampling, tau 4" 3 \
        "wall-$2-0.7" "d = 0.7" "wall-$2-1.7" "d = 1.7" "wall-$2-2.2" "d = 2.2"
}

# Levels as rows of a contact sheet: SUBJECT-BASIS-LEVEL, and what to call each.
pyramid_sheet() {
    set --
    for subject in head dome shell; do
        for basis in opacity extinction; do
            for level in 0 1 2 3 4 5; do
                set -- "$@" "$subject-$basis-$level" "$subject, by $basis: level $level"
            done
        done
    done
    sheet pyramids "Pyramids, 4-tap box. The head's skin hides a blue inside; dome: opacity 0.98, shell: 0.5" 6 "$@"
}

kraus() {
    pyramid_sheet
    plot figure4
    plot filters
    wall_sheet 5 opacity
    wall_sheet 6 extinction
    sheet figure7 "Figure 7: scattered opaque voxels, d = 1" 2 \
        scattered-opacity "opacity-based sampling" scattered-extinction "extinction-based sampling"
}

# ---- Williams et al.: alpha dithering --------------------------------------------

# The index that the program writes has a line for each figure: name, kind of plot,
# title, caption.
plot_figures() {
    while IFS='|' read -r name kind title _; do
        gnuplot -c "$SOURCES/dithering/curves.gp" "$folder" "$name" "$kind" "$title"
    done <"$folder/data/index"
}

# figures NAME TITLE NUMBER...: a sheet of plots.
figures() {
    sheet_name=$1 sheet_title=$2
    shift 2
    for number in "$@"; do
        shift
        set -- "$@" "figure$number" \
            "$(awk -F'|' -v name="figure$number" '$1 == name { print $4 }' "$folder/data/index")"
    done
    sheet "$sheet_name" "$sheet_title" 3 "$@"
}

# head_by_slices PICTURE OPTION...: the demo's head in a frame buffer of 8 bits.
head_by_slices() {
    picture=$1
    shift
    "$QVOL" render /usr/share/mricron/templates/ch2.nii.gz -q --shade --compositing slices \
        --mask /usr/share/mricron/templates/ch2bet.nii.gz --mask-tf brain \
        --background 0b1220 --elevation 14 --size 256x256 "$@" -o "$folder/pictures/$picture.png"
}

# haze HOW OPTION...: in so many $slices.
haze() {
    how=$1
    shift
    head_by_slices "haze-$slices-$how" --tf "$SOURCES/dithering/haze.tf" --zoom 1.45 \
        --azimuth 130 --slices "$slices" "$@"
}

# fog BRICKS HOW OPTION...
fog() {
    bricks=$1 how=$2
    shift 2
    head_by_slices "fog-$bricks-$how" --tf "$SOURCES/dithering/fog.tf" --zoom 1.15 \
        --azimuth 160 --slices 400 --bricks "$bricks" "$@"
}

head_pictures() {
    for slices in 128 275 600; do
        haze none --dither none
        haze rounding --dither rounding
        haze exact --framebuffer 24
    done
    haze random --dither random --period 16
    haze ordered --dither ordered --period 16
    haze bump --dither bump
    haze feedback --dither feedback
    for bricks in 1x1x1 2x1x1; do
        fog "$bricks" none --dither none
        fog "$bricks" rounding --dither rounding
    done
}

# measured PICTURE OTHER WHAT: a label with the RMS of the two's difference, in levels, which
# becomes a line of numbers.txt too.
measured() {
    levels=$("$QVOL" compare "$folder/pictures/$1.png" "$folder/pictures/$2.png" |
        awk '$4 == "rms" { sum += $5 * $5 } END { printf "%.2f", sqrt(sum / 3) }')
    printf '| %-10s | %-58s | %8s | %8s |\n' "$sheet_name" "$3, RMS" - "$levels" >>"$folder/numbers.txt"
    printf '%s\nRMS %s\n' "$3" "$levels"
}

words_of() { # words_of HOW
    case $1 in
    none) echo "without dither" ;;
    random | ordered) echo "$1 dither, period 16" ;;
    bump) echo "ordered dither, bumps" ;;
    rounding) echo "dithered rounding" ;;
    feedback) echo "feedback, 8 bits beside" ;;
    esac
}

head_sheets() {
    sheet_name=figure3
    set --
    for how in rounding none; do
        for slices in 128 275 600; do
            set -- "$@" "haze-$slices-$how" "$(measured "haze-$slices-$how" \
                "haze-$slices-exact" "$slices slices, $(words_of $how)")"
        done
    done
    sheet $sheet_name "Figure 3: a haze in 8 bits; RMS from 24 bits" 3 "$@"

    sheet_name=techniques
    set --
    for how in none random ordered bump rounding feedback; do
        set -- "$@" "haze-600-$how" \
            "$(measured "haze-600-$how" haze-600-exact "$(words_of $how)")"
    done
    sheet $sheet_name "The haze in 600 slices, 8 bits; RMS from 24 bits" 3 "$@"

    sheet_name=figure6
    set --
    for how in none rounding; do
        set -- "$@" "fog-2x1x1-$how" \
            "$(measured "fog-2x1x1-$how" "fog-1x1x1-$how" "two bricks, $(words_of $how)")" \
            "fog-1x1x1-$how" "one brick"
    done
    sheet $sheet_name "Figure 6: fog in two bricks; RMS from one" 2 "$@"
}

dithering() {
    plot_figures
    plot histogram
    figures problem "8 bits without dither: slices of colour 255, and two bricks of them" \
        05 10 11 08 15 07 12 13 14
    figures dithered "Ordered and random dither of the opacity, and dithered rounding of the blend" \
        16 18 22 23 24 25 26 27 28 29 30 31 32 33 34 55 56 39
    figures bricks "Two bricks" 09 17 19 20 21 35
    figures chunks "Two bricks, blended in chunks (section 7)" 42 43 44 45 46 47 48 49 50 51 52 53 54
    figures bits12 "Frame buffers of 12 bits (section 4.1)" 36 37 38
    head_pictures
    printf '\n## %s\n\n| sheet | what | paper | computed |\n|---|---|---|---|\n' \
        "Pictures of the head, in levels" >>"$folder/numbers.txt"
    head_sheets
}

# ---- FreeVoxels ---------------------------------------------------------------------

# The program's index has a line for each row: layers, opacity, what errors are multiplied by.
leak_sheet() {
    set --
    while read -r layers opacity gain; do
        set -- "$@" "leak-$layers-over" "$layers deep, opacity $opacity: conventional" \
            "leak-$layers-added" "FreeVoxels" \
            "leak-$layers-over-error" "conventional: error times $gain" \
            "leak-$layers-added-error" "FreeVoxels: error times $gain"
    done <"$folder/data/leak.index"
    sheet figure6 "Figure 6: uniform voxels, 14 pixels wide, linear kernel" 4 "$@"
}

level_sheet() {
    set --
    for subject in skin glass; do
        for way in geometric rebuilt; do
            for level in 0 1 2 3 4 5; do
                set -- "$@" "$subject-$way-$level" "$subject, $way: level $level"
            done
        done
    done
    sheet levels "Section 3.2: levels with light by the geometric mean, and built anew on each" 6 "$@"
}

# Views from all over the sphere, by the program that tests them; a minute for 500.
between_directions() {
    QV_VIEWS=${QV_VIEWS:-500} "$BUILD/tests/accuracy/splat_directions" >"$folder/data/directions.tap" ||
        [ -s "$folder/data/directions.tap" ]
    {
        printf '\n## Between the 26 directions: views of the whole sphere, in levels\n\n'
        printf '| volume | against | as published: RMS, worst | nearest, by length |'
        echo " between depths | between light | each by the last |"
        echo "|---|---|---|---|---|---|---|"
        sed -n 's/^# \(.*|.*|.*|.*|.*|.*[0-9]\)$/| \1 |/p' "$folder/data/directions.tap"
    } >>"$folder/table.md"
    awk -F'[ |]+' '/[|] exact splats [|]/ { print $2, $5, $7, $9, $11 }' \
        "$folder/data/directions.tap" >"$folder/data/directions.dat"
    plot directions
}

freevoxels() {
    plot figure2
    leak_sheet
    sheet figure7 "Figure 7: a head in red light, which its voxels' bytes let through" 2 \
        head-unlit-splats "splats, unlit" head-lit-splats "splats, lit: shadows of brow, ear and nose" \
        head-unlit-rays "ray casting, unlit" head-lit-rays "ray casting of lit voxels"
    plot nodes
    level_sheet
    plot hierarchy
    plot inside
    between_directions
}

[ $# -gt 0 ] || set -- wittenbrink kraus dithering freevoxels
for paper in "$@"; do
    compute "$paper"
    "$paper"
    echo "Wrote to $folder:"
    (cd "$folder" && find . -maxdepth 1 -type f | sort | sed 's/^/  /' && echo "  ./pictures/")
done
