# Draws loads.png: error against run time of the default load and of the thesis's probe, from the results of four cases.
# gnuplot -c loads.gp, in the folder cases/verification
set terminal pngcairo size 1200,900 font 'Sans,13'
set output 'loads.png'
set datafile separator ','
set datafile columnheaders
set multiplot layout 2,2
set logscale xy
set xlabel 'wall time of the steps, s' offset 0, 0.7
set ylabel 'relative error, %'
set format y '%g'
set format x '%g'
set grid linecolor rgb '#dddddd'
set key below
set style line 1 linecolor rgb '#0072b2' linewidth 2 pointtype 7 pointsize 1.2
set style line 2 linecolor rgb '#d55e00' linewidth 2 pointtype 5 pointsize 1.2
set style line 3 linecolor rgb '#56b4e9' linewidth 2 pointtype 6 pointsize 1.2 dashtype 2
set style line 4 linecolor rgb '#e69f00' linewidth 2 pointtype 4 pointsize 1.2 dashtype 2
error(method, quantity) = strcol('method') eq method && strcol('quantity') eq quantity && \
  column('relative_error') > 0 ? 100 * column('relative_error') : NaN
array load = ['reaction', 'probe', 'reaction lattice', 'probe lattice', 'reaction shape', 'probe shape']
array label = ['reaction', 'probe', 'reaction, lattice', 'multidirect, lattice', 'reaction, shape', \
  'multidirect, shape']

set title 'Permeability of spheres, 16 to 48 cells a period'
plot for [k=3:6] 'spheres/results/study_loads.csv' using 'wall_median_s':(error(load[k], 'permeability')) \
  smooth unique with linespoints linestyle (k - 2) title label[k]
set title 'Drag of a sphere by its load, 8 to 32 cells a diameter'
plot for [k=1:2] 'sphere_drag/results/study_loads.csv' using 'wall_median_s':(error(load[k], 'drag by the load')) \
  smooth unique with linespoints linestyle k title label[k]
set title 'Speed of a settling sphere, 6 and 12 cells'
plot for [k=1:2] 'ten_cate/results/study_loads.csv' using 'wall_median_s':(error(load[k], 'largest speed over u_inf')) \
  smooth unique with linespoints linestyle k title label[k]
set title 'Main case: bonds broken at 8 ms, 2 to 1/4 steps'
plot for [k=1:2] '../porous_channel/results/study_loads.csv' using 'wall_median_s':(error(load[k], 'share broken')) \
  smooth unique with linespoints linestyle k title label[k]
