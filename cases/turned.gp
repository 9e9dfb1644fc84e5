# Draws turned.png: a quantity of each run over the angle that a plate is turned by, a panel for each horizon ratio, and
# mean and standard deviation of each angle. In the folder of the results, which has turned.csv and turned_spread.csv:
#   gnuplot -e "quantity = 'COLUMN'; label = 'TEXT'; steel = 'NAME'" turned.gp
# With a steel only the rows of that steel with a spacing of 2 mm; '' where there is none.
set terminal pngcairo size 1200,420 font 'Sans,12'
set output 'turned.png'
set datafile separator ','
set datafile columnheaders
is_of(m, kind) = column('m') == m && strcol('particles') eq kind && \
  (steel eq '' || (strcol('steel') eq steel && column('spacing (mm)') == 2))
run_of(m, kind) = is_of(m, kind) ? column(quantity) : NaN
mean_of(m, kind) = is_of(m, kind) && strcol('quantity') eq quantity ? column('mean') : NaN
kinds = 'lattice perturbed'
side(kind) = kind eq 'lattice' ? -1.2 : 1.2
stats 'turned.csv' using 'turned by (deg)' name 'angle' nooutput
stats 'turned.csv' using (is_of(column('m'), 'lattice') || is_of(column('m'), 'perturbed') ? column(quantity) : NaN) \
  nooutput
set multiplot layout 1,3
set xlabel 'plate turned by, degrees' offset 0, 0.5
set xrange [-6:angle_max + 6]
set ylabel label
set xtics 15
set grid linecolor rgb '#dddddd'
set key bottom center horizontal maxrows 1 samplen 1
set bmargin 4
set lmargin 8
set yrange [STATS_min - 0.2 * (STATS_max - STATS_min):STATS_max + 0.06 * (STATS_max - STATS_min)]
set style line 1 linecolor rgb '#56b4e9' pointtype 6 pointsize 0.9
set style line 2 linecolor rgb '#e69f00' pointtype 4 pointsize 0.9
set style line 3 linecolor rgb '#0072b2' linewidth 2 pointtype 7 pointsize 1.1
set style line 4 linecolor rgb '#d55e00' linewidth 2 pointtype 5 pointsize 1.1
do for [m=3:5] {
  set title 'm = '.m
  plot for [k=1:2] 'turned.csv' using (column('turned by (deg)') + side(word(kinds, k))):(run_of(m, word(kinds, k))) \
      with points linestyle k title word(kinds, k), \
    for [k=1:2] 'turned_spread.csv' \
      using (column('turned by (deg)') + side(word(kinds, k))):(mean_of(m, word(kinds, k))):'deviation' \
      with yerrorbars linestyle (k + 2) notitle
  unset ylabel
}
