# Draws slit.png from the map's numbers; run by edge.sh in the folder of the results.
set logscale xy; set xlabel 'width, cells'; set ylabel "flow over h^3/12 G/mu"; set xtics (1, 2, 3, 4, 8, 16);
set key top right
f = "<sed 's/\"//g; s/ /,/g' measured.csv"; of(k) = strcol(1) eq k && strcol(3) eq 'flow' ? $4 : NaN
plot f using 2:(of('reaction')) with points pt 7 title 'reaction', \
  '' using 2:(of('probe')) with points pt 4 title 'probe', \
  '' using 2:(of('implicit')) with points pt 6 title 'implicit, ten times the step', 1 with lines lc 'black' notitle
