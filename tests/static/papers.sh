#!/bin/sh
# What make papers writes: every number within what its row allows, the papers' own
# numbers among them, artefacts where they belong and nowhere else, and all pictures.
set -u
. tests/tap
BUILD=${BUILD:-build}
PAPERS_OUT=$work/papers
QV_VIEWS=20 # of the sphere; the papers take 500, for a minute
export BUILD PAPERS_OUT QV_VIEWS

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

check "Wittenbrink: every row within what it allows" rows_hold wittenbrink 55
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

# Figure 4 as spreads over r: method, tau, then d 0.5 .6 .8 1 1.2 1.6, in double precision: within
# 4 %, for points rounded to 1/256 voxel, and half of the last digit here.
figure4() {
    while read -r method tau spreads; do
        for d in 0.5 0.6 0.8 1 1.2 1.6; do
            expected=${spreads%% *}
            spreads=${spreads#* }
            echo "$expected spread, $method, tau $tau, d $d"
        done
    done | awk '{ expected = $1; $1 = ""; off = .04 * expected + .00005
        print expected - off, expected + off $0 }'
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

# ---- Alpha dithering ---------------------------------------------------------------

# The paper's numbers. Each line: lowest and highest that passes, place, what.
dithering_says() {
    while read -r low high row; do
        found=$(awk -F' *[|] *' -v row="$row" '$2 ": " $3 == row { print $5; exit }' \
            "$PAPERS_OUT/dithering/numbers.txt")
        echo "$row: $found, wanted $low to $high"
        [ -n "$found" ] || return 1
        awk -v n="$found" -v low="$low" -v high="$high" 'BEGIN { exit !(n >= low && n <= high) }' ||
            return 1
    done
}

# Worst of the figures. Each line: columns (3: plain, 4: ordered, 6: ours, 7: ours with more
# bits), the amount that it must have or, with "most", may have, figures.
dithering_worst() {
    while read -r column amount figures; do
        for figure in $figures; do
            awk -F' *[|] *' -v column="$column" -v amount="$amount" -v figure="$figure" '
                NF == 10 && $2 == figure {
                    split($(column + 2), worst, " ")
                    worst[1] = worst[1] < 0 ? -worst[1] : worst[1]
                    print "figure", figure, "column", column ":", worst[1], "wanted", amount
                    limit = amount
                    if (sub(/^most/, "", limit)) seen = worst[1] <= limit + 0
                    else seen = worst[1] - limit < .051 && limit - worst[1] < .051
                }
                END { exit !seen }' "$PAPERS_OUT/dithering/numbers.txt" || return 1
        done
    done
}

# What vanishes without dither, and the seam between bricks.
check "Dithering: pictures of the head" dithering_says <<'ROWS'
15 40 figure3: 600 slices, without dither, RMS
5 15 figure3: 275 slices, without dither, RMS
0 1.2 figure3: 128 slices, dithered rounding, RMS
0 1.2 figure3: 275 slices, dithered rounding, RMS
0 1.2 figure3: 600 slices, dithered rounding, RMS
5 15 techniques: ordered dither, period 16, RMS
0 .3 techniques: feedback, 8 bits beside, RMS
4 20 figure6: two bricks, without dither, RMS
0 1 figure6: two bricks, dithered rounding, RMS
ROWS

check "Dithering: the paper's numbers" dithering_says <<'ROWS'
153 153 section 5: colour 157 under a slice of opacity 7 and no colour
0 0 figure 41: equation 12, worst difference of an opacity
35 35 figure 41: entries at peaks
100 100 figure 5: 8 bits, level after 100 slices
82.86 82.86 figure 5: exact, level after 100 slices
128 128 figure 5: 8 bits, level after 200 slices
138.79 138.79 figure 5: exact, level after 200 slices
160.5 161.4 figure 7: 8 bits, two bricks of 100 slices
27.5 28.5 figure 7: 8 bits, AAP error in %
8.3 9.1 figure 12: 8 bits, AAP error in %
4.2 5 figure 13: 8 bits, AAP error in %
49 49.9 figure 14: 8 bits, AAP error in %
128 128 figure 18: ordered, level of the plateau
49 49.9 figure 19: ordered, AAP error in %
49 49.9 figure 20: ordered, AAP error in %
24 24.8 figure 21: ordered, AAP error in %
192 192 figure 34: ordered, level of the plateau of base + bump
.54 .7 figure 35: ordered, AAP error in %, without sign
149 153 figure 55: ordered, slice where the plateau begins
225 234 figure 56: ordered, slice where the plateau begins
4 60 figure 39: dithered apart, largest fall from a slice to the next
0 0 figure 39: dithered rounding, largest fall
0 4 figure 39: dithered rounding, worst difference in levels
ROWS

check "Dithering: how far the published curves are off" dithering_worst <<'ROWS'
4 2.9 24
4 10.8 16
4 11.5 25
4 9.7 23 26
4 13.3 27
4 14.0 28
4 8.9 29
4 9.0 30
4 26.3 31
4 33.0 32
3 7.0 36
3 17.4 37
3 2.9 38
ROWS

# Levels, then percent: two bricks of 200, 400 or 500 slices, and of 1000.
check "Dithering: how far ours are off" dithering_worst <<'ROWS'
6 most4 5 8 10 11 15 16 18 22 23 24 25 26 27 28 29 30 31 32 33 34 36 37 38 55 56
7 most.2 5 8 10 11 15 16 18 22 23 24 25 26 27 28 29 30 31 32 33 34 55 56
7 most.35 36 37 38
6 most3.5 7 9 12 13 52 53 54
6 most1 14 19 20 21 35 42 43 44 45 46 47 48 49 50 51
7 most.05 7 9 12 13 14 19 20 21 35 42 43 44 45 46 47 48 49 50 51 52 53 54
ROWS

check "Dithering: every row within what it allows" rows_hold dithering 39

cat >"$work/table1" <<'ROWS'
128 2 192 3 213 4 224 5 230 6 234 7 237 8 240 9 241 10 243 11 244 12 245 13 246 15 247 16
248 19 249 22 250 26 251 32 252 43 253 64 254 128
ROWS
dithering_table1() {
    xargs -n 2 <"$work/table1" >"$work/expected"
    awk '$1 + 0 > 0 && NF == 2 { print $1, $2 }' "$PAPERS_OUT/dithering/table1.txt" |
        diff "$work/expected" -
}
check "Dithering: table 1" dithering_table1

# 1 in 4 of the six rows of .25, as far apart as they can be, and not the row above; the rest as
# it is. The sum of all is 532.5.
dithering_table3() {
    awk '$1 ~ /^[0-9]+$/ && NF == 10 {
            rows++
            total += $10
            pattern = ""
            for (slice = 0; slice < 8; slice++) {
                pattern = pattern " " $(slice + 2)
                bad = bad || $10 != .25 && $(slice + 2) != $10 ||
                    $10 == .25 && $(slice + 2) != $((slice + 4) % 8 + 2)
                sum += $10 == .25 ? $(slice + 2) : 0
            }
            bad = bad || pattern == above
            above = $10 == .25 ? pattern : ""
        }
        END { print rows, sum, total / rows; exit bad || rows != 25 || sum != 12 || total != 532.5 }' \
        "$PAPERS_OUT/dithering/table3.txt"
}
check "Dithering: table 3" dithering_table3

