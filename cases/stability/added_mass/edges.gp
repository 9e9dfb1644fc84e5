# Draws edges.png from the map's numbers; run by edge.sh in the folder of the results.
set logscale xy; set xlabel 'thickness, particles'; set xrange [0.8:10]; set yrange [0.0003:100];
set ylabel 'least rho_s/rho_f that holds';
set key bottom left
f = "<sed 's/\"//g; s/ /,/g' measured.csv"; of(s, l, d) = strcol(1) eq s && $3 == l && $4 == d ? $5 : NaN
plot f using 2:(of('probe', 40, 20)) with points pt 7 title 'probe, column of 40 cells, 20 us', \
  '' using 2:(of('probe', 40, 5)) with points pt 1 ps 2 title '5 us', \
  '' using 2:(of('probe', 40, 40)) with points pt 2 ps 2 title '40 us', \
  '' using 2:(of('probe', 20, 20)) with points pt 8 title '20 cells', \
  '' using 2:(of('probe', 80, 20)) with points pt 10 title '80 cells', \
  '' using 2:(of('reaction', 40, 20)) with points pt 12 ps 2 title 'reaction, 40 cells (0.01: the least tried)', \
  40 / x with lines lc 'black' title 'rho_s h = rho_f L'
