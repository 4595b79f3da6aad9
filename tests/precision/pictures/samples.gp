# gnuplot -c samples.gp FOLDER: the error of a fog by the number of its samples, from
# FOLDER/pictures_samples.csv.
folder = ARG1
set datafile separator ","
set terminal pngcairo size 1000,560 font "DejaVu Sans,11"
set output folder."/pictures_samples.png"
set title "Accumulators: a pixel in fogs that let 78, 37 and 1.8 % of the light through, the worst"
set border 3 lc rgb "#555555"
set tics nomirror
set grid xtics ytics lt 1 lc rgb "#dddddd"
set logscale x 2
set logscale y
set format y "10^{%L}"
set xlabel "samples"
set ylabel "error of the worst channel, levels of 255"
set xrange [1:4096]
set yrange [1e-8:1e3]
set key outside right center Left reverse samplen 2 title "fraction bits"
file = folder."/pictures_samples.csv"
half_level(x) = 0.5
plot file using 1:2 skip 1 with linespoints pt 7 ps 0.6 lc rgb "#922b21" title "8", \
     file using 1:3 skip 1 with linespoints pt 7 ps 0.6 lc rgb "#e59866" title "12", \
     file using 1:4 skip 1 with linespoints pt 7 ps 0.6 lc rgb "#b7950b" title "16", \
     file using 1:5 skip 1 with linespoints pt 7 ps 0.6 lc rgb "#1e8449" title "20", \
     file using 1:6 skip 1 with linespoints pt 7 ps 0.6 lc rgb "#1a5276" title "24", \
     file using 1:8 skip 1 with lines dt 2 lc rgb "#1a5276" title "24, bound", \
     file using 1:7 skip 1 with linespoints pt 7 ps 0.6 lc rgb "#7d3c98" title "31, the library", \
     half_level(x) with lines lc rgb "#555555" dt 3 title "half a level"
