# gnuplot -c hierarchy.gp FOLDER: levels against level 0, from FOLDER/data/hierarchy-*.dat.
folder = ARG1
skin = folder."/data/hierarchy-skin.dat"
glass = folder."/data/hierarchy-glass.dat"
set terminal pngcairo size 1240,480 font "DejaVu Sans,11"
set output folder."/hierarchy.png"
set border 3 lc rgb "#555555"
set tics nomirror
set grid ytics lc rgb "#e8e8e8" lt 1
set style line 1 lw 2 pt 7 ps 0.9 lc rgb "#c0392b"
set style line 2 lw 2 pt 7 ps 0.9 lc rgb "#1f618d"
set xlabel "level"
set xrange [-0.15:5.15]
set xtics 1
set key top left
set multiplot layout 1,2 title "Section 3.2: levels of the head, by the geometric mean and built anew" font ",14"
do for [part=0:1] {
    set title part == 0 ? "brightness, of level 0's" : "RMS from level 0, levels of 255"
    if (part == 0) { set yrange [0.4:1.6] } else { set yrange [0:140] }
    mean = 2 + 2 * part
    plot skin using 1:mean with linespoints ls 1 title "skin, geometric mean", \
         glass using 1:mean with linespoints ls 1 dt 2 title "glass, geometric mean", \
         skin using 1:(column(mean + 1)) with linespoints ls 2 title "skin, built anew", \
         glass using 1:(column(mean + 1)) with linespoints ls 2 dt 2 title "glass, built anew"
}
unset multiplot