# ---- FreeVoxels ---------------------------------------------------------------------

check "FreeVoxels: every row within what it allows" rows_hold freevoxels 68

check "FreeVoxels: the leak of equation 9 is there, that of equation 10 is not" all_within freevoxels <<'ROWS'
.62 .66 two splats, opacity 0.1: conventional leaks
15.9 16 two splats, opacity 0.5: conventional leaks
51.6 51.7 two splats, opacity 0.9: conventional leaks
.25 .45 cube, opacity 0.01: conventional leaks
1.71 1.91 cube, opacity 0.05: conventional leaks
3.61 3.81 cube, opacity 0.1: conventional leaks
10.0 10.2 cube, opacity 0.25: conventional leaks
23.8 24 cube, opacity 0.5: conventional leaks
66.4 66.6 cube, opacity 0.9: conventional leaks
0 .5 cube, opacity 0.9: FreeVoxels leak
60 70 figure 6, 1 layers: conventional
0 .1 figure 6, 1 layers: FreeVoxels
2 2.3 figure 6, 24 layers: conventional
0 .1 figure 6, 24 layers: FreeVoxels
ROWS

check "FreeVoxels: light along diagonals, the nearest direction, the viewer inside" all_within freevoxels <<'ROWS'
.19 .197 as published, along an axis
.31 .316 as published, along a diagonal of a face
.385 .391 as published, along a diagonal of the cube
.19 .197 by the length of a step, along a diagonal of a face
.19 .197 by the length of a step, along a diagonal of the cube
27.56 27.58 nearest direction, at most so many degrees away
.99 1.01 viewer in a voxel of 1: farthest off
3.9 4 viewer in a voxel of 0.25: farthest off
9.7 9.9 viewer in a voxel of 0.1: farthest off
19.5 20.5 viewer in a voxel of 0.05: farthest off
.412 .416 geometric mean of 1 .9 .8 .5 .4 .3 .2 .1
ROWS

