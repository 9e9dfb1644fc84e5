# Draws grid.png from the map's numbers; run by edge.sh in the folder of the results.
set logscale xy; set xlabel 'E/(rho_f U^2)'; set ylabel 'rho_s/rho_f'; set xrange [300:1e11]; set yrange [0.003:3000];
set format x '1e%T'; set key top right horizontal
f = "<sed 's/\"//g; s/ /,/g' measured.csv"; of(s, h) = strcol(1) eq s && $4 == h ? $3 : NaN
plot f using ($2 * 0.7):(of('reaction', 1)) with points pt 7 ps 2 lc 'web-green' title 'reaction: holds', \
  '' using ($2 * 0.7):(of('reaction', 0)) with points pt 2 ps 2 lc 'red' title 'diverges', \
  '' using ($2 * 0.5):(of('reaction_ab2', 1)) with points pt 6 ps 2 lc 'web-green' title 'reaction, AB2: holds', \
  '' using ($2 * 0.5):(of('reaction_ab2', 0)) with points pt 8 ps 2 lc 'red' title 'diverges', \
  '' using 2:(of('probe', 1)) with points pt 9 ps 2 lc 'orange' title 'probe: holds', \
  '' using 2:(of('probe', 0)) with points pt 1 ps 2 lc 'red' title 'diverges'
