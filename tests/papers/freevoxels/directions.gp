# gnuplot -c directions.gp FOLDER: error between the 26 directions, from FOLDER/data/directions.dat
# and between.dat.
folder = ARG1
set terminal pngcairo size 1500,520 font "DejaVu Sans,11"
set output folder."/directions.png"
set border 3 lc rgb "#555555"
set tics nomirror
set grid ytics lc rgb "#e8e8e8" lt 1
set yrange [0:*]
set ylabel "RMS error, levels of 255"
set key top left
set style line 1 lw 2.5 lc rgb "#c0392b"
set style line 2 lw 2.5 lc rgb "#e0a030"
set style line 3 lw 2.5 lc rgb "#1f618d"
set style line 4 lw 2.5 lc rgb "#af7ac5"
set multiplot layout 1,2 title "Light from 26 directions, against splats with exact light" font ",14"
set title "the head at 1/8 of its resolution, on a way past three directions"
set xrange [0:135]
set xtics ("axis" 0, "face diagonal" 45, "cube diagonal" 80.264, "axis" 135)
set grid xtics
plot folder."/data/between.dat" using 1:2 with lines ls 4 title "nearest direction, by length", \
     "" using 1:3 with lines ls 2 title "between three, of depths", \
     "" using 1:4 with lines ls 3 title "between three, of light"
set title "views of the whole sphere"
set xrange [-0.6:4.6]
set xtics autofreq
unset grid
set grid ytics
set style data histograms
set style histogram clustered gap 1.5
set style fill solid noborder
plot folder."/data/directions.dat" using 2:xtic(1) ls 1 title "nearest direction, as published", \
     "" using 3 ls 4 title "nearest, by length", \
     "" using 4 ls 2 title "between three, of depths", \
     "" using 5 ls 3 title "between three, of light"
unset multiplot
