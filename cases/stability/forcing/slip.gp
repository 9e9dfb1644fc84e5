# Draws slip.png from the map's numbers; run by edge.sh in the folder of the results.
f = "<sed 's/\"//g; s/ /,/g' measured.csv"
stats f using (strcol(1) eq 'explicit' && $2 == 0.1 && $3 == 100 ? $4 : NaN) name 'exact' nooutput
stats f using (strcol(1) eq 'explicit' && $2 == 1 && $3 == 0 ? $4 : NaN) name 'feedback' nooutput
set logscale xy; set xrange [1:100]; set xlabel 'iterations N_s'
set ylabel 'slip, share of the bulk velocity'; set key bottom left;
set yrange [1e-8:0.1]; set format y '1e%T'
of(k, d) = strcol(1) eq k && column(2) == d ? column(4) / exact_max - 1 : NaN
plot f using 3:(of('explicit', 1)) with points pt 7 title 'explicit, at the viscous limit', \
  abs(feedback_max / exact_max - 1) with lines lc 'black' title 'feedback (reaction), any step, either diffusion', \
  '' using 3:(of('explicit', 0.1)) with points pt 6 title 'a tenth of it'
