# Draws limits.png from the map's numbers; run by edge.sh in the folder of the results.
set multiplot layout 1, 3
set key bottom left; set yrange [0.8:2.2]; set ylabel 'longest step / computed limit'; set ytics 0.2
f = "<sed 's/\"//g; s/ /,/g' measured.csv"
pick(w, m) = strcol(1) ne w || strcol(3) ne m ? NaN : strcol(4) eq 'computed' ? (limit = $5, NaN) : $4 / limit
set title 'horizon, and stiffness of contact'; set logscale x; set key top right; set xlabel 'm;  k_c/c_0'
plot f using (strcol(1) eq 'm' ? $2 : NaN):(pick('m', 'rk3')) with points pt 7 title 'm, RK3', \
  '' using (strcol(1) eq 'm' ? $2 : NaN):(pick('m', 'verlet')) with points pt 6 title 'm, Verlet', \
  '' using (strcol(1) eq 'contact' ? $2 : NaN):(pick('contact', 'rk3')) with points pt 5 title 'contact, RK3', \
  1 with lines lc 'black' notitle
set title 'pairwise damping'; set key bottom left; set xlabel 'k_d'
plot f using (strcol(1) eq 'damping' ? $2 : NaN):(pick('damping', 'rk3')) with points pt 7 title 'RK3', \
  '' using (strcol(1) eq 'damping' ? $2 : NaN):(pick('damping', 'verlet')) with points pt 6 title 'Verlet', \
  1 with lines lc 'black' notitle
unset logscale; set title 'cracks across a cube of 6 particles'; set xlabel 'cracks'
plot f using (strcol(1) eq 'cracks' ? $2 : NaN):(pick('cracks', 'rk3')) with points pt 7 title 'RK3', \
  '' using (strcol(1) eq 'cracks' ? $2 : NaN):(pick('cracks', 'verlet')) with points pt 6 title 'Verlet', \
  1 with lines lc 'black' notitle
