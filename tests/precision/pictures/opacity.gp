# gnuplot -c opacity.gp FOLDER: the error of a fog by its opacity, from FOLDER/pictures_opacity.dat.
folder = ARG1
set terminal pngcairo size 1000,560 font "DejaVu Sans,11"
set output folder."/pictures_opacity.png"
set title "A pixel in a fog of 256 samples"
set border 3 lc rgb "#555555"
set tics nomirror
set grid xtics ytics lt 1 lc rgb "#dddddd"
set logscale xy
set format x "10^{%L}"
set xlabel "opacity of a sample"
set ylabel "error of the worst channel, levels of 255"
set xrange [1e-5:1]
set yrange [1e-4:300]
set key outside right center Left reverse samplen 2
file = folder."/pictures_opacity.dat"
half_level(x) = 0.5
plot file using 1:3 with lines lw 2 lc rgb "#922b21" title "RGBA8, weighted", \
     file using 1:4 with lines lw 2 lc rgb "#e59866" title "RGBA8, preweighted", \
     file using 1:5 with lines lw 2 lc rgb "#7d3c98" title "15 bits, as VTK", \
     file using 1:6 with lines lw 2 lc rgb "#1e8449" title "half floats", \
     file using 1:2 with lines lw 2 lc rgb "#1a5276" title "RGBA16, weighted", \
     half_level(x) with lines lc rgb "#555555" dt 2 title "half a level"
