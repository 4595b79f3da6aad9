# gnuplot -c stages.gp FOLDER: worst and RMS error of each stage by its bound, from FOLDER/stages.csv.
folder = ARG1
# Bound, worst, RMS and name: the name may hold commas.
rows = "< sed -n '2,$s/^\\([^,]*\\),\\([^,]*\\),\\([^,]*\\),[^\"]*\"\\([^\"]*\\)\".*/\\1\t\\2\t\\3\t\\4/p' " . folder . "/stages.csv"
set datafile separator "\t"
stats rows using 1 nooutput
set terminal pngcairo size 1200,140+17*STATS_records font "DejaVu Sans,10"
set output folder."/stages.png"
set title "Measured errors of each stage as parts of their bounds"
set border 3 lc rgb "#555555"
set tics nomirror
set grid xtics ytics lc rgb "#e5e5e5"
set xrange [0:1.03]
set yrange [STATS_records:-1]
set xlabel "error / bound (at 1 the bound is reached)"
set key top center outside horizontal
plot rows using ($2/$1):($0):ytic(stringcolumn(4)) with points pt 7 lc rgb "#922b21" title "worst", \
     rows using ($3/$1):($0) with points pt 6 lc rgb "#1a5276" title "RMS"
