# gnuplot -c histogram.gp FOLDER: figures 40 and 41, from FOLDER/data/histogram.dat.
folder = ARG1
file = folder."/data/histogram.dat"
set terminal pngcairo size 1500,480 font "DejaVu Sans,11"
set output folder."/histogram.png"
set border 11 lc rgb "#555555"
set tics nomirror
set grid ytics lc rgb "#e8e8e8" lt 1
set style fill solid noborder
set boxwidth 0.9
set xlabel "value"
set ylabel "voxels"
set y2label "opacity, levels"
set yrange [0:70000]
set y2range [0:28]
set y2tics
set key top right samplen 2
set multiplot layout 1,2 title "Equation 12 on the head: 100 / ln(voxels), and 0.25 at peaks" font ",14"
do for [part=0:1] {
    set title part ? "As figure 41: between grey and white matter" : "As figure 40: all values (air goes on to 2957530)"
    set xrange [(part ? 94.5 : -1):(part ? 121.5 : 200)]
    plot file using 1:2 with boxes lc rgb "#d5d8dc" title "voxels", \
         file using 1:3 axes x1y2 with linespoints lc rgb "#1f618d" lw 2 pt 7 ps (part ? 0.8 : 0.01) title "opacity"
}
unset multiplot
