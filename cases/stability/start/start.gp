# Draws start.png from the map's numbers; run by edge.sh in the folder of the results.
set logscale x; set xlabel 't U/D'; set ylabel 'load / (rho U^2 D^2)'; set yrange [-10:200]; set key top right
plot for [s in '0.2 0.1 0.05 0.025'] 'load_'.s.'_0.csv' using ($1 / 6):($2 / 36) \
  with linespoints title 'elastic from the start, step '.s.' s', 'load_0.1_2.csv' using ($1 / 6):($2 / 36) \
  with lines lc 'black' lw 2 title 'after 2 s of flow alone'
