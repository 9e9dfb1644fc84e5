# Draws waves.png from the map's tables; run by edge.sh in the folder of the results.
set logscale x; set xlabel 'U dx/nu'; set logscale y; set yrange [0.001:100]; set ylabel 'longest step, dx/U';
set key bottom right
f = 'waves.csv'; of(k, c) = strcol(1) eq k ? column(c) : NaN
plot f using (of('explicit', 2)):(of('explicit', 3)) with points pt 7 title 'explicit', '' using (of('explicit', \
  2)):(of('explicit', 4)) with lines lc 'black' title 'computed', \
  '' using (of('implicit', 2)):(of('implicit', 3)) with points pt 6 title 'implicit (100: none found)', \
  '' using (of('implicit', 2)):(of('implicit', 4)) with lines lc 'black' dt 2 title 'computed', \
  x * 1.65 / 12 with lines lc 'grey' title '1.65/(4 nu sum 1/dx^2)', \
  sqrt(3) / 3 with lines lc 'grey' dt 2 title 'sqrt(3)/sum |u|/dx'
