# Draws error.png in the folder of the results, beside study.csv: error of K over run time, with bonds and by
# element-free Galerkin, from the studies of both cases. usage: gnuplot -c draw.gp CASE, with the case's folder
set datafile separator ','
set terminal pngcairo size 800,600 font 'DejaVu Sans,12'
set output 'error.png'
set logscale xy
set xlabel 'wall time of the steps, or of the solution, s'
set ylabel 'error of K, %'
set format x '%g'
set format y '%g'
set grid linecolor rgb '#dddddd'
set key left bottom
of(method, quantity, file) = sprintf("< grep '^%s,.*,%s,' %s | sort -t , -g -k 12,12", method, quantity, file)
free = ARG1.'/../element_free/results/study.csv'
plot of('bonds', 'K by J', 'study.csv') using 12:(100 * $10) with linespoints linewidth 2 pointtype 7 \
    linecolor rgb '#0072b2' title 'bonds, 25, 50, 100 spacings: J', \
  of('bonds', 'K by the interaction integral', 'study.csv') using 12:(100 * $10) with linespoints linewidth 2 \
    pointtype 6 linecolor rgb '#0072b2' title 'the same: interaction integral', \
  of('nodes graded about the tip', 'K', free) using 12:(100 * $10) with linespoints linewidth 2 pointtype 5 \
    linecolor rgb '#d55e00' title 'element-free, nodes graded about the tip', \
  of('even nodes', 'K', free) using 12:(100 * $10) with linespoints linewidth 2 pointtype 4 \
    linecolor rgb '#d55e00' title 'element-free, even nodes', \
  0.1 with lines dashtype 2 linecolor rgb '#888888' title 'uncertainty of the reference'
