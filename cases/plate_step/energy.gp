# Draws energy.png from energy.csv: gnuplot -c energy.gp, in the folder of the results
set terminal pngcairo size 900,560
set output "energy.png"
set datafile separator ","
set xlabel "t, s"
set ylabel "(energy of the uniform coarse grid - energy)/its largest, %"
stats "energy.csv" every ::2 using 2 nooutput
plot for [c=4:7] "energy.csv" every ::2 using 1:(100*(column(2)-column(c))/STATS_max) \
  with lines lw 1.5 title word("B B-corrected dual dual-kept", c-3)
