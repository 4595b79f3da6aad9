# gnuplot -c chains.gp FOLDER: how errors grow with the number of samples, from FOLDER/stages.csv.
folder = ARG1
chains = '"transmittance" "light, front to back" "light, back to front" "transmittance by extinction"'
# Lines of the chain's number, bound, worst, RMS.
rows(name) = "< sed -n 's/^\\([^,]*\\),\\([^,]*\\),\\([^,]*\\),.*\"" . name . ", n = \\([0-9]*\\)\".*/\\4 \\1 \\2 \\3/p' " . folder . "/stages.csv"
set terminal pngcairo size 1300,900 font "DejaVu Sans,11"
set output folder."/chains.png"
set border 3 lc rgb "#555555"
set tics nomirror
set grid lc rgb "#dddddd"
set logscale xy
set xrange [.8:5000]
set yrange [.1:10000]
set xlabel "samples n"
set ylabel "error, 2^{-31} of 1"
set key top left
set multiplot layout 2,2 title "Errors of a ray after n samples" font ",14"
do for [i=1:4] {
    set title word(chains, i)
    plot rows(word(chains, i)) using 1:2 with lines lw 2 lc rgb "#888888" title "bound", \
         "" using 1:3 with linespoints pt 7 lc rgb "#922b21" title "worst found", \
         "" using 1:4 with linespoints pt 6 lc rgb "#1a5276" title "RMS of random ones"
}
unset multiplot
