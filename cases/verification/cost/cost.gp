# Error over cost, from cost.csv and study_column.csv. usage: gnuplot -e "folder = 'results'" cost.gp
set terminal pngcairo size 1200, 900 font 'Sans,12'
set output folder.'/cost.png'
set datafile separator ','
set datafile missing 'NaN'
set multiplot layout 2, 2
set logscale xy; set grid lc rgb '#dddddd'; set format '%g'
set style line 1 lc rgb '#0072b2' lw 2 pt 7 ps 1.2
set style line 2 lc rgb '#d55e00' lw 2 pt 5 ps 1.2
set style line 3 lc rgb '#009e73' lw 2 pt 9 ps 1.4
set style line 4 lc rgb '#e69f00' lw 2 pt 11 ps 1.4
set style line 5 lc rgb '#999999' lw 2 pt 4 ps 1.2
set style line 6 lc rgb '#cc79a7' lw 2 pt 13 ps 1.4
f = folder.'/cost.csv'
# rows of a study's quantity, of the levels whose names match
pick(s, q, levels) = sprintf("< awk -F, '$1 == \"%s\" && $4 == \"%s\" && $3 ~ /%s/ && $6 > 0' %s", s, q, levels, f)
base(s) = real(system(sprintf("awk -F, '$1 == \"%s\" && $3 == \"default\" { print $9; exit }' %s", s, f)))
steps = '^(step . [0-9]+|default)$'
name(s) = s[1:4] eq 'step' ? s[6:*] : s
set xlabel 'counted cost of the elastic steps, over that of the default'
set ylabel 'error, %'
set key outside below samplen 1 maxrows 3
set xtics (0.25, 0.5, 1, 2, 4); b = base('study_first')
set title 'time of the first bond, no settling before'
plot pick('study_first', 'first bond', steps) using ($9 / b):(100 * $6) \
    with linespoints ls 1 title 'reaction, the fluid''s step', \
  pick('study_first', 'first bond', steps) using ($9 / b):(100 * $6):(name(strcol(3))) \
    with labels left offset 0.7, 0.5 tc ls 1 notitle, \
  pick('study_first', 'first bond', 'substeps$') using ($9 / b):(100 * $6) \
    with linespoints ls 3 title '6, 12, 24 substeps', \
  pick('study_first', 'first bond', '^rk3$') using ($9 / b):(100 * $6) with points ls 4 title 'RK3', \
  pick('study_first', 'first bond', '^probe N_s = [124]$') using ($9 / b):(100 * $6) \
    with linespoints ls 2 title 'probe, N_s = 1, 2, 4'
set xrange [0.3:5]; set yrange [0.5:50]
set title 'bonds broken: settled, at 2.4 ms; released, at 4.8 ms'
b1 = base('study_broken'); b2 = base('study_settled')
plot pick('study_broken', 'share broken at 4.8 ms', steps) using ($9 / b1):(100 * $6) \
    with linespoints ls 1 title 'released at once, fluid step', \
  pick('study_settled', 'share broken at 2.4 ms', steps) using ($9 / b2):(100 * $6) \
    with linespoints ls 2 title 'settled, fluid step', \
  pick('study_settled', 'share broken at 2.4 ms', steps) using ($9 / b2):(100 * $6):(name(strcol(3))) \
    with labels left offset 0.7, 0.5 tc ls 2 notitle, \
  pick('study_settled', 'share broken at 2.4 ms', 'broken by') using ($9 / b2):(100 * $6) \
    with linespoints ls 5 title 'settled by steps x 2, broken by / 2, / 3', \
  pick('study_multistep', 'share broken at 2.4 ms', '^AB2 settled by steps x 2 broken by . [0-9]$') \
    using ($9 / b2):(100 * $6) with linespoints ls 6 title 'the same by AB2, / 2, / 3, / 4', \
  pick('study_broken', 'share broken at 4.8 ms', '^([0-9]+ substeps|safety.*|rk3.*)$') using ($9 / b1):(100 * $6) \
    with points ls 3 title 'released: substeps, safety, RK3', \
  pick('study_settled', 'share broken at 2.4 ms', '^([0-9]+ substeps|safety.*|rk3.*)$') using ($9 / b2):(100 * $6) \
    with points ls 4 title 'settled: the same'
set autoscale; set xtics autofreq
set title 'drag of the rigid block'
set xlabel 'counted cost of 34 ms of flow, s of one core'
hold(m) = sprintf("< awk -F, '$1 == \"study_hold\" && $4 == \"drag\" && $2 == \"%s\" && $6 > 0' %s", m, f)
plot hold('reaction') using 9:(100 * $6) with linespoints ls 1 title 'reaction', \
  hold('N_s = 1') using 9:(100 * $6) with linespoints ls 5 title 'multidirect, N_s = 1', \
  hold('N_s = 2') using 9:(100 * $6) with linespoints ls 2 title 'N_s = 2', \
  hold('N_s = 4') using 9:(100 * $6) with linespoints ls 4 title 'N_s = 4'
set title 'a column of fluid on a spring, density ratio 3'
set xlabel 'steps a period'
g = folder.'/study_column.csv'
col(m, q) = sprintf("< awk -F, '$1 == \"%s\" && $4 == \"%s\" && $10 > 0' %s", m, q, g)
period = 6.3e-3
plot col('reaction', 'frequency') using (period / $3):(100 * $10) \
    with linespoints ls 1 title 'frequency, reaction', \
  col('reaction', 'amplitude after a period') using (period / $3):(100 * $10) \
    with linespoints ls 3 title 'amplitude lost in a period, reaction'
unset multiplot
