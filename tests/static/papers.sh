#!/bin/sh
# What make papers writes: every number within what its row allows, the papers' own
# numbers among them, artefacts where they belong and nowhere else, and all pictures.
set -u
. tests/tap
BUILD=${BUILD:-build}
PAPERS_OUT=$work/papers
export BUILD PAPERS_OUT

check "the programs are built" make -s BUILD="$BUILD" paper-programs
check "the papers are recomputed" tests/papers/papers.sh

# ---- Tables ------------------------------------------------------------------

# Rows are | what | paper | double precision | ours | difference | allowed |.
rows_hold() { # rows_hold PAPER LEAST_ROWS
    awk -F' *[|] *' -v least="$2" '
        NF == 8 && $4 + 0 == $4 {
            rows++
            off = $5 - $4
            if (($6 > $7 || -$6 > $7) || off > $7 + 1e-6 || -off > $7 + 1e-6) { print; bad = 1 }
        }
        END { print rows, "rows"; exit bad || rows < least }' "$PAPERS_OUT/$1/table.md"
}

check "Wittenbrink: every row within what it allows" rows_hold wittenbrink 43
check "Kraus: every row within what it allows" rows_hold kraus 210

# ours PAPER WHAT: the library's number in that row, the first of the name.
ours() {
    awk -F' *[|] *' -v what="$2" '$2 == what { print $5; found = 1; exit }
        END { exit !found }' "$PAPERS_OUT/$1/table.md"
}

within() { # within LOW HIGH PAPER WHAT
    found=$(ours "$3" "$4") || { echo "no row '$4'"; return 1; }
    echo "$4: $found, wanted $1 to $2"
    awk -v n="$found" -v low="$1" -v high="$2" 'BEGIN { exit !(n >= low && n <= high) }'
}

# Each line of standard input: lowest and highest number that pass, and the row.
all_within() { # all_within PAPER
    while read -r low high what; do
        within "$low" "$high" "$1" "$what" || return 1
    done
}

# Figure 4 as spreads over r: method, tau, then d 0.5 .6 .8 1 1.2 1.6, in double precision.
figure4() {
    while read -r method tau spreads; do
        for d in 0.5 0.6 0.8 1 1.2 1.6; do
            expected=${spreads%% *}
            spreads=${spreads#* }
            echo "$expected spread, $method, tau $tau, d $d"
        done
    done | awk '{ expected = $1; $1 = ""; print expected - .0025, expected + .0025 $0 }'
}

check "Wittenbrink: three samples and the phase curve" all_within wittenbrink <<'ROWS'
0.25 0.25 separate, C~ of two samples
0.75 0.75 separate, C~ of three samples
0.75 0.75 separate, colour of the ray
0.5 0.5 weighted, C~ of two samples
1 1 weighted, C~ of three samples
1 1 weighted, colour of the ray
0.75 0.75 figure 6: least separate
1 1 figure 6: least weighted
ROWS

check "Wittenbrink: errors at 32^3 are about twice those at 128^3" all_within wittenbrink <<'ROWS'
1.9 2.2 RMS error of 32^3 by that of 128^3, corner
1.9 2.2 RMS error of 32^3 by that of 128^3, corner, antialiased
ROWS

check "Kraus: figures 2 and 3" all_within kraus <<'ROWS'
0.98158 0.98178 figure 2, volume of extinction
0.98158 0.98178 figure 2, volume of opacity
0.49074 0.49094 figure 3, mean opacity
0.74066 0.74086 figure 3, corrected
ROWS

figure4 >"$work/figure4" <<'ROWS'
opacity 1 .0126 .0582 .0926 .0999 .2179 .5043
opacity 4 .0323 .0725 .1535 .2409 .3557 .6389
opacity 8 .0349 .0729 .1597 .2498 .3600 .6400
extinction 1 .0000 .0433 .0566 .0000 .0817 .3254
extinction 4 .0000 .0082 .0102 .0000 .0133 .0756
extinction 8 .0000 .0003 .0003 .0000 .0004 .0060
ROWS
kraus_figure4() {
    all_within kraus <"$work/figure4"
}
check "Kraus: figure 4" kraus_figure4

check "Kraus: filters" all_within kraus <<'ROWS'
0.3411 0.3421 box2-linear, epsilon
0.1438 0.1448 box2-linear, epsilon_0
0.0567 0.0577 box4-linear, epsilon
0.0089 0.0098 box4-linear, epsilon_0
0.0312 0.0322 quad4-bspline, epsilon
0.0036 0.0045 quad4-bspline, epsilon_0
ROWS

check "Kraus: the wall breaks where the paper says, and not before" all_within kraus <<'ROWS'
0.05 1 wall-opacity-0.7, spread of opacity
0 0.015 wall-extinction-0.7, spread of opacity
0.5 1 wall-opacity-1.7, spread of opacity
0.02 0.1 wall-extinction-1.7, spread of opacity
0.9 1 wall-opacity-2.2, spread of opacity
ROWS

check "Kraus: averages of opacity lose what averages of extinction keep" all_within kraus <<'ROWS'
0.99 1.02 dome-extinction-5
0.99 1.02 shell-extinction-4
0 0.83 dome-opacity-5
0 0.93 shell-opacity-4
0 0.82 head-opacity-2
0.9 1 head-extinction-2
ROWS

# ---- Pictures -------------------------------------------------------------------

# Each is a PNG of that size (0: any) and shows something.
pictures_exist() { # pictures_exist PAPER SIZE NAME...
    folder=$PAPERS_OUT/$1 size=$2
    shift 2
    (cd "$folder" && /usr/bin/python3 -c '
import sys
from PIL import Image
size, names = int(sys.argv[1]), sys.argv[2:]
for name in names:
    picture = Image.open(name + ".png")
    print(name, picture.size)
    assert picture.format == "PNG" and size in (0, picture.width)
    low, high = picture.convert("L").getextrema()
    assert high > low
' "$size" "$@")
}

check "Wittenbrink: plots and sheets" pictures_exist wittenbrink 0 phase_curve rms corner graze phase torus
check "Wittenbrink: the torus at 512x512" pictures_exist wittenbrink 512 \
    pictures/torus-separate pictures/torus-weighted pictures/torus-difference
for scene in corner graze phase; do
    set --
    for volume in 32 32-aa 128 128-aa; do
        for what in separate weighted difference equalised; do
            set -- "$@" "pictures/$scene-$volume-$what"
        done
    done
    check "Wittenbrink: $scene" pictures_exist wittenbrink 320 "$@"
done

check "Kraus: plots and sheets" pictures_exist kraus 0 \
    figure4-opacity figure4-extinction filters figure5 figure6 figure7 pyramids
check "Kraus: figures 5 to 7 at 512x512" pictures_exist kraus 512 \
    pictures/wall-opacity-0.7 pictures/wall-opacity-1.7 pictures/wall-opacity-2.2 \
    pictures/wall-extinction-0.7 pictures/wall-extinction-1.7 pictures/wall-extinction-2.2 \
    pictures/scattered-opacity pictures/scattered-extinction
finish
