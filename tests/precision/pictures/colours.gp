# gnuplot -c colours.gp FOLDER: what weighting colours in 8 bits loses, by opacity, from
# FOLDER/pictures_section7.csv.
folder = ARG1
set datafile separator ","
set terminal pngcairo size 1000,560 font "DejaVu Sans,11"
set output folder."/pictures_section7.png"
set title "Colours divided by opacity again (Wittenbrink et al., section 7)"
set border 3 lc rgb "#555555"
set tics nomirror
set grid xtics ytics lt 1 lc rgb "#dddddd"
set logscale x 2
set logscale y
set format y "10^{%L}"
set xlabel "opacity of a voxel, of 255"
set ylabel "error of colour, levels of 255"
set xrange [0.9:300]
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 255)
set yrange [1e-6:300]
set key outside right center Left reverse samplen 2
file = folder."/pictures_section7.csv"
bound(x) = 127.5 / x
plot bound(x) with lines dt 2 lc rgb "#922b21" title "1/2 * 255 / opacity", \
     file using 1:3 skip 1 with points pt 7 lc rgb "#922b21" title "a preweighted voxel, worst", \
     file using 1:6 skip 1 with linespoints pt 6 lc rgb "#e59866" \
         title "a preweighted picture, RMS", \
     file using 1:5 skip 1 with linespoints pt 7 lc rgb "#1a5276" title "a weighted picture, RMS"
