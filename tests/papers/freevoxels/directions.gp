# gnuplot -c directions.gp FOLDER: error between the 26 directions, from FOLDER/data/directions.dat.
folder = ARG1
set terminal pngcairo size 900,480 font "DejaVu Sans,11"
set output folder."/directions.png"
set border 3 lc rgb "#555555"
set tics nomirror
set grid ytics lc rgb "#e8e8e8" lt 1
set style data histograms
set style histogram clustered gap 1.5
set style fill solid noborder
set yrange [0:*]
set ylabel "RMS error, levels of 255"
set key top left
set title "Light from 26 directions, views of the whole sphere: against splats with exact light" font ",13"
plot folder."/data/directions.dat" using 2:xtic(1) lc rgb "#c0392b" title "nearest direction, as published", \
     "" using 3 lc rgb "#e0a030" title "nearest direction for light alone", \
     "" using 5 lc rgb "#8fb8d8" title "between three, of bytes", \
     "" using 4 lc rgb "#1f618d" title "between three, of depths"
