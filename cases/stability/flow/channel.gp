# Draws channel.png from the map's numbers; run by edge.sh in the folder of the results.
set logscale xy; set xlabel 'Re_b'; set ylabel 'step, s'; set key bottom right
# of(KIND): the longest steps, lines channel,KIND,RE,STEP; automatic(KIND): lines channel,KIND,RE,automatic,STEP
of(k) = "<sed -n 's/\"//g; s/^channel ".k." \\([^ ]*\\),/\\1,/p' measured.csv"
automatic(k) = "<sed -n 's/\"//g; s/^channel ".k." \\(.*\\) automatic,/\\1,/p' measured.csv"
plot of('explicit') using 1:2 with linespoints pt 7 title 'explicit: longest', \
  automatic('explicit') using 1:2 with lines dt 2 title 'explicit: automatic, cfl 1', \
  of('implicit') using 1:2 with linespoints pt 6 title 'implicit: longest', \
  automatic('implicit') using 1:2 with lines dt 2 title 'implicit: automatic, cfl 1'
