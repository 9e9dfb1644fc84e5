# Draws paths.png: the crack near a hole by the maximum hoop stress and with bonds, opened slowly and pulled at once.
# gnuplot -c paths.gp OUT, in the folder of the runs
set terminal pngcairo size 860,700 font 'DejaVu Sans,12'
set output ARG1.'/paths.png'
set datafile separator ','
set size ratio -1
set xrange [0:30]
set yrange [0:24]
set xlabel 'x, mm'
set ylabel 'y, mm'
set grid linecolor rgb '#eeeeee'
set key top left
set object 1 circle at 20,8 size 4 fillcolor rgb '#dddddd' fillstyle solid border linecolor rgb '#5a6068'
set arrow 1 from 0,15 to 10,15 nohead linewidth 3 linecolor rgb '#23282e'
set label 1 'crack at the start' at 1,14.3
set label 2 'hole' at 20,8 center
plot 'hole/growth.csv' every ::1 using (1e3*$3):(1e3*$4) \
    with linespoints linewidth 2 pointtype 7 linecolor rgb '#d55e00' \
    title 'maximum hoop stress, element-free, opened slowly', \
  'bonds/crack.csv' every ::1 using (1e3*$3):(1e3*$4) with linespoints linewidth 2 pointtype 5 linecolor rgb '#0072b2' \
    title 'bonds, opened slowly (horizon 1.5 mm)', \
  'pulled/crack.csv' every ::1 using (1e3*$3):(1e3*$4) \
    with linespoints linewidth 1 pointtype 4 pointsize 0.6 dashtype 2 linecolor rgb '#009e73' \
    title 'bonds, pulled at once by 22 MPa'
