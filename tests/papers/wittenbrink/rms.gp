# gnuplot -c rms.gp FOLDER: bars like the paper's figure 7, from FOLDER/data/rms.dat.
folder = ARG1
set terminal pngcairo size 900,520 font "DejaVu Sans,11"
set output folder."/rms.png"
set title "RMS error of separate interpolation, of 255 (as figure 7)"
set border 3 lc rgb "#555555"
set tics nomirror
set grid ytics lc rgb "#dddddd"
set style data histograms
set style histogram clustered gap 1
set style fill solid border -1
set boxwidth 0.9
set ylabel "levels of 255"
set yrange [0:*]
set key top right
colours = "#922b21 #d98880 #1a5276 #7fb3d5"
file = folder."/data/rms.dat"
plot for [i=2:5] file using i:xtic(1) lc rgb word(colours, i - 1) title columnheader(i)
