# Draws curves.png from curves.csv; run by curves.sh in the folder of the results.
set datafile separator ','
set terminal pngcairo size 1200,560 font ',9'
set output 'curves.png'
set multiplot layout 2,4
set logscale xy
set format '10^{%L}'
set xlabel 'seconds'; set ylabel 'error of k' offset 1
set xrange [1e-3:100]; set yrange [1e-4:2]
unset key
samples = '"slit of 4" "duct of 8 x 8" "duct of 4 x 8" "cubes of 4 in 8" '. \
  '"columns of 2 in 8" "stairs along [110]" "body-centred spheres"'
methods = '"at once" "two grids" "stepped" "Palabos"'
of(s, m) = sprintf('< grep "^%s,%s," curves.csv', system('printf "%s" "'.s.'" | sed "s/[][]/\\\\&/g"'), m)
do for [s in samples] {
  set title s
  plot for [k = 1:4] of(s, word(methods, k)) using 5:(abs($4)) with linespoints pt 7 ps 0.7 lt k
}
unset title; unset border; unset tics; unset xlabel; unset ylabel
set key center center spacing 2
plot for [k = 1:4] NaN with linespoints pt 7 lt k title word(methods, k)
