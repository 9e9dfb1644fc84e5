# Draws reflection.png, energy_density.png and patch.png from the tables of draw.sh, in the folder of the results
set terminal pngcairo size 900,560
set output "reflection.png"
set datafile separator ","
set xlabel "t, s"
set ylabel "(u - u of the uniform grid) at (0.034, 0.02), % of the pulse"
set key top left
stats "displacement.csv" every ::2 using 2 nooutput
plot for [c=3:7] "displacement.csv" every ::2 using 1:(100*(column(c)-column(2))/STATS_max) \
  with lines lw 1.5 title word("A B B-corrected dual dual-kept", c-2)
set output "energy_density.png"
set terminal pngcairo size 1000,900
set multiplot layout 3,2
set key top right
set xtics 0.005
set xrange [0.04:0.06]
set yrange [0:1.2]
set xlabel "x"
set ylabel "energy density / largest, uniform"
do for [y in "0.02 0.02025 0.02275"] {
  do for [t in "0.038 0.044"] {
    set title sprintf("t = %s s, y = %s", t, y)
    plot for [r in "uniform a b"] "energy_density.csv" every ::2 \
      using (strcol(1) eq r && strcol(2) eq t && strcol(3) eq y ? $4 : NaN):5 \
      with points pt (r eq "uniform" ? 7 : r eq "a" ? 6 : 2) ps 0.6 title (r eq "uniform" ? r : r eq "a" ? "A" : "B")
  }
}
unset multiplot
set output "patch.png"
set terminal pngcairo size 1000,900
set multiplot layout 2,2
set xtics 0.002
set xrange [0.0465:0.0535]
set yrange [0.0165:0.0235]
set size ratio 1
unset key
set xlabel "x"
set ylabel "y"
do for [c=4:5] {
  if (c == 4) { set cbrange [0.65:1] } else { set cbrange [-10:60] }
  do for [r in "b b_corrected"] {
    set title (c == 4 ? "volume within the horizon over the circle, " : "loss of the largest energy density, %, ") \
      .(r eq "b" ? "B" : "B corrected")
    plot "patch.csv" every ::2 using 2:(strcol(1) eq r ? $3 : NaN):c with points pt 5 ps 1.1 palette
  }
}
unset multiplot
