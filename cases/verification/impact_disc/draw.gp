# Draws damage.png, modes.png and curve.png: gnuplot -c draw.gp WORK CASE RUNS, in the folder of the results. WORK
# has the tables of draw.sh, CASE the energies by LAMMPS, RUNS the series.
work = ARG1
blue = '#0072b2'
red = '#d55e00'
set terminal pngcairo size 1000,960 font 'DejaVu Sans,12'
set output 'damage.png'
set multiplot layout 2,2 margins 0.05,0.87,0.06,0.96 spacing 0.06,0.09
set size ratio -1
set xrange [-38:38]
set yrange [-38:38]
set cbrange [0:1]
set palette defined (0 '#f7fbff', 0.35 '#fdae61', 0.7 '#b2182b', 1 '#40004b')
set xlabel 'mm' offset 0, 0.7
unset key
unset colorbox
do for [name in 'lattice centroidal'] {
  do for [step in '300 600'] {
    if (name.step eq 'centroidal600') {
      set colorbox user origin 0.91,0.3 size 0.02,0.4
      set cblabel 'damage of the struck face'
    }
    set title sprintf('%s, %d µs', name, step / 10)
    plot work.'/'.name.'.'.step using 1:2:3 with points pointtype 5 pointsize 0.36 linecolor palette
  }
}
unset multiplot
reset

set terminal pngcairo size 1300,480 font 'DejaVu Sans,12'
set output 'modes.png'
set multiplot layout 1,2
set xlabel 'azimuthal mode'
set ylabel 'amplitude of the damage, over all rings'
set xtics 1
set xrange [0.5:12.5]
set grid linecolor rgb '#dddddd'
set key top left
set title '103,110 particles, 60 µs'
plot work.'/full.lattice' with linespoints pointtype 5 linewidth 2 linecolor rgb blue title 'lattice', \
  work.'/full.lammps' with points pointtype 4 pointsize 1.6 linecolor rgb '#000000' title 'lattice, LAMMPS', \
  work.'/full.centroidal' with linespoints pointtype 7 linewidth 2 linecolor rgb red title 'centroidal'
set title '10,758 particles, 40 µs, mean and deviation of ten seeds'
set datafile separator ','
set datafile columnheaders
set datafile missing NaN
# the value, or another column, of a method's modes at step 400
is_mode(name) = name[1:4] eq 'mode' && strstrt(name, '_400')
mode(shift) = is_mode(strcol(4)) ? shift + real(substr(strcol(4), 5, strstrt(strcol(4), '_') - 1)) : NaN
of(name, c) = strcol(1) eq name && is_mode(strcol(4)) ? column(c) : NaN
plot 'study_axes.csv' using (mode(0)):(of('lattice', 'value')) \
    with linespoints pointtype 5 linewidth 2 linecolor rgb blue title 'lattice', \
  'study_axes.csv' using (mode(0)):(of('hexagonal', 'value')) \
    with linespoints pointtype 9 linewidth 2 linecolor rgb '#56b4e9' title 'hexagonal', \
  'study_seeds.csv' using (mode(-0.08)):(of('perturbed', 'value')):'value_spread' \
    with yerrorlines pointtype 13 linewidth 2 linecolor rgb '#e69f00' title 'perturbed', \
  'study_seeds.csv' using (mode(0.08)):(of('centroidal', 'value')):'value_spread' \
    with yerrorlines pointtype 7 linewidth 2 linecolor rgb red title 'centroidal'
unset multiplot
reset

set terminal pngcairo size 1300,440 font 'DejaVu Sans,12'
set output 'curve.png'
set datafile separator ','
set datafile columnheaders
set multiplot layout 1,2
set xlabel 'time, µs'
set grid linecolor rgb '#dddddd'
set key top left
run(name) = ARG3.'/'.name.'/series.csv'
do for [what in 'damage_mean e_kinetic_solid'] {
  set ylabel (what eq 'damage_mean' ? 'mean damage' : 'kinetic energy, J')
  plot run('lattice') using (1e6 * column('t')):what \
      with lines linewidth 2 linecolor rgb blue title 'lattice', \
    ARG2.'/lammps.csv' using (column('step') / 10):(column(what eq 'damage_mean' ? 4 : 3)) \
      with points pointtype 4 linecolor rgb '#000000' title 'lattice, LAMMPS', \
    run('centroidal') using (1e6 * column('t')):what \
      with lines linewidth 2 linecolor rgb red title 'centroidal'
}
