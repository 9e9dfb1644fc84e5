# Draws channel.png from the map's tables; run by edge.sh in the folder of the results.
set logscale xy; set xlabel 'Re_b'; set ylabel 'step, s'; set key bottom right
f = 'channel.csv'; of(k, c) = strcol(1) eq k ? column(c) : NaN
plot f using (of('explicit', 2)):(of('explicit', 3)) with linespoints pt 7 title 'explicit: longest', \
  '' using (of('explicit', 2)):(of('explicit', 4)) with lines dt 2 title 'explicit: automatic, cfl 1', \
  '' using (of('implicit', 2)):(of('implicit', 3)) with linespoints pt 6 title 'implicit: longest', \
  '' using (of('implicit', 2)):(of('implicit', 4)) with lines dt 2 title 'implicit: automatic, cfl 1'
