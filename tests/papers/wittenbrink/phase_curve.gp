# gnuplot -c phase_curve.gp FOLDER: figure 6 and the general formulas, from FOLDER/data/phase-*.dat.
folder = ARG1
set terminal pngcairo size 1200,520 font "DejaVu Sans,11"
set output folder."/phase_curve.png"
set style line 1 lc rgb "#c0392b" lw 2
set style line 2 lc rgb "#1f618d" lw 2
set border 3 lc rgb "#555555"
set tics nomirror
set grid lc rgb "#dddddd"
set xlabel "phase r"
set xrange [0:1]
set key bottom left Left reverse samplen 2
set multiplot layout 1,2
set title "Figure 6: colour of a ray into an opaque white material"
set ylabel "colour"
set yrange [0.7:1.02]
file = folder."/data/phase-1.00.dat"
plot file using 1:3 with lines lc rgb "#e6b0aa" lw 7 title "1 - r + r^2", \
     file using 1:2 with lines ls 1 title "separate, the library", \
     file using 1:5 with lines lc rgb "#a9cce3" lw 7 title "1", \
     file using 1:4 with lines ls 2 title "weighted, the library"
set title "The same by opacity a of the material"
set ylabel "associated colour / opacity"
set yrange [0.6:1.02]
plot for [a in "0.25 0.50 0.75 1.00"] folder."/data/phase-".a.".dat" using 1:6 with lines ls 1 \
         dashtype int(4.5 - 4 * a) + 1 title "separate, a = ".a, \
     for [a in "0.25 0.50 0.75 1.00"] folder."/data/phase-".a.".dat" using 1:7 with lines ls 2 \
         title (a eq "1.00" ? "weighted, every a" : "")
unset multiplot
