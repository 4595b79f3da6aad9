# gnuplot -c stages.gp FOLDER: worst and RMS error of each stage by its bound, from FOLDER/stages.csv.
folder = ARG1
set datafile separator ","
set terminal pngcairo size 1200,400 font "DejaVu Sans,10"
set output folder."/stages.png"
set title "Measured errors as parts of their bounds"
set border 3 lc rgb "#555555"
set grid xtics lc rgb "#dddddd"
set xrange [0:1.05]
set xlabel "error / bound (1: the bound is reached)"
set key top right outside
file = folder."/stages.csv"
stats file using 1 skip 1 nooutput
set yrange [STATS_records:-1]
set tics nomirror
plot file using ($2/$1):($0):ytic(stringcolumn(6)) skip 1 with points pt 7 lc rgb "#922b21" title "worst", \
     file using ($3/$1):($0) skip 1 with points pt 6 lc rgb "#1a5276" title "RMS"
