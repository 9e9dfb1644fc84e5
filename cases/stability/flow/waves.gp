# Draws waves.png from the map's numbers; run by edge.sh in the folder of the results.
set logscale x; set xlabel 'U dx/nu'; set logscale y; set yrange [0.001:100]; set ylabel 'longest step, dx/U';
set key bottom right
# of(KIND): the longest steps, lines waves,KIND,RE,STEP; computed(KIND): lines waves,KIND,RE,computed,STEP
of(k) = "<sed -n 's/\"//g; s/^waves ".k." \\([^ ]*\\),/\\1,/p' measured.csv"
computed(k) = "<sed -n 's/\"//g; s/^waves ".k." \\(.*\\) computed,/\\1,/p' measured.csv"
plot of('explicit') using 1:2 with points pt 7 title 'explicit', \
  computed('explicit') using 1:2 with lines lc 'black' title 'computed', \
  of('implicit') using 1:2 with points pt 6 title 'implicit (100: none found)', \
  computed('implicit') using 1:2 with lines lc 'black' dt 2 title 'computed', \
  x * 1.65 / 12 with lines lc 'grey' title '1.65/(4 nu sum 1/dx^2)', \
  sqrt(3) / 3 with lines lc 'grey' dt 2 title 'sqrt(3)/sum |u|/dx'
