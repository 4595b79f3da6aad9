# gnuplot -c budget.gp FOLDER: the error of the head's picture by stages, from
# FOLDER/pictures_budget.csv.
folder = ARG1
set datafile separator ","
set terminal pngcairo size 1000,560 font "DejaVu Sans,11"
set output folder."/pictures_budget.png"
set title "Error budget of the head: each stage alone"
set border 3 lc rgb "#555555"
set tics nomirror
set grid xtics lt 1 lc rgb "#dddddd"
set logscale x
set format x "10^{%L}"
set xlabel "RMS error, levels of 255"
set xrange [1e-8:1]
set yrange [9:-1]
set key outside right center Left reverse samplen 1
file = folder."/pictures_budget.csv"
of(storage) = strcol(1) eq "head" && strcol(2) eq storage && strcol(3) ne "the library" \
              && strcol(3) ne "the sum of these" ? 1 : NaN
plot file using ($4 * of("RGBA16")):($0):ytic(3) every ::0::8 skip 1 with points \
         pt 7 ps 1.5 lc rgb "#1a5276" title "RGBA16", \
     file using ($4 * of("RGBA8")):($0) every ::11::19 skip 1 with points \
         pt 6 ps 1.5 lc rgb "#922b21" title "RGBA8"
