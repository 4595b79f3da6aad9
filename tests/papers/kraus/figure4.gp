# gnuplot -c figure4.gp FOLDER: opacity of a ray over (d, r), from FOLDER/data/figure4-*.dat.
folder = ARG1
set terminal pngcairo size 1640,940 font "DejaVu Sans,10"
set pm3d depthorder border lc rgb "#303030" lw 0.3
set palette defined (0 "#1a2a6c", 0.5 "#2a9d8f", 0.8 "#e9c46a", 1 "#fdf6e3")
set cbrange [0:1]
unset colorbox
unset key
set view 58,322,1.12,1.05
set xyplane at 0
set xrange [0:2]
set yrange [0:1]
set zrange [0:1]
set lmargin 4
set xtics 0.5,0.5 offset 0,-0.4
set ytics 0.5,0.5 offset 0,-0.4
set ztics 0.5
set xlabel "d" offset 0,-0.6
set ylabel "r" offset 0,-0.6
do for [method in "opacity extinction"] {
    set output folder."/figure4-".method.".png"
    set multiplot layout 2,4 title "Figure 4: opacity of a ray through one vertex, ".method. \
        "-based sampling" font ",15"
    do for [row=1:2] {
        do for [tau in "1 2 4 8"] {
            set title "tau = ".tau.", ".(row == 1 ? "the library" : "double precision") offset 0,1
            splot folder."/data/figure4-".method."-".tau.".dat" using 1:2:(column(row + 2)) with pm3d
        }
    }
    unset multiplot
}
