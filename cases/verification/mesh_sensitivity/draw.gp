# Draws mesh_sensitivity.png from the tables of the studies: gnuplot -c draw.gp, in the folder of the results
set terminal pngcairo size 1300,1000 font 'DejaVu Sans,12'
set output 'mesh_sensitivity.png'
set datafile separator ','
set datafile columnheaders
set multiplot layout 2,2
set logscale y
set ylabel 'relative L2 error'
set format y '%g'
set grid linecolor rgb '#dddddd'
set key below
set style line 1 linecolor rgb '#0072b2' linewidth 2 pointtype 5
set style line 2 linecolor rgb '#56b4e9' linewidth 2 pointtype 9
set style line 3 linecolor rgb '#e69f00' linewidth 2 pointtype 13
set style line 4 linecolor rgb '#d55e00' linewidth 2 pointtype 7
set style line 5 linecolor rgb '#cc79a7' linewidth 2 pointtype 6
set style line 6 linecolor rgb '#888888' linewidth 2 pointtype 3
# a column of a method's rows; the number in the name of a level: "m 2.25", "h 0.05", "0.1 h"
is_of(method) = strcol('method') eq method && strcol('quantity') eq 'error_l2' && strcol('status') eq 'done'
of(method, name) = is_of(method) ? column(name) : NaN
at(k) = real(word(strcol('level'), k))
array method = ['lattice', 'hexagonal', 'perturbed', 'centroidal', 'centroidal cells', 'random']
array label = ['lattice', 'hexagonal', 'perturbed, 0.2 h', 'centroidal', 'centroidal, volumes of cells', 'random']
# lattices have one run a level, the others ten
table(k, name) = k < 3 ? name.'_grids.csv' : name.'.csv'

set title 'horizon 0.25 m, mean and standard deviation of ten seeds'
set xlabel "horizon over spacing, m\n"
plot for [k=1:6] table(k, 'study_horizon') using (at(2)):(of(method[k], 'value')):(of(method[k], 'value_spread')) \
  with yerrorlines linestyle k title label[k]
set title 'horizon 3 spacings'
set xlabel "spacing, m\n"
set logscale x
set format x '%g'
set xtics (0.03, 0.05, 0.08, 0.13)
set xrange [0.03:0.15]
plot for [k=1:6] table(k, 'study_points') using (at(2)):(of(method[k], 'value')):(of(method[k], 'value_spread')) \
  with yerrorlines linestyle k title label[k]
set title 'perturbed lattice, horizon 3 spacings'
set xlabel "perturbation, spacings\n"
unset logscale x
set xtics auto
set xrange [0:0.42]
plot for [k=0:2] 'study_perturbation.csv' using (at(1)):(of('P = '.k, 'value')):(of('P = '.k, 'value_spread')) \
  with yerrorlines linestyle (k == 0 ? 1 : 5 - k) title 'P = '.k
set title 'horizon 0.25 m'
set xlabel "wall time with the arrangement, s\n"
set logscale x
set xtics auto
set xrange [*:*]
plot for [k=1:6] table(k, 'study_horizon') using (of(method[k], 'wall_median_s')):(of(method[k], 'value')) \
  with points linestyle k title label[k]
