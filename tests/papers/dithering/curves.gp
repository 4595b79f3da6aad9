# gnuplot -c curves.gp FOLDER NAME KIND TITLE: a figure's curves, from FOLDER/data/NAME.dat,
# and below them what they are off. KIND: accumulated, pair, bricks or line.
folder = ARG1
name = ARG2
kind = ARG3
file = folder."/data/".name.".dat"

# Columns: slices; exact, plain, ordered, random, ours, with more bits; the errors of these.
colours = "#d5d8dc #2471a3 #ca8a04 #9b7fc0 #c0392b #1e8449"
widths = "9 2 2 1.5 2.2 2.2"
shown(i) = system(sprintf("awk 'NR == 3 { print $%d }' %s", i, file)) ne "-"
drawn = ""
do for [i=2:7] {
    if (shown(i)) { drawn = drawn." ".i }
}
set datafile missing "-"
stats file using 1 skip 1 nooutput
slices = STATS_max
worst = low = high = 0
do for [i in drawn] {
    stats file using (abs(column(int(i) + 6))) skip 1 nooutput
    worst = STATS_max > worst ? STATS_max : worst
    stats file using int(i) skip 1 nooutput
    low = i == 2 || STATS_min < low ? STATS_min : low
    high = STATS_max > high ? STATS_max : high
}

bricks = kind eq "bricks" || kind eq "line"
set terminal pngcairo size 760,580 font "DejaVu Sans,10"
set output folder."/pictures/".name.".png"
set border 3 lc rgb "#555555"
set tics nomirror
set grid lc rgb "#e8e8e8" lt 1
set xrange [0:slices]
set lmargin at screen 0.10
set rmargin at screen 0.975
set multiplot title ARG4 font ",13" offset 0,-0.2

set tmargin at screen 0.84
set bmargin at screen 0.41
set key at screen 0.53,0.935 center top horizontal maxcols 3 Left reverse samplen 2 spacing 1.15
set format x ""
set ylabel (bricks ? "level of two bricks" : "level") offset 0.5
set yrange [0:*]
if (bricks) { # small errors are for the other plot
    spare = high - low < 20 ? 10 : 2
    set yrange [low - spare:high + spare]
}
if (kind eq "pair") {
    plot for [i in drawn] file using 1:int(i) with lines lc rgb word(colours, i - 1) \
             lw real(word(widths, i - 1)) title columnheader(int(i)), \
         for [i in drawn] file using (slices - $1):int(i) with lines lc rgb word(colours, i - 1) \
             lw real(word(widths, i - 1)) notitle
} else {
    plot for [i in drawn] file using 1:int(i) with lines lc rgb word(colours, i - 1) \
        lw real(word(widths, i - 1)) title columnheader(int(i))
}

set tmargin at screen 0.37
set bmargin at screen 0.10
unset key
set format x "%g"
set xlabel (kind eq "accumulated" ? "slices" : kind eq "line" ? "pixel" : "slices in brick 1") offset 0,0.6
set ylabel (bricks ? "AAP error, %" : "off, levels") offset 0.5
limit = worst > 40 && !bricks ? 40 : worst * 1.08
set yrange [-limit:limit]
if (bricks) { set yrange [*:*] }
plot for [i in drawn] file using 1:int(i)+6 with lines lc rgb word(colours, i - 1) \
    lw (i == 2 ? 5 : 1.8) notitle
unset multiplot