# Two numbers of a row. Each line of standard input: lowest and highest of the first, of the
# second, and the row.
pairs_within() { # pairs_within PAPER
    while read -r low high low2 high2 what; do
        awk -F' *[|] *' -v what="$what" -v low="$low" -v high="$high" -v low2="$low2" \
            -v high2="$high2" '
            NF == 5 && $2 == what {
                print what ": " $3 ", " $4 ", wanted", low, "to", high ",", low2, "to", high2
                seen = $3 >= low && $3 <= high && $4 >= low2 && $4 <= high2
            }
            END { exit !seen }' "$PAPERS_OUT/$1/table.md" || return 1
    done
}

check "Dithering: ours beside other techniques of section 9" pairs_within dithering <<'ROWS'
0 100 0 4.2 bump by pixel, hits corrected, opacity 0.03
0 100 0 4.2 bump by pixel, hits corrected, opacity 0.1
0 100 0 4.2 bump by pixel, hits corrected, opacity 0.5
0 100 0 4.2 bump by pixel, hits corrected, opacity 1
0 100 0 4.2 bump by pixel, hits corrected, opacity 1.5
0 100 0 4.2 bump by pixel, hits corrected, opacity 2
0 100 0 .55 residual of 8 bits by pixel, opacity 0.03
0 100 0 .55 residual of 8 bits by pixel, opacity 0.1
0 100 0 .55 residual of 8 bits by pixel, opacity 0.5
0 100 0 .55 residual of 8 bits by pixel, opacity 1
0 100 0 .55 residual of 8 bits by pixel, opacity 1.5
0 100 0 .55 residual of 8 bits by pixel, opacity 2
0 100 .5 .65 8.8, hash, worst of the six opacities
0 100 .5 .65 8.8, hash, every 233rd slice
0 100 .9 1.2 8.8, golden ratio, every 233rd slice
6.6 6.7 6.8 6.9 random slices, opacities up to 2
3.3 3.5 3.6 3.7 random slices, opacities up to 16
1.5 1.6 1.6 1.7 random slices, opacities up to 128
ROWS

check "Kraus: extinction breaks later for larger tau" all_within kraus <<'ROWS'
1.1 1.3 extinction, tau 2: breaks at d
1.4 1.6 extinction, tau 4: breaks at d
1.6 1.9 extinction, tau 8: breaks at d
1.7 2 extinction, tau 16: breaks at d
ROWS

