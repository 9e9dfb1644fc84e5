# Draws limits.png from the map's tables; run by edge.sh in the folder of the results.
set multiplot layout 1, 3
set key bottom left; set yrange [0.8:2.2]; set ylabel 'longest step / computed limit'; set ytics 0.2
f = 'limits.csv'
pick(w, k) = strcol(1) eq w ? column(k) / column(k + 1) : NaN
set title 'horizon, and stiffness of contact'; set logscale x; set key top right; set xlabel 'm;  k_c/c_0'
plot f using (strcol(1) eq 'm' ? $2 : NaN):(pick('m', 3)) with points pt 7 title 'm, RK3', \
  '' using (strcol(1) eq 'm' ? $2 : NaN):(pick('m', 5)) with points pt 6 title 'm, Verlet', \
  '' using (strcol(1) eq 'contact' ? $2 : NaN):(pick('contact', 3)) with points pt 5 title 'contact, RK3', \
  1 with lines lc 'black' notitle
set title 'pairwise damping'; set key bottom left; set xlabel 'k_d'
plot f using (strcol(1) eq 'damping' ? $2 : NaN):(pick('damping', 3)) with points pt 7 title 'RK3', \
  '' using (strcol(1) eq 'damping' ? $2 : NaN):(pick('damping', 5)) with points pt 6 title 'Verlet', \
  1 with lines lc 'black' notitle
unset logscale; set title 'cracks across a cube of 6 particles'; set xlabel 'cracks'
plot f using (strcol(1) eq 'cracks' ? $2 : NaN):(pick('cracks', 3)) with points pt 7 title 'RK3', \
  '' using (strcol(1) eq 'cracks' ? $2 : NaN):(pick('cracks', 5)) with points pt 6 title 'Verlet', \
  1 with lines lc 'black' notitle
