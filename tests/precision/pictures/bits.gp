# gnuplot -c bits.gp FOLDER: the error of pictures by the bits of one stage, from
# FOLDER/pictures_*_bits.csv.
folder = ARG1
set datafile separator ","
set terminal pngcairo size 1000,560 font "DejaVu Sans,11"
set output folder."/pictures_bits.png"
set title "One stage rounded, all others exact: RMS over twelve scenes"
set border 3 lc rgb "#555555"
set tics nomirror
set grid xtics ytics lt 1 lc rgb "#dddddd"
set logscale y
set format y "10^{%L}"
set xlabel "bits of a channel, or fraction bits"
set ylabel "RMS error before packing, levels of 255"
set xrange [0:32]
set xtics 4
set yrange [1e-7:100]
set key outside right center Left reverse samplen 2
name(stage) = folder."/pictures_".stage."_bits.csv"
packing(x) = 1 / sqrt(12.0)
plot name("storage") using 1:2 skip 1 with linespoints pt 7 lc rgb "#922b21" title "storage", \
     name("associated") using 1:2 skip 1 with linespoints pt 6 lc rgb "#e59866" \
         title "storage, preweighted", \
     name("position") using 1:2 skip 1 with linespoints pt 7 lc rgb "#1e8449" title "position", \
     name("weight") using 1:2 skip 1 with linespoints pt 7 lc rgb "#7d3c98" title "weights", \
     name("accumulator") using 1:2 skip 1 with linespoints pt 7 lc rgb "#1a5276" \
         title "accumulators", \
     packing(x) with lines dt 2 lc rgb "#555555" title "packing to 8 bits"
