# gnuplot -c filters.gp FOLDER: psi of eight impulses, and the convolution nearest to
# them, from FOLDER/data/filter-*.dat.
folder = ARG1
set terminal pngcairo size 1500,480 font "DejaVu Sans,11"
set output folder."/filters.png"
set border 3 lc rgb "#555555"
set tics nomirror
set grid lc rgb "#dddddd"
set xrange [-2.6:2.6]
set yrange [0:1.05]
set xlabel "distance from the impulse, coarse voxels"
set key top right samplen 2
pairs = "box2-linear box4-linear quad4-bspline"
titles = '"box of 2 taps, trilinear" "box of 4 taps, trilinear" "(13 19 19 13)/64, B-spline"'
set multiplot layout 1,3 title "Section 4.2: a pyramid's answer to an impulse, at eight places" font ",14"
do for [i=1:3] {
    set title word(titles, i)
    file = folder."/data/filter-".word(pairs, i).".dat"
    plot for [c=3:10] file using 1:c with lines lc rgb "#7fb3d5" title (c == 3 ? "psi, the library" : ""), \
         file using 1:2 with lines lw 2.5 lc rgb "#922b21" title "phi, their mean"
}
unset multiplot
