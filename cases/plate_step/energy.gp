# Draws energy.png from energy.csv: gnuplot -c energy.gp, in the folder of the results
set terminal pngcairo size 900,1000
set output "energy.png"
set datafile separator ","
set xlabel "t, s"
set multiplot layout 2,1
do for [u=2:3] {
  set ylabel sprintf("energy less than uniform %s, over the largest, %%", u == 2 ? "coarse" : "fine")
  stats "energy.csv" every ::2 using u nooutput
  plot for [c=4:7] "energy.csv" every ::2 using 1:(100*(column(u)-column(c))/STATS_max) \
    with lines lw 1.5 title word("B B-corrected dual dual-kept", c-3)
}
unset multiplot
