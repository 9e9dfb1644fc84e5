# gnuplot -e "folder = 'results'" study_chaos.gp
set datafile separator ","
set terminal pngcairo size 900,600
set output folder . "/study_chaos.png"
set logscale y
set format y "10^{%T}"
set xlabel "time since bonds may break, ms"
set ylabel "pressure drop, relative difference to the unchanged inflow"
set key bottom right
file = folder . "/study_chaos.csv"
plot for [i = 0:2] file using (1e3 * $1):(abs(column(4 + 2 * i))) every ::1 with lines \
     title "inflow changed by 1e-" . word("12 6 4", i + 1)