check "FreeVoxels: what other ways cost, and not ours" pairs_within freevoxels <<'ROWS'
3.9 4.1 0 .5 truncated byte, the same six opacities
47.5 49 0 .51 product kept in a byte, opacity 0.01: byte after 500 voxels
.524 .526 .412 .416 arithmetic mean of the same
0 0 1 1 one voxel in eight has a byte of 0: byte of the block
.6 1 0 .51 500 blocks of level 3, by bytes of levels 1 and 2: farthest off
.77 .78 .34 .36 light after 10 voxels of opacity 0.1: equation 11, weights of 1/4
ROWS

check "FreeVoxels: the head in red light has shadows, by splats and by ray casting" pairs_within freevoxels <<'ROWS'
.1 .3 .1 .3 share of the head in shadow, red below 1/4
.4 .8 .4 .8 share of the head in light, red above 1/2
ROWS

check "FreeVoxels: the geometric mean darkens levels, attenuation built anew does not" pairs_within freevoxels <<'ROWS'
.85 .95 .98 1.02 skin, level 1: brightness of level 0's
.7 .85 .98 1.04 skin, level 2: brightness of level 0's
0 .6 .95 1.2 skin, level 4: brightness of level 0's
15 200 0 10 skin, level 1: RMS from level 0
70 200 0 30 skin, level 3: RMS from level 0
.9 .97 .98 1.04 glass, level 2: brightness of level 0's
28 200 0 28 glass, level 3: RMS from level 0
ROWS

check "FreeVoxels: nearly as many times faster as there are nodes, where blocks are voxels" pairs_within freevoxels <<'ROWS'
7.9 8 7.5 8 8 nodes, blocks of 1 voxels an axis
15.5 16 15 16 16 nodes, blocks of 1 voxels an axis
62 64 56 64 64 nodes, blocks of 1 voxels an axis
120 128 110 128 128 nodes, blocks of 1 voxels an axis
ROWS

# The nearest of 26 is what the paper takes; head, fog, ball, clouds and all of them. Between light is
# the last column.
freevoxel_directions() {
    awk '{ print; volumes++; bad = bad || !($5 > 0 && $5 < $2 && $5 < $3 && $5 < $4)
           bad = bad || $1 == "head" && $5 > $2 / 2 }
        END { exit bad || volumes != 5 }' "$PAPERS_OUT/freevoxels/data/directions.dat"
}
check "FreeVoxels: errors between the directions" freevoxel_directions

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

check "Dithering: sheets" pictures_exist dithering 0 problem dithered bricks chunks bits12 \
    figure3 techniques figure6 histogram
set --
for figure in 05 $(seq -f %02.0f 7 39) $(seq 42 56); do
    set -- "$@" "pictures/figure$figure"
done
check "Dithering: figures 5, 7 to 39 and 42 to 56" pictures_exist dithering 760 "$@"

check "FreeVoxels: plots and sheets" pictures_exist freevoxels 0 \
    figure2 figure6 figure7 figure8 levels hierarchy inside directions
set --
for layers in 1 4 24; do
    set -- "$@" "pictures/leak-$layers-over" "pictures/leak-$layers-added" \
        "pictures/leak-$layers-over-error"
done
check "FreeVoxels: figure 6" pictures_exist freevoxels 364 "$@"
check "FreeVoxels: figure 7 at 600x600" pictures_exist freevoxels 600 \
    pictures/head-unlit-splats pictures/head-lit-splats pictures/head-unlit-rays pictures/head-lit-rays
set --
for subject in skin glass; do
    for level in 0 1 2 3 4 5; do
        set -- "$@" "pictures/$subject-geometric-$level" "pictures/$subject-rebuilt-$level"
    done
done
check "FreeVoxels: levels" pictures_exist freevoxels 256 "$@"
finish
