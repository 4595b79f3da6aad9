# gnuplot -c figure2.gp FOLDER: attenuation of a cube along three directions, from FOLDER/data/cube-*.
folder = ARG1
edge = 440
set terminal pngcairo size 1400,1030 font "DejaVu Sans,12" background rgb "#f6f5f2"
set output folder."/figure2.png"
unset border
unset tics
unset key
set xrange [0:edge]
set yrange [edge:0]
set margins 1,1,0.5,2.2
titles = "'along an axis' 'along a diagonal of a face' 'along a diagonal of the cube'"
set multiplot layout 2,3 title "Figure 2: light that passes between each voxel of a uniform cube and the viewer (arrow). Dotted: none\n" font ",17"
do for [how in "published corrected"] {
    do for [i=1:3] {
        name = folder."/data/cube-".how."-".word("face edge corner", i)
        set title word(titles, i).(how eq "published" ? ", as published" : ", by the length of a step")
        plot name.".ppm" binary array=(edge,edge) skip=15 format='%uchar%uchar%uchar' with rgbimage, \
             name.".lines" index 1 with lines lw 1 lc rgb "#d8dde6", \
             name.".lines" index 2 with lines lw 2.5 dt (2,3) lc rgb "#ffd23f", \
             name.".lines" index 0 with vectors head filled size 20,22 lw 5 lc rgb "#d62828"
    }
}
unset multiplot
