# Draws consolidation.png from the results: pressure against time and depth, settlement, beside the series.
# usage: gnuplot -e "out = 'results'" draw.gp
set terminal pngcairo size 1100,900 font 'DejaVu Sans,11'
set output out.'/consolidation.png'
set datafile separator ','
set datafile commentschars '#'
set multiplot layout 2, 2
set grid linecolor rgb '#dddddd'
set logscale x
set format x '%g'
set xrange [0.008:2.2]
set xlabel 'T'
blue = '#0072b2'
red = '#d55e00'
set title 'column: pressure at the base, part of the settlement' noenhanced
set yrange [0:1.75]
set key left top
plot out.'/column.csv' using 1:3 with lines lw 2 lc rgb blue title 'series', \
  '' using 1:2 with points pt 6 lc rgb blue title 'p/p_u, alpha = 1, M infinite' noenhanced, \
  out.'/column_compressible.csv' using 1:2 with points pt 2 lc rgb blue title 'alpha = 0.8, M = 2 E', \
  out.'/column.csv' using 1:5 with lines lw 2 lc rgb red title 'series', \
  '' using 1:4 with points pt 6 lc rgb red title 'settlement, alpha = 1, M infinite', \
  out.'/column_compressible.csv' using 1:4 with points pt 2 lc rgb red title 'alpha = 0.8, M = 2 E'
set title 'slab: pressure in the middle'
set key default left bottom
set yrange [0:1.15]
plot out.'/slab_early.csv' using ($1 < 0.15 ? $1 : 1/0):3 with lines lw 2 lc rgb blue title 'series', \
  out.'/slab.csv' using ($1 > 0.1 ? $1 : 1/0):3 with lines lw 2 lc rgb blue notitle, \
  out.'/slab_early.csv' using ($1 < 0.15 ? $1 : 1/0):2 with points pt 6 lc rgb blue \
    title 'p/p_0, alpha = 1, M infinite' noenhanced, \
  out.'/slab.csv' using ($1 > 0.1 ? $1 : 1/0):2 with points pt 6 lc rgb blue notitle, \
  out.'/slab_compressible_early.csv' using ($1 < 0.15 ? $1 : 1/0):3 with lines lw 2 lc rgb red title 'series', \
  out.'/slab_compressible.csv' using ($1 > 0.1 ? $1 : 1/0):3 with lines lw 2 lc rgb red notitle, \
  out.'/slab_compressible_early.csv' using ($1 < 0.15 ? $1 : 1/0):2 with points pt 2 lc rgb red \
    title 'alpha = 0.8, M = 2 E', \
  out.'/slab_compressible.csv' using ($1 > 0.1 ? $1 : 1/0):2 with points pt 2 lc rgb red notitle
unset logscale x
set xrange [0:1.05]
set yrange [1:0]
set xlabel 'p/p_u' noenhanced
set ylabel 'depth/H'
set key default right top
set title 'column: pressure over depth at T = 0.05 to 1'
plot out.'/profile.csv' using 4:1 with lines lw 2 lc rgb blue title 'series', \
  '' using 3:1 with points pt 6 lc rgb blue title 'alpha = 1, M infinite'
set xrange [0.008:2.2]
set logscale x
set yrange [0.9:1.1]
set xlabel 'T'
unset ylabel
set title 'slab: reaction of the plates over the load'
set key default left bottom
plot out.'/slab_early.csv' using ($1 < 0.15 ? $1 : 1/0):4 with lines lw 2 lc rgb blue title 'alpha = 1, M infinite', \
  out.'/slab.csv' using ($1 > 0.1 ? $1 : 1/0):4 with lines lw 2 lc rgb blue notitle, \
  out.'/slab_compressible_early.csv' using ($1 < 0.15 ? $1 : 1/0):4 with lines lw 2 lc rgb red \
    title 'alpha = 0.8, M = 2 E', \
  out.'/slab_compressible.csv' using ($1 > 0.1 ? $1 : 1/0):4 with lines lw 2 lc rgb red notitle
unset multiplot
