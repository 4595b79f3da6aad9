# gnuplot -c inside.gp FOLDER: what bytes cost a viewer in the volume, from FOLDER/data/inside.dat.
folder = ARG1
set terminal pngcairo size 860,520 font "DejaVu Sans,11"
set output folder."/inside.png"
set border 3 lc rgb "#555555"
set tics nomirror
set grid lc rgb "#e8e8e8" lt 1
set logscale xy
set xrange [0.004:1]
set yrange [0.5:300]
set xlabel "A_V, light from the viewer's voxel"
set ylabel "A_B / A_V, farthest off, levels of 255"
set key top right
set title "Section 3.3: the viewer in the volume" font ",14"
plot 1/x with lines lw 6 lc rgb "#f0c9a0" title "1 / A_V", \
     folder."/data/inside.dat" using 1:2 with lines lw 3 lc rgb "#1f618d" title "double precision", \
     folder."/data/inside.dat" using 1:3 every 6 with points pt 7 ps 0.7 lc rgb "#c0392b" title "the library"
