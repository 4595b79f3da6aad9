# gnuplot -c nodes.gp FOLDER: work of many nodes, from FOLDER/data/nodes.dat and shares.dat.
folder = ARG1
speed = folder."/data/nodes.dat"
shares = folder."/data/shares.dat"
set terminal pngcairo size 1400,580 font "DejaVu Sans,11"
set output folder."/figure8.png"
set border 3 lc rgb "#555555"
set tics nomirror
set grid lc rgb "#e8e8e8" lt 1
array side[4] = ["1 voxel, as published", "4^3 voxels", "8^3 voxels", "16^3 voxels"]
array colour[4] = ["#1f618d", "#2a9d8f", "#e0a030", "#c0392b"]
set multiplot layout 1,2 title "Figure 8, a SIMULATION: one machine counts the work of each block; nothing ran in parallel" font ",14"
set title "speed-up: all work by that of the busiest node, mean of 24 random views"
set xlabel "nodes"
set ylabel "speed-up"
set xrange [0:132]
set yrange [0:132]
set xtics (8, 16, 32, 64, 96, 128)
set ytics (8, 16, 32, 64, 96, 128)
set key top left title "blocks of" left
plot x with lines lw 1 dt 2 lc rgb "#888888" title "nodes", \
     for [i=1:4] speed using 1:(column(2 * i)) with linespoints lw 2.5 pt 7 ps 0.9 lc rgb colour[i] title side[i]
set title "work of each of 128 nodes, mean of the same views, as part of an equal share"
set xlabel "node"
set ylabel "work"
set xrange [0:128]
set yrange [0:*]
set xtics 16
set ytics 0.5
set key top right title "blocks of" left
plot for [i=4:1:-1] shares using 1:(column(i + 1)) with steps lw (i == 1 ? 3 : 1.5) lc rgb colour[i] title side[i]
unset multiplot
